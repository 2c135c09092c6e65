#include "Core/PolyDataTriangles.h"
#include "Core/ArrayMemory.h"

#include "Core/ParallelFor.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolygon.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Calls `visit(corners, ids, cell)` for each cell of `cells`, counting cells from `first`.
template <typename Visit>
void ForEachCell(vtkCellArray* cells, vtkIdType first, Visit&& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(corners, ids);
    visit(corners, ids, first + iterator->GetCurrentCellId());
  }
}

bool IsAllTriangles(vtkPolyData* surface)
{
  return surface->GetNumberOfStrips() == 0 &&
    (surface->GetNumberOfPolys() == 0 || surface->GetPolys()->IsHomogeneous() == 3);
}

}

PolyDataTriangles::PolyDataTriangles(vtkPolyData* surface, Damage damage)
  : FirstCell(surface->GetNumberOfVerts() + surface->GetNumberOfLines())
  , OnDamage(damage)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  this->Mesh.Points.resize(At(points));
  ParallelFor(0, points, 16384,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        surface->GetPoints()->GetPoint(point, this->Mesh.Points[At(point)].data());
      }
    });
  this->Mesh.Triangles.reserve(At(surface->GetNumberOfPolys()));
  if (IsAllTriangles(surface))
  {
    this->CopyTriangles(surface);
  }
  else
  {
    this->Cells.reserve(At(surface->GetNumberOfPolys()));
    this->AddPolygons(surface);
    this->AddStrips(surface);
  }
  if (damage == Damage::Refused)
  {
    this->CheckPoints();
  }
}

void PolyDataTriangles::CopyTriangles(vtkPolyData* surface)
{
  ForEachCell(surface->GetPolys(), this->FirstCell,
    [&](vtkIdType corners, const vtkIdType* ids, vtkIdType cell)
    {
      if (this->OnDamage == Damage::Refused)
      {
        this->CheckCorners(ids, corners, cell);
      }
      this->Mesh.Triangles.push_back({ ids[0], ids[1], ids[2] });
    });
}

void PolyDataTriangles::AddPolygons(vtkPolyData* surface)
{
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> split;
  vtkNew<vtkPoints> places; // vtkCell's call, which all versions have, asks for them
  ForEachCell(surface->GetPolys(), this->FirstCell,
    [&](vtkIdType corners, const vtkIdType* ids, vtkIdType cell)
    {
      this->CheckCorners(ids, corners, cell);
      if (corners == 3)
      {
        this->AddTriangle(ids[0], ids[1], ids[2], cell);
        return;
      }
      bool isSplit = false;
      split->Reset();
      if (corners > 3)
      {
        polygon->Initialize(static_cast<int>(corners), ids, surface->GetPoints());
        isSplit = polygon->Triangulate(0, split, places) != 0;
      }
      if (!isSplit && this->OnDamage == Damage::Refused)
      {
        throw std::invalid_argument("Cell " + std::to_string(cell) + " with " +
          std::to_string(corners) +
          " corners can't be split into triangles: it is flat, folded or "
          "crosses itself. Remove it (Clean) or triangulate the surface first (Triangulate).");
      }
      for (vtkIdType i = 0; i + 2 < split->GetNumberOfIds(); i += 3)
      {
        this->AddTriangle(split->GetId(i), split->GetId(i + 1), split->GetId(i + 2), cell);
      }
    });
}

void PolyDataTriangles::AddStrips(vtkPolyData* surface)
{
  ForEachCell(surface->GetStrips(), this->FirstCell + surface->GetNumberOfPolys(),
    [&](vtkIdType corners, const vtkIdType* ids, vtkIdType cell)
    {
      this->CheckCorners(ids, corners, cell);
      for (vtkIdType i = 0; i + 2 < corners; ++i)
      {
        // Every second triangle of a strip runs the other way round; it begins as in VTK.
        const vtkIdType odd = i % 2;
        this->AddTriangle(ids[i + odd], ids[i + 1 - odd], ids[i + 2], cell);
      }
    });
}

void PolyDataTriangles::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
{
  this->Mesh.Triangles.push_back({ a, b, c });
  this->Cells.push_back(cell);
}

void PolyDataTriangles::CheckCorners(
  const vtkIdType* corners, vtkIdType count, vtkIdType cell) const
{
  const auto points = static_cast<vtkIdType>(this->Mesh.Points.size());
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (corners[i] < 0 || corners[i] >= points)
    {
      throw std::invalid_argument("Cell " + std::to_string(cell) + " has the corner " +
        std::to_string(corners[i]) + ", but the surface has " + std::to_string(points) +
        " points, counted from 0. The file is damaged.");
    }
  }
}

void PolyDataTriangles::CheckPoints() const
{
  for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
  {
    for (const vtkIdType point : this->Mesh.Triangles[t])
    {
      const Point3& x = this->Mesh.Points[At(point)];
      if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
      {
        throw std::invalid_argument("Point " + std::to_string(point) +
          " of the surface, a corner of "
          "cell " +
          std::to_string(this->CellOf(static_cast<vtkIdType>(t))) +
          ", has a coordinate that is not a finite "
          "number. Remove the cell or repair the file.");
      }
    }
  }
}

TriangleMesh MeshOf(vtkPolyData* surface)
{
  return PolyDataTriangles(surface, PolyDataTriangles::Damage::Kept).TakeMesh();
}

void SetMesh(const SurfaceView& mesh, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  SizePoints(points, mesh.NumberOfPoints());
  for (vtkIdType i = 0; i < mesh.NumberOfPoints(); ++i)
  {
    points->SetPoint(i, mesh.Point(i).data());
  }
  vtkNew<vtkCellArray> cells;
  ReserveCells(cells, mesh.NumberOfTriangles(), 3 * mesh.NumberOfTriangles());
  for (const Triangle& t : mesh.Triangles)
  {
    cells->InsertNextCell(3, t.data());
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
}

}
