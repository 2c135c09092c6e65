#include "ChokingLoops/ChokeSurroundings.h"

#include "Core/Index.h"

#include <cmath>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double CapacityOfRadius2 = 1073741824.0; ///< of an area of one squared radius
constexpr double LargestCapacity = 1e12;           ///< so that a million of them can be added

}

CellPlace ChokeSurroundings::Meet(TetrahedronId cell)
{
  CellPlace& place = this->Places[cell];
  if (!place.Exists())
  {
    place = CellPlace::At(this->Met.size());
    this->Met.push_back(cell);
  }
  return place;
}

Point3 ChokeSurroundings::Middle(TetrahedronId cell) const
{
  const auto& c = this->F.Tetrahedra[cell];
  const auto p = [&](std::size_t k) -> const Point3& { return this->F.Points[At(c[k])]; };
  return this->Context.PointError.empty() ? 0.25 * (p(0) + p(1) + p(2) + p(3))
                                          : Circumcentre(p(0), p(1), p(2), p(3));
}

double ChokeSurroundings::Area(TriangleId triangle) const
{
  const auto t = this->F.TrianglePoints(triangle);
  return TriangleArea(this->F.Points[At(t[0])], this->F.Points[At(t[1])], this->F.Points[At(t[2])]);
}

void ChokeSurroundings::Link(TriangleId triangle, CellPlace from, CellPlace to)
{
  const double capacity =
    1.0 + CapacityOfRadius2 * this->Area(triangle) / (this->Radius * this->Radius);
  this->All.push_back(
    { { from, to }, static_cast<std::int64_t>(std::min(capacity, LargestCapacity)), triangle });
}

/// From a cell over one of its faces, if that is within reach.
void ChokeSurroundings::Cross(TriangleId triangle, CellPlace from)
{
  if (!this->IsWithinReach(triangle))
  {
    this->Beyond.emplace_back(triangle, from);
    return;
  }
  this->Link(triangle, from, this->Meet(this->F.Across(triangle, this->Met[from])));
}

/// Over the faces of a cell that were not met from their other side.
void ChokeSurroundings::Pass(CellPlace own)
{
  const TetrahedronId cell = this->Met[own];
  for (std::size_t corner = 0; cell.Exists() && corner < 4; ++corner)
  {
    const TetrahedronId beyond = this->F.Neighbours[cell][corner];
    const CellPlace place = beyond.Exists() ? this->PlaceOf(beyond) : CellPlace::None();
    if (place.Exists() && place < own)
    {
      continue;
    }
    const TriangleId triangle = this->F.TriangleOf(cell, corner);
    if (!this->Context.IsWall(triangle))
    {
      this->Cross(triangle, own);
    }
  }
}

bool ChokeSurroundings::Collect(double reach, std::size_t most)
{
  this->Reach = reach;
  for (const TetrahedronId cell : this->F.TriangleSides(this->Choke))
  {
    this->Meet(cell);
  }
  for (const auto& [triangle, cell] : std::exchange(this->Beyond, {}))
  {
    this->Cross(triangle, cell);
  }
  for (; this->Passed < this->Met.size() && this->Met.size() <= most; ++this->Passed)
  {
    this->Pass(CellPlace::At(this->Passed));
  }
  return !this->Beyond.empty();
}

}
