#include "ChokingLoops/FeatureDrawing.h"

#include "Core/Stopwatch.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// Fewer say little of the others.
constexpr std::size_t LeastSample = 24;

/// One of so many is drawn first.
constexpr std::size_t SampleShare = 4;

}

DrawingCost DrawingCost::After(std::size_t done, std::size_t count, double seconds)
{
  const std::size_t left = count - done;
  return { left,
    done == 0 ? 0.0 : seconds * static_cast<double>(left) / static_cast<double>(done) };
}

std::vector<std::size_t> SampledFirst(std::size_t count, std::size_t& sample)
{
  sample = std::min(count, std::max(LeastSample, count / SampleShare));
  std::vector<std::size_t> order;
  std::vector<char> isFirst(count, 0);
  for (std::size_t i = 0; i < sample; ++i)
  {
    order.push_back((2 * i + 1) * count / (2 * sample)); // the middles of as many equal parts
    isFirst[order.back()] = 1;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!isFirst[i])
    {
      order.push_back(i);
    }
  }
  return order;
}

void DrawFeatures(ChokingLoops& loops, const std::vector<std::size_t>& features, int rounds,
  DrawnFeatures& drawn, const std::function<void(const DrawingCost&)>& estimated,
  const ProgressCallback& progress)
{
  Report(progress, 0.0); // also where nothing is missing: that it is to stop may be known already
  std::vector<std::size_t> missing;
  std::copy_if(features.begin(), features.end(), std::back_inserter(missing),
    [&](std::size_t feature) {
      return drawn.count({ feature, rounds }) == 0;
    });
  std::size_t sample = 0;
  const std::vector<std::size_t> order = SampledFirst(missing.size(), sample);
  const auto done = [&order](std::size_t i)
  { return static_cast<double>(i) / static_cast<double>(order.size()); };
  Stopwatch watch;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == sample && estimated)
    {
      estimated(DrawingCost::After(sample, order.size(), watch.Lap()));
    }
    const std::size_t feature = missing[order[i]];
    const auto part = Between(progress, done(i), done(i + 1));
    Report(part, 0.0);
    drawn.emplace(std::make_pair(feature, rounds), MakeLoopFeature(loops, feature, rounds, part));
  }
}

}
