/**
 * @file SurfaceDistance.h
 * @brief Distance to a triangle surface at points and at the nodes of a grid.
 */
#ifndef isthmus_SurfaceDistance_h
#define isthmus_SurfaceDistance_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceCrossings.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/// Unsigned distance of each point to the nearest point of any triangle, by a TriangleTree, in
/// parallel and bitwise the same on any number of threads.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<double> SurfaceDistances(const SurfaceView& surface,
  const std::vector<Point3>& points, const ProgressCallback& progress = {});

/// A regular grid over a box.
struct DistanceGrid
{
  Point3 Origin{ 0, 0, 0 };
  double Spacing = 0.0;
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::vector<double> Values; ///< x fastest

  /// Trilinear interpolation; p is clamped to the grid.
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT double At(const Point3& p) const;
};

inline GridShape GetGridShape(const DistanceGrid& grid)
{
  return { grid.Dimensions, { grid.Spacing, grid.Spacing, grid.Spacing } };
}

/**
 * Distance to the surface at the nodes of a grid over `box`; `cells` is the number of cells along
 * its longest side.
 *
 * It is computed by DistanceToSurface(): exact within two spacings h of the surface, and farther
 * away too large by at most about h^2 / (2 distance), which is also the possible error of trilinear
 * interpolation.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT DistanceGrid ComputeDistanceGrid(const SurfaceView& surface,
  const Bounds3& box, std::int64_t cells, const ProgressCallback& progress = {});

}

#endif
