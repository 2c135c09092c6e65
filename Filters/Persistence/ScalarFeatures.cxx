#include "Persistence/ScalarFeatures.h"

#include "Core/RangeChecks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>

namespace isthmus
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Numbers of the features that components and voids are joined to.
void LinkElders(std::vector<ScalarFeature>& features)
{
  std::unordered_map<std::int64_t, std::int64_t> components;
  std::unordered_map<std::int64_t, std::int64_t> voids;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const CubicalPair& pair = features[i].Pair;
    if (pair.Dimension == 0)
    {
      components[pair.Birth.Name()] = static_cast<std::int64_t>(i);
    }
    else if (pair.Dimension == 2)
    {
      voids[pair.Death.Name()] = static_cast<std::int64_t>(i);
    }
  }
  for (ScalarFeature& feature : features)
  {
    const auto& known = feature.Pair.Dimension == 0 ? components : voids;
    const auto found = known.find(feature.Pair.Elder.Name());
    if (feature.Pair.Elder.Node() >= 0 && found != known.end())
    {
      feature.Joined = found->second;
    }
  }
}

bool IsBefore(const ScalarFeature& a, const ScalarFeature& b)
{
  const auto place = [](const ScalarFeature& f)
  {
    return std::make_tuple(
      -f.Persistence, f.Pair.Dimension, f.Pair.Birth.Name(), f.Pair.Death.Name());
  };
  return place(a) < place(b);
}

/// The least persistence above the widest gap between consecutive ones, 0 included.
double AboveLargestGap(const std::vector<ScalarFeature>& features)
{
  double threshold = 0.0;
  double widest = 0.0;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const double here = features[i].Persistence;
    const double next = i + 1 < features.size() ? features[i + 1].Persistence : 0.0;
    if (std::isfinite(here) && here - next > widest)
    {
      widest = here - next;
      threshold = here;
    }
  }
  return threshold;
}

/// The number of `sorted places` at or before each level, and the sum of (level - place) of
/// those.
struct CountsBelow
{
  explicit CountsBelow(const std::vector<double>& levels)
    : Levels(levels)
    , Counts(levels.size() + 1, 0)
    , Offsets(levels.size() + 1, 0.0)
  {
  }

  void Add(double place)
  {
    const auto at = std::lower_bound(this->Levels.begin(), this->Levels.end(), place);
    const auto i = static_cast<std::size_t>(at - this->Levels.begin());
    if (i < this->Levels.size())
    {
      ++this->Counts[i];
      // Relative to the first level, where the integrals start.
      this->Offsets[i] += std::max(place, this->Levels.front()) - this->Levels.front();
    }
  }

  void Sum()
  {
    for (std::size_t i = 1; i < this->Levels.size(); ++i)
    {
      this->Counts[i] += this->Counts[i - 1];
      this->Offsets[i] += this->Offsets[i - 1];
    }
  }

  double Length(std::size_t level) const
  {
    return static_cast<double>(this->Counts[level]) * (this->Levels[level] - this->Levels.front()) -
      this->Offsets[level];
  }

  const std::vector<double>& Levels;
  std::vector<std::int64_t> Counts;
  std::vector<double> Offsets;
};

/// Counts and integrals of the features of one dimension; levels ascend with the filtration.
void Count(const FeatureList& features, std::size_t used, int dimension, double sign,
  const std::vector<double>& levels, std::vector<std::int64_t>& counts,
  std::vector<double>& integrals)
{
  CountsBelow born(levels);
  CountsBelow dead(levels);
  for (std::size_t i = 0; i < used; ++i)
  {
    const ScalarFeature& feature = features.Features[i];
    if (feature.Pair.Dimension == dimension)
    {
      born.Add(sign * feature.Birth);
      dead.Add(sign * feature.Death);
    }
  }
  born.Sum();
  dead.Sum();
  counts.resize(levels.size());
  integrals.resize(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    counts[i] = born.Counts[i] - dead.Counts[i];
    integrals[i] = born.Length(i) - dead.Length(i);
  }
}

}

void Check(const FeatureParameters& parameters)
{
  if (!(parameters.Range[0] < parameters.Range[1]))
  {
    throw std::invalid_argument("Range goes from " + FormatNumber(parameters.Range[0]) + " to " +
      FormatNumber(parameters.Range[1]) + ", but the first has to be below the second.");
  }
  RequireRange("MinimumPersistence", parameters.MinimumPersistence, 0.0, Unlimited,
    "It is a difference of levels.");
  RequireChoice(
    "PersistenceUnit", parameters.PersistenceUnit, static_cast<int>(FeatureParameters::LargestGap));
}

FeatureList ScalarFeatures(const VolumeView& volume, const VolumeStatistics& statistics,
  const CubicalDiagram& diagram, const FeatureParameters& parameters)
{
  Check(parameters);
  const double never = parameters.Superlevel ? -Infinity : Infinity;
  FeatureList list;
  for (const CubicalPair& pair : diagram.Pairs)
  {
    ScalarFeature feature;
    feature.Pair = pair;
    feature.Birth = volume.Value(pair.Birth.Node());
    feature.Death = pair.Death.Node() < 0 ? never : volume.Value(pair.Death.Node());
    const double low = std::max(std::min(feature.Birth, feature.Death), parameters.Range[0]);
    const double high = std::min(std::max(feature.Birth, feature.Death), parameters.Range[1]);
    // Values of 64 bits can differ and be one double: such a class is listed, with persistence 0.
    feature.Persistence = pair.Death.Node() < 0 ? Infinity : high > low ? high - low : 0.0;
    if (high > low || (high == low && feature.Birth == feature.Death))
    {
      list.Features.push_back(feature);
    }
  }
  std::sort(list.Features.begin(), list.Features.end(), IsBefore);
  LinkElders(list.Features);
  list.Threshold = parameters.PersistenceUnit == FeatureParameters::LargestGap
    ? AboveLargestGap(list.Features)
    : parameters.PersistenceUnit == FeatureParameters::StandardDeviations
    ? parameters.MinimumPersistence * statistics.StandardDeviation
    : parameters.MinimumPersistence;
  while (list.Kept < list.Features.size() && list.Features[list.Kept].Persistence >= list.Threshold)
  {
    ++list.Kept;
  }
  return list;
}

BettiCurves CountBetti(
  const FeatureList& features, bool superlevel, const std::vector<double>& levels)
{
  BettiCurves curves;
  curves.Levels = levels;
  const double sign = superlevel ? -1.0 : 1.0;
  std::vector<double> places(levels);
  if (superlevel)
  {
    std::reverse(places.begin(), places.end());
    std::transform(places.begin(), places.end(), places.begin(), [](double v) { return -v; });
  }
  for (std::size_t d = 0; d < 3; ++d)
  {
    const int dimension = static_cast<int>(d);
    Count(features, features.Features.size(), dimension, sign, places, curves.All[d],
      curves.Integral[d]);
    Count(features, features.Kept, dimension, sign, places, curves.Filtered[d],
      curves.FilteredIntegral[d]);
    if (superlevel)
    {
      std::reverse(curves.All[d].begin(), curves.All[d].end());
      std::reverse(curves.Filtered[d].begin(), curves.Filtered[d].end());
      std::reverse(curves.Integral[d].begin(), curves.Integral[d].end());
      std::reverse(curves.FilteredIntegral[d].begin(), curves.FilteredIntegral[d].end());
    }
  }
  return curves;
}

void RequireLevels(std::int64_t count, const double* range)
{
  RequireRange("NumberOfLevels", static_cast<double>(count), 2, 1e6);
  if (range && !(std::isfinite(range[0]) && std::isfinite(range[1]) && range[0] < range[1]))
  {
    throw std::invalid_argument("Range goes from " + FormatNumber(range[0]) + " to " +
      FormatNumber(range[1]) + ", but the first has to be below the second.");
  }
}

std::vector<double> EvenLevels(double low, double high, std::int64_t count)
{
  if (!(low < high) || count < 2)
  {
    return { low };
  }
  std::vector<double> levels(static_cast<std::size_t>(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(count - 1);
    levels[static_cast<std::size_t>(i)] = (1.0 - t) * low + t * high;
  }
  levels.back() = high;
  return levels;
}

}
