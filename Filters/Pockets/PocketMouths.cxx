#include "Pockets/PocketMouths.h"

#include "Core/DisjointSets.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace isthmus
{
namespace
{

/// Area of a triangle that is not covered by the discs which its corners' balls are in its plane.
double OpenArea(const RegularFiltration& f, TriangleId triangle)
{
  const CellFiltration& c = f.Complex;
  const auto t = c.TrianglePoints(triangle);
  double area = TriangleArea(c.Points[At(t[0])], c.Points[At(t[1])], c.Points[At(t[2])]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Point3& p = c.Points[At(t[k])];
    const SimplexId second = t[(k + 1) % 3];
    const Point3 u = c.Points[At(second)] - p;
    const Point3 v = c.Points[At(t[(k + 2) % 3])] - p;
    const Point3 normal = Cross(u, v);
    const double r = f.Radii[At(t[k])];
    if (f.VertexValue[At(t[k])] <= 0.0)
    {
      area -= 0.5 * std::atan2(Length(normal), Dot(u, v)) * r * r;
    }
    if (c.EdgeValue[c.TriangleEdges[triangle][(k + 2) % 3]] <= 0.0)
    {
      // Half of the lens of two discs, as segments beyond their common chord.
      const double q = f.Radii[At(second)];
      const double d = Length(u);
      const double chord = 0.5 * (d + (r - q) * (r + q) / d);
      const auto segment = [](double radius, double height)
      {
        const double x = std::clamp(height / radius, -1.0, 1.0);
        return radius * radius * (std::acos(x) - x * std::sqrt(1.0 - x * x));
      };
      area += 0.5 * (segment(r, chord) + segment(q, d - chord));
    }
  }
  return area;
}

/// The open triangles of one pocket, in their order, with the group of each.
std::vector<PocketMouth> Group(
  const RegularFiltration& f, const CellAccess& access, const TriangleChain& open)
{
  DisjointSets<std::size_t> sets(open.size());
  std::map<EdgeId, std::size_t> firstAt;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    for (const EdgeId edge : f.Complex.TriangleEdges[open[i]])
    {
      sets.Join(firstAt.emplace(edge, i).first->second, i);
    }
  }
  std::map<std::size_t, std::size_t> numberOf;
  std::vector<PocketMouth> mouths;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    const auto number = numberOf.emplace(sets.Find(i), mouths.size());
    if (number.second)
    {
      mouths.emplace_back();
    }
    PocketMouth& mouth = mouths[number.first->second];
    const auto t = f.Complex.TrianglePoints(open[i]);
    const double clearance = access.TriangleClearance[open[i]];
    mouth.Radius = std::max(mouth.Radius, clearance);
    mouth.Area += OpenArea(f, open[i]);
    mouth.Triangles.push_back({ t[0], t[1], t[2] });
    mouth.Clearance.push_back(clearance);
  }
  std::stable_sort(mouths.begin(), mouths.end(),
    [](const PocketMouth& a, const PocketMouth& b) { return a.Radius > b.Radius; });
  return mouths;
}

}

void AddMouths(const RegularFiltration& f, const CellAccess& access, const PocketByCell& labels,
  double inner, std::vector<Pocket>& pockets)
{
  HandleVector<PocketNumber, TriangleChain> open(pockets.size());
  const auto pocketOf = [&labels](TetrahedronId cell)
  { return cell.Exists() ? labels[cell] : PocketNumber::None(); };
  for (const TriangleId t : f.Complex.Triangles())
  {
    const auto sides = f.Complex.TriangleSides(t);
    const PocketNumber a = pocketOf(sides[0]);
    const PocketNumber b = pocketOf(sides[1]);
    if (a != b && access.TriangleClearance[t] > inner)
    {
      for (const PocketNumber pocket : { a, b })
      {
        if (pocket.Exists())
        {
          open[pocket].push_back(t);
        }
      }
    }
  }
  for (std::size_t i = 0; i < pockets.size(); ++i)
  {
    pockets[i].Mouths = Group(f, access, open[PocketNumber::At(i)]);
  }
}

}
