#include "Imaging/NoiseEstimate.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Calls body(|pseudo-residual|, value) for those of the nodes [begin, end) of one row whose
/// value fewer than three of their neighbours have.
template <typename T, typename Body>
void ForResiduals(
  const DiffusionGrid<T>& grid, const T* values, std::int64_t begin, std::int64_t end, Body&& body)
{
  const auto& size = grid.Dimensions;
  const std::int64_t step = size[0], plane = size[0] * size[1];
  const std::int64_t line = begin / size[0], j = line % size[1], k = line / size[1];
  const std::int64_t start = line * size[0];
  // Beyond the ends a node replaces its missing neighbour.
  const std::int64_t front = j > 0 ? -step : 0, back = j + 1 < size[1] ? step : 0;
  const std::int64_t below = k > 0 ? -plane : 0, above = k + 1 < size[2] ? plane : 0;
  for (std::int64_t n = begin; n < end; ++n)
  {
    const T* at = values + n;
    const T left = n > start ? at[-1] : at[0];
    const T right = n + 1 < start + size[0] ? at[1] : at[0];
    const int equal = (left == at[0]) + (right == at[0]) + (at[front] == at[0]) +
      (at[back] == at[0]) + (at[below] == at[0]) + (at[above] == at[0]);
    if (equal >= 3)
    {
      continue;
    }
    const double sum = static_cast<double>(left) + static_cast<double>(right) +
      static_cast<double>(at[front]) + static_cast<double>(at[back]) +
      static_cast<double>(at[below]) + static_cast<double>(at[above]);
    body(std::abs(static_cast<double>(at[0]) - sum / 6.0), static_cast<double>(at[0]));
  }
}

/// Median of the absolute pseudo-residuals, by histograms with finer and finer bins.
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
          [&](double residual, double)
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
  return low > 0.0 ? (low + high) / 2.0 : 0.0; // below the finest bin: no noise
}

/// Whether the nodes that count have at most 32 values, on every rank.
template <typename T>
bool HasFewValues(const DiffusionGrid<T>& grid, const T* values)
{
  std::array<double, 32> seen{};
  std::size_t count = 0;
  double many = 0.0;
  for (std::int64_t row = 0; row < grid.Size() && many == 0.0; row += grid.Dimensions[0])
  {
    ForResiduals(grid, values, row, row + grid.Dimensions[0],
      [&](double, double value)
      {
        const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
        if (many > 0.0 || std::find(seen.begin(), end, value) != end)
        {
          return;
        }
        if (count == seen.size())
        {
          many = 1.0;
          return;
        }
        seen[count++] = value;
      });
  }
  if (grid.SumOverRanks)
  {
    grid.SumOverRanks(&many, 1);
  }
  return many == 0.0;
}

}

template <typename T>
NoiseEstimate EstimateNoise(const DiffusionGrid<T>& grid, const T* values)
{
  const auto sums = SumRows<5>(grid,
    [&](std::int64_t begin, std::int64_t end, std::array<double, 5>& sum)
    {
      sum[4] += static_cast<double>(end - begin);
      ForResiduals(grid, values, begin, end,
        [&](double residual, double value)
        {
          sum[0] += 1.0;
          sum[1] += value;
          sum[2] += value * value;
          sum[3] += residual * residual;
        });
    });
  NoiseEstimate estimate;
  estimate.FewValues = HasFewValues(grid, values);
  if (sums[0] > 0.0)
  {
    const double mean = sums[1] / sums[0];
    estimate.Counted = sums[0] / sums[4];
    estimate.Deviation = std::sqrt(std::max(0.0, sums[2] / sums[0] - mean * mean));
    // By Chebyshev's inequality the median is below sqrt(2) times the root mean square.
    const double bound = 1.5 * std::sqrt(sums[3] / sums[0]);
    estimate.Noise = estimate.FewValues
      ? 0.0
      : MedianResidual(grid, values, bound, sums[0]) / (0.674490 * std::sqrt(7.0 / 6.0));
  }
  return estimate;
}

template NoiseEstimate EstimateNoise(const DiffusionGrid<float>&, const float*);
template NoiseEstimate EstimateNoise(const DiffusionGrid<double>&, const double*);

double NoiseGradient(const NoiseEstimate& noise, double voxel)
{
  return noise.Noise > 0.0 ? 1.5 * noise.Noise / voxel : 1.0;
}

}
