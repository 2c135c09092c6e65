#include "NoiseEstimate.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Calls body(|pseudo-residual|) for the nodes [begin, end) of one row.
template <typename T, typename Body>
void ForResiduals(
  const DiffusionGrid<T>& grid, const T* values, std::int64_t begin, std::int64_t end, Body&& body)
{
  const auto& size = grid.Dimensions;
  const std::int64_t step = size[0], plane = size[0] * size[1];
  const std::int64_t line = begin / size[0], j = line % size[1], k = line / size[1];
  const std::int64_t start = line * size[0];
  // Beyond the ends a node stands in for its missing neighbour.
  const std::int64_t front = j > 0 ? -step : 0, back = j + 1 < size[1] ? step : 0;
  const std::int64_t below = k > 0 ? -plane : 0, above = k + 1 < size[2] ? plane : 0;
  for (std::int64_t n = begin; n < end; ++n)
  {
    const T* at = values + n;
    const T left = n > start ? at[-1] : at[0];
    const T right = n + 1 < start + size[0] ? at[1] : at[0];
    const double sum = static_cast<double>(left) + static_cast<double>(right) +
      static_cast<double>(at[front]) + static_cast<double>(at[back]) +
      static_cast<double>(at[below]) + static_cast<double>(at[above]);
    body(std::abs(static_cast<double>(at[0]) - sum / 6.0));
  }
}

/// Median of the absolute pseudo-residuals, by counting into bins, ever finer.
template <typename T>
double MedianResidual(const DiffusionGrid<T>& grid, const T* values, double high, double count)
{
  constexpr std::size_t bins = 256;
  double low = 0.0, before = 0.0;
  for (int pass = 0; pass < 3 && high > low; ++pass)
  {
    const double scale = bins / (high - low);
    const auto counts = SumRows<bins>(grid,
      [&](std::int64_t begin, std::int64_t end, std::array<double, bins>& sum)
      {
        ForResiduals(grid, values, begin, end,
          [&](double residual)
          {
            const double bin = (residual - low) * scale;
            if (bin >= 0.0 && bin < bins)
            {
              sum[static_cast<std::size_t>(bin)] += 1.0;
            }
          });
      });
    std::size_t bin = 0;
    while (bin + 1 < bins && before + counts[bin] < count / 2.0)
    {
      before += counts[bin++];
    }
    low += static_cast<double>(bin) / scale;
    high = low + 1.0 / scale;
  }
  return low > 0.0 ? (low + high) / 2.0 : 0.0; // less than the finest bin is nothing
}

}

template <typename T>
NoiseEstimate EstimateNoise(const DiffusionGrid<T>& grid, const T* values)
{
  const auto sums = SumRows<4>(grid,
    [&](std::int64_t begin, std::int64_t end, std::array<double, 4>& sum)
    {
      sum[0] += static_cast<double>(end - begin);
      for (std::int64_t n = begin; n < end; ++n)
      {
        sum[1] += static_cast<double>(values[n]);
        sum[2] += static_cast<double>(values[n]) * static_cast<double>(values[n]);
      }
      ForResiduals(
        grid, values, begin, end, [&](double residual) { sum[3] += residual * residual; });
    });
  NoiseEstimate estimate;
  if (sums[0] > 0.0)
  {
    const double mean = sums[1] / sums[0];
    estimate.Deviation = std::sqrt(std::max(0.0, sums[2] / sums[0] - mean * mean));
    // By Chebyshev's inequality the median is below sqrt(2) times the root mean square.
    const double bound = 1.5 * std::sqrt(sums[3] / sums[0]);
    estimate.Noise =
      MedianResidual(grid, values, bound, sums[0]) / (0.674490 * std::sqrt(7.0 / 6.0));
  }
  return estimate;
}

template NoiseEstimate EstimateNoise(const DiffusionGrid<float>&, const float*);
template NoiseEstimate EstimateNoise(const DiffusionGrid<double>&, const double*);

}
