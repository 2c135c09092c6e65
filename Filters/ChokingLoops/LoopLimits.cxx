#include "ChokingLoops/LoopLimits.h"

#include <algorithm>
#include <map>

namespace isthmus
{
namespace
{

double LongestOf(const ShownFeature& feature)
{
  const std::vector<double>& lengths = feature.Geometry->Lengths;
  return lengths.empty() ? 0.0 : *std::max_element(lengths.begin(), lengths.end());
}

}

double ReachOf(const ChokingLoops& loops, const ShownFeature& feature)
{
  const Point3 centre = loops.ChokePoint(feature.Index);
  double farthest = 0.0;
  for (const std::vector<SimplexId>& loop : feature.Geometry->Loops)
  {
    for (const SimplexId p : loop)
    {
      farthest = std::max(farthest, Distance(centre, feature.Geometry->Point(p, loops.Samples())));
    }
  }
  const double radius = loops.Diagram().Features[feature.Index].Distance();
  return radius > 0.0 ? farthest / radius : 0.0;
}

void KeepWithin(
  const ChokingLoops& loops, const LoopLimits& limits, std::vector<ShownFeature>& features)
{
  const auto isBeyond = [&](const ShownFeature& feature)
  {
    return (limits.MaximumLength > 0.0 && LongestOf(feature) > limits.MaximumLength) ||
      (limits.MaximumReach > 0.0 && ReachOf(loops, feature) > limits.MaximumReach);
  };
  const auto end = std::remove_if(features.begin(), features.end(), isBeyond);
  if (end != features.end())
  {
    features.erase(end, features.end());
    std::map<const LoopFeature*, std::size_t> first;
    for (ShownFeature& feature : features)
    {
      const auto [known, isFirst] = first.emplace(feature.Geometry, feature.Index);
      feature.SharedWith = isFirst ? -1 : static_cast<std::ptrdiff_t>(known->second);
    }
  }
  if (limits.ByLength)
  {
    std::stable_sort(features.begin(), features.end(),
      [](const ShownFeature& a, const ShownFeature& b) { return LongestOf(a) < LongestOf(b); });
  }
}

}
