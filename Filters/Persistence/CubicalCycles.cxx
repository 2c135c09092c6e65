#include "Persistence/CubicalCycles.h"

#include "Persistence/CubicalCritical.h"
#include "Persistence/CubicalLoops.h"
#include "Persistence/LoopCompletion.h"
#include "Persistence/WayRound.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace isthmus
{
namespace
{

using Nodes = std::vector<std::int64_t>;

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

/// Makes cycles shorter and keeps their class.
template <typename Gradient>
class CycleShortening
{
public:
  CycleShortening(const Gradient& gradient, LoopReduction<Gradient>& reduction,
    const std::array<double, 3>& spacing)
    : Cells(gradient)
    , Reduction(reduction)
    , Ways(gradient, spacing)
    , Spacing(spacing)
  {
  }

  WayRound<Gradient>& Shortest() { return this->Ways; }

  /**
   * Replaces arcs, longer ones first, by shorter ways where what lies between is filled by the
   * faces given to the reduction so far. Arcs with the node `latest` stay.
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
    const double length = LengthOf(arc, stars, this->Spacing) -
      LengthOf({ arc.back(), arc.front() }, stars, this->Spacing) / 2.0;
    const Nodes way = this->Ways.Between(arc.front(), arc.back(), latest, 0.999 * length);
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
  WayRound<Gradient> Ways;
  std::array<double, 3> Spacing;
};

/// Features of dimension 1 by the face that ends them.
using Wanted = std::unordered_map<std::int64_t, std::int64_t>;

Wanted WantedOf(const FeatureList& features, std::size_t most)
{
  Wanted wanted;
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

template <typename Gradient>
std::vector<CubicalCycle> Trace(const Gradient& gradient, const std::array<double, 3>& spacing,
  const Wanted& wanted, const ProgressCallback& progress)
{
  const CubicalCritical<Gradient> critical(gradient);
  LoopReduction<Gradient> reduction(gradient, critical.Edges, critical.Negative);
  LoopCompletion<Gradient> completion(gradient, critical.Edges, critical.Negative);
  CycleShortening<Gradient> shortening(gradient, reduction, spacing);
  std::vector<CubicalCycle> cycles;
  const auto keep = [&](std::int64_t feature, const Nodes& loop) {
    cycles.push_back({ feature, loop, LengthOf(loop, gradient.Lower(), spacing) });
  };
  std::size_t done = 0;
  for (std::size_t i = 0; i < critical.Faces.size() && done < wanted.size(); ++i)
  {
    const auto& face = critical.Faces[i];
    const auto found = wanted.find(gradient.Named(face.Node(), Gradient::FaceOf(face)).Name());
    if (found == wanted.end())
    {
      reduction.Fill(face);
      continue;
    }
    Report(progress, static_cast<double>(done) / static_cast<double>(wanted.size()));
    ++done;
    const auto edge = reduction.Find(face);
    const auto ends = gradient.EndsOf(edge);
    const Nodes loop = shortening.Shortest().Round(ends[0], ends[1]);
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
    // Another tunnel was in the way. As long as this one lives, what is filled can be passed.
    std::vector<Nodes> parts = completion.Close(reduction.ColumnOf(edge));
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
