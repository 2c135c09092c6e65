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

#include <algorithm>
#include <cmath>
#include <cstdint>
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

constexpr std::int64_t grain = 16384; // number of points or triangles in a piece of parallel work

/// The least of several numbers, for ParallelReduce.
struct Least
{
  std::int64_t Value;

  Least& operator+=(const Least& other)
  {
    this->Value = std::min(this->Value, other.Value);
    return *this;
  }
};

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
  ParallelFor(0, points, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        surface->GetPoints()->GetPoint(point, this->Mesh.Points[At(point)].data());
      }
    });
  if (IsAllTriangles(surface))
  {
    this->CopyTriangles(surface);
  }
  else
  {
    this->Mesh.Triangles.reserve(At(surface->GetNumberOfPolys()));
    this->Cells.reserve(At(surface->GetNumberOfPolys()));
    this->AddPolygons(surface);
    this->AddStrips(surface);
  }
  if (damage == Damage::Refused)
  {
    this->CheckPoints();
  }
}

template <typename Wrong>
vtkIdType PolyDataTriangles::FindFirstTriangle(const Wrong& isWrong) const
{
  const auto count = static_cast<std::int64_t>(this->Mesh.Triangles.size());
  return ParallelReduce(count, grain, Least{ count },
    [&](Least& least, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t t = first; t < last; ++t)
      {
        const Triangle& corners = this->Mesh.Triangles[At(t)];
        if (std::any_of(corners.begin(), corners.end(), isWrong))
        {
          least.Value = t;
          return;
        }
      }
    })
    .Value;
}

void PolyDataTriangles::CopyTriangles(vtkPolyData* surface)
{
  vtkCellArray* const cells = surface->GetPolys();
  const vtkIdType count = surface->GetNumberOfPolys();
  this->Mesh.Triangles.resize(At(count));
  ParallelFor(0, count, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      vtkNew<vtkIdList> copied; // for ids of 32 bits
      for (vtkIdType cell = first; cell < last; ++cell)
      {
        vtkIdType corners = 0;
        const vtkIdType* ids = nullptr;
        cells->GetCellAtId(cell, corners, ids, copied);
        this->Mesh.Triangles[At(cell)] = { ids[0], ids[1], ids[2] };
      }
    });
  if (this->OnDamage == Damage::Refused)
  {
    const auto points = static_cast<vtkIdType>(this->Mesh.Points.size());
    const vtkIdType wrong = this->FindFirstTriangle(
      [points](vtkIdType corner) { return corner < 0 || corner >= points; });
    if (wrong < count)
    {
      this->CheckCorners(this->Mesh.Triangles[At(wrong)].data(), 3, this->FirstCell + wrong);
    }
  }
}

void PolyDataTriangles::AddPolygons(vtkPolyData* surface)
{
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> split;
  vtkNew<vtkPoints> places; // vtkCell's call, which all versions have, requires them
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
  const auto isWrong = [this](vtkIdType point)
  {
    const Point3& x = this->Mesh.Points[At(point)];
    return !std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]);
  };
  const vtkIdType wrong = this->FindFirstTriangle(isWrong);
  if (wrong < static_cast<vtkIdType>(this->Mesh.Triangles.size()))
  {
    const Triangle& corners = this->Mesh.Triangles[At(wrong)];
    throw std::invalid_argument("Point " +
      std::to_string(*std::find_if(corners.begin(), corners.end(), isWrong)) +
      " of the surface, a corner of cell " + std::to_string(this->GetCellId(wrong)) +
      ", has a coordinate that is not a finite number. Remove the cell or repair the file.");
  }
}

TriangleMesh ToTriangleMesh(vtkPolyData* surface)
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
