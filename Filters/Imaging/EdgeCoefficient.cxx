#include "Imaging/EdgeCoefficient.h"

#include "Core/ParallelFor.h"
#include "Imaging/DiffusionEvaluation.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace isthmus
{
namespace
{

/// Running means along lines that lie side by side: `width` lines, `step` values from node to node.
template <typename T>
void MeanAlongLines(
  T* lines, std::int64_t width, std::int64_t length, std::int64_t step, std::int64_t window)
{
  window = std::min(window, length);
  std::vector<T> copy(static_cast<std::size_t>(width * length));
  for (std::int64_t n = 0; n < length; ++n)
  {
    std::copy_n(lines + n * step, width, copy.data() + n * width);
  }
  std::vector<double> sums(static_cast<std::size_t>(width), 0.0);
  for (std::int64_t n = 0; n < window; ++n)
  {
    const T* row = copy.data() + n * width;
    std::transform(sums.begin(), sums.end(), row, sums.begin(),
      [](double sum, T value) { return sum + static_cast<double>(value); });
  }
  const double scale = 1.0 / static_cast<double>(window);
  for (std::int64_t n = 0, begin = 0; n < length; ++n)
  {
    if (n > window / 2 && begin + window < length)
    {
      const T* leaves = copy.data() + begin * width;
      const T* enters = leaves + window * width;
      for (std::int64_t i = 0; i < width; ++i)
      {
        sums[static_cast<std::size_t>(i)] +=
          static_cast<double>(enters[i]) - static_cast<double>(leaves[i]);
      }
      ++begin;
    }
    std::transform(sums.begin(), sums.end(), lines + n * step,
      [scale](double sum) { return static_cast<T>(sum * scale); });
  }
}

/// Replaces each value by the mean over the `window` nodes around it along every axis; near the
/// grid's ends the window is moved inwards until it fits (and is all of a shorter axis), so that it
/// always has that many values. O(nodes), whatever the window.
template <typename T>
void BoxMean(const std::array<std::int64_t, 3>& dimensions, int window, T* values)
{
  const auto [nx, ny, nz] = dimensions;
  const std::int64_t plane = nx * ny, length = nz;
  const std::int64_t rowLength = nx, rows = ny;
  ParallelFor(0, length, 1,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < rows; ++j)
        {
          MeanAlongLines(values + k * plane + j * rowLength, 1, rowLength, 1, window);
        }
        MeanAlongLines(values + k * plane, rowLength, rows, rowLength, window);
      }
    });
  ParallelFor(0, rows, 1,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t j = first; j < last; ++j)
      {
        MeanAlongLines(values + j * rowLength, rowLength, length, plane, window);
      }
    });
}

/// Calls body(index, gradient of `values`) for every node, in parallel; one-sided at the ends.
template <typename T, typename Body>
void ForGradients(const DiffusionGrid<T>& grid, const T* values, Body&& body)
{
  const auto [nx, ny, nz] = grid.Dimensions;
  const std::array<std::int64_t, 3> size{ nx, ny, nz }, step{ 1, nx, nx * ny };
  /// Neighbours along an axis as offsets, and one over the distance between them.
  struct Pair
  {
    std::int64_t Before, After;
    T Weight;
  };
  auto pair = [&](std::size_t axis, std::int64_t at)
  {
    const std::int64_t before = at > 0 ? step[axis] : 0;
    const std::int64_t after = at + 1 < size[axis] ? step[axis] : 0;
    const double one = 1.0 / grid.Spacing[axis];
    return Pair{ before, after, static_cast<T>(before > 0 && after > 0 ? 0.5 * one : one) };
  };
  ParallelFor(0, size[1] * size[2], 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const T* row = values + line * size[0];
        const Pair y = pair(1, line % size[1]), z = pair(2, line / size[1]);
        auto node = [&](std::int64_t i, const Pair& x)
        {
          auto along = [&](const Pair& p)
          { return p.Weight * (row[i + p.After] - row[i - p.Before]); };
          body(line * size[0] + i, std::array<T, 3>{ along(x), along(y), along(z) });
        };
        const Pair inside{ 1, 1, static_cast<T>(0.5 / grid.Spacing[0]) };
        node(0, pair(0, 0));
        for (std::int64_t i = 1; i + 1 < size[0]; ++i)
        {
          node(i, inside);
        }
        if (size[0] > 1)
        {
          node(size[0] - 1, pair(0, size[0] - 1));
        }
      }
    });
}

template <typename T>
T Squared(const std::array<T, 3>& vector)
{
  return vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
}

template <typename T>
double Mean(const DiffusionGrid<T>& grid, const T* values)
{
  const auto sums = SumRows<2>(grid,
    [values](std::int64_t begin, std::int64_t end, std::array<double, 2>& sum)
    {
      for (std::int64_t n = begin; n < end; ++n)
      {
        sum[0] += static_cast<double>(values[n]);
      }
      sum[1] += static_cast<double>(end - begin);
    });
  return sums[0] / sums[1];
}

/// Takes the squared window mean of a component from `variance`, which holds the mean square.
template <typename T>
void TakeSquaredMean(
  const std::array<std::int64_t, 3>& dimensions, int window, T* component, T* variance)
{
  BoxMean(dimensions, window, component);
  ParallelFor(0, dimensions[0] * dimensions[1] * dimensions[2], 1 << 16,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        variance[n] -= component[n] * component[n];
      }
    });
}

/// c = exp(-|grad u|^2 / (2 sigma^2)), sigma^2 the window's mean square less its squared mean.
template <typename T>
void FillFromLocalVariance(const DiffusionGrid<T>& grid,
  const EdgeCoefficientParameters& parameters, const T* values, T* variance, T* c)
{
  const int window = parameters.Window;
  if (parameters.Order == 0)
  {
    // Squares of values far from zero would cancel.
    const T center = static_cast<T>(Mean(grid, values));
    ParallelFor(0, grid.Size(), 1 << 16,
      [=](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          c[n] = values[n] - center;
          variance[n] = c[n] * c[n];
        }
      });
    BoxMean(grid.Dimensions, window, variance);
    TakeSquaredMean(grid.Dimensions, window, c, variance);
  }
  else
  {
    ForGradients(grid, values,
      [=](std::int64_t n, const std::array<T, 3>& slope) { variance[n] = Squared(slope); });
    BoxMean(grid.Dimensions, window, variance);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      ForGradients(
        grid, values, [=](std::int64_t n, const std::array<T, 3>& slope) { c[n] = slope[axis]; });
      TakeSquaredMean(grid.Dimensions, window, c, variance);
    }
  }
  ForGradients(grid, values,
    [=](std::int64_t n, const std::array<T, 3>& slope) {
      c[n] = std::exp(-Squared(slope) / (2 * std::max(variance[n], std::numeric_limits<T>::min())));
    });
}

/// Heat flow for half the variance; the result is in scratch[0]. Returns the number of steps.
template <typename T>
int Smooth(
  const DiffusionGrid<T>& grid, double deviation, const T* values, const std::array<T*, 2>& scratch)
{
  DiffusionOperator<T> heat;
  heat.Dimensions = grid.Dimensions;
  heat.Spacing = grid.Spacing;
  const double time = deviation * deviation / 2.0;
  const auto steps = EulerSteps(time, 2.0 / heat.SpectralBound(), 0);
  RowUpdate<T> update;
  update.RateFactor = static_cast<T>(steps.front().Length);
  const auto most = static_cast<std::size_t>(StagesPerPass(grid, heat));
  const std::size_t passes = (steps.size() + most - 1) / most;
  DiffusionPass<T> pass;
  pass.Current = values;
  for (std::size_t left = passes, stages = steps.size(); left-- > 0; stages -= pass.Updates.size())
  {
    pass.Updates.assign((stages + left) / (left + 1), update);
    pass.Out = scratch[left % 2];
    Evaluate(heat, pass);
    grid.Exchange(pass.Out);
    pass.Current = pass.Out;
  }
  return static_cast<int>(steps.size());
}

}

template <typename T>
int FillEdgeCoefficient(const DiffusionGrid<T>& grid, const EdgeCoefficientParameters& parameters,
  const T* values, const std::array<T*, 2>& scratch, T* coefficient)
{
  int evaluations = 1;
  if (parameters.PreSmoothing > 0.0)
  {
    evaluations += Smooth(grid, parameters.PreSmoothing, values, { scratch[0], coefficient });
    values = scratch[0];
  }
  if (parameters.LocalVariance)
  {
    FillFromLocalVariance(grid, parameters, values, scratch[1], coefficient);
  }
  else
  {
    const T scale = static_cast<T>(-0.5 / (parameters.Sigma * parameters.Sigma));
    ForGradients(grid, values,
      [=](std::int64_t n, const std::array<T, 3>& slope)
      { coefficient[n] = std::exp(scale * Squared(slope)); });
  }
  grid.Exchange(coefficient);
  return evaluations;
}

template int FillEdgeCoefficient(const DiffusionGrid<float>&, const EdgeCoefficientParameters&,
  const float*, const std::array<float*, 2>&, float*);
template int FillEdgeCoefficient(const DiffusionGrid<double>&, const EdgeCoefficientParameters&,
  const double*, const std::array<double*, 2>&, double*);

}
