/**
 * @file MiddleNodes.h
 * @brief The nodes of quadratic cells in VTK's order, whatever the order of the file.
 *
 * Programs agree on the corners of a quadratic cell, which come first, and not on the order of the
 * nodes on its edges, faces and in its middle (libMeshb, Gmsh and TetGen all differ for
 * tetrahedra). Those lie near the mean of the corners around them, which decides.
 */
#ifndef isthmus_MiddleNodes_h
#define isthmus_MiddleNodes_h

#include "Meshes/CellMesh.h"

#include <cstddef>

namespace isthmus
{

/**
 * Reorders the nodes behind the corners of cells [first, last), which have one shape and one order:
 * that for which the sum of squared distances to the means of corners is smallest. Where that is
 * ambiguous (all points in one place), they stay as they are. Shapes without such nodes stay, too.
 * @pre all vertices are valid. Time O(cells).
 */
void OrderMiddleNodes(CellMesh& mesh, std::size_t first, std::size_t last);

}

#endif
