#include "ChokingLoops/GridTetrahedra.h"

#include <vtkCellType.h>
#include <vtkUnstructuredGrid.h>

#include <stdexcept>
#include <string>

namespace isthmus
{

TetrahedralMesh TetrahedraOf(vtkUnstructuredGrid* grid)
{
  TetrahedralMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_TETRA)
    {
      throw std::invalid_argument("Cell " + std::to_string(c) +
        " of the tetrahedral mesh is no tetrahedron: tetrahedralize it first.");
    }
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    grid->GetCellPoints(c, count, p);
    mesh.Tetrahedra.push_back({ p[0], p[1], p[2], p[3] });
  }
  if (mesh.Tetrahedra.empty())
  {
    throw std::invalid_argument("The second input has no tetrahedra: give a mesh of one side of "
                                "the surface or both, or leave it empty.");
  }
  return mesh;
}

}
