#include "PolyDataTriangles.h"

#include "ParallelFor.h"

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

}

PolyDataTriangles::PolyDataTriangles(vtkPolyData* surface)
{
  const vtkIdType points = surface->GetNumberOfPoints();
  this->Points.resize(3 * static_cast<std::size_t>(points));
  ParallelFor(0, points, 16384,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType point = first; point < last; ++point)
      {
        surface->GetPoints()->GetPoint(point, this->Points.data() + 3 * point);
      }
    });
  const auto cells = static_cast<std::size_t>(surface->GetNumberOfPolys());
  this->Triangles.reserve(3 * cells);
  this->Cells.reserve(cells);
  this->AddPolygons(surface);
  this->AddStrips(surface);
  this->CheckPoints();
}

SurfaceView PolyDataTriangles::View() const
{
  return { this->Points.data(), static_cast<vtkIdType>(this->Points.size() / 3),
    this->Triangles.data(), static_cast<vtkIdType>(this->Cells.size()) };
}

vtkIdType PolyDataTriangles::CellOf(vtkIdType triangle) const
{
  return this->Cells[static_cast<std::size_t>(triangle)];
}

void PolyDataTriangles::AddPolygons(vtkPolyData* surface)
{
  vtkNew<vtkPolygon> polygon;
  vtkNew<vtkIdList> split;
  vtkNew<vtkPoints> places; // vtkCell's call, which all versions have, asks for them
  ForEachCell(surface->GetPolys(), surface->GetNumberOfVerts() + surface->GetNumberOfLines(),
    [&](vtkIdType corners, const vtkIdType* ids, vtkIdType cell)
    {
      if (corners == 3)
      {
        this->AddTriangle(ids[0], ids[1], ids[2], cell);
        return;
      }
      for (vtkIdType corner = 0; corner < corners; ++corner)
      {
        this->CheckCorner(ids[corner], cell);
      }
      polygon->Initialize(static_cast<int>(corners), ids, surface->GetPoints());
      if (corners < 3 || polygon->Triangulate(0, split, places) == 0)
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
  const vtkIdType before =
    surface->GetNumberOfVerts() + surface->GetNumberOfLines() + surface->GetNumberOfPolys();
  ForEachCell(surface->GetStrips(), before,
    [&](vtkIdType corners, const vtkIdType* ids, vtkIdType cell)
    {
      for (vtkIdType i = 0; i + 2 < corners; ++i)
      {
        // Every second triangle of a strip runs the other way round.
        const vtkIdType odd = i % 2;
        this->AddTriangle(ids[i], ids[i + 1 + odd], ids[i + 2 - odd], cell);
      }
    });
}

void PolyDataTriangles::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
{
  for (const vtkIdType corner : { a, b, c })
  {
    this->CheckCorner(corner, cell);
    this->Triangles.push_back(corner);
  }
  this->Cells.push_back(cell);
}

void PolyDataTriangles::CheckCorner(vtkIdType corner, vtkIdType cell) const
{
  const auto points = static_cast<vtkIdType>(this->Points.size() / 3);
  if (corner < 0 || corner >= points)
  {
    throw std::invalid_argument("Cell " + std::to_string(cell) + " has the corner " +
      std::to_string(corner) + ", but the surface has " + std::to_string(points) +
      " points, counted from 0. The file is damaged.");
  }
}

void PolyDataTriangles::CheckPoints() const
{
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const vtkIdType point = this->Triangles[i];
    const double* const x = this->Points.data() + 3 * point;
    if (!std::isfinite(x[0]) || !std::isfinite(x[1]) || !std::isfinite(x[2]))
    {
      throw std::invalid_argument("Point " + std::to_string(point) +
        " of the surface, a corner of "
        "cell " +
        std::to_string(this->Cells[i / 3]) +
        ", has a coordinate that is not a finite "
        "number. Remove the cell or repair the file.");
    }
  }
}

}
