/**
 * @file ThinTriangles.h
 * @brief Finds triangles that are nearly degenerate, and removes them from a surface.
 */
#ifndef isthmus_ThinTriangles_h
#define isthmus_ThinTriangles_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersRemeshingModule.h" // for the export macro

namespace isthmus
{

/// Ids of triangles whose height is less than a millionth of their longest edge, ascending. O(n).
/// @pre corners exist and are finite.
VTKISTHMUSFILTERSREMESHING_EXPORT std::vector<std::int64_t> ThinTriangles(const SurfaceView& mesh);

/**
 * `mesh` with needles collapsed and caps flipped, as CGAL's Polygon_mesh_processing does it; no
 * point moves farther than a hundred-thousandth of the diagonal of the box. Some may remain: call
 * it again. Throws std::runtime_error with a message if CGAL fails.
 *
 * @pre closed, manifold and oriented. O(n log n).
 */
VTKISTHMUSFILTERSREMESHING_EXPORT TriangleMesh RemoveThinTriangles(const SurfaceView& mesh);

}

#endif
