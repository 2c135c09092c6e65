/**
 * @file SelfIntersections.h
 * @brief Which triangles of a surface cross or touch another one.
 */
#ifndef isthmus_SelfIntersections_h
#define isthmus_SelfIntersections_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersRemeshingModule.h"

namespace isthmus
{

/**
 * Ids of all triangles that cross or touch another one other than in a shared edge or point, or
 * that have no area, in ascending order; the answer of CGAL's Polygon_mesh_processing, exact.
 *
 * Pairs come from a tree of boxes (TriangleBoxTree). A plane that separates the two, with a margin
 * above what rounding can do, decides nearly all of them, flat neighbours included; CGAL's exact
 * predicates decide the rest.
 *
 * Corners must exist and points be finite (std::invalid_argument for coordinates beyond 1e100).
 * O(n log n + pairs of boxes), parallel; about 120 bytes a triangle.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT std::vector<std::int64_t> SelfIntersections(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

}

#endif
