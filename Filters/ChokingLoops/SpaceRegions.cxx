#include "ChokingLoops/SpaceRegions.h"

#include "Core/Index.h"

namespace isthmus
{
SpaceRegions::SpaceRegions(const FeatureContext& context, const ProgressCallback& progress)
  : Context(context)
  , Groups(context.Filtration.Tetrahedra.size())
  , Test(context.Surface.Mesh(), context.Homology)
{
  const CellFiltration& f = context.Filtration;
  for (const TriangleId t : f.Triangles())
  {
    if (t.Index() % (1U << 18) == 0)
    {
      Report(progress, static_cast<double>(t.Index()) / static_cast<double>(f.TriangleCount()));
    }
    const auto sides = f.TriangleSides(t);
    if (sides[0].Exists() && sides[1].Exists() && !context.IsWall(t))
    {
      const TetrahedronId a = this->Groups.Find(sides[0]);
      const TetrahedronId b = this->Groups.Find(sides[1]);
      const bool later = f.EntersLater(a, b);
      this->Groups.JoinUnder(later ? b : a, later ? a : b);
    }
  }
}

const std::vector<int>& SpaceRegions::Of(TetrahedronId cell)
{
  static const std::vector<int> none;
  if (!cell.Exists())
  {
    return none;
  }
  const TetrahedronId group = this->Groups.Find(cell);
  auto known = this->Known.find(group);
  if (known == this->Known.end())
  {
    known = this->Known.emplace(group, this->Test.Enclosing(this->Inner(group))).first;
  }
  return known->second;
}

// In a Delaunay triangulation the circumcentre is what keeps its distance from M; in a mesh that
// conforms to M the tetrahedron itself lies on one side.
Point3 SpaceRegions::Inner(TetrahedronId deepest) const
{
  const CellFiltration& f = this->Context.Filtration;
  const auto& t = f.Tetrahedra[deepest];
  const Point3& p = f.Points[At(t[0])];
  const Point3& q = f.Points[At(t[1])];
  const Point3& r = f.Points[At(t[2])];
  const Point3& s = f.Points[At(t[3])];
  return this->Context.PointError.empty() ? 0.25 * (p + q + r + s) : Circumcentre(p, q, r, s);
}

Point3 Circumcentre(const Point3& p, const Point3& q, const Point3& r)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 n = Cross(a, b);
  const Point3 towards = Dot(a, a) * Cross(b, n) + Dot(b, b) * Cross(n, a);
  return p + (0.5 / Dot(n, n)) * towards;
}

Point3 Circumcentre(const Point3& p, const Point3& q, const Point3& r, const Point3& s)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 c = s - p;
  const Point3 sum = Dot(a, a) * Cross(b, c) + Dot(b, b) * Cross(c, a) + Dot(c, c) * Cross(a, b);
  return p + (0.5 / Dot(a, Cross(b, c))) * sum;
}

}
