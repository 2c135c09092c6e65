#include "Tetrahedra/TetrahedralGrid.h"
#include "Core/ArrayMemory.h"

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
  vtkNew<vtkIdTypeArray> original;
  original->SetName("OriginalPointId");
  SizeArray(original, points->GetNumberOfPoints());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
    original->SetValue(static_cast<vtkIdType>(i), mesh.OriginalPoints[i]);
  }
  const auto count = static_cast<vtkIdType>(mesh.Tetrahedra.size());
  vtkNew<vtkCellArray> cells;
  ReserveCells(cells, count, 4 * count);
  vtkNew<vtkIntArray> regions;
  regions->SetName("RegionId");
  SizeArray(regions, count);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    cells->InsertNextCell({ t[0], t[1], t[2], t[3] });
    regions->SetValue(static_cast<vtkIdType>(i), mesh.Regions[i]);
  }
  grid->SetPoints(points);
  SetCellsOfType(grid, VTK_TETRA, cells);
  grid->GetPointData()->AddArray(original);
  grid->GetCellData()->SetScalars(regions);
}

}
