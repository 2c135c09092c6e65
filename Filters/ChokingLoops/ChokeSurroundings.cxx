#include "ChokeSurroundings.h"

#include "Index.h"

#include <cmath>

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

bool ChokeSurroundings::Collect(double reach, std::size_t most)
{
  this->Reach = reach;
  this->Places.Clear();
  this->Met.clear();
  this->All.clear();
  for (const TetrahedronId cell : this->F.TriangleSides(this->Choke))
  {
    this->Meet(cell);
  }
  bool isPart = false;
  for (std::size_t i = 0; i < this->Met.size() && this->Met.size() <= most; ++i)
  {
    const auto own = CellPlace::At(i);
    const TetrahedronId cell = this->Met[own];
    if (!cell.Exists())
    {
      continue;
    }
    ForFaces(this->F, cell,
      [&](TriangleId t)
      {
        if (this->Context.IsWall(t))
        {
          return;
        }
        if (!this->IsWithinReach(t))
        {
          isPart = true;
          return;
        }
        const TetrahedronId beyond = this->F.Across(t, cell);
        const CellPlace other = this->Meet(beyond);
        if (!beyond.Exists() || other > own)
        {
          this->Link(t, own, other);
        }
      });
  }
  return isPart;
}

}
