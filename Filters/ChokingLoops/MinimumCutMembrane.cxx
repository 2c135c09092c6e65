#include "ChokingLoops/MinimumCutMembrane.h"

#include "ChokingLoops/ChainPieces.h"
#include "ChokingLoops/ChokeSurroundings.h"
#include "ChokingLoops/MinimumCut.h"
#include "ChokingLoops/FeatureDiagram.h"
#include "Core/Index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

/// Of the search, in radii of the choke: each costs almost three times the one before, and a
/// membrane that needs more than the last is not taken (README.md).
constexpr std::array<double, 3> Reaches = { 3.0, 4.25, 6.0 };
constexpr double Anchor = 1.5;           ///< of what stays whole on either side, in radii
constexpr double Grain = 0.15;           ///< side of the cubes that share a node, in radii
constexpr std::size_t MostCells = 50000; ///< seconds of work, for each feature that asks

/// The flow from one side of a choke to the other, and what it is held up by.
class ChokeFlow
{
public:
  ChokeFlow(const FeatureContext& context, const ShapeFeature& feature, const Point3& centre)
    : F(context.Filtration)
    , Choke(feature.Choke)
    , Centre(centre)
    , Radius(feature.Distance())
    , Around(context, feature, centre)
  {
  }

  /// As ChokeSurroundings::Collect().
  bool Collect(double reach) { return this->Around.Collect(reach, MostCells); }

  bool IsTooLarge() const { return this->Around.Cells().size() > MostCells; }

  /// The triangles of the smallest cut that parts the two sides of the choke.
  std::set<TriangleId> Cut(const ProgressCallback& progress) const;

private:
  using NodeByCell = HandleVector<CellPlace, std::int32_t>; ///< nodes of the flow

  std::array<std::vector<CellPlace>, 2> Ends() const;
  NodeByCell Nodes(std::int32_t& count) const;
  std::vector<FlowLink> Merged(const NodeByCell& nodes) const;
  std::array<std::int64_t, 3> CubeOf(CellPlace place, bool& isNowhere) const;

  const CellFiltration& F;
  TriangleId Choke;
  Point3 Centre;
  double Radius;
  ChokeSurroundings Around;
};

/// What stays whole on either side. Both grow in turn, so that where they would meet each has half.
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
        if (!cell.Exists() || this->F.TriangleValue[t] <= depth2 ||
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
/// whose middles share a small cube. Fine sampling makes a great many of these, and which of them
/// a membrane passes is nothing that its loops would keep.
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
bool EndsInSpace(const FeatureContext& context, const TriangleChain& triangles)
{
  const EdgeChain boundary = BoundaryOf(context.Filtration, triangles);
  return std::any_of(boundary.begin(), boundary.end(),
    [&context](EdgeId e)
    {
      const auto& ends = context.Filtration.Edges[e];
      const Point3 d =
        context.Filtration.Points[At(ends[1])] - context.Filtration.Points[At(ends[0])];
      return !context.Embedding.SurfaceEdge(e).Exists() &&
        Dot(d, d) > 4.0 * context.SquaredError(ends);
    });
}

}

TriangleChain TightestCut(const FeatureContext& context, const ShapeFeature& feature,
  const Point3& centre, const ProgressCallback& progress)
{
  const auto sides = context.Filtration.TriangleSides(feature.Choke);
  // Values on a mesh need not be lengths: where one is not above 0, no surroundings are its own.
  // And nothing passes through a triangle of M.
  if (sides[0] == sides[1] || !(feature.Distance() > 0.0) || context.IsWall(feature.Choke))
  {
    return {};
  }
  ChokeFlow around(context, feature, centre);
  for (const double radii : Reaches)
  {
    const bool isPart = around.Collect(radii * feature.Distance());
    if (around.IsTooLarge())
    {
      return {};
    }
    const std::set<TriangleId> cut = around.Cut(progress);
    if (cut.count(feature.Choke) == 0)
    {
      return {};
    }
    TriangleChain piece = PieceAround(context.Filtration, context.Embedding, cut, feature.Choke);
    if (!isPart || !EndsInSpace(context, piece))
    {
      return piece;
    }
  }
  return {};
}

}
