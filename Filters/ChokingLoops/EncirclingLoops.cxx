#include "EncirclingLoops.h"

#include "SurfacePaths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace isthmus
{
namespace
{

/// A loop along edges: an edge closed through the tree of shortest paths.
struct Closed
{
  double Length;
  std::vector<SimplexId> Points;
};

HomologyClass Sum(HomologyClass a, const HomologyClass& b)
{
  std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::bit_xor<>());
  return a;
}

/// Shortest paths from one contact, and their classes, each closed through the same other paths.
class Tree
{
public:
  Tree(const FeatureContext& context, SimplexId base, double reach)
    : Context(context)
    , Base(base)
    , Paths(context.Surface, base, reach)
  {
    for (const SimplexId p : this->Paths.Points())
    {
      const HalfEdgeId last = this->Paths.Last(p);
      this->Classes.emplace(p,
        last.Exists() ? Sum(this->Classes.at(context.Surface.From(last)),
                          context.Homology.ClassOf({ context.Surface.Edge(last) }))
                      : context.Homology.ClassOf({}));
    }
  }

  SimplexId Root() const { return this->Base; }
  const SurfacePaths& Lengths() const { return this->Paths; }
  const HomologyClass& ClassTo(SimplexId p) const { return this->Classes.at(p); }

  /// From the root to p, both included.
  std::vector<SimplexId> PathTo(SimplexId p) const
  {
    std::vector<SimplexId> path{ p };
    for (HalfEdgeId last = this->Paths.Last(p); last.Exists(); last = this->Paths.Last(path.back()))
    {
      path.push_back(this->Context.Surface.From(last));
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  const FeatureContext& Context;
  SimplexId Base;
  SurfacePaths Paths;
  std::unordered_map<SimplexId, HomologyClass> Classes;
};

/// A closed walk whose last point is its first, as a loop; what it goes to and fro there, goes.
std::vector<SimplexId> LoopOf(const std::vector<SimplexId>& walk)
{
  std::size_t tail = 0;
  while (2 * (tail + 1) + 1 < walk.size() && walk[tail + 1] == walk[walk.size() - tail - 2])
  {
    ++tail;
  }
  return { walk.begin() + static_cast<std::ptrdiff_t>(tail),
    walk.end() - static_cast<std::ptrdiff_t>(tail + 1) };
}

/// The shortest loops that go straight from one contact to another (or the same) and come back,
/// one of each class in `bounding`.
std::vector<Closed> LoopsThrough(const FeatureContext& context, const HomologySpan& bounding,
  const Tree& one, const Tree& other, double longest)
{
  const SurfaceAdjacency& surface = context.Surface;
  std::map<HomologyClass, std::pair<double, HalfEdgeId>> best;
  if (!one.Lengths().Has(other.Root()))
  {
    return {};
  }
  const double straight = one.Lengths().Length(other.Root());
  const HomologyClass& out = one.ClassTo(other.Root());
  for (const SimplexId p : one.Lengths().Points())
  {
    const HalfEdgeId first = surface.Leaving(p);
    HalfEdgeId h = first;
    do
    {
      const SimplexId q = surface.To(h);
      const double length = other.Lengths().Has(q)
        ? straight + one.Lengths().Length(p) + surface.Length(h) + other.Lengths().Length(q)
        : HUGE_VAL;
      if (length <= longest)
      {
        const HomologyClass c = Sum(Sum(Sum(one.ClassTo(p), other.ClassTo(q)), out),
          context.Homology.ClassOf({ surface.Edge(h) }));
        const auto known =
          IsZero(c) ? best.end() : best.emplace(c, std::make_pair(HUGE_VAL, h)).first;
        if (known != best.end() && length < known->second.first)
        {
          known->second = { length, h };
        }
      }
      h = surface.Turn(h);
    } while (h != first);
  }
  std::vector<Closed> loops;
  for (const auto& [c, shortest] : best)
  {
    if (bounding.Contains(c))
    {
      // From `one` over the edge to `other`, and straight back.
      std::vector<SimplexId> walk = one.PathTo(surface.From(shortest.second));
      const std::vector<SimplexId> on = other.PathTo(surface.To(shortest.second));
      walk.insert(walk.end(), on.rbegin(), on.rend());
      const std::vector<SimplexId> back = one.PathTo(other.Root());
      walk.insert(walk.end(), back.rbegin() + 1, back.rend());
      loops.push_back({ shortest.first, LoopOf(walk) });
    }
  }
  return loops;
}

/// The fan that a loop bounds, seen from a point off M.
Membrane FanFrom(const FeatureContext& context, const Point3& centre, std::vector<SimplexId> loop)
{
  Membrane membrane;
  membrane.Extra.push_back(centre);
  const auto apex = static_cast<SimplexId>(context.Surface.Mesh().Points.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    membrane.Triangles.push_back({ loop[i], loop[(i + 1) % loop.size()], apex });
  }
  membrane.Loops.push_back(std::move(loop));
  return membrane;
}

std::vector<Tree> TreesOf(const FeatureContext& context, const ShapeFeature& f, double reach)
{
  std::vector<Tree> trees;
  for (const SimplexId p : context.Filtration.TrianglePoints(f.Choke))
  {
    if (context.Surface.Leaving(p).Exists())
    {
      trees.emplace_back(context, p, reach);
    }
  }
  return trees;
}

}

std::vector<Membrane> EncirclingMembranes(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  const HomologySpan bounding = BoundingClasses(context, features, f.Side);
  if (bounding.Rank() == 0)
  {
    return {};
  }
  const std::vector<Tree> trees = TreesOf(context, f, 0.5 * longest);
  std::vector<Closed> loops;
  for (std::size_t i = 0; i < trees.size(); ++i)
  {
    for (std::size_t j = i; j < trees.size(); ++j)
    {
      const auto found = LoopsThrough(context, bounding, trees[i], trees[j], longest);
      loops.insert(loops.end(), found.begin(), found.end());
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [](const Closed& a, const Closed& b) { return a.Length < b.Length; });
  std::vector<Membrane> membranes;
  for (Closed& loop : loops)
  {
    Membrane membrane = FanFrom(context, features.Centres[feature], std::move(loop.Points));
    if (IsInterchangeable(context, features, feature, membrane))
    {
      membranes.push_back(std::move(membrane));
    }
  }
  return membranes;
}

std::optional<Membrane> ContactMembrane(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  const std::vector<Tree> trees = TreesOf(context, f, longest);
  std::vector<SimplexId> loop;
  HomologyClass c = context.Homology.ClassOf({});
  for (std::size_t i = 0; i < trees.size(); ++i)
  {
    const SimplexId next = trees[(i + 1) % trees.size()].Root();
    if (!trees[i].Lengths().Has(next))
    {
      return std::nullopt;
    }
    const std::vector<SimplexId> path = trees[i].PathTo(next);
    loop.insert(loop.end(), path.begin(), path.end() - 1);
    c = Sum(c, trees[i].ClassTo(next));
  }
  Membrane membrane = FanFrom(context, features.Centres[feature], std::move(loop));
  const bool holds = membrane.Loops[0].size() >= 3 &&
    BoundingClasses(context, features, f.Side).Contains(c) &&
    IsInterchangeable(context, features, feature, membrane);
  return holds ? std::optional<Membrane>(std::move(membrane)) : std::nullopt;
}

}
