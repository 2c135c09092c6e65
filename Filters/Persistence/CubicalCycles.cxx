#include "CubicalCycles.h"

#include "CubicalCritical.h"
#include "CubicalLoops.h"
#include "LoopCompletion.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <unordered_map>

namespace isthmus
{
namespace
{

using Nodes = std::vector<std::int64_t>;

/// Shortest way from the far end of an edge round to its node, through cells that were there
/// before. Empty where there is none.
template <typename Gradient>
class WayRound
{
public:
  WayRound(const Gradient& gradient, const std::array<double, 3>& spacing)
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

  /// Nodes from the far end to the edge's own node.
  Nodes Find(std::int64_t node, std::int64_t far)
  {
    this->Goal = node;
    this->Start = far;
    this->Reached.clear();
    Open open;
    this->Offer(open, far, 0.0, far);
    while (!open.empty())
    {
      const auto [length, at] = open.top();
      open.pop();
      if (at == node)
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

  double StepLength(int cell) const { return this->Lengths[static_cast<std::size_t>(cell)]; }

private:
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
    for (int cell = 0; cell < Star::Node; ++cell)
    {
      if (!this->StaysInside(at, cell))
      {
        continue;
      }
      const std::int64_t next = at + stars.Offset(cell);
      // The last step is along another edge of the node; diagonals keep away from it, so that
      // they do not run along the edge itself.
      const bool arrives = next == this->Goal && cell < Star::FirstFace && at != this->Start;
      if (arrives || this->WasThere(at, cell))
      {
        this->Offer(open, next, length + this->StepLength(cell), at);
      }
    }
  }

  bool StaysInside(std::int64_t node, int cell) const
  {
    const LowerStars& stars = this->Cells.Lower();
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t at = node / stars.Stride(axis) % stars.Dimensions()[axis];
      const std::int64_t to = at + Star::Steps[static_cast<std::size_t>(cell)][axis];
      if (to < 0 || to >= stars.Dimensions()[axis])
      {
        return false;
      }
    }
    return true;
  }

  /// Whether all corners of the cell entered before the goal.
  bool WasThere(std::int64_t node, int cell) const
  {
    const auto& step = Star::Steps[static_cast<std::size_t>(cell)];
    for (int corner = 1; corner < 8; ++corner)
    {
      std::int64_t at = node;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        at += (corner >> axis & 1) != 0 ? step[axis] * this->Cells.Lower().Stride(axis) : 0;
      }
      if (!this->Cells.IsLater(this->Goal, at))
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
  std::unordered_map<std::int64_t, Visit> Reached;
};

/// The grid's edges along a closed way; diagonals are taken axis by axis.
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

double LengthOf(const Nodes& loop, const LowerStars& stars, const std::array<double, 3>& spacing)
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

/// Features of dimension 1 by the face that ends them.
using Wanted = std::unordered_map<std::uint64_t, std::int64_t>;

std::uint64_t NameOf(const CubicalCell& cell)
{
  return static_cast<std::uint64_t>(cell.Node) * 27U + static_cast<std::uint64_t>(cell.Direction);
}

Wanted WantedOf(const FeatureList& features, std::size_t most)
{
  Wanted wanted;
  for (std::size_t i = 0; i < features.Kept && wanted.size() < most; ++i)
  {
    const CubicalPair& pair = features.Features[i].Pair;
    if (pair.Dimension == 1)
    {
      wanted[NameOf(pair.Death)] = static_cast<std::int64_t>(i);
    }
  }
  return wanted;
}

template <typename Gradient>
std::vector<CubicalCycle> Trace(const Gradient& gradient, const std::array<double, 3>& spacing,
  const Wanted& wanted, const ProgressCallback& progress)
{
  const CubicalCritical<Gradient> critical(gradient);
  LoopReduction<Gradient> reduction(gradient, critical.Edges, critical.Negative);
  LoopCompletion<Gradient> completion(gradient, critical.Edges, critical.Negative);
  WayRound<Gradient> wayRound(gradient, spacing);
  std::vector<CubicalCycle> cycles;
  const auto keep = [&](std::int64_t feature, const Nodes& loop) {
    cycles.push_back({ feature, loop, LengthOf(loop, gradient.Lower(), spacing) });
  };
  std::size_t done = 0;
  for (std::size_t i = 0; i < critical.Faces.size() && done < wanted.size(); ++i)
  {
    const auto& face = critical.Faces[i];
    const auto found = wanted.find(NameOf(gradient.Named(face.Node(), Gradient::FaceOf(face))));
    if (found == wanted.end())
    {
      reduction.Fill(face);
      continue;
    }
    Report(progress, static_cast<double>(done) / static_cast<double>(wanted.size()));
    ++done;
    const auto edge = reduction.Find(face);
    const auto ends = gradient.EndsOf(edge);
    const Nodes loop = wayRound.Find(ends[0], ends[1]);
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
    for (const Nodes& part : completion.Close(reduction.ColumnOf(edge)))
    {
      keep(found->second, part);
    }
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
  const Wanted wanted = WantedOf(features, most);
  if (!wanted.empty())
  {
    WithGradient(volume, superlevel, Between(progress, 0.0, 0.2),
      [&](const auto& gradient)
      { cycles = Trace(gradient, spacing, wanted, Between(progress, 0.2, 1.0)); });
  }
  return cycles;
}

}
