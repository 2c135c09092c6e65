#include "Surfaces/LevelCrossings.h"

#include <Eigen/Dense>

namespace isthmus
{
namespace
{

template <typename T>
double DifferenceAlong(
  const GridView<const T>& grid, std::int64_t node, std::int64_t index, int axis)
{
  const auto a = static_cast<std::size_t>(axis);
  const std::int64_t size = grid.Dimensions[a];
  const std::int64_t step = axis == 0 ? 1
    : axis == 1                       ? grid.Dimensions[0]
                                      : grid.Dimensions[0] * grid.Dimensions[1];
  const T* const value = grid.Data + node;
  const double h = grid.Spacing[a];
  if (size < 3)
  {
    const std::int64_t other = index == 0 ? step : -step;
    return size < 2
      ? 0.0
      : (static_cast<double>(value[other]) - static_cast<double>(value[0])) / (index == 0 ? h : -h);
  }
  if (index > 0 && index + 1 < size)
  {
    return (static_cast<double>(value[step]) - static_cast<double>(value[-step])) / (2.0 * h);
  }
  const std::int64_t inwards = index == 0 ? step : -step;
  const double difference = -3.0 * static_cast<double>(value[0]) +
    4.0 * static_cast<double>(value[inwards]) - static_cast<double>(value[2 * inwards]);
  return difference / (index == 0 ? 2.0 * h : -2.0 * h);
}

template <typename T>
class LayerCrossings
{
public:
  LayerCrossings(const LevelView<T>& level, std::vector<GridCrossing>& crossings)
    : Level(level)
    , Crossings(crossings)
  {
  }

  void Run(std::int64_t k)
  {
    const auto& size = this->Level.Grid.Dimensions;
    for (std::int64_t j = 0; j < size[1]; ++j)
    {
      for (std::int64_t i = 0; i < size[0]; ++i)
      {
        const std::int64_t index[3] = { i, j, k };
        const std::int64_t step[3] = { 1, size[0], size[0] * size[1] };
        const std::int64_t node = this->Level.Grid.Index(i, j, k);
        for (int axis = 0; axis < 3; ++axis)
        {
          if (index[axis] + 1 < size[static_cast<std::size_t>(axis)])
          {
            this->Edge(index, node, node + step[axis], axis);
          }
        }
      }
    }
  }

private:
  void Edge(const std::int64_t index[3], std::int64_t lower, std::int64_t upper, int axis)
  {
    const auto a = static_cast<double>(this->Level.Grid.Data[lower]);
    const auto b = static_cast<double>(this->Level.Grid.Data[upper]);
    if (this->Level.IsInside(a) == this->Level.IsInside(b))
    {
      return;
    }
    GridCrossing crossing;
    crossing.Node = lower;
    crossing.Axis = axis;
    crossing.Fraction = (this->Level.Level - a) / (b - a);
    std::int64_t next[3] = { index[0], index[1], index[2] };
    ++next[axis];
    const auto low = GradientAtNode(this->Level.Grid, index[0], index[1], index[2]);
    const auto high = GradientAtNode(this->Level.Grid, next[0], next[1], next[2]);
    const Eigen::Map<const Eigen::Vector3d> from(low.data());
    const Eigen::Map<const Eigen::Vector3d> to(high.data());
    Eigen::Vector3d gradient = from + crossing.Fraction * (to - from);
    if (!(gradient.norm() > 0.0))
    {
      gradient = (b - a) * Eigen::Vector3d::Unit(axis);
    }
    const double outwards = this->Level.InsideIsHigher ? -1.0 : 1.0;
    Eigen::Map<Eigen::Vector3d>(crossing.Normal.data()) = outwards * gradient.normalized();
    this->Crossings.push_back(crossing);
  }

  const LevelView<T>& Level;
  std::vector<GridCrossing>& Crossings;
};

}

template <typename T>
std::array<double, 3> GradientAtNode(
  const GridView<const T>& grid, std::int64_t i, std::int64_t j, std::int64_t k)
{
  const std::int64_t node = grid.Index(i, j, k);
  return { DifferenceAlong(grid, node, i, 0), DifferenceAlong(grid, node, j, 1),
    DifferenceAlong(grid, node, k, 2) };
}

template <typename T>
void AppendLevelCrossings(
  const LevelView<T>& level, std::int64_t k, std::vector<GridCrossing>& crossings)
{
  LayerCrossings<T>(level, crossings).Run(k);
}

template std::array<double, 3> GradientAtNode(
  const GridView<const float>&, std::int64_t, std::int64_t, std::int64_t);
template std::array<double, 3> GradientAtNode(
  const GridView<const double>&, std::int64_t, std::int64_t, std::int64_t);
template void AppendLevelCrossings(
  const LevelView<float>&, std::int64_t, std::vector<GridCrossing>&);
template void AppendLevelCrossings(
  const LevelView<double>&, std::int64_t, std::vector<GridCrossing>&);

}
