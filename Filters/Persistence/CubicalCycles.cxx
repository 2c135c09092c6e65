#include "Persistence/CubicalCycles.h"

#include "Persistence/CubicalComponents.h"
#include "Persistence/CubicalGradient.h"
#include "Persistence/CubicalLoops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Shortest paths through a volume's complex, for the cycles around its tunnels.

/**
 * Shortest paths through the complex just before a node enters (Dijkstra, by cells: along edges and
 * across faces and cubes). Cost: the part of the volume within the length of the path.
 */
template <typename Gradient>
class ShortestPaths
{
public:
  using Nodes = std::vector<std::int64_t>;

  ShortestPaths(const Gradient& gradient, const std::array<double, 3>& spacing)
    : Cells(gradient)
  {
    for (std::size_t cell = 0; cell < 26; ++cell)
    {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double step = Star::Steps[cell][axis] * spacing[axis];
        squared += step * step;
      }
      this->Lengths[cell] = std::sqrt(squared);
    }
  }

  /// From the far end of an edge to its node, which is the one that enters: nodes, both ends
  /// included. Empty if there is no path.
  Nodes CloseEdge(std::int64_t node, std::int64_t far)
  {
    return this->Find(far, node, node, std::numeric_limits<double>::infinity());
  }

  /// Between two nodes that existed before `latest`, if there is a path shorter than `limit`.
  Nodes Between(std::int64_t from, std::int64_t to, std::int64_t latest, double limit)
  {
    return this->Find(from, to, latest, limit);
  }

  double StepLength(StarCell cell) const { return this->Lengths[cell.Index()]; }

private:
  Nodes Find(std::int64_t from, std::int64_t to, std::int64_t latest, double limit)
  {
    this->Start = from;
    this->Goal = to;
    this->Latest = latest;
    this->Reached.clear();
    Open open;
    this->Offer(open, from, 0.0, from);
    while (!open.empty())
    {
      const auto [length, at] = open.top();
      open.pop();
      if (length >= limit)
      {
        break;
      }
      if (at == to)
      {
        return this->Trace();
      }
      if (length <= this->Reached[at].Length)
      {
        this->Spread(open, at, length);
      }
    }
    return {};
  }

  struct Visit
  {
    double Length;
    std::int64_t From;
  };
  using Entry = std::pair<double, std::int64_t>;
  using Open = std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>>;

  void Offer(Open& open, std::int64_t node, double length, std::int64_t from)
  {
    const auto [visit, isNew] = this->Reached.try_emplace(node, Visit{ length, from });
    if (isNew || length < visit->second.Length)
    {
      visit->second = { length, from };
      open.push({ length, node });
    }
  }

  void Spread(Open& open, std::int64_t at, double length)
  {
    const LowerStars& stars = this->Cells.Lower();
    for (const StarCell cell : HandleRange<StarCell>(Star::Node))
    {
      if (!this->StaysInside(at, cell))
      {
        continue;
      }
      const std::int64_t next = at + stars.Offset(cell);
      // The last step is along another edge of the node; diagonals keep away from it, so that
      // they do not run along the edge itself.
      const bool arrives = next == this->Latest && next == this->Goal &&
        cell.Value < Star::FirstFace && at != this->Start;
      if (arrives || this->HadEntered(at, cell))
      {
        this->Offer(open, next, length + this->StepLength(cell), at);
      }
    }
  }

  bool StaysInside(std::int64_t node, StarCell cell) const
  {
    const LowerStars& stars = this->Cells.Lower();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t at = node / stars.Stride(axis) % stars.Dimensions()[axis];
      const std::int64_t to = at + Star::Steps[cell.Index()][axis];
      if (to < 0 || to >= stars.Dimensions()[axis])
      {
        return false;
      }
    }
    return true;
  }

  /// Whether all corners of the cell entered before the latest.
  bool HadEntered(std::int64_t node, StarCell cell) const
  {
    const auto& step = Star::Steps[cell.Index()];
    for (int corner = 1; corner < 8; ++corner)
    {
      std::int64_t at = node;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        at += (corner >> axis & 1) != 0 ? step[axis] * this->Cells.Lower().Stride(axis) : 0;
      }
      if (!this->Cells.IsLater(this->Latest, at))
      {
        return false;
      }
    }
    return true;
  }

  Nodes Trace()
  {
    Nodes nodes{ this->Goal };
    while (nodes.back() != this->Start)
    {
      nodes.push_back(this->Reached[nodes.back()].From);
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

  const Gradient& Cells;
  std::array<double, 26> Lengths{};
  std::int64_t Goal = 0;
  std::int64_t Start = 0;
  std::int64_t Latest = 0;
  std::unordered_map<std::int64_t, Visit> Reached;
};

//--------------------------------------------------------------------------------------------------
// Closes a reduced column, from which edges that join components were omitted.

/**
 * The edges that join components are a spanning tree of the grid: gradient paths down to minima,
 * and critical edges between these. The missing part of a column is the only set of them that
 * closes it, and it lies below the column.
 */
template <typename Gradient>
class LoopCompletion
{
public:
  using Key = typename Gradient::Key;
  using Nodes = std::vector<std::int64_t>;

  LoopCompletion(
    const Gradient& gradient, const std::vector<Key>& edges, const std::vector<char>& negative)
    : Cells(gradient)
    , Edges(edges)
    , Negative(negative)
  {
  }

  /// Closed paths that together consist of the column and the missing edges.
  std::vector<Nodes> Close(const std::vector<Key>& column)
  {
    if (this->Above.empty())
    {
      this->MakeTree();
    }
    this->Chain.clear();
    std::set<std::int64_t> odd;
    for (const Key& edge : column)
    {
      const auto ends = this->Cells.GetEnds(edge);
      this->ToggleEdge(ends[0], ends[1]);
      Toggle(odd, ends[0]);
      Toggle(odd, ends[1]);
    }
    for (const std::int64_t node : odd)
    {
      this->TogglePathToRoot(node);
    }
    return this->TakeLoops();
  }

private:
  struct Link
  {
    std::int64_t Minimum; ///< towards the root
    std::size_t Edge;     ///< number of the critical edge between
  };

  template <typename T>
  static void Toggle(std::set<T>& set, const T& member)
  {
    if (!set.insert(member).second)
    {
      set.erase(member);
    }
  }

  void ToggleEdge(std::int64_t a, std::int64_t b)
  {
    Toggle(this->Chain, std::make_pair(std::min(a, b), std::max(a, b)));
  }

  std::int64_t Below(std::int64_t node) const
  {
    const int edge = this->Cells.Lower()[node].Partner[Star::Node];
    return edge == Star::Node ? node : node + this->Cells.Lower().Offset(StarCell(edge));
  }

  std::int64_t FindMinimum(std::int64_t node) const
  {
    for (std::int64_t next = this->Below(node); next != node; next = this->Below(node))
    {
      node = next;
    }
    return node;
  }

  /// Descends from `node` to its minimum, toggling the path.
  std::int64_t ToggleDescent(std::int64_t node)
  {
    for (std::int64_t next = this->Below(node); next != node; next = this->Below(node))
    {
      this->ToggleEdge(node, next);
      node = next;
    }
    return node;
  }

  void TogglePathToRoot(std::int64_t node)
  {
    std::int64_t minimum = this->ToggleDescent(node);
    for (auto link = this->Above.find(minimum); link->second.Minimum >= 0;
         link = this->Above.find(minimum))
    {
      const auto ends = this->Cells.GetEnds(this->Edges[link->second.Edge]);
      this->ToggleEdge(ends[0], ends[1]);
      this->ToggleDescent(ends[0]);
      this->ToggleDescent(ends[1]);
      minimum = link->second.Minimum;
    }
  }

  void MakeTree()
  {
    std::map<std::int64_t, std::vector<Link>> neighbours;
    for (std::size_t i = 0; i < this->Edges.size(); ++i)
    {
      if (this->Negative[i])
      {
        const auto ends = this->Cells.GetEnds(this->Edges[i]);
        const std::int64_t a = this->FindMinimum(ends[0]);
        const std::int64_t b = this->FindMinimum(ends[1]);
        neighbours[a].push_back({ b, i });
        neighbours[b].push_back({ a, i });
      }
    }
    const std::int64_t root = this->FindMinimum(0);
    this->Above[root] = { -1, 0 };
    Nodes open{ root };
    while (!open.empty())
    {
      const std::int64_t minimum = open.back();
      open.pop_back();
      for (const Link& link : neighbours[minimum])
      {
        if (this->Above.try_emplace(link.Minimum, Link{ minimum, link.Edge }).second)
        {
          open.push_back(link.Minimum);
        }
      }
    }
  }

  /// Removes closed paths from the chain until nothing is left. Every node has an even number of
  /// edges.
  std::vector<Nodes> TakeLoops()
  {
    std::map<std::int64_t, std::set<std::int64_t>> beside;
    for (const auto& edge : this->Chain)
    {
      beside[edge.first].insert(edge.second);
      beside[edge.second].insert(edge.first);
    }
    std::vector<Nodes> loops;
    while (!beside.empty())
    {
      Nodes way{ beside.begin()->first };
      std::map<std::int64_t, std::size_t> at{ { way.front(), 0 } };
      for (;;)
      {
        const std::int64_t here = way.back();
        const std::int64_t next = *beside[here].begin();
        Remove(beside, here, next);
        Remove(beside, next, here);
        const auto [seen, isNew] = at.try_emplace(next, way.size());
        if (!isNew)
        {
          // A loop has closed; the path that leads to it is resumed later.
          loops.emplace_back(way.begin() + static_cast<std::ptrdiff_t>(seen->second), way.end());
          for (std::size_t i = 0; i < seen->second; ++i)
          {
            beside[way[i]].insert(way[i + 1]);
            beside[way[i + 1]].insert(way[i]);
          }
          break;
        }
        way.push_back(next);
      }
    }
    return loops;
  }

  static void Remove(
    std::map<std::int64_t, std::set<std::int64_t>>& beside, std::int64_t from, std::int64_t to)
  {
    const auto found = beside.find(from);
    found->second.erase(to);
    if (found->second.empty())
    {
      beside.erase(found);
    }
  }

  const Gradient& Cells;
  const std::vector<Key>& Edges;
  const std::vector<char>& Negative;
  std::map<std::int64_t, Link> Above; ///< from each minimum towards the root
  std::set<std::pair<std::int64_t, std::int64_t>> Chain;
};

namespace
{

using Nodes = std::vector<std::int64_t>;

/// The grid's edges along a closed path; diagonals are taken axis by axis.
template <typename Gradient>
std::vector<typename Gradient::Key> EdgesAlong(const Gradient& gradient, const Nodes& way)
{
  const LowerStars& stars = gradient.Lower();
  std::vector<typename Gradient::Key> edges;
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    std::int64_t at = way[i];
    const std::int64_t to = way[(i + 1) % way.size()];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t stride = stars.Stride(axis);
      const std::int64_t length = stars.Dimensions()[axis];
      const std::int64_t steps = to / stride % length - at / stride % length;
      if (steps != 0)
      {
        edges.push_back(gradient.EdgeAlong(at, axis, steps > 0));
        at += steps * stride;
      }
    }
  }
  return edges;
}

double ComputeLoopLength(
  const Nodes& loop, const LowerStars& stars, const std::array<double, 3>& spacing)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto at = [&](std::int64_t node)
      { return node / stars.Stride(axis) % stars.Dimensions()[axis]; };
      const double step =
        static_cast<double>(at(loop[(i + 1) % loop.size()]) - at(loop[i])) * spacing[axis];
      squared += step * step;
    }
    length += std::sqrt(squared);
  }
  return length;
}

/// Shortens cycles within their class.
template <typename Gradient>
class CycleShortening
{
public:
  CycleShortening(const Gradient& gradient, LoopReduction<Gradient>& reduction,
    const std::array<double, 3>& spacing)
    : Cells(gradient)
    , Reduction(reduction)
    , Paths(gradient, spacing)
    , Spacing(spacing)
  {
  }

  ShortestPaths<Gradient>& Shortest() { return this->Paths; }

  /**
   * Replaces arcs, longer ones first, by shorter paths if the loop between them is filled by the
   * faces reduced so far. Arcs with the node `latest` stay.
   */
  void Shorten(Nodes& loop, std::int64_t latest)
  {
    const auto own = std::find(loop.begin(), loop.end(), latest);
    if (own != loop.end())
    {
      std::rotate(loop.begin(), own, loop.end());
    }
    for (int round = 0; round < 3; ++round)
    {
      bool changed = false;
      for (std::size_t width = loop.size() / 2; width >= 2; width /= 2)
      {
        for (std::size_t i = 1; i + width < loop.size(); i += std::max<std::size_t>(1, width / 2))
        {
          changed = this->Replace(loop, i, width, latest) || changed;
        }
      }
      if (!changed)
      {
        break;
      }
    }
  }

private:
  bool Replace(Nodes& loop, std::size_t first, std::size_t width, std::int64_t latest)
  {
    const auto begin = loop.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = begin + static_cast<std::ptrdiff_t>(width + 1);
    const Nodes arc(begin, end);
    const LowerStars& stars = this->Cells.Lower();
    const double length = ComputeLoopLength(arc, stars, this->Spacing) -
      ComputeLoopLength({ arc.back(), arc.front() }, stars, this->Spacing) / 2.0;
    const Nodes way = this->Paths.Between(arc.front(), arc.back(), latest, 0.999 * length);
    if (way.empty())
    {
      return false;
    }
    Nodes between(arc);
    between.insert(between.end(), way.rbegin() + 1, way.rend() - 1);
    if (!this->Reduction.IsFilled(EdgesAlong(this->Cells, between)))
    {
      return false;
    }
    Nodes shorter(loop.begin(), begin);
    shorter.insert(shorter.end(), way.begin(), way.end());
    shorter.insert(shorter.end(), end, loop.end());
    loop.swap(shorter);
    return true;
  }

  const Gradient& Cells;
  LoopReduction<Gradient>& Reduction;
  ShortestPaths<Gradient> Paths;
  std::array<double, 3> Spacing;
};

/// Features of dimension 1 by the face that ends them.
using SelectedFeatures = std::unordered_map<std::int64_t, std::int64_t>;

SelectedFeatures SelectCycles(const FeatureList& features, std::size_t most)
{
  SelectedFeatures wanted;
  for (std::size_t i = 0; i < features.Kept && wanted.size() < most; ++i)
  {
    const CubicalPair& pair = features.Features[i].Pair;
    if (pair.Dimension == 1)
    {
      wanted[pair.Death.Name()] = static_cast<std::int64_t>(i);
    }
  }
  return wanted;
}

/// A reduction checks that the face that ends the feature fills exactly the shortest loop, and not
/// an earlier one. If the shortest path also runs around another tunnel, the boundary of the
/// pairing is shortened arc by arc, checking each time that the difference is filled while the
/// feature exists. It can have several loops; those that are filled on their own are dropped.
template <typename Gradient>
std::vector<CubicalCycle> Trace(const Gradient& gradient, const std::array<double, 3>& spacing,
  const SelectedFeatures& wanted, const ProgressCallback& progress)
{
  const CubicalCritical<Gradient> critical(gradient);
  LoopReduction<Gradient> reduction(gradient, critical.Edges, critical.Negative);
  LoopCompletion<Gradient> completion(gradient, critical.Edges, critical.Negative);
  CycleShortening<Gradient> shortening(gradient, reduction, spacing);
  std::vector<CubicalCycle> cycles;
  const auto keep = [&](std::int64_t feature, const Nodes& loop) {
    cycles.push_back({ feature, loop, ComputeLoopLength(loop, gradient.Lower(), spacing) });
  };
  std::size_t done = 0;
  for (std::size_t i = 0; i < critical.Faces.size() && done < wanted.size(); ++i)
  {
    const auto& face = critical.Faces[i];
    const auto found = wanted.find(gradient.MakeCell(face.Node(), Gradient::GetFace(face)).Name());
    if (found == wanted.end())
    {
      reduction.Fill(face);
      continue;
    }
    Report(progress, static_cast<double>(done) / static_cast<double>(wanted.size()));
    ++done;
    const auto edge = reduction.Find(face);
    const auto ends = gradient.GetEnds(edge);
    const Nodes loop = shortening.Shortest().CloseEdge(ends[0], ends[1]);
    const auto edges =
      loop.empty() ? std::vector<typename Gradient::Key>() : EdgesAlong(gradient, loop);
    // Filled by this face, and not before.
    const bool lived = !loop.empty() && !reduction.IsFilled(edges);
    reduction.Fill(face);
    if (lived && reduction.IsFilled(edges))
    {
      keep(found->second, loop);
      continue;
    }
    // Another tunnel was in the way. As long as this one exists, loops that are filled can be
    // crossed.
    std::vector<Nodes> parts = completion.Close(reduction.BuildColumn(edge));
    reduction.SetUsed(edge, false);
    for (Nodes& part : parts)
    {
      if (!reduction.IsFilled(EdgesAlong(gradient, part)))
      {
        shortening.Shorten(part, edge.Node());
        keep(found->second, part);
      }
    }
    reduction.SetUsed(edge, true);
  }
  std::stable_sort(cycles.begin(), cycles.end(),
    [](const CubicalCycle& a, const CubicalCycle& b) { return a.Feature < b.Feature; });
  return cycles;
}

}

std::vector<CubicalCycle> CubicalCycles(const VolumeView& volume,
  const std::array<double, 3>& spacing, const FeatureList& features, bool superlevel,
  std::size_t most, const ProgressCallback& progress)
{
  std::vector<CubicalCycle> cycles;
  const SelectedFeatures wanted = SelectCycles(features, most);
  if (!wanted.empty())
  {
    WithGradient(volume, superlevel, Between(progress, 0.0, 0.2),
      [&](const auto& gradient)
      { cycles = Trace(gradient, spacing, wanted, Between(progress, 0.2, 1.0)); });
  }
  return cycles;
}

}
