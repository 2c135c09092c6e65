#include "Curvature/HessianCurvature.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Curvature/FiniteDifference.h"
#include "Curvature/HessianCurvatureRows.h"
#include "Curvature/PointDerivative.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

template <typename T>
void CheckGrid(const GridView<const T>& grid)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(grid.Spacing[axis] > 0.0) || std::isinf(grid.Spacing[axis]))
    {
      throw std::invalid_argument(std::string("The spacing of the grid along ") + "xyz"[axis] +
        " is " + FormatNumber(grid.Spacing[axis]) + ": it must be a positive length.");
    }
  }
}

template <typename T>
void CheckBox(const GridView<const T>& grid, const NodeBox& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.First[axis] < 0 || box.Size[axis] < 0 ||
      box.First[axis] + box.Size[axis] > grid.Dimensions[axis])
    {
      throw std::invalid_argument(std::string("The box of nodes leaves the grid along ") +
        "xyz"[axis] + ": request nodes 0 to " + std::to_string(grid.Dimensions[axis] - 1) + ".");
    }
  }
}

/// The condition for a valid place: depends on the grid and on the type of its values.
template <typename T>
ShapeRule RuleFor(const GridView<const T>& grid, const HessianCurvatureOptions& options)
{
  ShapeRule rule;
  rule.InsideIsHigher = options.InsideIsHigher;
  rule.Spacing = std::min({ grid.Spacing[0], grid.Spacing[1], grid.Spacing[2] });
  rule.ValueRounding = std::is_floating_point_v<T>
    ? 4.0 * static_cast<double>(std::numeric_limits<T>::epsilon())
    : 0.0;
  rule.Largest = static_cast<double>(std::numeric_limits<ResultType<T>>::max());
  return rule;
}

/// One row of the box: places with a complete stencil in pieces, zeros at the others.
template <typename T>
void ComputeCurvatureRow(const GridView<const T>& grid, const NodeBox& box, std::int64_t j,
  std::int64_t k, const HessianCurvatureOptions& options, const ShapeRule& rule,
  const CurvatureArrays<ResultType<T>>& arrays)
{
  const std::int64_t radius = StencilRadius(options.Accuracy);
  const auto inside = [&](int axis, std::int64_t node)
  { return node >= radius && node < grid.Dimensions[axis] - radius; };
  const std::int64_t rowBegin = box.Size[0] * (j + box.Size[1] * k);
  const std::int64_t end = box.First[0] + box.Size[0];
  std::int64_t begin = end;
  std::int64_t stop = end;
  if (inside(1, box.First[1] + j) && inside(2, box.First[2] + k))
  {
    begin = std::clamp(radius, box.First[0], end);
    stop = std::clamp(grid.Dimensions[0] - radius, begin, end);
  }
  ClearCurvature(arrays, rowBegin, begin - box.First[0]);
  ClearCurvature(arrays, rowBegin + stop - box.First[0], end - stop);
  DerivativeRows derivatives;
  for (std::int64_t i = begin; i < stop; i += DerivativeRows::Capacity)
  {
    const std::int64_t count = std::min(DerivativeRows::Capacity, stop - i);
    DifferentiateAtNodes(
      grid, { i, box.First[1] + j, box.First[2] + k }, count, options.Accuracy, derivatives);
    WriteCurvature(derivatives, count, rule, options, arrays, rowBegin + i - box.First[0]);
  }
}

}

void Check(const HessianCurvatureOptions& options)
{
  StencilRadius(options.Accuracy);
  Check(static_cast<const CurvatureDescriptorOptions&>(options));
}

template <typename T>
void HessianCurvatureAtNodes(const GridView<const T>& grid, const NodeBox& box,
  const HessianCurvatureOptions& options, const CurvatureArrays<ResultType<T>>& arrays,
  const ProgressCallback& progress)
{
  Check(options);
  CheckGrid(grid);
  CheckBox(grid, box);
  if (box.Size[0] == 0)
  {
    return;
  }
  constexpr std::int64_t nodesPerPiece = 16384;
  const ShapeRule rule = RuleFor(grid, options);
  ParallelFor(
    0, box.Size[1] * box.Size[2], nodesPerPiece / box.Size[0] + 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t row = first; row < last; ++row)
      {
        ComputeCurvatureRow(grid, box, row % box.Size[1], row / box.Size[1], options, rule, arrays);
      }
    },
    progress);
}

template <typename T>
void HessianCurvatureAtPoints(const GridView<const T>& grid, std::int64_t count,
  const PointSource& points, const HessianCurvatureOptions& options,
  const CurvatureArrays<ResultType<T>>& arrays, const ProgressCallback& progress)
{
  Check(options);
  CheckGrid(grid);
  constexpr std::int64_t capacity = DerivativeRows::Capacity;
  const ShapeRule rule = RuleFor(grid, options);
  ParallelFor(
    0, (count + capacity - 1) / capacity, 8,
    [&](std::int64_t first, std::int64_t last)
    {
      DerivativeRows derivatives;
      std::array<std::array<double, 3>, capacity> indices;
      for (std::int64_t block = first; block < last; ++block)
      {
        const std::int64_t begin = block * capacity;
        const std::int64_t places = std::min(capacity, count - begin);
        points(begin, places, indices.data());
        for (std::int64_t place = 0; place < places; ++place)
        {
          if (!DifferentiateAtPoint(grid, indices[place], options.Accuracy, place, derivatives))
          {
            SetZeroGradient(derivatives, place);
          }
        }
        WriteCurvature(derivatives, places, rule, options, arrays, begin);
      }
    },
    progress);
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template void HessianCurvatureAtNodes(const GridView<const T>&, const NodeBox&,                  \
    const HessianCurvatureOptions&, const CurvatureArrays<ResultType<T>>&,                         \
    const ProgressCallback&);                                                                      \
  template void HessianCurvatureAtPoints(const GridView<const T>&, std::int64_t,                   \
    const PointSource&, const HessianCurvatureOptions&, const CurvatureArrays<ResultType<T>>&,     \
    const ProgressCallback&)
ISTHMUS_FOR_EACH_SCALAR_TYPE(ISTHMUS_INSTANTIATE);
#undef ISTHMUS_INSTANTIATE

}
