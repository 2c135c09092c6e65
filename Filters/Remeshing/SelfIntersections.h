/**
 * @file SelfIntersections.h
 * @brief Finds triangles of a surface that cross or touch another triangle.
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
 * that have no area, in ascending order. The result is exact and the same as that of CGAL's
 * Polygon_mesh_processing.
 *
 * Corners must exist and points be finite (std::invalid_argument for coordinates beyond 1e100).
 * O(n log n + pairs of boxes), parallel; about 120 bytes for each triangle.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT std::vector<std::int64_t> SelfIntersections(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

}

#endif
