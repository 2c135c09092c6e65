#include "Persistence/CubicalPersistence.h"

#include "Core/ParallelFor.h"
#include "Persistence/CubicalComponents.h"
#include "Persistence/CubicalLoops.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// Numbers, added up place by place.
struct Histogram
{
  std::vector<std::int64_t> Counts;

  Histogram& operator+=(const Histogram& other)
  {
    for (std::size_t i = 0; i < this->Counts.size(); ++i)
    {
      this->Counts[i] += other.Counts[i];
    }
    return *this;
  }
};

/// The contribution of the stars to the Euler number, summed up to each level.
std::vector<std::int64_t> EulerNumbers(
  const VolumeView& volume, const LowerStars& stars, const CubicalParameters& parameters)
{
  const std::vector<double>& levels = parameters.Levels;
  if (levels.empty())
  {
    return {};
  }
  // At [i + 1], the cells that enter at the i-th level (sublevels: or since the one before it); the
  // last and first entries count those beyond all levels.
  const Histogram none{ std::vector<std::int64_t>(levels.size() + 1, 0) };
  const std::int64_t block = std::max<std::int64_t>(65536, volume.NodeCount() / 64);
  Histogram total = ParallelReduce(volume.NodeCount(), block, none,
    [&](Histogram& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const int change = stars[node].EulerNumber;
        if (change != 0)
        {
          const double value = volume.Value(node);
          const auto at = parameters.Superlevel
            ? std::upper_bound(levels.begin(), levels.end(), value)
            : std::lower_bound(levels.begin(), levels.end(), value);
          part.Counts[static_cast<std::size_t>(at - levels.begin())] += change;
        }
      }
    });
  std::vector<std::int64_t>& counts = total.Counts;
  if (parameters.Superlevel)
  {
    // counts[i]: values in [levels[i - 1], levels[i]): on from level i - 1 downwards.
    for (std::size_t i = levels.size(); i-- > 1;)
    {
      counts[i] += counts[i + 1];
    }
    counts.erase(counts.begin());
    return counts;
  }
  for (std::size_t i = 1; i < levels.size(); ++i)
  {
    counts[i] += counts[i - 1];
  }
  counts.pop_back();
  return counts;
}

template <typename Gradient>
void PairLoops(const Gradient& gradient, const std::vector<typename Gradient::Key>& edges,
  const std::vector<char>& negative, const std::vector<typename Gradient::Key>& faces,
  std::vector<CubicalPair>& pairs, const ProgressCallback& progress)
{
  LoopReduction<Gradient> reduction(gradient, edges, negative);
  reduction.FillAll(
    faces,
    [&](std::int64_t i, const typename Gradient::Key& edge)
    {
      const auto& face = faces[static_cast<std::size_t>(i)];
      if (!edge.SameValue(face))
      {
        pairs.push_back({ gradient.MakeCell(edge.Node(), Gradient::GetEdge(edge)),
          gradient.MakeCell(face.Node(), Gradient::GetFace(face)), 1, CubicalCell() });
      }
    },
    progress);
}

template <typename Gradient>
std::vector<CubicalPair> PairAll(const Gradient& gradient, const ProgressCallback& progress)
{
  CubicalCritical<Gradient> critical(gradient);
  Report(progress, 0.3);
  std::vector<CubicalPair> pairs;
  pairs.swap(critical.Components);
  PairLoops(gradient, critical.Edges, critical.Negative, critical.Faces, pairs,
    Between(progress, 0.3, 1.0));
  pairs.insert(pairs.end(), critical.Voids.begin(), critical.Voids.end());
  return pairs;
}

}

CubicalDiagram CubicalPersistence(
  const VolumeView& volume, const CubicalParameters& parameters, const ProgressCallback& progress)
{
  if (volume.NodeCount() == 0)
  {
    return { {}, std::vector<std::int64_t>(parameters.Levels.size(), 0) };
  }
  RejectNaN(volume);
  Report(progress, 0.0);
  CubicalDiagram diagram;
  WithGradient(volume, parameters.Superlevel, Between(progress, 0.0, 0.4),
    [&](const auto& gradient)
    {
      diagram.EulerNumbers = EulerNumbers(volume, gradient.Lower(), parameters);
      diagram.Pairs = PairAll(gradient, Between(progress, 0.4, 1.0));
    });
  return diagram;
}

}
