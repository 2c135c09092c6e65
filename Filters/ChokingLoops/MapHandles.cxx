#include "ChokingLoops/MapHandles.h"

#include "Core/ParallelFor.h"
#include "Persistence/CubicalPersistence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace isthmus
{
namespace
{

/// Values in the direction of the filtration: negative for superlevels.
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
  // A tunnel has a bridge and a window as long as it exists. A bridge between two
  // components stays; the window that closes a void has been open from the start.
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

// ------------------------------------------------------------------------------------------
// HandleSupport
namespace
{

using Index = std::array<std::int64_t, 3>;

constexpr std::int64_t Window = 8; ///< nodes on both sides
constexpr std::int64_t Block = 16;
constexpr int Tries = 20; ///< for a block inside of the mask

Index GridPlace(std::int64_t node, const Index& n)
{
  return { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
}

std::int64_t GridNode(const Index& place, const Index& n)
{
  return place[0] + n[0] * (place[1] + n[1] * place[2]);
}

/// Sums over windows along one axis, in place.
void SumAlong(std::vector<double>& values, const Index& n, std::size_t axis)
{
  const std::int64_t step = axis == 0 ? 1 : axis == 1 ? n[0] : n[0] * n[1];
  const std::int64_t length = n[axis];
  const auto total = static_cast<std::int64_t>(values.size());
  ParallelFor(0, total / length, 64,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<double> sums(static_cast<std::size_t>(length) + 1);
      for (std::int64_t line = first; line < last; ++line)
      {
        const std::int64_t begin = line / step * step * length + line % step;
        sums[0] = 0.0;
        for (std::int64_t i = 0; i < length; ++i)
        {
          sums[static_cast<std::size_t>(i + 1)] =
            sums[static_cast<std::size_t>(i)] + values[static_cast<std::size_t>(begin + i * step)];
        }
        for (std::int64_t i = 0; i < length; ++i)
        {
          const std::int64_t low = std::max<std::int64_t>(i - Window, 0);
          const std::int64_t high = std::min(i + Window + 1, length);
          values[static_cast<std::size_t>(begin + i * step)] =
            sums[static_cast<std::size_t>(high)] - sums[static_cast<std::size_t>(low)];
        }
      }
    });
}

/// Independent of the standard library, whose distributions differ.
std::int64_t Draw(std::mt19937_64& random, std::int64_t count)
{
  return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(count));
}

/// For each of `handles`, the longest first, that one of the same kind among `found` within reach
/// whose interval is the most similar; null if there is none. Each is used once. Sorts `found`.
std::vector<const MapHandle*> Match(
  const std::vector<MapHandle>& handles, std::vector<MapHandle>& found, const Index& n)
{
  std::sort(found.begin(), found.end(),
    [](const MapHandle& a, const MapHandle& b) { return a.Node < b.Node; });
  std::vector<const MapHandle*> matched(handles.size());
  std::vector<bool> used(found.size());
  const std::int64_t slice = n[0] * n[1];
  const auto reach = static_cast<std::int64_t>(HandleMatchDistance);
  for (std::size_t i = 0; i < handles.size(); ++i) // by FeatureId, thus by persistence
  {
    const MapHandle& handle = handles[i];
    const Index a = GridPlace(handle.Node, n);
    const auto first = std::lower_bound(found.begin(), found.end(), (a[2] - reach) * slice,
      [](const MapHandle& other, std::int64_t node) { return other.Node < node; });
    auto least = std::numeric_limits<double>::infinity();
    for (auto at = first; at != found.end() && at->Node < (a[2] + reach + 1) * slice; ++at)
    {
      const Index b = GridPlace(at->Node, n);
      const double distance = std::hypot(static_cast<double>(a[0] - b[0]),
        static_cast<double>(a[1] - b[1]), static_cast<double>(a[2] - b[2]));
      const double difference = std::abs(at->Interval[0] - handle.Interval[0]) +
        std::abs(at->Interval[1] - handle.Interval[1]);
      if (at->IsBridge == handle.IsBridge && distance <= HandleMatchDistance &&
        difference < least && !used[static_cast<std::size_t>(at - found.begin())])
      {
        least = difference;
        matched[i] = &*at;
      }
    }
    if (matched[i])
    {
      used[static_cast<std::size_t>(matched[i] - found.data())] = true;
    }
  }
  return matched;
}

bool IsThere(const MapHandle& handle, double level)
{
  return handle.Interval[0] <= level && level <= handle.Interval[1];
}

/// Whether noise extended the interval of the handle, at either end, by at least its distance from
/// the level.
bool CouldBeNoise(const MapHandle& handle, const MapHandle* resampled, double level)
{
  return !resampled || handle.Interval[0] - resampled->Interval[0] >= level - handle.Interval[0] ||
    resampled->Interval[1] - handle.Interval[1] >= handle.Interval[1] - level;
}

}

NoiseBootstrap::NoiseBootstrap(
  const std::vector<float>& noise, const std::array<std::int64_t, 3>& dimensions)
  : Dimensions(dimensions)
  , Unit(noise)
  , Deviation(noise.size())
{
  std::vector<double> squares(noise.size()), counts(noise.size());
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    squares[i] = static_cast<double>(noise[i]) * static_cast<double>(noise[i]);
    counts[i] = noise[i] != 0.0F ? 1.0 : 0.0;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    SumAlong(squares, dimensions, axis);
    SumAlong(counts, dimensions, axis);
  }
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    if (noise[i] != 0.0F)
    {
      this->Deviation[i] = static_cast<float>(std::sqrt(squares[i] / counts[i]));
      this->Unit[i] /= this->Deviation[i];
    }
  }
}

template <typename T>
void NoiseBootstrap::AddTo(std::vector<T>& values, std::uint64_t seed) const
{
  const Index& n = this->Dimensions;
  std::mt19937_64 random(seed);
  Index size{}, offset{}, count{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    size[a] = std::min(Block, n[a]);
    offset[a] = Draw(random, size[a]);
    count[a] = (n[a] + offset[a] + size[a] - 1) / size[a];
  }
  for (std::int64_t block = 0; block < count[0] * count[1] * count[2]; ++block)
  {
    Index low = GridPlace(block, count), high{}, from{}, best{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = low[a] * size[a] - offset[a];
      high[a] = std::min(low[a] + size[a], n[a]);
    }
    // The nodes of a block from the mask's border have noise only in a part of it.
    int most = -1;
    for (int attempt = 0; attempt < Tries && most < 9; ++attempt)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        from[a] = Draw(random, n[a] - size[a] + 1);
      }
      int known = 0;
      for (const Index& probe :
        { Index{ 0, 0, 0 }, Index{ 1, 0, 0 }, Index{ 0, 1, 0 }, Index{ 1, 1, 0 }, Index{ 0, 0, 1 },
          Index{ 1, 0, 1 }, Index{ 0, 1, 1 }, Index{ 1, 1, 1 } })
      {
        Index at = from;
        for (std::size_t a = 0; a < 3; ++a)
        {
          at[a] += probe[a] * (size[a] - 1);
        }
        known += this->Unit[static_cast<std::size_t>(GridNode(at, n))] != 0.0F ? 1 : 0;
      }
      Index middle = from;
      for (std::size_t a = 0; a < 3; ++a)
      {
        middle[a] += size[a] / 2;
      }
      known += this->Unit[static_cast<std::size_t>(GridNode(middle, n))] != 0.0F ? 1 : 0;
      if (known > most)
      {
        most = known;
        best = from;
      }
    }
    const float sign = (random() & 1U) != 0 ? 1.0F : -1.0F;
    for (std::int64_t z = std::max<std::int64_t>(low[2], 0); z < high[2]; ++z)
    {
      for (std::int64_t y = std::max<std::int64_t>(low[1], 0); y < high[1]; ++y)
      {
        for (std::int64_t x = std::max<std::int64_t>(low[0], 0); x < high[0]; ++x)
        {
          const auto to = static_cast<std::size_t>(GridNode({ x, y, z }, n));
          const auto source = static_cast<std::size_t>(
            GridNode({ best[0] + x - low[0], best[1] + y - low[1], best[2] + z - low[2] }, n));
          values[to] += sign * this->Deviation[to] * this->Unit[source];
        }
      }
    }
  }
}

template void NoiseBootstrap::AddTo(std::vector<float>&, std::uint64_t) const;
template void NoiseBootstrap::AddTo(std::vector<double>&, std::uint64_t) const;

namespace
{

/// ComputeSupport(), with resamples of type T.
template <typename T>
HandleSupport SupportAs(const std::vector<MapHandle>& handles, const VolumeView& volume,
  const FeatureParameters& parameters, double threshold, const std::vector<float>& noise,
  const SupportParameters& bootstrap, const ProgressCallback& progress)
{
  const NoiseBootstrap noises(noise, volume.Dimensions);
  std::vector<T> observed(noise.size());
  for (std::size_t i = 0; i < observed.size(); ++i)
  {
    observed[i] = static_cast<T>(volume.Value(static_cast<std::int64_t>(i)));
  }
  FeatureParameters wanted = parameters;
  wanted.PersistenceUnit = FeatureParameters::Absolute;
  wanted.MinimumPersistence = threshold;
  CubicalParameters cubical;
  cubical.Superlevel = parameters.Superlevel;
  std::vector<int> found(handles.size()), noisy(handles.size());
  std::vector<T> values;
  for (int r = 0; r < bootstrap.NumberOfResamples; ++r)
  {
    values = observed;
    noises.AddTo(values,
      static_cast<std::uint64_t>(bootstrap.Seed) * 1000003U + static_cast<std::uint64_t>(r));
    const VolumeView resample(values.data(), volume.Dimensions);
    const auto part = Between(progress, static_cast<double>(r) / bootstrap.NumberOfResamples,
      static_cast<double>(r + 1) / bootstrap.NumberOfResamples);
    const CubicalDiagram pairs = CubicalPersistence(resample, cubical, part);
    auto others = MapHandles(
      resample, ScalarFeatures(resample, MeasureVolume(resample), pairs, wanted), wanted);
    const auto matched = Match(handles, others, volume.Dimensions);
    for (std::size_t i = 0; i < handles.size(); ++i)
    {
      found[i] += matched[i] ? 1 : 0;
      noisy[i] += CouldBeNoise(handles[i], matched[i], bootstrap.Level) ? 1 : 0;
    }
  }
  HandleSupport result;
  for (std::size_t i = 0; i < handles.size(); ++i)
  {
    const double count = bootstrap.NumberOfResamples;
    result.Support.push_back(found[i] / count);
    result.PValue.push_back(
      IsThere(handles[i], bootstrap.Level) ? (1.0 + noisy[i]) / (1.0 + count) : 1.0);
  }
  return result;
}

}

HandleSupport ComputeSupport(const std::vector<MapHandle>& handles, const VolumeView& volume,
  const FeatureParameters& parameters, double threshold, const std::vector<float>& noise,
  const SupportParameters& bootstrap, const ProgressCallback& progress)
{
  Check(bootstrap);
  const bool fitsFloat = volume.Floating ? volume.Bytes == 4 : volume.Bytes <= 2;
  const auto support = fitsFloat ? &SupportAs<float> : &SupportAs<double>;
  return support(handles, volume, parameters, threshold, noise, bootstrap, progress);
}

}
