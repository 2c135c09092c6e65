#include "ChokeSurroundings.h"

#include "Index.h"

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
  const TetrahedronId beyond = this->F.Across(triangle, this->Met[from]);
  const CellPlace other = this->Meet(beyond);
  if (!beyond.Exists() || other > from)
  {
    this->Link(triangle, from, other);
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
    const auto own = CellPlace::At(this->Passed);
    const TetrahedronId cell = this->Met[own];
    if (cell.Exists())
    {
      ForFaces(this->F, cell,
        [&](TriangleId t)
        {
          if (!this->Context.IsWall(t))
          {
            this->Cross(t, own);
          }
        });
    }
  }
  return !this->Beyond.empty();
}

}
