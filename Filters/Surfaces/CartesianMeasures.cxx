#include "Surfaces/CartesianMeasures.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <cmath>
#include <string>

namespace isthmus
{
namespace
{

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

  std::vector<GridCrossing> crossings;
  AppendLevelCrossings(level, k, crossings);
  for (const GridCrossing& crossing : crossings)
  {
    const auto axis = static_cast<std::size_t>(crossing.Axis);
    sum.Area += std::abs(crossing.Normal[axis]) * cell / h[axis];
  }
}

}

CartesianMeasures& CartesianMeasures::operator+=(const CartesianMeasures& other)
{
  this->Area += other.Area;
  this->Volume += other.Volume;
  this->SmearedArea += other.SmearedArea;
  this->SmearedVolume += other.SmearedVolume;
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

template CartesianMeasures MeasureOnGrid(
  const LevelView<float>&, double, double, const ProgressCallback&);
template CartesianMeasures MeasureOnGrid(
  const LevelView<double>&, double, double, const ProgressCallback&);

}
