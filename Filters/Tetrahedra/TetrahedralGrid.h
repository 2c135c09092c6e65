/**
 * @file TetrahedralGrid.h
 * @brief Converts TetrahedralMesh to vtkUnstructuredGrid, for the VTK classes of this module.
 */
#ifndef isthmus_TetrahedralGrid_h
#define isthmus_TetrahedralGrid_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"

class vtkUnstructuredGrid;

namespace isthmus
{

/// Sets `grid` to the points (double) and tetrahedra of `mesh`, with the cell array RegionId (its
/// scalars) and the point array OriginalPointId.
void SetGrid(const TetrahedralMesh& mesh, vtkUnstructuredGrid* grid);

}

#endif
