#include "CellComplex/TetCutaway.h"

#include "Core/RangeChecks.h"

namespace isthmus
{
namespace
{

/// Whether the cell with this center may be removed; for ByNumber the count alone decides.
bool Allows(const CutawayRule& rule, const Position& seed, const Position& center)
{
  double squaredDistance = 0.0, height = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    squaredDistance += (center[i] - seed[i]) * (center[i] - seed[i]);
    height += (center[i] - rule.PlaneOrigin[i]) * rule.PlaneNormal[i];
  }
  switch (rule.StopRule)
  {
    case CutawayRule::StopRules::ByDistance:
      return squaredDistance <= rule.Distance * rule.Distance;
    case CutawayRule::StopRules::ByPlane:
      return height > 0.0;
    case CutawayRule::StopRules::ByNumber:
      break;
  }
  return true;
}

}

void Check(const CutawayRule& rule)
{
  RequireChoice("StopRule", rule.StopRule, CutawayRule::StopRules::ByPlane);
  RequireRange("NumberOfCells", static_cast<double>(rule.NumberOfCells), 0.0, Unlimited);
  RequireRange("Distance", rule.Distance, 0.0, Unlimited, "It is a length.");
  for (std::size_t i = 0; i < 3; ++i)
  {
    RequireRange("PlaneOrigin", rule.PlaneOrigin[i], -Unlimited, Unlimited);
    RequireRange("PlaneNormal", rule.PlaneNormal[i], -Unlimited, Unlimited);
  }
}

template <typename Id>
std::vector<unsigned char> CutAway(const CompactCombinatorialMap<Id>& map,
  typename CompactCombinatorialMap<Id>::Cell seed, const CutawayRule& rule,
  const std::function<Position(std::size_t)>& centerOf, const ProgressCallback& progress)
{
  Check(rule);
  using Cell = typename CompactCombinatorialMap<Id>::Cell;
  constexpr std::size_t cellsPerReport = 1u << 16;
  const std::size_t most = rule.StopRule == CutawayRule::StopRules::ByNumber
    ? static_cast<std::size_t>(rule.NumberOfCells)
    : map.NumberOfCells();
  std::vector<unsigned char> gone(map.NumberOfCells(), 0);
  const Position seedCenter = centerOf(seed.Value);
  std::vector<Cell> queue;
  const auto take = [&](Cell cell)
  {
    if (!gone[cell.Value] && queue.size() < most && Allows(rule, seedCenter, centerOf(cell.Value)))
    {
      gone[cell.Value] = 1;
      queue.push_back(cell);
    }
  };
  take(seed);
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    if (next % cellsPerReport == 0)
    {
      Report(progress, static_cast<double>(next) / static_cast<double>(map.NumberOfCells()));
    }
    for (const auto across : map.Neighbours(queue[next]))
    {
      if (!map.IsOutside(across))
      {
        take(map.GetCell(across));
      }
    }
  }
  return gone;
}

template std::vector<unsigned char> CutAway(const CompactCombinatorialMap<std::uint32_t>&,
  CompactCombinatorialMap<std::uint32_t>::Cell, const CutawayRule&,
  const std::function<Position(std::size_t)>&, const ProgressCallback&);
template std::vector<unsigned char> CutAway(const CompactCombinatorialMap<std::uint64_t>&,
  CompactCombinatorialMap<std::uint64_t>::Cell, const CutawayRule&,
  const std::function<Position(std::size_t)>&, const ProgressCallback&);

}
