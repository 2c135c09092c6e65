#include "EncirclingLoops.h"

#include "SurfacePaths.h"

#include <algorithm>
#include <cmath>
#include <deque>
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

void Add(HomologyClass& sum, const HomologyClass& c)
{
  std::transform(sum.begin(), sum.end(), c.begin(), sum.begin(), std::bit_xor<>());
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
    this->Classes.reserve(this->Paths.Points().size());
    this->Classes.push_back(context.Homology.ClassOf({}));
    for (std::size_t i = 1; i < this->Paths.Points().size(); ++i)
    {
      const HalfEdgeId last = this->Paths.LastAt(i);
      this->Classes.push_back(this->ClassTo(context.Surface.From(last)));
      context.Homology.AddTo(this->Classes.back(), context.Surface.Edge(last));
    }
  }

  SimplexId Root() const { return this->Base; }
  const SurfacePaths& Lengths() const { return this->Paths; }
  const HomologyClass& ClassAt(std::size_t place) const { return this->Classes[place]; }
  const HomologyClass& ClassTo(SimplexId p) const
  {
    return this->Classes[static_cast<std::size_t>(this->Paths.PlaceOf(p))];
  }

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
  std::vector<HomologyClass> Classes; ///< by place among Paths.Points()
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

using ShortestOfClass = std::map<HomologyClass, std::pair<double, HalfEdgeId>>;

/// Of each class but zero, the length of the shortest loop from `one` over an edge to `other` and
/// straight back, and that edge.
ShortestOfClass ShortestOfClasses(
  const FeatureContext& context, const Tree& one, const Tree& other, double longest)
{
  const SurfaceAdjacency& surface = context.Surface;
  const double straight = one.Lengths().Length(other.Root());
  const HomologyClass& back = one.ClassTo(other.Root());
  HomologyClass c;
  ShortestOfClass best;
  for (std::size_t i = 0; i < one.Lengths().Points().size(); ++i)
  {
    const HalfEdgeId first = surface.Leaving(one.Lengths().Points()[i]);
    HalfEdgeId h = first;
    do
    {
      const HalfEdgeId over = h;
      h = surface.Turn(h);
      const std::ptrdiff_t place = other.Lengths().PlaceOf(surface.To(over));
      const auto k = static_cast<std::size_t>(place);
      if (place < 0 || (&one == &other && k < i)) // there, it is the same loop the other way
      {
        continue;
      }
      const double paths = straight + one.Lengths().LengthAt(i) + other.Lengths().LengthAt(k);
      const double length = paths > longest ? HUGE_VAL : paths + surface.Length(over);
      if (length > longest)
      {
        continue;
      }
      c = back;
      Add(c, one.ClassAt(i));
      Add(c, other.ClassAt(k));
      context.Homology.AddTo(c, surface.Edge(over));
      if (!IsZero(c))
      {
        auto& known = best.try_emplace(c, HUGE_VAL, over).first->second;
        known = length < known.first ? std::make_pair(length, over) : known;
      }
    } while (h != first);
  }
  return best;
}

/// The shortest loops that go straight from one contact to another (or the same) and come back,
/// one of each class in `bounding`.
std::vector<Closed> LoopsThrough(const FeatureContext& context, const HomologySpan& bounding,
  const Tree& one, const Tree& other, double longest)
{
  if (!one.Lengths().Has(other.Root()))
  {
    return {};
  }
  const SurfaceAdjacency& surface = context.Surface;
  std::vector<Closed> loops;
  for (const auto& [c, shortest] : ShortestOfClasses(context, one, other, longest))
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

std::deque<Tree> TreesOf(const FeatureContext& context, const ShapeFeature& f, double reach)
{
  std::deque<Tree> trees; // which are not moved
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
  const std::deque<Tree> trees = TreesOf(context, f, 0.5 * longest);
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
  const std::deque<Tree> trees = TreesOf(context, f, longest);
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
    Add(c, trees[i].ClassTo(next));
  }
  Membrane membrane = FanFrom(context, features.Centres[feature], std::move(loop));
  const bool holds = membrane.Loops[0].size() >= 3 &&
    BoundingClasses(context, features, f.Side).Contains(c) &&
    IsInterchangeable(context, features, feature, membrane);
  return holds ? std::optional<Membrane>(std::move(membrane)) : std::nullopt;
}

}
