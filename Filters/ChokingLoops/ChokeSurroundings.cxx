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

std::int32_t ChokeSurroundings::Meet(SimplexId cell)
{
  const auto next = static_cast<std::int32_t>(this->Met.size());
  const auto [known, isNew] = this->Places.emplace(cell, next);
  if (isNew)
  {
    this->Met.push_back(cell);
  }
  return known->second;
}

Point3 ChokeSurroundings::Middle(SimplexId cell) const
{
  const auto& c = this->F.Tetrahedra[At(cell)];
  const auto p = [&](std::size_t k) -> const Point3& { return this->F.Points[At(c[k])]; };
  return this->Context.PointError.empty() ? 0.25 * (p(0) + p(1) + p(2) + p(3))
                                          : Circumcentre(p(0), p(1), p(2), p(3));
}

double ChokeSurroundings::Area(SimplexId triangle) const
{
  const auto t = this->F.TrianglePoints(At(triangle));
  return TriangleArea(this->F.Points[At(t[0])], this->F.Points[At(t[1])], this->F.Points[At(t[2])]);
}

void ChokeSurroundings::Link(SimplexId triangle, std::int32_t from, std::int32_t to)
{
  const double capacity =
    1.0 + CapacityOfRadius2 * this->Area(triangle) / (this->Radius * this->Radius);
  this->All.push_back(
    { { from, to }, static_cast<std::int64_t>(std::min(capacity, LargestCapacity)) });
  this->Linking.push_back(triangle);
}

bool ChokeSurroundings::Collect(double reach, std::size_t most)
{
  this->Reach = reach;
  this->Places.clear();
  this->Met.clear();
  this->Linking.clear();
  this->All.clear();
  for (const SimplexId cell : this->F.TriangleSides(At(this->Choke)))
  {
    this->Meet(cell);
  }
  bool isPart = false;
  for (std::size_t i = 0; i < this->Met.size() && this->Met.size() <= most; ++i)
  {
    const SimplexId cell = this->Met[i];
    if (cell < 0)
    {
      continue;
    }
    const auto own = static_cast<std::int32_t>(i);
    ForFaces(this->F, cell,
      [&](SimplexId t)
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
        const SimplexId beyond = this->Beyond(t, cell);
        const std::int32_t other = this->Meet(beyond);
        if (beyond < 0 || other > own)
        {
          this->Link(t, own, other);
        }
      });
  }
  return isPart;
}

}
