#include "Electrostatics/ChargesOnGrid.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ChargeTree.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace isthmus
{
namespace
{

constexpr std::int64_t Brick = 8;

using BrickNumber = std::array<std::int64_t, 3>;

BrickNumber FindBrick(const SolverBox& box, const Point3& x)
{
  BrickNumber brick;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double place = (x[a] - box.Corner[a]) / (static_cast<double>(Brick) * box.Spacing[a]);
    brick[a] = static_cast<std::int64_t>(std::floor(place));
  }
  return brick;
}

Point3 BrickCenter(const SolverBox& box, const BrickNumber& brick)
{
  Point3 center;
  for (std::size_t a = 0; a < 3; ++a)
  {
    center[a] = box.Corner[a] +
      static_cast<double>(Brick) * box.Spacing[a] * (static_cast<double>(brick[a]) + 0.5);
  }
  return center;
}

/// Radius of a ball around a brick's nodes and the edges that start there.
double BrickRadius(const SolverBox& box)
{
  const double half = 0.5 * static_cast<double>(Brick);
  return half * std::hypot(box.Spacing[0], box.Spacing[1], box.Spacing[2]);
}

}

std::vector<SecondOrderTaylor> ChargesAtPoints(const ChargeList& charges, const SolverBox& box,
  const std::vector<Point3>& points, const ProgressCallback& progress)
{
  // The tree is traversed once for a brick of points, which use the same boxes.
  std::vector<std::pair<BrickNumber, std::size_t>> order(points.size());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    order[p] = { FindBrick(box, points[p]), p };
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || order[i].first != order[i - 1].first)
    {
      starts.push_back(i);
    }
  }
  starts.push_back(order.size());
  std::unique_ptr<ChargeTree> tree;
  if (charges.Size() >= FewestForTree)
  {
    tree = std::make_unique<ChargeTree>(charges);
  }
  std::vector<SecondOrderTaylor> result(points.size());
  ParallelFor(
    0, static_cast<std::int64_t>(starts.size()) - 1, 1,
    [&](std::int64_t first, std::int64_t last)
    {
      ChargeList seen;
      for (auto b = static_cast<std::size_t>(first); b < static_cast<std::size_t>(last); ++b)
      {
        if (tree)
        {
          tree->Gather(BrickCenter(box, order[starts[b]].first), BrickRadius(box), seen);
        }
        for (std::size_t i = starts[b]; i < starts[b + 1]; ++i)
        {
          const std::size_t p = order[i].second;
          result[p] = CoulombSum(tree ? seen : charges, points[p]);
        }
      }
    },
    progress);
  return result;
}

std::vector<SecondOrderTaylor> ChargesAtCrossings(const ChargeList& charges, const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const KnownCharges& known,
  const ProgressCallback& progress)
{
  std::vector<SecondOrderTaylor> result(crossings.size());
  std::vector<std::size_t> wanted;
  std::vector<Point3> points;
  const auto before = [](const InterfaceCrossing& a, const InterfaceCrossing& b)
  { return a.Node != b.Node ? a.Node < b.Node : a.Axis < b.Axis; };
  std::size_t k = 0;
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    const InterfaceCrossing& crossing = crossings[c];
    while (
      known.Crossings && k < known.Crossings->size() && before((*known.Crossings)[k], crossing))
    {
      ++k;
    }
    if (known.Crossings && k < known.Crossings->size() &&
      !before(crossing, (*known.Crossings)[k]) &&
      crossing.Fraction == (*known.Crossings)[k].Fraction)
    {
      result[c] = (*known.Values)[k];
      continue;
    }
    wanted.push_back(c);
    points.push_back(box.Position(crossing.Node));
    const auto a = static_cast<std::size_t>(crossing.Axis);
    points.back()[a] += crossing.Fraction * box.Spacing[a];
  }
  const std::vector<SecondOrderTaylor> sums = ChargesAtPoints(charges, box, points, progress);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    result[wanted[i]] = sums[i];
  }
  return result;
}

void ChargesAtNodes(const ChargeList& charges, const SolverBox& box,
  const std::function<void(std::int64_t node, double g)>& use, const ProgressCallback& progress)
{
  const auto& n = box.Dimensions;
  const std::int64_t bricks[3] = { (n[0] + Brick - 1) / Brick, (n[1] + Brick - 1) / Brick,
    (n[2] + Brick - 1) / Brick };
  const double nearest = 0.25 * *std::min_element(box.Spacing.begin(), box.Spacing.end());
  const ChargeTree tree(charges);
  ParallelFor(
    0, bricks[0] * bricks[1] * bricks[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      ChargeList seen;
      for (std::int64_t b = first; b < last; ++b)
      {
        const std::array<std::int64_t, 3> at{ b % bricks[0] * Brick,
          b / bricks[0] % bricks[1] * Brick, b / (bricks[0] * bricks[1]) * Brick };
        Point3 center;
        for (std::size_t a = 0; a < 3; ++a)
        {
          center[a] = box.Corner[a] +
            box.Spacing[a] * (static_cast<double>(at[a]) + 0.5 * static_cast<double>(Brick - 1));
        }
        tree.Gather(center, BrickRadius(box), seen);
        for (std::int64_t k = at[2]; k < std::min(n[2], at[2] + Brick); ++k)
        {
          for (std::int64_t j = at[1]; j < std::min(n[1], at[1] + Brick); ++j)
          {
            for (std::int64_t i = at[0]; i < std::min(n[0], at[0] + Brick); ++i)
            {
              use(i + n[0] * (j + n[1] * k), CoulombValue(seen, box.Position(i, j, k), nearest));
            }
          }
        }
      }
    },
    progress);
}

}
