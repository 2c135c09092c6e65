/**
 * @file Pore.h
 * @brief Pores through a molecule: parameters and result.
 */
#ifndef isthmus_Pore_h
#define isthmus_Pore_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace isthmus
{

/// Lengths in angstrom.
struct PoreOptions
{
  double EndRadius = 5.0;     ///< a pore ends where it is wider than this
  double Spacing = 0.25;      ///< distance between the planes
  double MinimumRadius = 1.0; ///< of automatically found pores
  double MinimumSpan = 20.0;  ///< distance between their ends
  int MaximumPores = 20;      ///< maximum number of these; those with the longest spans are kept
  double MaximumOffset =
    10.0; ///< between two points: largest distance of the path from the straight line
  /// Called with the predicted time of the triangulation in seconds (RegularFiltration.h).
  std::function<void(double)> Predicted;
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSPOCKETS_EXPORT void Check(const PoreOptions& options);

/// The largest ball in a plane across a pore.
struct PoreSample
{
  Point3 Center;
  double Radius = 0.0;
  /// How far the radius between this plane and the next ones may be from the line between theirs.
  double RadiusError = 0.0;
  double Least = 0.0;     ///< the smallest radius there
  double ArcLength = 0.0; ///< along the centers
  std::int64_t NearestAtom = -1;
};

struct Pore
{
  /// How much smaller than that of `sample` the radius may be before the next planes.
  static double DipBelow(const PoreSample& sample);
  /// The same in the whole pore, for the narrowest sample.
  double DipBelowNarrowest() const;

  std::vector<PoreSample> Samples;
  std::vector<std::size_t> Bottlenecks; ///< samples that are local minima, the narrowest first
  double Span = 0.0;                    ///< distance between the first and the last sample
  std::string Direction;                ///< "a", "b" or "c": along that vector of a crystal's cell
};

}

#endif
