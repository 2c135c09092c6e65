#include "Surfaces/CartesianMeasures.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isthmus
{
namespace
{

/// Of the jump across a crossing: 0 if S is as steep beside it, 1 for the edge of a mask.
template <typename T>
double Step(const GridView<const T>& grid, const GridCrossing& crossing)
{
  const auto axis = static_cast<std::size_t>(crossing.Axis);
  const std::int64_t steps[3] = { 1, grid.Dimensions[0], grid.Dimensions[0] * grid.Dimensions[1] };
  const std::int64_t step = steps[axis];
  const std::int64_t index = crossing.Node / step % grid.Dimensions[axis];
  const auto difference = [&](std::int64_t from)
  {
    return from < 0 || from + 1 >= grid.Dimensions[axis]
      ? 0.0
      : std::abs(static_cast<double>(grid.Data[crossing.Node + (from - index + 1) * step]) -
          static_cast<double>(grid.Data[crossing.Node + (from - index) * step]));
  };
  constexpr double resolved = 0.6;
  const double share =
    difference(index) / (difference(index - 1) + difference(index) + difference(index + 1));
  return std::max(0.0, (share - resolved) / (1.0 - resolved));
}

template <typename T>
void AddCrossings(const LevelView<T>& level, std::int64_t k, CartesianMeasures& sum)
{
  const auto& h = level.Grid.Spacing;
  const double cell = h[0] * h[1] * h[2];
  std::vector<GridCrossing> crossings;
  AppendLevelCrossings(level, k, crossings);
  for (const GridCrossing& crossing : crossings)
  {
    const auto axis = static_cast<std::size_t>(crossing.Axis);
    const double area = std::abs(crossing.Normal[axis]) * cell / h[axis];
    const bool ends = level.IsInside(static_cast<double>(level.Grid.Data[crossing.Node]));
    sum.Area += area;
    sum.StepArea += area * Step(level.Grid, crossing);
    // The node inside counts as half a spacing towards the crossing.
    sum.LineExcess += (ends ? crossing.Fraction - 0.5 : 0.5 - crossing.Fraction) * cell;
  }
}

template <typename T>
void AddLayer(
  const LevelView<T>& level, double inside, double outside, std::int64_t k, CartesianMeasures& sum)
{
  const GridView<const T>& grid = level.Grid;
  const auto& h = grid.Spacing;
  const double cell = h[0] * h[1] * h[2];
  const double scale = 1.0 / (inside - outside);
  CartesianMeasures counts; // in nodes, scaled at the end: fewer roundings
  for (std::int64_t j = 0; j < grid.Dimensions[1]; ++j)
  {
    for (std::int64_t i = 0; i < grid.Dimensions[0]; ++i)
    {
      const auto value = static_cast<double>(grid(i, j, k));
      const auto gradient = GradientAtNode(grid, i, j, k);
      counts.Volume += level.IsInside(value);
      counts.SmearedVolume += (value - outside) * scale;
      counts.SmearedArea += std::sqrt(
        gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
    }
  }
  sum.Volume += counts.Volume * cell;
  sum.SmearedVolume += counts.SmearedVolume * cell;
  sum.SmearedArea += counts.SmearedArea * std::abs(scale) * cell;
  AddCrossings(level, k, sum);
}

using Index3 = std::array<std::int64_t, 3>;

/// 2 along axes with several nodes, otherwise 1.
Index3 CoarseStep(const Index3& dimensions)
{
  Index3 step;
  std::transform(dimensions.begin(), dimensions.end(), step.begin(),
    [](std::int64_t n) { return n > 1 ? 2 : 1; });
  return step;
}

/// The level on the nodes first, first + step, ..., whose values are copied to `values`.
template <typename T>
LevelView<T> EverySecondNode(
  const LevelView<T>& level, const Index3& first, const Index3& step, std::vector<T>& values)
{
  LevelView<T> coarse = level;
  Index3& n = coarse.Grid.Dimensions;
  for (std::size_t a = 0; a < 3; ++a)
  {
    n[a] = (n[a] - first[a] + step[a] - 1) / step[a];
    coarse.Grid.Spacing[a] *= static_cast<double>(step[a]);
  }
  values.resize(static_cast<std::size_t>(coarse.Grid.Size()));
  coarse.Grid.Data = values.data();
  for (std::int64_t k = 0, node = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i, ++node)
      {
        values[static_cast<std::size_t>(node)] =
          level.Grid(first[0] + i * step[0], first[1] + j * step[1], first[2] + k * step[2]);
      }
    }
  }
  return coarse;
}

struct Spread
{
  double Mean = 0.0, Deviation = 0.0;
};

Spread ComputeSpread(const std::vector<double>& values)
{
  const auto count = static_cast<double>(values.size());
  Spread spread;
  spread.Mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  for (const double value : values)
  {
    spread.Deviation += (value - spread.Mean) * (value - spread.Mean);
  }
  spread.Deviation = std::sqrt(spread.Deviation / std::max(1.0, count - 1.0));
  return spread;
}

}

CartesianMeasures& CartesianMeasures::operator+=(const CartesianMeasures& other)
{
  this->Area += other.Area;
  this->Volume += other.Volume;
  this->SmearedArea += other.SmearedArea;
  this->SmearedVolume += other.SmearedVolume;
  this->LineExcess += other.LineExcess;
  this->StepArea += other.StepArea;
  return *this;
}

template <typename T>
CartesianMeasures MeasureOnGrid(const LevelView<T>& level, double insideValue, double outsideValue,
  const ProgressCallback& progress)
{
  RequireThat(insideValue != outsideValue, "InsideValue", insideValue,
    "it must differ from OutsideValue: the smeared measures scale by the difference");
  return ParallelReduce(
    level.Grid.Dimensions[2], 1, CartesianMeasures{},
    [&](CartesianMeasures& sum, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        AddLayer(level, insideValue, outsideValue, k, sum);
      }
    },
    progress);
}

template <typename T>
CartesianErrors EstimateErrors(
  const LevelView<T>& level, const CartesianMeasures& measures, const ProgressCallback& progress)
{
  const Index3 step = CoarseStep(level.Grid.Dimensions);
  const std::int64_t count = step[0] * step[1] * step[2];
  std::vector<T> values;
  std::vector<double> areas, volumes;
  for (std::int64_t part = 0; part < count; ++part)
  {
    const Index3 first{ part % step[0], part / step[0] % step[1], part / (step[0] * step[1]) };
    const auto coarse = MeasureOnGrid(EverySecondNode(level, first, step, values), 1.0, 0.0,
      Between(progress, static_cast<double>(part) / static_cast<double>(count),
        static_cast<double>(part + 1) / static_cast<double>(count)));
    areas.push_back(coarse.Area);
    volumes.push_back(coarse.Volume);
  }
  const double h = std::cbrt(level.Grid.Spacing[0] * level.Grid.Spacing[1] * level.Grid.Spacing[2]);
  const Spread area = ComputeSpread(areas), volume = ComputeSpread(volumes);
  return { 1.25 * std::abs(area.Mean - measures.Area) + 0.5 * area.Deviation +
      0.12 * measures.StepArea,
    std::max({ 0.6 * volume.Deviation, std::abs(measures.LineExcess),
      0.5 * std::sqrt(measures.Area) * h * h, measures.StepArea * h / 8.0 }) };
}

template CartesianMeasures MeasureOnGrid(
  const LevelView<float>&, double, double, const ProgressCallback&);
template CartesianMeasures MeasureOnGrid(
  const LevelView<double>&, double, double, const ProgressCallback&);

template CartesianErrors EstimateErrors(
  const LevelView<float>&, const CartesianMeasures&, const ProgressCallback&);
template CartesianErrors EstimateErrors(
  const LevelView<double>&, const CartesianMeasures&, const ProgressCallback&);

}
