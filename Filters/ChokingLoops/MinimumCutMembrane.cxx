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

  /// One char per node: 1 for those that more flow from `source` could reach.
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
  return this->Context.Errors.Point.empty() ? 0.25 * (p(0) + p(1) + p(2) + p(3))
                                            : Circumcenter(p(0), p(1), p(2), p(3));
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

/// The step from a cell over one of its faces, if that is within reach.
void ChokeSurroundings::Cross(TriangleId triangle, CellPlace from)
{
  if (!this->IsWithinReach(triangle))
  {
    this->Beyond.emplace_back(triangle, from);
    return;
  }
  this->Link(triangle, from, this->Meet(this->F.Across(triangle, this->Met[from])));
}

/// Steps over the faces of a cell that were not reached from their other side.
void ChokeSurroundings::Pass(CellPlace own)
{
  const TetrahedronId cell = this->Met[own];
  for (std::size_t corner = 0; cell.Exists() && corner < 4; ++corner)
  {
    const TetrahedronId beyond = this->F.Neighbours[cell][corner];
    const CellPlace place = beyond.Exists() ? this->GetPlace(beyond) : CellPlace::None();
    if (place.Exists() && place < own)
    {
      continue;
    }
    const TriangleId triangle = this->F.GetTriangle(cell, corner);
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

/// Radii of the search, in radii of the choke: each costs almost three times as much as the
/// previous one; a membrane that needs more than the last is not used.
constexpr std::array<double, 3> Reaches = { 3.0, 4.25, 6.0 };
constexpr double Anchor = 1.5;           ///< of the uncut region on either side, in radii
constexpr double Grain = 0.15;           ///< side of the cubes that share a node, in radii
constexpr std::size_t MostCells = 50000; ///< seconds of work for each feature that needs a membrane

/// The flow from one side of a choke to the other, and its bottleneck.
class ChokeFlow
{
public:
  ChokeFlow(
    const FeatureContext& context, const ShapeFeature& feature, const Point3& center, bool byRank)
    : F(context.Filtration)
    , ByRank(byRank)
    , Choke(feature.Choke)
    , Center(center)
    , Radius(feature.Radius())
    , Around(context, feature, center)
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
  std::array<std::int64_t, 3> FindCube(CellPlace place, bool& isNowhere) const;

  const CellFiltration& F;
  bool ByRank; ///< cells that enter after the choke are open, also those of equal value
  TriangleId Choke;
  Point3 Center;
  double Radius;
  ChokeSurroundings Around;
};

/// The cells that the cut does not separate on either side. Both sides grow alternately, so that
/// each gets half where they would meet.
std::array<std::vector<CellPlace>, 2> ChokeFlow::Ends() const
{
  const double depth2 = this->Radius * this->Radius * (1.0 + 1e-9);
  HandleVector<CellPlace, char> side(this->Around.Cells().size(), 0); // 1 and 2: taken
  std::vector<CellPlace> queue;
  const auto chokeSides = this->F.TriangleSides(this->Choke);
  for (std::size_t s = 0; s < 2; ++s)
  {
    queue.push_back(this->Around.GetPlace(chokeSides[s]));
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
        const CellPlace other = this->Around.GetPlace(cell);
        if (side[other] == 0)
        {
          side[other] = ownSide;
          queue.push_back(other);
        }
      });
  }
  return ends;
}

/// The small cube that the middle of a cell lies in; cells beyond the complex, and flat cells,
/// whose middle is undefined, have none.
std::array<std::int64_t, 3> ChokeFlow::FindCube(CellPlace place, bool& isNowhere) const
{
  std::array<std::int64_t, 3> cube{};
  const TetrahedronId cell = this->Around.Cells()[place];
  isNowhere = !cell.Exists();
  if (!isNowhere)
  {
    const Point3 middle =
      (1.0 / (Grain * this->Radius)) * (this->Around.Middle(cell) - this->Center);
    isNowhere = !std::isfinite(Dot(middle, middle));
    for (std::size_t k = 0; !isNowhere && k < 3; ++k)
    {
      cube[k] = static_cast<std::int64_t>(std::floor(std::clamp(middle[k], -1e9, 1e9)));
    }
  }
  return cube;
}

/// Per cell, the node of the flow: 0 and 1 for the uncut region on either side, one for all cells
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
      cubes.emplace_back(this->FindCube(c, isNowhere), c);
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

/// True if the boundary contains edges that are neither on M nor as short as the error.
bool EndsInSpace(const FeatureContext& context, const TriangleChain& triangles, bool chords)
{
  const EdgeChain boundary = ComputeBoundary(context.Filtration, triangles);
  return std::any_of(boundary.begin(), boundary.end(),
    [&](EdgeId e)
    {
      const auto& ends = context.Filtration.Edges[e];
      const Point3 d =
        context.Filtration.Points[At(ends[1])] - context.Filtration.Points[At(ends[0])];
      const bool isChord = chords && context.Homology.GetComponent(ends[0]) >= 0 &&
        context.Homology.GetComponent(ends[1]) >= 0;
      return !context.Embedding.SurfaceEdge(e).Exists() && !isChord &&
        Dot(d, d) > 4.0 * context.SquaredError(ends);
    });
}

}

TriangleChain MinimumCutTriangles(const FeatureContext& context, const ShapeFeature& feature,
  const Point3& center, const ProgressCallback& progress, bool chords)
{
  const auto sides = context.Filtration.TriangleSides(feature.Choke);
  // Values on a mesh need not be lengths: a choke whose value is not positive has no surroundings.
  // The flow passes no triangle of M.
  if (sides[0] == sides[1] || !(feature.Radius() > 0.0) || context.IsWall(feature.Choke))
  {
    return {};
  }
  // The function of a mesh has the value of the choke on all triangles of its last vertex.
  ChokeFlow around(context, feature, center, chords);
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

}
