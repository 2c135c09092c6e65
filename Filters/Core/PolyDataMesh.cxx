#include "Core/PolyDataMesh.h"

#include "Core/PolyDataTriangles.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>

namespace isthmus
{

TriangleMesh MeshOf(vtkPolyData* surface)
{
  return PolyDataTriangles(surface, PolyDataTriangles::Damage::Kept).TakeMesh();
}

void SetMesh(const SurfaceView& mesh, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.NumberOfPoints());
  for (vtkIdType i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh.Point(i).data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.NumberOfTriangles(), 3 * mesh.NumberOfTriangles());
  for (const Triangle& t : mesh.Triangles)
  {
    cells->InsertNextCell(3, t.data());
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
}

}
