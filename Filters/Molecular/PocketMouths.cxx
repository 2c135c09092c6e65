#include "PocketMouths.h"

#include "DisjointSets.h"
#include "Index.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace isthmus
{
namespace
{

/// Area of a triangle that is not covered by the discs which its corners' balls are in its plane.
double OpenArea(const RegularFiltration& f, SimplexId triangle)
{
  const CellFiltration& c = f.Complex;
  const auto t = c.TrianglePoints(At(triangle));
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
    if (c.EdgeValue[At(c.TriangleEdges[At(triangle)][(k + 2) % 3])] <= 0.0)
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
  const RegularFiltration& f, const CellAccess& access, const std::vector<SimplexId>& open)
{
  DisjointSets<std::size_t> sets(open.size());
  std::map<SimplexId, std::size_t> firstAt;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    for (const SimplexId edge : f.Complex.TriangleEdges[At(open[i])])
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
    const auto t = f.Complex.TrianglePoints(At(open[i]));
    const double clearance = access.TriangleClearance[At(open[i])];
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

void AddMouths(const RegularFiltration& f, const CellAccess& access,
  const std::vector<SimplexId>& labels, double inner, std::vector<Pocket>& pockets)
{
  std::vector<std::vector<SimplexId>> open(pockets.size());
  for (std::size_t i = 0; i < f.Complex.TriangleCount(); ++i)
  {
    const auto sides = f.Complex.TriangleSides(i);
    const SimplexId a = sides[0] < 0 ? -1 : labels[At(sides[0])];
    const SimplexId b = sides[1] < 0 ? -1 : labels[At(sides[1])];
    if (a != b && access.TriangleClearance[i] > inner)
    {
      for (const SimplexId pocket : { a, b })
      {
        if (pocket >= 0)
        {
          open[At(pocket)].push_back(static_cast<SimplexId>(i));
        }
      }
    }
  }
  for (std::size_t i = 0; i < pockets.size(); ++i)
  {
    pockets[i].Mouths = Group(f, access, open[i]);
  }
}

}
