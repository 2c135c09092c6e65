#include "CellAccess.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace isthmus
{
namespace
{

template <std::size_t N>
double Clearance(
  const RegularFiltration& f, const std::array<SimplexId, N>& corners, double value, double probe)
{
  double largest = 0.0;
  for (const SimplexId p : corners)
  {
    largest = std::max(largest, f.Radii[At(p)]);
  }
  return std::sqrt(std::max(0.0, value + largest * largest)) - (largest - probe);
}

/// A way that has reached `Cell` through `Triangle`.
struct Way
{
  double Width;
  SimplexId Cell;
  SimplexId Triangle;

  /// The widest comes first, then the lowest ids.
  bool operator<(const Way& other) const
  {
    if (this->Width != other.Width)
    {
      return this->Width < other.Width;
    }
    return this->Cell != other.Cell ? this->Cell > other.Cell : this->Triangle > other.Triangle;
  }
};

}

CellAccess FindAccess(
  const RegularFiltration& f, const std::vector<std::array<SimplexId, 4>>& faces, double probe)
{
  const CellFiltration& c = f.Complex;
  CellAccess access;
  access.CellClearance.resize(c.Tetrahedra.size());
  for (std::size_t i = 0; i < c.Tetrahedra.size(); ++i)
  {
    access.CellClearance[i] = Clearance(f, c.Tetrahedra[i], c.TetrahedronValue[i], probe);
  }
  access.TriangleClearance.resize(c.TriangleCount());
  std::priority_queue<Way> ways;
  for (std::size_t i = 0; i < c.TriangleCount(); ++i)
  {
    access.TriangleClearance[i] = Clearance(f, c.TrianglePoints(i), c.TriangleValue[i], probe);
    const auto sides = c.TriangleSides(i);
    if (sides[0] < 0 || sides[1] < 0)
    {
      ways.push(
        { access.TriangleClearance[i], std::max(sides[0], sides[1]), static_cast<SimplexId>(i) });
    }
  }
  access.Access.assign(c.Tetrahedra.size(), 0.0);
  access.TowardsOut.assign(c.Tetrahedra.size(), -1);
  while (!ways.empty())
  {
    const Way way = ways.top();
    ways.pop();
    if (access.TowardsOut[At(way.Cell)] >= 0)
    {
      continue;
    }
    access.TowardsOut[At(way.Cell)] = way.Triangle;
    const double width = std::min(way.Width, access.CellClearance[At(way.Cell)]);
    access.Access[At(way.Cell)] = width;
    for (const SimplexId triangle : faces[At(way.Cell)])
    {
      const SimplexId next = Across(c, triangle, way.Cell);
      if (next >= 0 && access.TowardsOut[At(next)] < 0)
      {
        ways.push({ std::min(width, access.TriangleClearance[At(triangle)]), next, triangle });
      }
    }
  }
  return access;
}

}
