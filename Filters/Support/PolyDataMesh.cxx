#include "PolyDataMesh.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace isthmus
{

namespace
{

/// vtkTriangleFilter follows corners wherever they point.
void DemandCorners(vtkCellArray* cells, vtkIdType points)
{
  const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      if (ids[i] < 0 || ids[i] >= points)
      {
        throw std::invalid_argument("A polygon of the surface has the corner " +
          std::to_string(ids[i]) + ", but there are " + std::to_string(points) +
          " points, counted from 0. The file is damaged.");
      }
    }
  }
}

}

TriangleMesh MeshOf(vtkPolyData* surface)
{
  vtkSmartPointer<vtkPolyData> triangles = surface;
  if (surface->GetNumberOfStrips() > 0 ||
    (surface->GetNumberOfPolys() > 0 && surface->GetPolys()->IsHomogeneous() != 3))
  {
    DemandCorners(surface->GetPolys(), surface->GetNumberOfPoints());
    DemandCorners(surface->GetStrips(), surface->GetNumberOfPoints());
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(surface->GetPoints());
    bare->SetPolys(surface->GetPolys());
    bare->SetStrips(surface->GetStrips());
    vtkNew<vtkTriangleFilter> filter;
    filter->PassVertsOff();
    filter->PassLinesOff();
    filter->SetInputData(bare);
    filter->Update();
    triangles = filter->GetOutput();
  }
  TriangleMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(triangles->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    triangles->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  mesh.Triangles.reserve(static_cast<std::size_t>(triangles->GetNumberOfPolys()));
  const auto cells = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    if (count == 3)
    {
      mesh.Triangles.push_back({ ids[0], ids[1], ids[2] });
    }
  }
  return mesh;
}

TriangleMesh MeshOf(const SurfaceView& surface)
{
  TriangleMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(surface.NumberOfPoints));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    std::copy_n(surface.Point(static_cast<vtkIdType>(i)), 3, mesh.Points[i].begin());
  }
  mesh.Triangles.resize(static_cast<std::size_t>(surface.NumberOfTriangles));
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    std::copy_n(surface.Triangle(static_cast<vtkIdType>(i)), 3, mesh.Triangles[i].begin());
  }
  return mesh;
}

void SetMesh(const TriangleMesh& mesh, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  vtkNew<vtkCellArray> cells;
  const auto count = static_cast<vtkIdType>(mesh.Triangles.size());
  cells->AllocateExact(count, 3 * count);
  for (const Triangle& t : mesh.Triangles)
  {
    cells->InsertNextCell({ t[0], t[1], t[2] });
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
}

}
