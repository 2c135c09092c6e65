#include "ChokingLoops/MinimumCutMembrane.h"

#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/SurfaceHomology.h"
#include "Core/Index.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // in boost/graph/detail/adjacency_list.hpp
#endif

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// MinimumCut
namespace
{

using FlowGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS,
  boost::no_property, boost::property<boost::edge_index_t, std::size_t>>;
using FlowArc = boost::graph_traits<FlowGraph>::edge_descriptor;

/// Links as arcs in both directions, each the reverse of the other.
class FlowNetwork
{
public:
  explicit FlowNetwork(std::int32_t nodes)
    : Graph(At(nodes))
  {
  }

  void Add(std::int32_t from, std::int32_t to, std::int64_t along, std::int64_t against)
  {
    const FlowArc there = this->AddArc(from, to, along);
    const FlowArc back = this->AddArc(to, from, against);
    this->Reverse.push_back(back);
    this->Reverse.push_back(there);
  }

  /// One char a node: 1 for those that flow from `source` could still reach.
  std::vector<char> Reached(std::int32_t source, std::int32_t sink)
  {
    const std::size_t nodes = num_vertices(this->Graph);
    std::vector<std::int64_t> residual(this->Capacity.size());
    std::vector<FlowArc> predecessor(nodes);
    std::vector<boost::default_color_type> colour(nodes);
    std::vector<std::int64_t> distance(nodes);
    const auto arc = get(boost::edge_index, this->Graph);
    const auto node = get(boost::vertex_index, this->Graph);
    boost::boykov_kolmogorov_max_flow(this->Graph,
      boost::make_iterator_property_map(this->Capacity.begin(), arc),
      boost::make_iterator_property_map(residual.begin(), arc),
      boost::make_iterator_property_map(this->Reverse.begin(), arc),
      boost::make_iterator_property_map(predecessor.begin(), node),
      boost::make_iterator_property_map(colour.begin(), node),
      boost::make_iterator_property_map(distance.begin(), node), node, At(source), At(sink));
    std::vector<char> reached(nodes);
    std::transform(colour.begin(), colour.end(), reached.begin(),
      [](boost::default_color_type c)
      { return static_cast<char>(c == boost::black_color); }); // the tree of the source
    return reached;
  }

private:
  FlowArc AddArc(std::int32_t from, std::int32_t to, std::int64_t capacity)
  {
    this->Capacity.push_back(capacity);
    return add_edge(At(from), At(to), this->Capacity.size() - 1, this->Graph).first;
  }

  FlowGraph Graph;
  std::vector<std::int64_t> Capacity;
  std::vector<FlowArc> Reverse;
};

}

std::vector<char> MinimumCut(std::int32_t nodes, const std::vector<FlowLink>& links,
  const std::vector<std::int32_t>& sources, const std::vector<std::int32_t>& sinks,
  const ProgressCallback& progress)
{
  constexpr std::int64_t Unbounded = std::numeric_limits<std::int64_t>::max() / 4;
  Report(progress, 0.0);
  FlowNetwork network(nodes + 2); // the last two feed the sources and drain the sinks
  for (const FlowLink& link : links)
  {
    network.Add(link.Nodes[0], link.Nodes[1], link.Capacity, link.Capacity);
  }
  for (const std::int32_t node : sources)
  {
    network.Add(nodes, node, Unbounded, 0);
  }
  for (const std::int32_t node : sinks)
  {
    network.Add(node, nodes + 1, Unbounded, 0);
  }
  std::vector<char> reached = network.Reached(nodes, nodes + 1);
  reached.resize(At(nodes));
  return reached;
}

// ------------------------------------------------------------------------------------------
// ChokeSurroundings
namespace
{

constexpr double CapacityOfRadius2 = 1073741824.0; ///< of an area of one squared radius
constexpr double LargestCapacity = 1e12;           ///< so that a million of them can be added

}

CellPlace ChokeSurroundings::Meet(TetrahedronId cell)
{
  CellPlace& place = this->Places[cell];
  if (!place.Exists())
  {
    place = CellPlace::At(this->Met.size());
    this->Met.push_back(cell);
  }
  return place;
}

Point3 ChokeSurroundings::Middle(TetrahedronId cell) const
{
  const auto& c = this->F.Tetrahedra[cell];
  const auto p = [&](std::size_t k) -> const Point3& { return this->F.Points[At(c[k])]; };
  return this->Context.PointError.empty() ? 0.25 * (p(0) + p(1) + p(2) + p(3))
                                          : Circumcentre(p(0), p(1), p(2), p(3));
}

double ChokeSurroundings::Area(TriangleId triangle) const
{
  const auto t = this->F.TrianglePoints(triangle);
  return TriangleArea(this->F.Points[At(t[0])], this->F.Points[At(t[1])], this->F.Points[At(t[2])]);
}

void ChokeSurroundings::Link(TriangleId triangle, CellPlace from, CellPlace to)
{
  const double capacity =
    1.0 + CapacityOfRadius2 * this->Area(triangle) / (this->Radius * this->Radius);
  this->All.push_back(
    { { from, to }, static_cast<std::int64_t>(std::min(capacity, LargestCapacity)), triangle });
}

/// From a cell over one of its faces, if that is within reach.
void ChokeSurroundings::Cross(TriangleId triangle, CellPlace from)
{
  if (!this->IsWithinReach(triangle))
  {
    this->Beyond.emplace_back(triangle, from);
    return;
  }
  this->Link(triangle, from, this->Meet(this->F.Across(triangle, this->Met[from])));
}

/// Over the faces of a cell that were not met from their other side.
void ChokeSurroundings::Pass(CellPlace own)
{
  const TetrahedronId cell = this->Met[own];
  for (std::size_t corner = 0; cell.Exists() && corner < 4; ++corner)
  {
    const TetrahedronId beyond = this->F.Neighbours[cell][corner];
    const CellPlace place = beyond.Exists() ? this->PlaceOf(beyond) : CellPlace::None();
    if (place.Exists() && place < own)
    {
      continue;
    }
    const TriangleId triangle = this->F.TriangleOf(cell, corner);
    if (!this->Context.IsWall(triangle))
    {
      this->Cross(triangle, own);
    }
  }
}

bool ChokeSurroundings::Collect(double reach, std::size_t most)
{
  this->Reach = reach;
  for (const TetrahedronId cell : this->F.TriangleSides(this->Choke))
  {
    this->Meet(cell);
  }
  for (const auto& [triangle, cell] : std::exchange(this->Beyond, {}))
  {
    this->Cross(triangle, cell);
  }
  for (; this->Passed < this->Met.size() && this->Met.size() <= most; ++this->Passed)
  {
    this->Pass(CellPlace::At(this->Passed));
  }
  return !this->Beyond.empty();
}

// ------------------------------------------------------------------------------------------
// MinimumCutMembrane
namespace
{

/// Radii of the search, in radii of the choke: each costs almost three times the one before; a
/// membrane that needs more than the last is not used.
constexpr std::array<double, 3> Reaches = { 3.0, 4.25, 6.0 };
constexpr double Anchor = 1.5;           ///< of what stays whole on either side, in radii
constexpr double Grain = 0.15;           ///< side of the cubes that share a node, in radii
constexpr std::size_t MostCells = 50000; ///< seconds of work, for each feature that asks

/// The flow from one side of a choke to the other, and its bottleneck.
class ChokeFlow
{
public:
  ChokeFlow(
    const FeatureContext& context, const ShapeFeature& feature, const Point3& centre, bool byRank)
    : F(context.Filtration)
    , ByRank(byRank)
    , Choke(feature.Choke)
    , Centre(centre)
    , Radius(feature.Radius())
    , Around(context, feature, centre)
  {
  }

  /// As ChokeSurroundings::Collect().
  bool Collect(double reach) { return this->Around.Collect(reach, MostCells); }

  bool IsTooLarge() const { return this->Around.Cells().size() > MostCells; }

  /// The triangles of the smallest cut that separates the two sides of the choke.
  std::set<TriangleId> Cut(const ProgressCallback& progress) const;

private:
  using NodeByCell = HandleVector<CellPlace, std::int32_t>; ///< nodes of the flow

  std::array<std::vector<CellPlace>, 2> Ends() const;
  NodeByCell Nodes(std::int32_t& count) const;
  std::vector<FlowLink> Merged(const NodeByCell& nodes) const;
  std::array<std::int64_t, 3> CubeOf(CellPlace place, bool& isNowhere) const;

  const CellFiltration& F;
  bool ByRank; ///< what opens is what enters after the choke, of equal values too
  TriangleId Choke;
  Point3 Centre;
  double Radius;
  ChokeSurroundings Around;
};

/// The cells that stay uncut on either side. Both sides grow alternately, so that each gets half
/// where they would meet.
std::array<std::vector<CellPlace>, 2> ChokeFlow::Ends() const
{
  const double depth2 = this->Radius * this->Radius * (1.0 + 1e-9);
  HandleVector<CellPlace, char> side(this->Around.Cells().size(), 0); // 1 and 2: taken
  std::vector<CellPlace> queue;
  const auto chokeSides = this->F.TriangleSides(this->Choke);
  for (std::size_t s = 0; s < 2; ++s)
  {
    queue.push_back(this->Around.PlaceOf(chokeSides[s]));
    side[queue.back()] = static_cast<char>(s + 1);
  }
  std::array<std::vector<CellPlace>, 2> ends;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const TetrahedronId own = this->Around.Cells()[queue[i]];
    const char ownSide = side[queue[i]];
    ends[static_cast<std::size_t>(ownSide - 1)].push_back(queue[i]);
    this->Around.ForLinks(own,
      [&](TriangleId t, TetrahedronId cell)
      {
        const bool isOpen =
          this->ByRank ? this->F.EntersLater(t, this->Choke) : this->F.TriangleValue[t] > depth2;
        if (!cell.Exists() || !isOpen ||
          !this->Around.IsWithin(this->Around.Middle(cell), Anchor * this->Radius))
        {
          return;
        }
        const CellPlace other = this->Around.PlaceOf(cell);
        if (side[other] == 0)
        {
          side[other] = ownSide;
          queue.push_back(other);
        }
      });
  }
  return ends;
}

/// The small cube that the middle of a cell lies in; what lies beyond the complex, and flat cells,
/// whose middle is nowhere, have none.
std::array<std::int64_t, 3> ChokeFlow::CubeOf(CellPlace place, bool& isNowhere) const
{
  std::array<std::int64_t, 3> cube{};
  const TetrahedronId cell = this->Around.Cells()[place];
  isNowhere = !cell.Exists();
  if (!isNowhere)
  {
    const Point3 middle =
      (1.0 / (Grain * this->Radius)) * (this->Around.Middle(cell) - this->Centre);
    isNowhere = !std::isfinite(Dot(middle, middle));
    for (std::size_t k = 0; !isNowhere && k < 3; ++k)
    {
      cube[k] = static_cast<std::int64_t>(std::floor(std::clamp(middle[k], -1e9, 1e9)));
    }
  }
  return cube;
}

/// Per cell, the node of the flow: 0 and 1 for what stays whole on either side, one for all cells
/// whose middles share a small cube. Fine sampling makes very many of these, and the choice among
/// them does not change the loops.
ChokeFlow::NodeByCell ChokeFlow::Nodes(std::int32_t& count) const
{
  NodeByCell nodes(this->Around.Cells().size(), -1);
  const auto ends = this->Ends();
  for (std::size_t side = 0; side < 2; ++side)
  {
    for (const CellPlace cell : ends[side])
    {
      nodes[cell] = static_cast<std::int32_t>(side);
    }
  }
  count = 2;
  std::vector<std::pair<std::array<std::int64_t, 3>, CellPlace>> cubes; // and a cell in each
  for (const CellPlace c : nodes.Keys())
  {
    bool isNowhere = false;
    if (nodes[c] < 0)
    {
      cubes.emplace_back(this->CubeOf(c, isNowhere), c);
    }
    if (isNowhere)
    {
      cubes.pop_back();
      nodes[c] = count++;
    }
  }
  std::sort(cubes.begin(), cubes.end());
  for (std::size_t i = 0; i < cubes.size(); ++i)
  {
    count += i == 0 || cubes[i].first != cubes[i - 1].first ? 1 : 0;
    nodes[cubes[i].second] = count - 1;
  }
  return nodes;
}

/// Links between the same two nodes become one.
std::vector<FlowLink> ChokeFlow::Merged(const NodeByCell& nodes) const
{
  std::vector<FlowLink> links;
  for (const CellLink& link : this->Around.Links())
  {
    const auto [a, b] = std::minmax(nodes[link.Cells[0]], nodes[link.Cells[1]]);
    if (a != b)
    {
      links.push_back({ { a, b }, link.Capacity });
    }
  }
  std::sort(links.begin(), links.end(),
    [](const FlowLink& a, const FlowLink& b) { return a.Nodes < b.Nodes; });
  std::vector<FlowLink> merged;
  for (const FlowLink& link : links)
  {
    if (!merged.empty() && merged.back().Nodes == link.Nodes)
    {
      merged.back().Capacity += link.Capacity;
    }
    else
    {
      merged.push_back(link);
    }
  }
  return merged;
}

std::set<TriangleId> ChokeFlow::Cut(const ProgressCallback& progress) const
{
  std::int32_t count = 0;
  const NodeByCell nodes = this->Nodes(count);
  const std::vector<char> reached = MinimumCut(count, this->Merged(nodes), { 0 }, { 1 }, progress);
  std::set<TriangleId> cut;
  for (const CellLink& link : this->Around.Links())
  {
    if (reached[At(nodes[link.Cells[0]])] != reached[At(nodes[link.Cells[1]])])
    {
      cut.insert(link.Triangle);
    }
  }
  return cut;
}

/// True where the boundary runs along edges that are neither on M nor as short as the error.
bool EndsInSpace(const FeatureContext& context, const TriangleChain& triangles, bool chords)
{
  const EdgeChain boundary = BoundaryOf(context.Filtration, triangles);
  return std::any_of(boundary.begin(), boundary.end(),
    [&](EdgeId e)
    {
      const auto& ends = context.Filtration.Edges[e];
      const Point3 d =
        context.Filtration.Points[At(ends[1])] - context.Filtration.Points[At(ends[0])];
      const bool isChord = chords && context.Homology.ComponentOf(ends[0]) >= 0 &&
        context.Homology.ComponentOf(ends[1]) >= 0;
      return !context.Embedding.SurfaceEdge(e).Exists() && !isChord &&
        Dot(d, d) > 4.0 * context.SquaredError(ends);
    });
}

}

TriangleChain MinimumCutTriangles(const FeatureContext& context, const ShapeFeature& feature,
  const Point3& centre, const ProgressCallback& progress, bool chords)
{
  const auto sides = context.Filtration.TriangleSides(feature.Choke);
  // Values on a mesh need not be lengths: where one is not above 0, no surroundings are its own.
  // And nothing passes through a triangle of M.
  if (sides[0] == sides[1] || !(feature.Radius() > 0.0) || context.IsWall(feature.Choke))
  {
    return {};
  }
  // The function of a mesh has the value of the choke on all triangles of its last vertex.
  ChokeFlow around(context, feature, centre, chords);
  for (const double radii : Reaches)
  {
    const bool isPart = around.Collect(radii * feature.Radius());
    if (around.IsTooLarge())
    {
      return {};
    }
    const std::set<TriangleId> cut = around.Cut(progress);
    if (cut.count(feature.Choke) == 0)
    {
      return {};
    }
    TriangleChain piece = ConnectedPiece(context.Filtration, context.Embedding, cut, feature.Choke);
    if (!isPart || !EndsInSpace(context, piece, chords))
    {
      return piece;
    }
  }
  return {};
}

// ------------------------------------------------------------------------------------------
// GreedyGrowth
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
  bool IsOnSurface(SimplexId p) const { return this->Context.Homology.ComponentOf(p) >= 0; }
  double Value(SimplexId p) const { return this->Context.PointValue[At(p)]; }

  bool TakeDeepest(std::size_t& walk, std::size_t& place) const;
  std::vector<TetrahedronId> Star(SimplexId v) const;
  bool IsOpen(TriangleId t) const;
  Ring RingOf(SimplexId v, const std::vector<TetrahedronId>& star) const;
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

/// True for a triangle that a patch may take: in the filtration before the choke triangle, and not
/// within one cluster.
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

Ring GreedyGrowth::RingOf(SimplexId v, const std::vector<TetrahedronId>& star) const
{
  Ring ring;
  for (const TetrahedronId cell : star)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const TetrahedronId beyond = this->F.Neighbours[cell][corner];
      const TriangleId t = this->F.TriangleOf(cell, corner);
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

/// The cheapest path in a ring, both ends included; empty: there is none.
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
        this->Membrane.count(this->F.TriangleOf(queue[i], corner)) != 0)
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
  ClosedWalk next(old.begin() + 1, old.end()); // from after the vertex around to before it
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
  const Ring ring = this->RingOf(v, star);
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

}
