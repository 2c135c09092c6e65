/**
 * @file MiddleNodes.h
 * @brief The nodes of quadratic cells in VTK's order, whatever the order of the file.
 *
 * Programs agree on the corners of a quadratic cell, which come first, but not on the order of the
 * nodes on its edges, on its faces and in its center (libMeshb, Gmsh and TetGen all differ for
 * tetrahedra). The order is inferred from the positions, since these nodes lie near the mean of the
 * corners around them.
 */
#ifndef isthmus_MiddleNodes_h
#define isthmus_MiddleNodes_h

#include "Meshes/CellMesh.h"

#include <cstddef>

namespace isthmus
{

/**
 * Reorders the nodes after the corners of the cells [first, last), which must have the same shape
 * and the same order. The order is that for which the sum of squared distances to the means of
 * corners is smallest. If that is ambiguous (e.g. if all points coincide), they are not reordered.
 * Shapes without such nodes are not changed either.
 * @pre all vertices are valid. Time O(cells).
 */
void OrderMiddleNodes(CellMesh& mesh, std::size_t first, std::size_t last);

}

#endif
