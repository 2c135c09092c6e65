#include "ChokingLoops/FeatureSelection.h"

#include <algorithm>
#include <functional>

namespace isthmus
{
namespace
{

/// Gaps narrower than this part of the reference length are none.
constexpr double NarrowestGap = 0.01;

bool IsWanted(const FeatureDiagram& diagram, const FeatureSelection& selection,
  const std::array<double, 2>& leastPersistence, const ShapeFeature& f)
{
  const auto side = static_cast<std::size_t>(f.Side);
  const double most = selection.MaximumDistance.Of(diagram.Reference[side]);
  const bool near = f.Distance() <= most * (1.0 + 1e-9);
  if (!(f.Side == SpaceSide::Inside ? selection.Inside : selection.Outside))
  {
    return false;
  }
  return IsGenerator(f)
    ? near || selection.AlwaysReportHandles
    : f.Kind == FeatureKind::Additional && near && f.Persistence() >= leastPersistence[side];
}

}

PersistenceGap LargestGap(const FeatureDiagram& diagram, SpaceSide side)
{
  std::vector<double> bars{ 0.0 };
  for (const ShapeFeature& f : diagram.Features)
  {
    if (f.Side == side && f.Kind == FeatureKind::Additional)
    {
      bars.push_back(f.Persistence());
    }
  }
  std::sort(bars.begin(), bars.end(), std::greater<>());
  const double least = NarrowestGap * diagram.Reference[static_cast<std::size_t>(side)];
  PersistenceGap gap{ least, 0.0 };
  for (std::size_t i = 0; i + 1 < bars.size(); ++i)
  {
    const double width = bars[i] - bars[i + 1];
    if (width > std::max(gap.Width, least))
    {
      gap = { 0.5 * (bars[i] + bars[i + 1]), width };
    }
  }
  return gap;
}

std::vector<std::size_t> SelectFeatures(
  const FeatureDiagram& diagram, const FeatureSelection& selection)
{
  std::array<double, 2> least{};
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    const auto s = static_cast<std::size_t>(side);
    least[s] = selection.Threshold == ThresholdMode::LargestGap
      ? LargestGap(diagram, side).Threshold
      : selection.MinimumPersistence.Of(diagram.Reference[s]);
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < diagram.Features.size(); ++i)
  {
    if (IsWanted(diagram, selection, least, diagram.Features[i]))
    {
      chosen.push_back(i);
    }
  }
  if (selection.MaximumNumber > 0 && chosen.size() > selection.MaximumNumber)
  {
    std::stable_sort(chosen.begin(), chosen.end(),
      [&diagram](std::size_t a, std::size_t b)
      { return diagram.Features[a].Widening() > diagram.Features[b].Widening(); });
    chosen.resize(selection.MaximumNumber);
    std::sort(chosen.begin(), chosen.end());
  }
  return chosen;
}

}
