#include "TightestCut.h"

#include "ChainPieces.h"
#include "ChokeSurroundings.h"
#include "Index.h"
#include "MinimumCut.h"
#include "ShapeFeatures.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr double FirstReach = 3.0;       ///< of the search, in radii of the choke
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
  std::set<SimplexId> Cut(const ProgressCallback& progress) const;

private:
  std::array<std::vector<std::int32_t>, 2> Ends() const;
  std::vector<std::int32_t> Nodes(std::int32_t& count) const;
  std::vector<FlowLink> Merged(const std::vector<std::int32_t>& nodes) const;
  std::array<std::int64_t, 3> CubeOf(std::int32_t cell, bool& isNowhere) const;

  const CellFiltration& F;
  SimplexId Choke;
  Point3 Centre;
  double Radius;
  ChokeSurroundings Around;
};

/// What stays whole on either side. Both grow in turn, so that where they would meet each has half.
std::array<std::vector<std::int32_t>, 2> ChokeFlow::Ends() const
{
  const double depth2 = this->Radius * this->Radius * (1.0 + 1e-9);
  std::vector<char> side(this->Around.Cells().size(), 0); // 1 and 2: taken
  std::vector<std::int32_t> queue;
  const auto chokeSides = this->F.TriangleSides(At(this->Choke));
  for (std::size_t s = 0; s < 2; ++s)
  {
    queue.push_back(this->Around.PlaceOf(chokeSides[s]));
    side[At(queue.back())] = static_cast<char>(s + 1);
  }
  std::array<std::vector<std::int32_t>, 2> ends;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const SimplexId own = this->Around.Cells()[At(queue[i])];
    const char ownSide = side[At(queue[i])];
    ends[static_cast<std::size_t>(ownSide - 1)].push_back(queue[i]);
    this->Around.ForLinks(own,
      [&](SimplexId t, SimplexId cell)
      {
        if (cell < 0 || this->F.TriangleValue[At(t)] <= depth2 ||
          !this->Around.IsWithin(this->Around.Middle(cell), Anchor * this->Radius))
        {
          return;
        }
        const std::int32_t other = this->Around.PlaceOf(cell);
        if (side[At(other)] == 0)
        {
          side[At(other)] = ownSide;
          queue.push_back(other);
        }
      });
  }
  return ends;
}

/// The small cube that the middle of a cell lies in; what lies beyond the complex, and flat cells,
/// whose middle is nowhere, have none.
std::array<std::int64_t, 3> ChokeFlow::CubeOf(std::int32_t cell, bool& isNowhere) const
{
  std::array<std::int64_t, 3> cube{};
  isNowhere = this->Around.Cells()[At(cell)] < 0;
  if (!isNowhere)
  {
    const Point3 place = (1.0 / (Grain * this->Radius)) *
      (this->Around.Middle(this->Around.Cells()[At(cell)]) - this->Centre);
    isNowhere = !std::isfinite(Dot(place, place));
    for (std::size_t k = 0; !isNowhere && k < 3; ++k)
    {
      cube[k] = static_cast<std::int64_t>(std::floor(std::clamp(place[k], -1e9, 1e9)));
    }
  }
  return cube;
}

/// Per cell, the node of the flow: 0 and 1 for what stays whole on either side, one for all cells
/// whose middles share a small cube. Fine sampling makes a great many of these, and which of them
/// a membrane passes is nothing that its loops would keep.
std::vector<std::int32_t> ChokeFlow::Nodes(std::int32_t& count) const
{
  std::vector<std::int32_t> nodes(this->Around.Cells().size(), -1);
  const auto ends = this->Ends();
  for (std::size_t side = 0; side < 2; ++side)
  {
    for (const std::int32_t cell : ends[side])
    {
      nodes[At(cell)] = static_cast<std::int32_t>(side);
    }
  }
  count = 2;
  std::vector<std::pair<std::array<std::int64_t, 3>, std::int32_t>> cubes; // and a cell in each
  for (std::int32_t c = 0; At(c) < this->Around.Cells().size(); ++c)
  {
    bool isNowhere = false;
    if (nodes[At(c)] < 0)
    {
      cubes.emplace_back(this->CubeOf(c, isNowhere), c);
    }
    if (isNowhere)
    {
      cubes.pop_back();
      nodes[At(c)] = count++;
    }
  }
  std::sort(cubes.begin(), cubes.end());
  for (std::size_t i = 0; i < cubes.size(); ++i)
  {
    count += i == 0 || cubes[i].first != cubes[i - 1].first ? 1 : 0;
    nodes[At(cubes[i].second)] = count - 1;
  }
  return nodes;
}

/// Links between the same two nodes become one.
std::vector<FlowLink> ChokeFlow::Merged(const std::vector<std::int32_t>& nodes) const
{
  std::vector<FlowLink> links;
  for (const FlowLink& link : this->Around.Links())
  {
    const auto [a, b] = std::minmax(nodes[At(link.Nodes[0])], nodes[At(link.Nodes[1])]);
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

std::set<SimplexId> ChokeFlow::Cut(const ProgressCallback& progress) const
{
  std::int32_t count = 0;
  const std::vector<std::int32_t> nodes = this->Nodes(count);
  const std::vector<char> reached = MinimumCut(count, this->Merged(nodes), { 0 }, { 1 }, progress);
  std::set<SimplexId> cut;
  for (std::size_t l = 0; l < this->Around.Links().size(); ++l)
  {
    const auto& cells = this->Around.Links()[l].Nodes;
    if (reached[At(nodes[At(cells[0])])] != reached[At(nodes[At(cells[1])])])
    {
      cut.insert(this->Around.Triangles()[l]);
    }
  }
  return cut;
}

/// True where the boundary runs along edges that are neither on M nor as short as the error.
bool EndsInSpace(const FeatureContext& context, const Chain& triangles)
{
  const Chain boundary = BoundaryOf(context.Filtration, triangles);
  return std::any_of(boundary.begin(), boundary.end(),
    [&context](SimplexId e)
    {
      const auto& ends = context.Filtration.Edges[At(e)];
      const Point3 d =
        context.Filtration.Points[At(ends[1])] - context.Filtration.Points[At(ends[0])];
      return context.Embedding.SurfaceEdge(e) < 0 && Dot(d, d) > 4.0 * context.SquaredError(ends);
    });
}

}

Chain TightestCut(const FeatureContext& context, const ShapeFeature& feature, const Point3& centre,
  const ProgressCallback& progress)
{
  const auto sides = context.Filtration.TriangleSides(At(feature.Choke));
  // Values on a mesh need not be lengths: where one is not above 0, no surroundings are its own.
  // And nothing passes through a triangle of M.
  if (sides[0] == sides[1] || !(feature.Distance() > 0.0) || context.IsWall(feature.Choke))
  {
    return {};
  }
  ChokeFlow around(context, feature, centre);
  double reach = FirstReach * feature.Distance();
  for (bool isPart = true; isPart; reach *= 2.0)
  {
    isPart = around.Collect(reach);
    if (around.IsTooLarge())
    {
      return {};
    }
    const std::set<SimplexId> cut = around.Cut(progress);
    if (cut.count(feature.Choke) == 0)
    {
      return {};
    }
    Chain piece = PieceAround(context.Filtration, context.Embedding, cut, feature.Choke);
    if (!isPart || !EndsInSpace(context, piece))
    {
      return piece;
    }
  }
  return {};
}

}
