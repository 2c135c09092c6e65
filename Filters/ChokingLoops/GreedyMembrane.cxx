#include "ChokingLoops/GreedyMembrane.h"

#include "Core/Geometry.h"
#include "Core/Index.h"

#include <algorithm>
#include <map>
#include <queue>
#include <set>
#include <utility>

namespace isthmus
{
namespace
{

enum class Cluster : char
{
  None,
  Left,
  Right
};

/// An edge of the one-ring of a vertex, with the triangle that it makes with the vertex.
struct RingEdge
{
  SimplexId To;
  TriangleId Triangle;
};

using Ring = std::map<SimplexId, std::vector<RingEdge>>;
using ClosedWalk = std::vector<SimplexId>; ///< of vertices

class GreedyGrowth
{
public:
  GreedyGrowth(const FeatureContext& context, TriangleId choke)
    : Context(context)
    , F(context.Filtration)
    , Choke(choke)
  {
    this->Join(choke);
    const auto sides = this->F.TriangleSides(choke);
    this->Clusters[sides[0]] = Cluster::Left;
    this->Clusters[sides[1]] = Cluster::Right;
    const auto corners = this->F.TrianglePoints(choke);
    this->Boundary.push_back({ corners.begin(), corners.end() });
  }

  /// Nothing if no step is possible.
  std::optional<GreedyPatches> Grow();

private:
  bool IsOnSurface(SimplexId p) const { return this->Context.Homology.GetComponent(p) >= 0; }
  double Value(SimplexId p) const { return this->Context.PointValue[At(p)]; }

  bool TakeDeepest(std::size_t& walk, std::size_t& place) const;
  std::vector<TetrahedronId> Star(SimplexId v) const;
  bool IsOpen(TriangleId t) const;
  Ring CollectRing(SimplexId v, const std::vector<TetrahedronId>& star) const;
  std::vector<SimplexId> Path(const Ring& ring, SimplexId from, SimplexId to, bool avoid);
  bool FillRing(std::size_t walk, std::size_t place);
  bool Spread(SimplexId v, const std::vector<TetrahedronId>& star);
  void Join(TriangleId t);
  void Replace(std::size_t walk, std::size_t place, const std::vector<SimplexId>& path);
  void Split(ClosedWalk walk);

  const FeatureContext& Context;
  const CellFiltration& F;
  TriangleId Choke;
  std::set<TriangleId> Membrane;
  std::map<TetrahedronId, Cluster> Clusters;
  std::map<SimplexId, TetrahedronId> Seats; ///< a tetrahedron at each vertex of the membrane
  std::set<SimplexId> Passed;
  std::vector<ClosedWalk> Boundary;
  GreedyPatches Found;
};

void GreedyGrowth::Join(TriangleId t)
{
  this->Membrane.insert(t);
  for (const SimplexId p : this->F.TrianglePoints(t))
  {
    this->Seats[p] = this->F.TriangleSides(t)[0];
  }
}

/// The vertex of the boundary off M with the largest value; false: all of them are on M.
bool GreedyGrowth::TakeDeepest(std::size_t& walk, std::size_t& place) const
{
  double deepest = -1.0;
  for (std::size_t w = 0; w < this->Boundary.size(); ++w)
  {
    for (std::size_t i = 0; i < this->Boundary[w].size(); ++i)
    {
      const SimplexId p = this->Boundary[w][i];
      if (!this->IsOnSurface(p) && this->Value(p) > deepest)
      {
        deepest = this->Value(p);
        walk = w;
        place = i;
      }
    }
  }
  return deepest >= 0.0;
}

/// The tetrahedra around a vertex, reached across their faces. Empty where the complex ends there.
std::vector<TetrahedronId> GreedyGrowth::Star(SimplexId v) const
{
  std::vector<TetrahedronId> star{ this->Seats.at(v) };
  std::set<TetrahedronId> known{ star.front() };
  for (std::size_t i = 0; i < star.size(); ++i)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const TetrahedronId next = this->F.Neighbours[star[i]][corner];
      if (this->F.Tetrahedra[star[i]][corner] == v)
      {
        continue;
      }
      if (!next.Exists())
      {
        return {};
      }
      if (known.insert(next).second)
      {
        star.push_back(next);
      }
    }
  }
  return star;
}

/// True for a triangle that a patch may contain: it precedes the choke triangle in the filtration,
/// and is not within one cluster.
bool GreedyGrowth::IsOpen(TriangleId t) const
{
  const auto cluster = [this](TetrahedronId cell)
  {
    const auto at = this->Clusters.find(cell);
    return at == this->Clusters.end() ? Cluster::None : at->second;
  };
  const auto sides = this->F.TriangleSides(t);
  return this->F.EntersLater(this->Choke, t) && this->Membrane.count(t) == 0 &&
    (cluster(sides[0]) == Cluster::None || cluster(sides[0]) != cluster(sides[1]));
}

Ring GreedyGrowth::CollectRing(SimplexId v, const std::vector<TetrahedronId>& star) const
{
  Ring ring;
  for (const TetrahedronId cell : star)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const TetrahedronId beyond = this->F.Neighbours[cell][corner];
      const TriangleId t = this->F.GetTriangle(cell, corner);
      if (this->F.Tetrahedra[cell][corner] == v || beyond < cell || !this->IsOpen(t))
      {
        continue;
      }
      std::array<SimplexId, 2> ends{ -1, -1 };
      for (const SimplexId p : this->F.TrianglePoints(t))
      {
        if (p != v)
        {
          ends[ends[0] < 0 ? 0 : 1] = p;
        }
      }
      ring[ends[0]].push_back({ ends[1], t });
      ring[ends[1]].push_back({ ends[0], t });
    }
  }
  return ring;
}

/// The cheapest path in a ring, both ends included; empty if there is none.
std::vector<SimplexId> GreedyGrowth::Path(
  const Ring& ring, SimplexId from, SimplexId to, bool avoid)
{
  std::set<SimplexId> closed = this->Passed;
  for (std::size_t w = 0; avoid && w < this->Boundary.size(); ++w)
  {
    closed.insert(this->Boundary[w].begin(), this->Boundary[w].end());
  }
  closed.erase(to);
  std::map<SimplexId, std::pair<double, SimplexId>> best{ { from, { 0.0, from } } };
  using Entry = std::pair<double, SimplexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.push({ 0.0, from });
  while (!queue.empty() && queue.top().second != to)
  {
    const auto [cost, p] = queue.top();
    queue.pop();
    const auto edges = ring.find(p);
    if (edges == ring.end() || cost > best[p].first)
    {
      continue;
    }
    for (const RingEdge& edge : edges->second)
    {
      const SimplexId q = edge.To;
      const double there =
        cost + 0.5 * (Distance(this->F.Points[At(p)], this->F.Points[At(q)]) + this->Value(q));
      const auto known = best.find(q);
      if (closed.count(q) == 0 && (known == best.end() || there < known->second.first))
      {
        best[q] = { there, p };
        queue.push({ there, q });
      }
    }
  }
  if (queue.empty())
  {
    return {};
  }
  this->Found.Cost += best[to].first;
  std::vector<SimplexId> path{ to };
  while (path.back() != from)
  {
    path.push_back(best[path.back()].second);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

/// Gives each tetrahedron around `v` the cluster of those that it is connected to without crossing
/// the membrane; false where both clusters would meet.
bool GreedyGrowth::Spread(SimplexId v, const std::vector<TetrahedronId>& star)
{
  std::vector<TetrahedronId> queue;
  std::copy_if(star.begin(), star.end(), std::back_inserter(queue),
    [this](TetrahedronId cell) { return this->Clusters.count(cell) != 0; });
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const Cluster own = this->Clusters[queue[i]];
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      if (this->F.Tetrahedra[queue[i]][corner] == v ||
        this->Membrane.count(this->F.GetTriangle(queue[i], corner)) != 0)
      {
        continue;
      }
      const TetrahedronId next = this->F.Neighbours[queue[i]][corner];
      const auto [at, isNew] = this->Clusters.emplace(next, own);
      if (isNew)
      {
        queue.push_back(next);
      }
      if (at->second != own)
      {
        return false;
      }
    }
  }
  return true;
}

/// Parts of a walk between two visits of a vertex become walks of their own; edges that are walked
/// there and back are removed.
void GreedyGrowth::Split(ClosedWalk walk)
{
  std::map<SimplexId, std::size_t> places;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    const auto [seen, isNew] = places.emplace(walk[i], i);
    if (!isNew)
    {
      const auto first = walk.begin() + static_cast<std::ptrdiff_t>(seen->second);
      const auto last = walk.begin() + static_cast<std::ptrdiff_t>(i);
      ClosedWalk part(first, last);
      walk.erase(first, last);
      this->Split(std::move(part));
      this->Split(std::move(walk));
      return;
    }
  }
  if (walk.size() > 2)
  {
    this->Boundary.push_back(std::move(walk));
  }
}

void GreedyGrowth::Replace(std::size_t walk, std::size_t place, const std::vector<SimplexId>& path)
{
  ClosedWalk old = std::move(this->Boundary[walk]);
  this->Boundary.erase(this->Boundary.begin() + static_cast<std::ptrdiff_t>(walk));
  std::rotate(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(place), old.end());
  ClosedWalk next(
    old.begin() + 1, old.end()); // from the point after the vertex to the one before it
  next.insert(next.end(), path.begin() + 1, path.end() - 1);
  this->Split(std::move(next));
}

/// Replaces one vertex of the boundary by a path in its ring.
bool GreedyGrowth::FillRing(std::size_t walk, std::size_t place)
{
  const ClosedWalk& loop = this->Boundary[walk];
  const SimplexId v = loop[place];
  const SimplexId before = loop[(place + loop.size() - 1) % loop.size()];
  const SimplexId after = loop[(place + 1) % loop.size()];
  const std::vector<TetrahedronId> star = this->Star(v);
  const Ring ring = this->CollectRing(v, star);
  std::vector<SimplexId> path = this->Path(ring, before, after, true);
  if (path.empty())
  {
    path = this->Path(ring, before, after, false);
  }
  if (path.empty())
  {
    return false;
  }
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    const auto& edges = ring.at(path[i]);
    this->Join(std::find_if(edges.begin(), edges.end(),
      [&](const RingEdge& edge) {
        return edge.To == path[i + 1];
      })->Triangle);
  }
  this->Passed.insert(v);
  this->Replace(walk, place, path);
  ++this->Found.Steps;
  return this->Spread(v, star);
}

std::optional<GreedyPatches> GreedyGrowth::Grow()
{
  std::size_t walk = 0, place = 0;
  while (this->TakeDeepest(walk, place))
  {
    if (!this->FillRing(walk, place))
    {
      return std::nullopt;
    }
  }
  this->Found.Triangles.assign(this->Membrane.begin(), this->Membrane.end());
  return std::move(this->Found);
}

}

std::optional<GreedyPatches> GrowGreedily(
  const FeatureContext& context, const ShapeFeature& feature)
{
  const auto sides = context.Filtration.TriangleSides(feature.Choke);
  if (context.PointValue.empty() || !sides[1].Exists() || context.IsWall(feature.Choke))
  {
    return std::nullopt;
  }
  return GreedyGrowth(context, feature.Choke).Grow();
}

std::optional<Membrane> GreedyMembrane(const FeatureContext& context, const ShapeFeature& feature)
{
  const std::optional<GreedyPatches> patches = GrowGreedily(context, feature);
  if (!patches)
  {
    return std::nullopt;
  }
  const EdgeChain boundary = ComputeBoundary(context.Filtration, patches->Triangles);
  Membrane membrane = SpanningMembrane(context, patches->Triangles, boundary, nullptr);
  if (membrane.Loops.empty())
  {
    return std::nullopt;
  }
  // An edge through the space between two points of M is allowed here: it ends the growth.
  membrane.OnSurface = true;
  membrane.GrowthCost = patches->Cost;
  return membrane;
}

}
