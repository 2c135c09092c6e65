/**
 * @file GridTetrahedra.h
 * @brief The tetrahedra of a VTK grid, for a filtration by values on a mesh.
 */
#ifndef isthmus_GridTetrahedra_h
#define isthmus_GridTetrahedra_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"

class vtkUnstructuredGrid;

namespace isthmus
{

/// All points and cells of `grid`. O(cells).
/// @throws std::invalid_argument for a cell that is no tetrahedron, with its number, or for none.
TetrahedralMesh TetrahedraOf(vtkUnstructuredGrid* grid);

}

#endif
