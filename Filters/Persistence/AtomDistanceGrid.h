/**
 * @file AtomDistanceGrid.h
 * @brief The grid method of X. Feng, PhD thesis, 6.4 and 6.5, for fullerenes: the distance from the
 * nearest atom on a grid, and its bars. For comparison; AlphaBars() (FullereneStability.h) is
 * exact.
 */
#ifndef isthmus_AtomDistanceGrid_h
#define isthmus_AtomDistanceGrid_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <array>

namespace isthmus
{

/// Parameters for sampling the distance from the atoms on a grid. Lengths are in the unit of the
/// points.
struct GridDistanceParameters
{
  double Spacing = 0.2;      ///< of the nodes
  double Theta = 2.0;        ///< distances beyond it are not computed
  bool FastMarching = false; ///< as in the thesis, first order; else the exact distance
};

/// @throws std::invalid_argument with property, value and range; so does the other function of this
/// name.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void Check(const GridDistanceParameters& parameters);

/// Values at nodes, x fastest, clamped at the greatest distance requested.
struct AtomDistances
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  Point3 Origin{};
  double Spacing = 1.0;
  std::vector<float> Values;
};

/// The distance that GridBars() describes. The grid reaches Theta beyond the outermost atom. Cost:
/// about (Theta / Spacing)^3 steps for each atom with exact distances, O(nodes log nodes) for each
/// type with fast marching; 4 to 13 bytes for each node. The result is the same on any number of
/// threads.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT AtomDistances AtomDistance(const std::vector<Point3>& atoms,
  const std::vector<double>& scales, const GridDistanceParameters& parameters,
  const ProgressCallback& progress = {});

/// A class of the growing balls: dimension 1 (a ring) or 2 (a cage), from distance to distance.
struct DistanceBar
{
  int Dimension = 1;
  double Birth = 0.0;
  double Death = 0.0;

  double Length() const { return this->Death - this->Birth; }
};

/**
 * Bars of dimension 1 and 2 of the union of balls around the atoms, by the cubical complex of the
 * distance on a grid, up to Theta (X. Feng, PhD thesis, 6.4 and 6.5). A bar that reaches Theta ends
 * there.
 *
 * The distance is that to the nearest atom, or the least of distance / scale where `scales` (one
 * per atom, the radius of its type) is not empty. With FastMarching each type has an eikonal
 * equation of its own, solved from the nodes round its atoms. Births and deaths have errors of up
 * to sqrt(3)/2 spacings, and bars shorter than one or two spacings are artefacts of the grid.
 *
 * Throws std::invalid_argument for parameters or atoms that are not finite or not positive, and
 * std::runtime_error for a grid of more than 2^31 nodes.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<DistanceBar> GridBars(
  const std::vector<Point3>& atoms, const std::vector<double>& scales,
  const GridDistanceParameters& parameters, const ProgressCallback& progress = {});

/// Sorts by dimension, then by length, the longest first.
void SortBars(std::vector<DistanceBar>& bars);

}

#endif
