/**
 * @file FlatTriangles.h
 * @brief Takes triangles without area out of a surface, and nothing moves.
 */
#ifndef isthmus_FlatTriangles_h
#define isthmus_FlatTriangles_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/**
 * `surface` without triangles that have no area, as a set of points the same.
 *
 * Those with a corner twice are left out. Of one whose corners a, b, c lie on a line, b between the
 * others, the neighbour (c, a, d) across the side ac is split at b: (c, b, d) and (b, a, d) stand
 * for both; at a border it is left out. It stays, to be told by FindDefects, where an edge bd is
 * there already or ac has more than two triangles.
 *
 * @pre corners exist and are finite, and no two points are at one place (MergePoints).
 * O(n log n) for each layer of flat triangles upon each other, of which 16 are tried.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh WithoutFlatTriangles(TriangleMesh surface);

}

#endif
