/**
 * @file ShellNesting.h
 * @brief Nesting of closed shells: solids, cavities, and a point in each region.
 */
#ifndef isthmus_ShellNesting_h
#define isthmus_ShellNesting_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/// A connected part of space between shells, and a point strictly inside it.
struct SpaceRegion
{
  int Id = 0;
  Point3 Seed{ 0, 0, 0 };
  double Volume = 0.0; ///< of the region itself, what lies in it not counted
};

/**
 * The shells (connected components) of a closed surface and the regions they bound.
 *
 * A shell within an even number of others bounds a solid on its inner side, one within an odd
 * number a cavity, whatever the orientation of its triangles. Region ids: solids 1, 2, ...,
 * cavities
 * -1, -2, ..., in the order of their shells; the exterior is 0.
 */
struct ShellNesting
{
  std::vector<int> ShellOfTriangle;
  std::vector<TriangleMesh> Shells;      ///< each with its own points, facing outward
  std::vector<SpaceRegion> InnerRegions; ///< for each shell the region right inside it
  std::vector<int> OuterRegionIds;       ///< for each shell the region right outside it
};

/**
 * Nesting of the shells of `mesh`.
 * @pre it is free of defects and self-intersections.
 *
 * Containment is decided by the winding number (sum of solid angles / 4 pi) of one point of a shell
 * with respect to each other shell whose box contains it: O(s F) for s nested shells with F
 * triangles in total, and s^2 boxes. Points inside take O(F) in total.
 * @throws std::invalid_argument when a shell is too thin to find a point inside; Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT ShellNesting FindNesting(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// Bounding box of the points of `mesh` that triangles use.
VTKISTHMUSFILTERSSURFACES_EXPORT Bounds3 ComputeBounds(const SurfaceView& mesh);

}

#endif
