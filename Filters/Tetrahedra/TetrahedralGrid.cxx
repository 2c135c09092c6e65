#include "Tetrahedra/TetrahedralGrid.h"
#include "Core/ArrayMemory.h"
#include "Core/NamedColumns.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

namespace isthmus
{

void SetGrid(const TetrahedralMesh& mesh, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  SizePoints(points, static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  const auto count = static_cast<vtkIdType>(mesh.Tetrahedra.size());
  vtkNew<vtkCellArray> cells;
  ReserveCells(cells, count, 4 * count);
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    cells->InsertNextCell({ t[0], t[1], t[2], t[3] });
  }
  grid->SetPoints(points);
  SetCellsOfType(grid, VTK_TETRA, cells);
  AddColumn<vtkIdTypeArray>(grid->GetPointData(), "OriginalPointId", mesh.OriginalPoints);
  AddColumn<vtkIntArray>(grid->GetCellData(), "RegionId", mesh.Regions);
  grid->GetCellData()->SetActiveScalars("RegionId");
}

}
