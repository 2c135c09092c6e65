#include "Imaging/NoiseEstimate.h"

#include "Imaging/DiffusionRows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr std::int64_t rowPiece = 256; ///< nodes whose residuals are computed at once

/// Calls body(residuals, values, count) for pieces of the nodes [begin, end) of one row: the moduli
/// of the pseudo-residuals, -1 at nodes whose value three or more of their neighbours have.
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
  std::array<double, rowPiece> residuals;
  for (std::int64_t first = begin; first < end; first += rowPiece)
  {
    const std::int64_t count = std::min(rowPiece, end - first), next = first + count;
    const T* at = values + first;
    const T left = first > start ? at[-1] : at[0];
    const T right = next < start + size[0] ? at[count] : at[count - 1];
    PseudoResidualRow(RowStencil<T>{ at, at + front, at + back, at + below, at + above }, left,
      right, count, residuals.data());
    body(residuals.data(), at, count);
  }
}

/// Median of the absolute pseudo-residuals, by histograms with finer and finer bins.
template <typename T>
double MedianResidual(const DiffusionGrid<T>& grid, const T* values, double high, double count)
{
  constexpr std::size_t bins = 256;
  constexpr std::size_t ignored = 8; // several, since one would be added to node after node
  double low = 0.0, before = 0.0;
  for (int pass = 0; pass < 3 && high > low; ++pass)
  {
    const double scale = bins / (high - low);
    const auto counts = SumRows<bins + ignored>(grid,
      [&](std::int64_t begin, std::int64_t end, std::array<double, bins + ignored>& sum)
      {
        ForResiduals(grid, values, begin, end,
          [&](const double* residuals, const T*, std::int64_t nodes)
          {
            // Without branches, which cannot be predicted here.
            std::array<std::int32_t, rowPiece> bin;
            for (std::size_t n = 0; n < static_cast<std::size_t>(nodes); ++n)
            {
              const double place = (residuals[n] - low) * scale;
              const bool counted = place >= 0.0 && place < double(bins);
              const auto other = static_cast<std::int32_t>(bins + n % ignored);
              bin[n] = counted ? static_cast<std::int32_t>(place) : other;
            }
            for (std::size_t n = 0; n < static_cast<std::size_t>(nodes); ++n)
            {
              sum[static_cast<std::size_t>(bin[n])] += 1.0;
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
      [&](const double* residuals, const T* at, std::int64_t nodes)
      {
        for (std::int64_t n = 0; n < nodes && many == 0.0; ++n)
        {
          const auto value = static_cast<double>(at[n]);
          const auto end = seen.begin() + static_cast<std::ptrdiff_t>(count);
          if (residuals[n] < 0.0 || std::find(seen.begin(), end, value) != end)
          {
            continue;
          }
          if (count == seen.size())
          {
            many = 1.0;
            return;
          }
          seen[count++] = value;
        }
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
    [&](std::int64_t begin, std::int64_t end, std::array<double, 5>& ofPlane)
    {
      std::array<double, 5> sum = ofPlane; // a copy can be in registers
      sum[4] += static_cast<double>(end - begin);
      ForResiduals(grid, values, begin, end,
        [&](const double* residuals, const T* at, std::int64_t nodes)
        {
          for (std::int64_t n = 0; n < nodes; ++n)
          {
            if (residuals[n] >= 0.0)
            {
              const auto value = static_cast<double>(at[n]);
              sum[0] += 1.0;
              sum[1] += value;
              sum[2] += value * value;
              sum[3] += residuals[n] * residuals[n];
            }
          }
        });
      ofPlane = sum;
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
