/**
 * @file Pore.h
 * @brief Pores through a molecule: parameters and result.
 */
#ifndef isthmus_Pore_h
#define isthmus_Pore_h

#include "Core/Geometry.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/// Lengths in angstrom.
struct PoreOptions
{
  double EndRadius = 5.0;        ///< a pore ends where it is wider than this
  double Spacing = 0.25;         ///< of the planes
  double MinimumRadius = 1.0;    ///< of pores that are found by themselves
  double MinimumSpan = 20.0;     ///< distance of their ends
  std::size_t MaximumPores = 20; ///< of those, the ones with the longest spans
  double MaximumOffset = 10.0;   ///< between two points: distance of the way from the straight line
  /// Called with the seconds that the triangulation is going to take (RegularFiltration.h).
  std::function<void(double)> Predicted;
};

/// The largest ball in a plane across a pore.
struct PoreSample
{
  Point3 Centre;
  double Radius = 0.0;
  double ArcLength = 0.0; ///< along the centres
  std::int64_t NearestAtom = -1;
};

struct Pore
{
  std::vector<PoreSample> Samples;
  std::vector<std::size_t> Bottlenecks; ///< samples that are local minima, the narrowest first
  double Span = 0.0;                    ///< distance of the first sample from the last
};

}

#endif
