#include "Contouring/ContourClusters.h"

#include "Contouring/CellBox.h"

#include <algorithm>
#include <numeric>

namespace isthmus
{
namespace
{

std::int64_t RootOf(std::vector<std::int64_t>& roots, std::int64_t id)
{
  const auto at = [&roots](std::int64_t i) -> std::int64_t&
  { return roots[static_cast<std::size_t>(i)]; };
  while (at(id) != id)
  {
    at(id) = at(at(id));
    id = at(id);
  }
  return id;
}

/// The cell of an octree, 2^depth grid cells each way, that has `index` in it.
Bounds3 CellOf(const UniformContour& contour, UniformContour::Index index, int depth, double reach)
{
  for (std::int64_t& i : index)
  {
    i = i >> depth << depth;
  }
  return CellBox(contour.Shape, index, std::int64_t{ 1 } << depth, reach);
}

}

ContourClusters::ContourClusters(const UniformContour& contour,
  const DualContouringParameters& parameters, const ProgressCallback& progress)
  : NumberOfPoints(static_cast<std::int64_t>(contour.Points.size()))
  , Points(contour.Points)
  , Parent(contour.Points.size(), -1)
  , MayStand(contour.Points.size(), 1)
{
  if (parameters.Tolerance > 0.0)
  {
    Level level = this->Fine(contour);
    const auto& n = contour.Shape.Dimensions;
    const std::int64_t most = *std::max_element(n.begin(), n.end());
    int depth = 1;
    while (most >> (depth - 1) > 0 && this->AddLevel(level, depth, contour, parameters))
    {
      Report(progress, 1.0 - std::pow(0.3, depth));
      ++depth;
    }
  }
  this->Choose();
}

ContourClusters::Level ContourClusters::Fine(const UniformContour& contour) const
{
  Level level;
  for (std::int64_t p = 0; p < this->NumberOfPoints; ++p)
  {
    level.Clusters.push_back({ p, contour.Errors[At(p)] });
  }
  for (const UniformContour::Edge& edge : contour.Edges)
  {
    level.Edges.push_back(edge.Around);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::int64_t a = edge.Around[i], b = edge.Around[(i + 1) % 4];
      level.Sides.push_back({ std::min(a, b), std::max(a, b) });
    }
  }
  std::sort(level.Sides.begin(), level.Sides.end());
  level.Sides.erase(std::unique(level.Sides.begin(), level.Sides.end()), level.Sides.end());
  level.Cells = contour.Cells;
  level.Euler.assign(contour.Points.size(), 1);
  return level;
}

/// Roots of clusters joined by sides inside a cell of this depth; these sides and the edges inside
/// such cells are counted for Euler's number of the root, and taken out.
std::vector<std::int64_t> ContourClusters::Joined(Level& level, int depth) const
{
  const auto isSame = [&level, depth](std::int64_t a, std::int64_t b)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (level.Cells[At(a)][axis] >> depth != level.Cells[At(b)][axis] >> depth)
      {
        return false;
      }
    }
    return true;
  };
  std::vector<std::int64_t> roots(this->Points.size());
  std::iota(roots.begin(), roots.end(), std::int64_t{ 0 });
  const auto outside = std::stable_partition(level.Sides.begin(), level.Sides.end(),
    [&](const auto& side) { return !isSame(side[0], side[1]); });
  std::for_each(outside, level.Sides.end(),
    [&](const auto& side)
    {
      const std::int64_t a = RootOf(roots, side[0]), b = RootOf(roots, side[1]);
      roots[At(std::max(a, b))] = std::min(a, b);
    });
  std::vector<int> more(this->Points.size(), 0);
  std::for_each(
    outside, level.Sides.end(), [&](const auto& side) { --more[At(RootOf(roots, side[0]))]; });
  level.Sides.erase(outside, level.Sides.end());
  const auto inside = [&](const std::array<std::int64_t, 4>& edge)
  {
    const bool is =
      isSame(edge[0], edge[1]) && isSame(edge[0], edge[2]) && isSame(edge[0], edge[3]);
    more[At(RootOf(roots, edge[0]))] += is ? 1 : 0;
    return is;
  };
  level.Edges.erase(
    std::remove_if(level.Edges.begin(), level.Edges.end(), inside), level.Edges.end());
  for (std::size_t i = 0; i < more.size(); ++i)
  {
    roots[i] = RootOf(roots, static_cast<std::int64_t>(i));
    level.Euler[i] += more[i];
  }
  return roots;
}

bool ContourClusters::AddLevel(Level& level, int depth, const UniformContour& contour,
  const DualContouringParameters& parameters)
{
  const std::vector<std::int64_t> roots = this->Joined(level, depth);
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<int> members(roots.size(), 0);
  std::vector<std::size_t> place(roots.size(), none); // of a root's cluster among those that follow
  for (const Open& open : level.Clusters)
  {
    ++members[At(roots[At(open.Id)])];
  }
  std::vector<Open> next;
  const std::int64_t first = this->Size();
  for (const Open& open : level.Clusters)
  {
    const std::size_t root = At(roots[At(open.Id)]);
    if (members[root] == 1)
    {
      next.push_back(open);
      continue;
    }
    if (place[root] == none)
    {
      place[root] = next.size();
      next.push_back({ this->Size(), {} });
      this->Points.emplace_back();
      this->Parent.push_back(-1);
      level.Cells.push_back(UniformContour::Index(level.Cells[root]));
      level.Euler.push_back(0);
    }
    Open& cluster = next[place[root]];
    cluster.Errors.Add(open.Errors);
    level.Euler[At(cluster.Id)] += level.Euler[At(open.Id)];
    this->Parent[At(open.Id)] = cluster.Id;
  }
  this->MayStand.resize(this->Points.size(), 0);
  bool any = false;
  for (const Open& open : next)
  {
    if (open.Id >= first)
    {
      const bool near = this->Place(
        open, CellOf(contour, level.Cells[At(open.Id)], depth, parameters.Reach), parameters);
      this->MayStand[At(open.Id)] = near && level.Euler[At(open.Id)] == 1 ? 1 : 0;
      any = any || near;
    }
  }
  level.Clusters.swap(next);
  this->Relabel(level);
  return any;
}

/// Puts a cluster where its planes are met best; are they met well enough?
bool ContourClusters::Place(
  const Open& open, const Bounds3& box, const DualContouringParameters& parameters)
{
  Point3& x = this->Points[At(open.Id)];
  x = open.Errors.Least(box, parameters.FeatureThreshold);
  const auto count = static_cast<double>(open.Errors.NumberOfPlanes());
  return open.Errors.At(x) <= count * parameters.Tolerance * parameters.Tolerance;
}

void ContourClusters::Relabel(Level& level) const
{
  const auto relabel = [this](std::int64_t& id)
  { id = this->Parent[At(id)] < 0 ? id : this->Parent[At(id)]; };
  for (auto& side : level.Sides)
  {
    std::for_each(side.begin(), side.end(), relabel);
  }
  for (auto& edge : level.Edges)
  {
    std::for_each(edge.begin(), edge.end(), relabel);
  }
}

bool ContourClusters::Split(std::int64_t id)
{
  const bool did = this->IsCluster(id) && this->MayStand[At(id)];
  this->MayStand[At(id)] = this->IsCluster(id) ? 0 : 1;
  return did;
}

void ContourClusters::Choose()
{
  this->Top.assign(this->Points.size(), -1);
  for (std::int64_t id = this->Size() - 1; id >= 0; --id)
  {
    const std::int64_t parent = this->Parent[At(id)];
    const std::int64_t above = parent < 0 ? -1 : this->Top[At(parent)];
    this->Top[At(id)] = above >= 0 ? above : this->MayStand[At(id)] ? id : -1;
  }
}

}
