#include "TightestCut.h"

#include "ChainPieces.h"
#include "MinimumCut.h"
#include "ShapeFeatures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace isthmus
{
namespace
{

std::size_t At(std::int64_t i)
{
  return static_cast<std::size_t>(i);
}

constexpr double FirstReach = 3.0;       ///< of the search, in radii of the choke
constexpr double Anchor = 1.5;           ///< of what stays whole on either side, in radii
constexpr double Grain = 0.15;           ///< side of the cubes that share a node, in radii
constexpr std::size_t MostCells = 50000; ///< seconds of work, for each feature that asks
constexpr double CapacityOfRadius2 = 1073741824.0; ///< of an area of one squared radius
constexpr double LargestCapacity = 1e12;           ///< so that a million of them can be added

/// Cells (tetrahedra, and -1 for what is beyond the complex) round a choke triangle, linked across
/// triangles that are no walls.
class Surroundings
{
public:
  Surroundings(const FeatureContext& context, const ShapeFeature& feature, const Point3& centre)
    : Context(context)
    , F(context.Filtration)
    , Choke(feature.Choke)
    , Centre(centre)
    , Radius(feature.Distance())
  {
  }

  /// Takes in all triangles with a corner within `reach` of the centre; false: these are all.
  bool Collect(double reach);

  bool IsTooLarge() const { return this->Cells.size() > MostCells; }

  /// The triangles of the smallest cut that parts the two sides of the choke.
  std::set<SimplexId> Cut(const ProgressCallback& progress) const;

private:
  std::int32_t NumberOf(SimplexId cell);
  std::vector<std::vector<std::int32_t>> Beside() const;
  std::array<std::vector<std::int32_t>, 2> Ends() const;
  std::vector<std::int32_t> Nodes(std::int32_t& count) const;
  bool IsWithin(const Point3& p, double reach) const
  {
    return Dot(p - this->Centre, p - this->Centre) < reach * reach;
  }
  Point3 Middle(SimplexId cell) const;
  double Area(SimplexId triangle) const;

  const FeatureContext& Context;
  const CellFiltration& F;
  SimplexId Choke;
  Point3 Centre;
  double Radius;
  std::unordered_map<SimplexId, std::int32_t> Numbers;
  std::vector<SimplexId> Cells;
  std::vector<SimplexId> Triangles; ///< of each link
  std::vector<FlowLink> Links;
};

std::int32_t Surroundings::NumberOf(SimplexId cell)
{
  const auto next = static_cast<std::int32_t>(this->Cells.size());
  const auto [known, isNew] = this->Numbers.emplace(cell, next);
  if (isNew)
  {
    this->Cells.push_back(cell);
  }
  return known->second;
}

Point3 Surroundings::Middle(SimplexId cell) const
{
  const auto& c = this->F.Tetrahedra[At(cell)];
  const auto p = [&](std::size_t k) -> const Point3& { return this->F.Points[At(c[k])]; };
  return this->Context.PointError.empty() ? 0.25 * (p(0) + p(1) + p(2) + p(3))
                                          : Circumcentre(p(0), p(1), p(2), p(3));
}

double Surroundings::Area(SimplexId triangle) const
{
  const auto& t = this->F.Triangles[At(triangle)];
  const Point3& p = this->F.Points[At(t[0])];
  const Point3 n = Cross(this->F.Points[At(t[1])] - p, this->F.Points[At(t[2])] - p);
  return 0.5 * std::sqrt(Dot(n, n));
}

bool Surroundings::Collect(double reach)
{
  this->Numbers.clear();
  this->Cells.clear();
  this->Triangles.clear();
  this->Links.clear();
  bool isPart = false;
  for (std::size_t t = 0; t < this->F.Triangles.size() && !this->IsTooLarge(); ++t)
  {
    const auto id = static_cast<SimplexId>(t);
    if (this->Context.IsWall(id))
    {
      continue;
    }
    const auto& corners = this->F.Triangles[t];
    // Of a coarse mesh, not even the choke triangle itself need be that near.
    if (id != this->Choke &&
      std::none_of(corners.begin(), corners.end(),
        [&](SimplexId p) { return this->IsWithin(this->F.Points[At(p)], reach); }))
    {
      isPart = true;
      continue;
    }
    const double capacity =
      1.0 + CapacityOfRadius2 * this->Area(id) / (this->Radius * this->Radius);
    const auto& sides = this->F.TriangleSides[t];
    this->Links.push_back({ { this->NumberOf(sides[0]), this->NumberOf(sides[1]) },
      static_cast<std::int64_t>(std::min(capacity, LargestCapacity)) });
    this->Triangles.push_back(id);
  }
  return isPart;
}

/// Per cell: its links.
std::vector<std::vector<std::int32_t>> Surroundings::Beside() const
{
  std::vector<std::vector<std::int32_t>> beside(this->Cells.size());
  for (std::size_t l = 0; l < this->Links.size(); ++l)
  {
    for (const std::int32_t node : this->Links[l].Nodes)
    {
      beside[At(node)].push_back(static_cast<std::int32_t>(l));
    }
  }
  return beside;
}

/// What stays whole on either side. Both grow in turn, so that where they would meet each has half.
std::array<std::vector<std::int32_t>, 2> Surroundings::Ends() const
{
  const auto beside = this->Beside();
  const double depth2 = this->Radius * this->Radius * (1.0 + 1e-9);
  std::vector<char> side(this->Cells.size(), 0); // 1 and 2: taken
  std::vector<std::int32_t> queue;
  const auto& chokeSides = this->F.TriangleSides[At(this->Choke)];
  for (std::size_t s = 0; s < 2; ++s)
  {
    queue.push_back(this->Numbers.at(chokeSides[s]));
    side[At(queue.back())] = static_cast<char>(s + 1);
  }
  std::array<std::vector<std::int32_t>, 2> ends;
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    const char own = side[At(queue[i])];
    ends[static_cast<std::size_t>(own - 1)].push_back(queue[i]);
    for (const std::int32_t l : beside[At(queue[i])])
    {
      const auto& nodes = this->Links[At(l)].Nodes;
      const std::int32_t other = nodes[0] == queue[i] ? nodes[1] : nodes[0];
      const SimplexId cell = this->Cells[At(other)];
      if (side[At(other)] == 0 && cell >= 0 &&
        this->F.TriangleValue[At(this->Triangles[At(l)])] > depth2 &&
        this->IsWithin(this->Middle(cell), Anchor * this->Radius))
      {
        side[At(other)] = own;
        queue.push_back(other);
      }
    }
  }
  return ends;
}

/// Per cell, the node of the flow: 0 and 1 for what stays whole on either side, one for all cells
/// whose middles share a small cube. Fine sampling makes a great many of these, and which of them
/// a membrane passes is nothing that its loops would keep.
std::vector<std::int32_t> Surroundings::Nodes(std::int32_t& count) const
{
  std::vector<std::int32_t> nodes(this->Cells.size(), -1);
  const auto ends = this->Ends();
  for (std::size_t side = 0; side < 2; ++side)
  {
    for (const std::int32_t cell : ends[side])
    {
      nodes[At(cell)] = static_cast<std::int32_t>(side);
    }
  }
  count = 2;
  std::map<std::array<std::int64_t, 3>, std::int32_t> cubes;
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    if (nodes[c] >= 0)
    {
      continue;
    }
    const Point3 place = this->Cells[c] < 0
      ? this->Centre
      : (1.0 / (Grain * this->Radius)) * (this->Middle(this->Cells[c]) - this->Centre);
    // What lies beyond the complex, and flat cells, whose middle is nowhere, stay by themselves.
    if (this->Cells[c] < 0 || !std::isfinite(Dot(place, place)))
    {
      nodes[c] = count++;
      continue;
    }
    std::array<std::int64_t, 3> cube;
    std::transform(place.begin(), place.end(), cube.begin(),
      [](double x) { return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e9, 1e9))); });
    const auto [known, isNew] = cubes.emplace(cube, count);
    count += isNew ? 1 : 0;
    nodes[c] = known->second;
  }
  return nodes;
}

std::set<SimplexId> Surroundings::Cut(const ProgressCallback& progress) const
{
  std::int32_t count = 0;
  const std::vector<std::int32_t> nodes = this->Nodes(count);
  std::map<std::array<std::int32_t, 2>, std::int64_t> capacity;
  for (const FlowLink& link : this->Links)
  {
    const auto [a, b] = std::minmax(nodes[At(link.Nodes[0])], nodes[At(link.Nodes[1])]);
    if (a != b)
    {
      capacity[{ a, b }] += link.Capacity;
    }
  }
  std::vector<FlowLink> links;
  for (const auto& [ends, sum] : capacity)
  {
    links.push_back({ ends, sum });
  }
  const std::vector<char> reached = MinimumCut(count, links, { 0 }, { 1 }, progress);
  std::set<SimplexId> cut;
  for (std::size_t l = 0; l < this->Links.size(); ++l)
  {
    const auto& cells = this->Links[l].Nodes;
    if (reached[At(nodes[At(cells[0])])] != reached[At(nodes[At(cells[1])])])
    {
      cut.insert(this->Triangles[l]);
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
  const auto& sides = context.Filtration.TriangleSides[At(feature.Choke)];
  // Values on a mesh need not be lengths: where one is not above 0, no surroundings are its own.
  // And nothing passes through a triangle of M.
  if (sides[0] == sides[1] || !(feature.Distance() > 0.0) || context.IsWall(feature.Choke))
  {
    return {};
  }
  Surroundings around(context, feature, centre);
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
