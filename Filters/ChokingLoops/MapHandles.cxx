#include "ChokingLoops/MapHandles.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Bars as they run with the filtration: negative for superlevels.
double Along(bool superlevel, double value)
{
  return superlevel ? -value : value;
}

MapHandle HandleAt(const VolumeView& volume, const FeatureList& features, std::size_t i,
  bool isDeath, const FeatureParameters& parameters)
{
  const ScalarFeature& feature = features.Features[i];
  MapHandle handle;
  handle.Feature = static_cast<std::int64_t>(i);
  const int index = feature.Pair.Dimension + (isDeath ? 1 : 0);
  handle.IsBridge = index == 1;
  handle.Node = isDeath ? feature.Pair.Death.Node() : feature.Pair.Birth.Node();
  handle.Level = volume.Value(handle.Node);
  // A tunnel has a bridge and a window as long as it lives. A bridge between two components stays;
  // the window that closes a void has been open from the start.
  const double first = parameters.Superlevel ? parameters.Range[1] : parameters.Range[0];
  const double last = parameters.Superlevel ? parameters.Range[0] : parameters.Range[1];
  const double from = feature.Pair.Dimension == 2 ? first
    : feature.Pair.Dimension == 0                 ? handle.Level
                                                  : feature.Birth;
  const double to = feature.Pair.Dimension == 0 ? last
    : feature.Pair.Dimension == 2               ? handle.Level
                                                : feature.Death;
  const auto clip = [&](double level)
  { return std::clamp(level, parameters.Range[0], parameters.Range[1]); };
  handle.Interval = { std::min(clip(from), clip(to)), std::max(clip(from), clip(to)) };
  return handle;
}

}

std::vector<MapHandle> MapHandles(
  const VolumeView& volume, const FeatureList& features, const FeatureParameters& parameters)
{
  std::vector<MapHandle> handles;
  for (const bool bridges : { true, false })
  {
    for (std::size_t i = 0; i < features.Kept; ++i)
    {
      const CubicalPair& pair = features.Features[i].Pair;
      for (const bool isDeath : { false, true })
      {
        const int index = pair.Dimension + (isDeath ? 1 : 0);
        if (pair.Death.Node() >= 0 && index == (bridges ? 1 : 2))
        {
          const MapHandle handle = HandleAt(volume, features, i, isDeath, parameters);
          if (handle.Level >= parameters.Range[0] && handle.Level <= parameters.Range[1])
          {
            handles.push_back(handle);
          }
        }
      }
    }
  }
  return handles;
}

std::array<std::int64_t, 3> BettiAt(const FeatureList& features, bool superlevel, double level)
{
  std::array<std::int64_t, 3> betti{};
  const double at = Along(superlevel, level);
  for (std::size_t i = 0; i < features.Kept; ++i)
  {
    const ScalarFeature& feature = features.Features[i];
    const bool alive =
      Along(superlevel, feature.Birth) <= at && at < Along(superlevel, feature.Death);
    betti[static_cast<unsigned char>(feature.Pair.Dimension)] += alive ? 1 : 0;
  }
  return betti;
}

std::vector<StableInterval> StableIntervals(
  const FeatureList& features, bool superlevel, const std::array<double, 2>& range)
{
  std::vector<double> events{ range[0], range[1] };
  for (std::size_t i = 0; i < features.Kept; ++i)
  {
    for (const double level : { features.Features[i].Birth, features.Features[i].Death })
    {
      if (level > range[0] && level < range[1])
      {
        events.push_back(level);
      }
    }
  }
  std::sort(events.begin(), events.end());
  events.erase(std::unique(events.begin(), events.end()), events.end());
  std::vector<StableInterval> intervals;
  for (std::size_t i = 0; i + 1 < events.size(); ++i)
  {
    StableInterval interval{ events[i], events[i + 1], {} };
    interval.Betti = BettiAt(features, superlevel, interval.Middle());
    if (interval.Betti[0] > 0)
    {
      intervals.push_back(interval);
    }
  }
  std::stable_sort(intervals.begin(), intervals.end(),
    [](const StableInterval& a, const StableInterval& b)
    { return a.High - a.Low > b.High - b.Low; });
  return intervals;
}

}
