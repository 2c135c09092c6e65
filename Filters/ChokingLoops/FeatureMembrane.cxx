#include "ChokingLoops/FeatureMembrane.h"

#include "ChokingLoops/ChainPieces.h"
#include "ChokingLoops/MinimumCutMembrane.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

namespace isthmus
{
namespace
{

/// The points of a path of surface edges that starts at `from`.
std::vector<SimplexId> PointsOf(
  const SurfaceAdjacency& surface, const std::vector<SurfaceEdgeId>& path, SimplexId from)
{
  std::vector<SimplexId> points{ from };
  for (const SurfaceEdgeId e : path)
  {
    const HalfEdgeId h = surface.HalfEdgeOf(e);
    points.push_back(surface.From(h) == points.back() ? surface.To(h) : surface.From(h));
  }
  return points;
}

/// The longest way along M between the ends of an edge of the complex, in lengths of the edge.
constexpr double FarthestWay = 1e6;

/// Puts edges of M in the place of each edge of the complex; what lies between joins the membrane.
/// Nothing where the ends of an edge lie on two components of M.
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
    const auto part = [&context](SimplexId p) { return context.Homology.ComponentOf(p); };
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
    AddFan(PointsOf(context.Surface, path, ends[0]), membrane.Triangles);
  }
  return edges;
}

double Length(const SurfaceView& mesh, const std::vector<SimplexId>& loop)
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
    const HalfEdgeId h = surface.HalfEdgeOf(e);
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
      // A point met again closes a simple loop; the trail goes on from there.
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

/// What fills the sum of basis loops that the feature is, as far as it lies on the feature's side.
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
      if (!context.IsWall(t) && SpaceRegions::SideOf(regions.OfTriangle(t)) == feature.Side)
      {
        Toggle(filling, t);
      }
    }
  }
  return filling.count(feature.Choke)
    ? PieceAround(context.Filtration, context.Embedding, filling, feature.Choke)
    : TriangleChain{};
}

/// The membrane made of `triangles`, whose boundary is `cycle`.
Membrane MembraneOf(const FeatureContext& context, const TriangleChain& triangles,
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
    { return Length(context.Surface.Mesh(), a) > Length(context.Surface.Mesh(), b); });
  HomologyClass total;
  for (const std::vector<SimplexId>& loop : loops)
  {
    const HomologyClass c = context.Homology.ClassOf(LoopEdges(context.Surface, loop));
    total.resize(c.size(), 0);
    std::transform(c.begin(), c.end(), total.begin(), total.begin(), std::bit_xor<>());
    // On another component, a loop that bounds there is no less a border: an annulus has two.
    const auto component = [&](const std::vector<SimplexId>& l)
    { return context.Homology.ComponentOf(l.front()); };
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

}

Membrane FeatureMembrane(const FeatureContext& context, SpaceRegions& regions,
  const ShapeFeature& feature, HomologySpan* span)
{
  const auto& boundary = context.Filtration.TriangleEdges[feature.Choke];
  TriangleChain swept{ feature.Choke };
  const EdgeChain cycle = context.Pairs.Push(
    { boundary.begin(), boundary.end() }, context.Filtration.RankOfTriangle[feature.Choke],
    [&context](EdgeId e) { return !context.Embedding.SurfaceEdge(e).Exists(); }, swept);
  Membrane membrane = MembraneOf(context, swept, cycle, span);
  if (membrane.Loops.empty() && span)
  {
    const TriangleChain filling = FillingOfSum(context, regions, feature);
    if (!filling.empty())
    {
      membrane = MembraneOf(context, filling, BoundaryOf(context.Filtration, filling), span);
    }
  }
  return membrane;
}

std::optional<Membrane> TightMembrane(const FeatureContext& context, const ShapeFeature& feature,
  const Point3& centre, const ProgressCallback& progress)
{
  const TriangleChain cut = TightestCut(context, feature, centre, progress);
  if (cut.empty())
  {
    return std::nullopt;
  }
  Membrane membrane = MembraneOf(context, cut, BoundaryOf(context.Filtration, cut), nullptr);
  if (!membrane.OnSurface || membrane.Loops.empty())
  {
    return std::nullopt;
  }
  return membrane;
}

}
