#include "ChokingLoops/FeatureMembrane.h"

#include "ChokingLoops/MinimumCutMembrane.h"
#include "ChokingLoops/SurfaceHomology.h"
#include "ChokingLoops/SurfacePaths.h"
#include "Core/Geometry.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <set>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// FeatureMembrane
namespace
{

/// The points of a path of surface edges that starts at `from`.
std::vector<SimplexId> PathPoints(
  const SurfaceAdjacency& surface, const std::vector<SurfaceEdgeId>& path, SimplexId from)
{
  std::vector<SimplexId> points{ from };
  for (const SurfaceEdgeId e : path)
  {
    const HalfEdgeId h = surface.GetHalfEdge(e);
    points.push_back(surface.From(h) == points.back() ? surface.To(h) : surface.From(h));
  }
  return points;
}

/// Longest allowed path along M between the ends of an edge of the complex, in edge lengths.
constexpr double FarthestWay = 1e6;

/// Replaces each edge of the complex by edges of M; the triangles between join the membrane.
/// Returns nothing if the ends of an edge lie on two components of M.
std::set<SurfaceEdgeId> OntoSurface(
  const FeatureContext& context, const EdgeChain& cycle, Membrane& membrane)
{
  std::set<SurfaceEdgeId> edges;
  for (const EdgeId e : cycle)
  {
    const SurfaceEdgeId own = context.Embedding.SurfaceEdge(e);
    if (own.Exists())
    {
      Toggle(edges, own);
      continue;
    }
    const auto& ends = context.Filtration.Edges[e];
    const double length =
      Distance(context.Filtration.Points[At(ends[0])], context.Filtration.Points[At(ends[1])]);
    membrane.OnSurface = membrane.OnSurface && length * length <= 4.0 * context.SquaredError(ends);
    const auto part = [&context](SimplexId p) { return context.Homology.GetComponent(p); };
    if (part(ends[0]) != part(ends[1]))
    {
      return {};
    }
    const std::vector<SurfaceEdgeId> path =
      context.Embedding.ShortestPath(ends[1], ends[0], FarthestWay * length);
    if (path.empty())
    {
      return {};
    }
    for (const SurfaceEdgeId step : path)
    {
      Toggle(edges, step);
    }
    AddFan(PathPoints(context.Surface, path, ends[0]), membrane.Triangles);
  }
  return edges;
}

double LoopLength(const SurfaceView& mesh, const std::vector<SimplexId>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += Distance(mesh.Points[At(loop[i])], mesh.Points[At(loop[(i + 1) % loop.size()])]);
  }
  return length;
}

}

void AddFan(const std::vector<SimplexId>& loop, std::vector<std::array<SimplexId, 3>>& triangles)
{
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
  {
    triangles.push_back({ loop[0], loop[i], loop[i + 1] });
  }
}

std::vector<std::vector<SimplexId>> SimpleLoops(
  const SurfaceAdjacency& surface, const SurfaceChain& edges)
{
  std::map<SimplexId, std::vector<HalfEdgeId>> around; // half edges that leave a point
  for (const SurfaceEdgeId e : edges)
  {
    const HalfEdgeId h = surface.GetHalfEdge(e);
    around[surface.From(h)].push_back(h);
    around[surface.To(h)].push_back(surface.Opposite(h));
  }
  std::set<SurfaceEdgeId> used;
  std::vector<std::vector<SimplexId>> loops;
  for (const auto& entry : around)
  {
    std::vector<SimplexId> trail{ entry.first };
    std::map<SimplexId, std::size_t> position{ { entry.first, 0 } };
    while (!trail.empty())
    {
      const auto& choices = around[trail.back()];
      const auto next = std::find_if(choices.begin(), choices.end(),
        [&](HalfEdgeId h) { return used.count(surface.Edge(h)) == 0; });
      if (next == choices.end())
      {
        break;
      }
      used.insert(surface.Edge(*next));
      const SimplexId to = surface.To(*next);
      const auto seen = position.find(to);
      if (seen == position.end())
      {
        position[to] = trail.size();
        trail.push_back(to);
        continue;
      }
      // A point visited again closes a simple loop; the trail continues from there.
      const std::size_t from = seen->second;
      loops.emplace_back(trail.begin() + static_cast<std::ptrdiff_t>(from), trail.end());
      for (std::size_t i = from + 1; i < trail.size(); ++i)
      {
        position.erase(trail[i]);
      }
      trail.resize(from + 1);
    }
  }
  return loops;
}

SurfaceChain LoopEdges(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop)
{
  SurfaceChain edges;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    edges.push_back(surface.Edge(surface.Find(loop[i], loop[(i + 1) % loop.size()])));
  }
  return edges;
}

namespace
{

/// The chain that fills the feature's sum of basis loops, restricted to the feature's side.
TriangleChain FillingOfSum(
  const FeatureContext& context, SpaceRegions& regions, const ShapeFeature& feature)
{
  EdgeChain image;
  for (const std::size_t loop : feature.Sum)
  {
    for (const SurfaceEdgeId e : context.Homology.Loop(loop))
    {
      const EdgeChain path = context.Embedding.Image(e);
      image.insert(image.end(), path.begin(), path.end());
    }
  }
  std::set<TriangleId> filling;
  for (const std::int64_t rank : context.Pairs.Bounding(image))
  {
    const auto last = TriangleRank::At(At(rank));
    for (const TriangleId t : context.Pairs.Filling(context.Filtration.TrianglesInOrder[last]))
    {
      if (!context.IsWall(t) && SpaceRegions::SideFrom(regions.OfTriangle(t)) == feature.Side)
      {
        Toggle(filling, t);
      }
    }
  }
  return filling.count(feature.Choke)
    ? ConnectedPiece(context.Filtration, context.Embedding, filling, feature.Choke)
    : TriangleChain{};
}

}

Membrane SpanningMembrane(const FeatureContext& context, const TriangleChain& triangles,
  const EdgeChain& cycle, HomologySpan* span)
{
  Membrane membrane;
  for (const TriangleId t : triangles)
  {
    membrane.Triangles.push_back(context.Filtration.TrianglePoints(t));
  }
  const std::set<SurfaceEdgeId> edges = OntoSurface(context, cycle, membrane);
  std::vector<std::vector<SimplexId>> loops =
    SimpleLoops(context.Surface, { edges.begin(), edges.end() });
  std::sort(loops.begin(), loops.end(),
    [&context](const auto& a, const auto& b)
    { return LoopLength(context.Surface.Mesh(), a) > LoopLength(context.Surface.Mesh(), b); });
  HomologyClass total;
  for (const std::vector<SimplexId>& loop : loops)
  {
    const HomologyClass c = context.Homology.GetClass(LoopEdges(context.Surface, loop));
    total.resize(c.size(), 0);
    std::transform(c.begin(), c.end(), total.begin(), total.begin(), std::bit_xor<>());
    // On another component, a loop that bounds there is a border as well: an annulus has two.
    const auto component = [&](const std::vector<SimplexId>& l)
    { return context.Homology.GetComponent(l.front()); };
    if (membrane.Loops.empty() || !IsZero(c) ||
      component(loop) != component(membrane.Loops.front()))
    {
      membrane.Loops.push_back(loop);
    }
    else
    {
      AddFan(loop, membrane.Triangles);
    }
  }
  if (span && (!membrane.OnSurface || membrane.Loops.empty() || !span->Add(total)))
  {
    membrane.Loops.clear();
  }
  return membrane;
}

Membrane FeatureMembrane(const FeatureContext& context, SpaceRegions& regions,
  const ShapeFeature& feature, HomologySpan* span)
{
  const auto boundary = context.Filtration.TriangleEdges(feature.Choke);
  TriangleChain swept{ feature.Choke };
  const EdgeChain cycle = context.Pairs.Push(
    { boundary.begin(), boundary.end() }, feature.Choke,
    [&context](EdgeId e) { return !context.Embedding.SurfaceEdge(e).Exists(); }, swept);
  Membrane membrane = SpanningMembrane(context, swept, cycle, span);
  if (membrane.Loops.empty() && span)
  {
    const TriangleChain filling = FillingOfSum(context, regions, feature);
    if (!filling.empty())
    {
      membrane =
        SpanningMembrane(context, filling, ComputeBoundary(context.Filtration, filling), span);
    }
  }
  return membrane;
}

std::optional<Membrane> MinimumCutMembrane(const FeatureContext& context,
  const ShapeFeature& feature, const Point3& center, const ProgressCallback& progress, bool chords)
{
  const TriangleChain cut = MinimumCutTriangles(context, feature, center, progress, chords);
  if (cut.empty())
  {
    return std::nullopt;
  }
  Membrane membrane =
    SpanningMembrane(context, cut, ComputeBoundary(context.Filtration, cut), nullptr);
  membrane.OnSurface = membrane.OnSurface || chords;
  if (!membrane.OnSurface || membrane.Loops.empty())
  {
    return std::nullopt;
  }
  return membrane;
}

/// The sum of the classes of a membrane's loops.
HomologyClass MembraneClass(const FeatureContext& context, const Membrane& membrane)
{
  HomologyClass sum = context.Homology.GetClass({});
  for (const auto& loop : membrane.Loops)
  {
    const HomologyClass c = context.Homology.GetClass(LoopEdges(context.Surface, loop));
    std::transform(c.begin(), c.end(), sum.begin(), sum.begin(), std::bit_xor<>());
  }
  return sum;
}

bool IsInterchangeable(const FeatureContext& context, const LocatedFeatures& features,
  std::size_t feature, const Membrane& other)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  if (!IsGenerator(f) || !features.Membranes[feature])
  {
    return !IsGenerator(f);
  }
  HomologyClass difference = MembraneClass(context, *features.Membranes[feature]);
  const HomologyClass c = MembraneClass(context, other);
  std::transform(c.begin(), c.end(), difference.begin(), difference.begin(), std::bit_xor<>());
  HomologySpan before;
  for (std::size_t i = 0; i < feature; ++i)
  {
    const ShapeFeature& earlier = features.Diagram.Features[i];
    if (IsGenerator(earlier) && earlier.Side == f.Side && features.Membranes[i])
    {
      before.Add(MembraneClass(context, *features.Membranes[i]));
    }
  }
  return before.Contains(difference);
}

HomologySpan BoundingClasses(
  const FeatureContext& context, const LocatedFeatures& features, SpaceSide side)
{
  HomologySpan span;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    if (IsGenerator(f) && f.Side == side && features.Membranes[i])
    {
      span.Add(MembraneClass(context, *features.Membranes[i]));
    }
  }
  return span;
}

// ------------------------------------------------------------------------------------------
// EncirclingLoops
namespace
{

/// The search begins with the length of the ball's circumference, or this fraction of the longest
/// if that is more, and increases the length by this factor until there are enough loops.
constexpr double FirstPart = 0.05;
constexpr double Growth = 1.5;

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
    , Words(context.Homology.GetClass({}).size())
    , Paths(context.Surface, base, reach)
  {
    this->AddClasses();
  }

  /// Adds the points within `reach`.
  void Grow(double reach)
  {
    this->Paths.Grow(reach);
    this->AddClasses();
  }

  SimplexId Root() const { return this->Base; }
  const SurfacePaths& Lengths() const { return this->Paths; }

  /// Adds the class of the path to a point, by its place among Lengths().Points().
  void AddClassAt(std::size_t place, HomologyClass& c) const
  {
    for (std::size_t w = 0; w < this->Words; ++w)
    {
      c[w] ^= this->Classes[this->Words * place + w];
    }
  }

  /// The class of the path to p. @pre Lengths().Has(p).
  HomologyClass ClassTo(SimplexId p) const
  {
    HomologyClass c(this->Words, 0);
    this->AddClassAt(static_cast<std::size_t>(this->Paths.GetPlace(p)), c);
    return c;
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
  void AddClasses();

  const FeatureContext& Context;
  SimplexId Base;
  std::size_t Words; ///< of a class
  SurfacePaths Paths;
  std::vector<std::uint64_t> Classes; ///< by place among Paths.Points()
  std::size_t Known = 0;              ///< of the places
};

void Tree::AddClasses()
{
  HomologyClass c(this->Words);
  for (; this->Known < this->Paths.Points().size(); ++this->Known)
  {
    std::fill(c.begin(), c.end(), 0);
    const HalfEdgeId last = this->Paths.LastAt(this->Known);
    if (last.Exists())
    {
      const SimplexId before = this->Context.Surface.From(last);
      this->AddClassAt(static_cast<std::size_t>(this->Paths.GetPlace(before)), c);
      this->Context.Homology.AddTo(c, this->Context.Surface.Edge(last));
    }
    this->Classes.insert(this->Classes.end(), c.begin(), c.end());
  }
}

/// A closed walk whose last point is its first, as a loop; steps there and back are removed.
std::vector<SimplexId> WithoutDetours(const std::vector<SimplexId>& walk)
{
  std::size_t tail = 0;
  while (2 * (tail + 1) + 1 < walk.size() && walk[tail + 1] == walk[walk.size() - tail - 2])
  {
    ++tail;
  }
  return { walk.begin() + static_cast<std::ptrdiff_t>(tail),
    walk.end() - static_cast<std::ptrdiff_t>(tail + 1) };
}

/// Loops that go straight from one contact to another (or the same) over an edge and come back: the
/// shortest of each accepted class, ascending as the trees grow.
class LoopsThrough
{
public:
  LoopsThrough(const FeatureContext& context, const Tree& one, const Tree& other)
    : Context(context)
    , One(one)
    , Other(other)
  {
  }

  /// Those longer than all previous ones, at most `longest`. @pre The trees reach as far as half of
  /// that.
  std::vector<Closed> Next(const AcceptClass& accepts, double longest);

private:
  void Search(double longest);
  std::vector<SimplexId> Along(HalfEdgeId over) const;

  const FeatureContext& Context;
  const Tree& One;
  const Tree& Other;
  /// Of each class but zero, the length of its shortest loop, and the edge that closes it.
  std::map<HomologyClass, std::pair<double, HalfEdgeId>> Shortest;
  double Searched = -1.0; ///< longer loops are not known
};

void LoopsThrough::Search(double longest)
{
  const SurfaceAdjacency& surface = this->Context.Surface;
  const SurfacePaths& one = this->One.Lengths();
  const SurfacePaths& other = this->Other.Lengths();
  const double straight = one.Length(this->Other.Root());
  const HomologyClass back = this->One.ClassTo(this->Other.Root());
  HomologyClass c;
  // From the edge's end, the other root is no farther than the way back over the edge: a loop there
  // is at most twice as long as `straight`, the path to the point and the edge. Shorter ones were
  // found before.
  for (std::size_t i = one.FirstBeyond(0.5 * this->Searched - straight - one.LongestEdge());
       i < one.Points().size(); ++i)
  {
    const HalfEdgeId first = surface.Leaving(one.Points()[i]);
    HalfEdgeId h = first;
    do
    {
      const HalfEdgeId over = h;
      h = surface.Turn(h);
      const std::ptrdiff_t place = other.GetPlace(surface.To(over));
      const auto k = static_cast<std::size_t>(place);
      if (place < 0 || (&one == &other && k < i)) // the latter is the same loop reversed
      {
        continue;
      }
      const double paths = straight + one.LengthAt(i) + other.LengthAt(k);
      const double length = paths > longest ? HUGE_VAL : paths + surface.Length(over);
      if (length > longest || length <= this->Searched)
      {
        continue;
      }
      c = back;
      this->One.AddClassAt(i, c);
      this->Other.AddClassAt(k, c);
      this->Context.Homology.AddTo(c, surface.Edge(over));
      if (!IsZero(c))
      {
        auto& known = this->Shortest.try_emplace(c, HUGE_VAL, over).first->second;
        known = length < known.first ? std::make_pair(length, over) : known;
      }
    } while (h != first);
  }
}

/// From `One` over the edge to `Other`, and straight back.
std::vector<SimplexId> LoopsThrough::Along(HalfEdgeId over) const
{
  std::vector<SimplexId> walk = this->One.PathTo(this->Context.Surface.From(over));
  const std::vector<SimplexId> on = this->Other.PathTo(this->Context.Surface.To(over));
  walk.insert(walk.end(), on.rbegin(), on.rend());
  const std::vector<SimplexId> back = this->One.PathTo(this->Other.Root());
  walk.insert(walk.end(), back.rbegin() + 1, back.rend());
  return WithoutDetours(walk);
}

std::vector<Closed> LoopsThrough::Next(const AcceptClass& accepts, double longest)
{
  if (!this->One.Lengths().Has(this->Other.Root()))
  {
    return {};
  }
  this->Search(longest);
  std::vector<Closed> loops;
  for (const auto& [c, shortest] : this->Shortest)
  {
    if (shortest.first > this->Searched && accepts(c))
    {
      loops.push_back({ shortest.first, this->Along(shortest.second) });
    }
  }
  this->Searched = longest;
  return loops;
}

/// The fan that a loop bounds, seen from a point off M.
Membrane FanFrom(const FeatureContext& context, const Point3& center, std::vector<SimplexId> loop)
{
  Membrane membrane;
  membrane.Extra.push_back(center);
  const auto apex = static_cast<SimplexId>(context.Surface.Mesh().Points.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    membrane.Triangles.push_back({ loop[i], loop[(i + 1) % loop.size()], apex });
  }
  membrane.Loops.push_back(std::move(loop));
  return membrane;
}

/// Loops that all searches find up to a length, ascending.
std::vector<Closed> NextLoops(
  std::vector<LoopsThrough>& searches, const AcceptClass& accepts, double longest)
{
  std::vector<Closed> loops;
  for (LoopsThrough& search : searches)
  {
    const auto found = search.Next(accepts, longest);
    loops.insert(loops.end(), found.begin(), found.end());
  }
  std::stable_sort(loops.begin(), loops.end(),
    [](const Closed& a, const Closed& b) { return a.Length < b.Length; });
  return loops;
}

/// Adds the membranes of loops that may replace those of the feature.
void AddShortest(const FeatureContext& context, const LocatedFeatures& features,
  std::size_t feature, std::vector<Closed> loops, std::vector<Membrane>& membranes)
{
  for (Closed& loop : loops)
  {
    Membrane membrane = FanFrom(context, features.Centers[feature], std::move(loop.Points));
    if (IsInterchangeable(context, features, feature, membrane))
    {
      membranes.push_back(std::move(membrane));
    }
  }
}

std::deque<Tree> GrowTrees(const FeatureContext& context, const ShapeFeature& f, double reach)
{
  std::deque<Tree> trees; // a deque keeps their addresses
  for (const SimplexId p : context.Filtration.TrianglePoints(f.Choke))
  {
    if (context.Surface.Leaving(p).Exists())
    {
      trees.emplace_back(context, p, reach);
    }
  }
  return trees;
}

/// The search through all contacts of a choke, up to a length that grows.
class ContactLoops
{
public:
  ContactLoops(
    const FeatureContext& context, const ShapeFeature& f, AcceptClass accepts, double longest)
    : Accepts(std::move(accepts))
    , Longest(longest)
    , Length(std::clamp(2.0 * Pi * f.Radius(), FirstPart * longest, longest))
    , Trees(GrowTrees(context, f, 0.5 * this->Length))
  {
    for (std::size_t i = 0; i < this->Trees.size(); ++i)
    {
      for (std::size_t j = i; j < this->Trees.size(); ++j)
      {
        this->Searches.emplace_back(context, this->Trees[i], this->Trees[j]);
      }
    }
  }

  /// Searches the next lengths; false if there are none.
  bool Grow()
  {
    if (this->IsBegun && this->Length >= this->Longest)
    {
      return false;
    }
    if (this->IsBegun)
    {
      this->Length = std::min(this->Longest, Growth * this->Length);
      for (Tree& tree : this->Trees)
      {
        tree.Grow(0.5 * this->Length);
      }
    }
    this->IsBegun = true;
    this->Loops = NextLoops(this->Searches, this->Accepts, this->Length);
    return true;
  }

  /// The loops of these lengths, ascending.
  const std::vector<Closed>& Found() const { return this->Loops; }

private:
  AcceptClass Accepts;
  double Longest;
  double Length;
  bool IsBegun = false;
  std::deque<Tree> Trees;
  std::vector<LoopsThrough> Searches;
  std::vector<Closed> Loops;
};

}

std::vector<Membrane> EncirclingMembranes(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest, std::size_t most)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  const HomologySpan bounding = BoundingClasses(context, features, f.Side);
  if (bounding.Rank() == 0)
  {
    return {};
  }
  ContactLoops search(
    context, f, [&bounding](const HomologyClass& c) { return bounding.Contains(c); }, longest);
  std::vector<Membrane> membranes;
  while (membranes.size() < most && search.Grow())
  {
    AddShortest(context, features, feature, search.Found(), membranes);
  }
  membranes.resize(std::min(membranes.size(), most));
  return membranes;
}

std::optional<Membrane> EncirclingMembrane(const FeatureContext& context,
  const ShapeFeature& feature, const Point3& center, const AcceptClass& accepts, double longest)
{
  ContactLoops search(context, feature, accepts, longest);
  while (search.Grow())
  {
    if (!search.Found().empty())
    {
      return FanFrom(context, center, search.Found().front().Points);
    }
  }
  return std::nullopt;
}

std::optional<Membrane> ContactMembrane(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, double longest)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  const std::deque<Tree> trees = GrowTrees(context, f, longest);
  std::vector<SimplexId> loop;
  HomologyClass c = context.Homology.GetClass({});
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
  Membrane membrane = FanFrom(context, features.Centers[feature], std::move(loop));
  const bool holds = membrane.Loops[0].size() >= 3 &&
    BoundingClasses(context, features, f.Side).Contains(c) &&
    IsInterchangeable(context, features, feature, membrane);
  return holds ? std::optional<Membrane>(std::move(membrane)) : std::nullopt;
}

}
