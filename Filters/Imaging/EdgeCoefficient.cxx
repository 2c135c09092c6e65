#include "EdgeCoefficient.h"

#include "BoxMean.h"
#include "TimeSteps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

/// Calls body(index, |gradient|^2 of `values`) for every node, in parallel.
template <typename T, typename Body>
void ForGradients(const DiffusionGrid<T>& grid, const T* values, Body&& body)
{
  const auto [nx, ny, nz] = grid.Dimensions;
  const std::array<std::int64_t, 3> size{ nx, ny, nz }, step{ 1, nx, nx * ny };
  const std::array<T, 3> half{ static_cast<T>(0.5 / grid.Spacing[0]),
    static_cast<T>(0.5 / grid.Spacing[1]), static_cast<T>(0.5 / grid.Spacing[2]) };
  ParallelFor(0, size[1] * size[2], 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const std::int64_t j = line % size[1], k = line / size[1];
        const T* row = values + line * size[0];
        const T* front = row - (j > 0 ? step[1] : 0);
        const T* back = row + (j + 1 < size[1] ? step[1] : 0);
        const T* below = row - (k > 0 ? step[2] : 0);
        const T* above = row + (k + 1 < size[2] ? step[2] : 0);
        for (std::int64_t i = 0; i < size[0]; ++i)
        {
          const T dx = half[0] * (row[std::min(i + 1, size[0] - 1)] - row[i > 0 ? i - 1 : 0]);
          const T dy = half[1] * (back[i] - front[i]);
          const T dz = half[2] * (above[i] - below[i]);
          body(line * size[0] + i, dx * dx + dy * dy + dz * dz);
        }
      }
    });
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

/// c = exp(-|grad u|^2 / (2 sigma^2)), sigma^2 the window's mean square less its squared mean.
template <typename T>
void FillFromLocalVariance(const DiffusionGrid<T>& grid, const DiffusionParameters& parameters,
  const T* values, const std::array<T*, 2>& scratch, T* c)
{
  T* mean = scratch[0];
  T* square = scratch[1];
  const bool ofValues = parameters.Order == 0;
  // Squares of values far from zero would cancel.
  const T centre = ofValues ? static_cast<T>(Mean(grid, values)) : T(0);
  ForGradients(grid, values, [&](std::int64_t n, T slope) { c[n] = slope; });
  ParallelFor(0, grid.Size(), 1 << 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        mean[n] = values[n] - centre; // `values` may be this very volume
        square[n] = ofValues ? mean[n] * mean[n] : c[n];
      }
    });
  BoxMean(grid.Dimensions, parameters.Window, mean);
  BoxMean(grid.Dimensions, parameters.Window, square);
  // The mean of the gradient is the gradient of the mean.
  ForGradients(grid, mean,
    [&](std::int64_t n, T slopeOfMean)
    {
      const T variance = square[n] - (ofValues ? mean[n] * mean[n] : slopeOfMean);
      const T exponent = -c[n] / (2 * std::max(variance, std::numeric_limits<T>::min()));
      c[n] = std::exp(exponent);
    });
}

/// Heat flow for half the variance; the result is in scratch[0].
template <typename T>
void Smooth(
  const DiffusionGrid<T>& grid, double deviation, const T* values, const std::array<T*, 2>& scratch)
{
  DiffusionOperator<T> heat;
  heat.Dimensions = grid.Dimensions;
  heat.Spacing = grid.Spacing;
  const double time = deviation * deviation / 2.0;
  const auto steps = EulerSteps(time, 2.0 / heat.SpectralBound(), 0);
  DiffusionStage<T> stage;
  stage.Update.OfRate = static_cast<T>(steps.front().Length);
  stage.Current = values;
  for (std::size_t left = steps.size(); left-- > 0;)
  {
    stage.Out = scratch[left % 2];
    Evaluate(heat, stage);
    grid.Exchange(stage.Out);
    stage.Current = stage.Out;
  }
}

}

bool LooksBeyondNeighbours(const DiffusionParameters& parameters)
{
  using Type = DiffusionParameters::EdgeStoppingType;
  return parameters.Flow == DiffusionParameters::FlowType::Hyperdiffusion &&
    (parameters.EdgeStopping == Type::LocalVariance ||
      (parameters.EdgeStopping == Type::Gaussian && parameters.PreSmoothing > 0.0));
}

template <typename T>
void FillEdgeCoefficient(const DiffusionGrid<T>& grid, const DiffusionParameters& parameters,
  const T* values, const std::array<T*, 2>& scratch, T* coefficient)
{
  if (parameters.PreSmoothing > 0.0)
  {
    Smooth(grid, parameters.PreSmoothing, values, { scratch[0], coefficient });
    values = scratch[0];
  }
  if (parameters.EdgeStopping == DiffusionParameters::EdgeStoppingType::LocalVariance)
  {
    FillFromLocalVariance(grid, parameters, values, scratch, coefficient);
  }
  else
  {
    const T scale = static_cast<T>(-0.5 / (parameters.Sigma * parameters.Sigma));
    ForGradients(
      grid, values, [=](std::int64_t n, T slope) { coefficient[n] = std::exp(scale * slope); });
  }
  grid.Exchange(coefficient);
}

template void FillEdgeCoefficient(const DiffusionGrid<float>&, const DiffusionParameters&,
  const float*, const std::array<float*, 2>&, float*);
template void FillEdgeCoefficient(const DiffusionGrid<double>&, const DiffusionParameters&,
  const double*, const std::array<double*, 2>&, double*);

}
