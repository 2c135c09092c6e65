#include "Contouring/LevelEstimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

double Quantile(const std::vector<double>& sorted, double fraction)
{
  const double position = fraction * static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(position))];
}

/// Otsu's threshold of sorted values: halfway between the last of one class and the first of the
/// other.
double OtsuThreshold(const std::vector<double>& sorted)
{
  // About the median, so that a large offset loses no digits.
  const double middle = Quantile(sorted, 0.5);
  double total = 0.0;
  for (const double value : sorted)
  {
    total += value - middle;
  }
  const auto count = static_cast<double>(sorted.size());
  double below = 0.0, best = -1.0, threshold = middle;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    below += sorted[i] - middle;
    if (sorted[i] == sorted[i + 1])
    {
      continue;
    }
    const double n = static_cast<double>(i + 1);
    const double difference = total * n / count - below;
    const double between = difference * difference / (n * (count - n));
    if (between > best)
    {
      best = between;
      threshold = sorted[i] / 2.0 + sorted[i + 1] / 2.0;
    }
  }
  return threshold;
}

/// Standard deviation of the values below the median about it: the median distance, which for a
/// normal distribution is 0.6745 of it.
double LowerDeviation(const std::vector<double>& sorted)
{
  return (Quantile(sorted, 0.5) - Quantile(sorted, 0.25)) / 0.674490;
}

/// An odd step through about 2^20 nodes of the grid, without a common factor with the rows or
/// layers, so that all columns are visited equally often.
template <typename T>
std::int64_t SampleStep(const GridView<const T>& grid)
{
  std::int64_t step = grid.Size() / (std::int64_t{ 1 } << 20) + 1;
  if (step > 1)
  {
    step |= 1;
    while (std::gcd(step, grid.Dimensions[0] * grid.Dimensions[1]) > 1)
    {
      step += 2;
    }
  }
  return step;
}

}

double EstimateLevel(std::vector<double>& values)
{
  if (values.empty())
  {
    throw std::invalid_argument("The map has no value that is a finite number.");
  }
  std::sort(values.begin(), values.end());
  const double low = Quantile(values, 0.0005);
  const double high = Quantile(values, 0.9995);
  if (!(low < high))
  {
    // Less than a thousandth of the values differ from the rest: assume that these are the object.
    return values.front() / 2.0 + values.back() / 2.0;
  }
  // Noise or solvent that fills the box does not form two classes: Otsu's threshold would lie
  // within it.
  const double background = Quantile(values, 0.5) + 3.0 * LowerDeviation(values);
  const double top = Quantile(values, 0.99);
  // A few hot voxels would raise the threshold to their values.
  for (double& value : values)
  {
    value = std::clamp(value, low, high);
  }
  const double level = std::max(OtsuThreshold(values), std::min(background, top));
  // Only a few values, as in a label map: still below the highest, so that something is inside.
  const auto below = std::lower_bound(values.begin(), values.end(), values.back());
  return level < values.back() || below == values.begin()
    ? level
    : *(below - 1) / 2.0 + values.back() / 2.0;
}

template <typename T>
std::vector<double> SampleValues(const GridView<const T>& grid, const unsigned char* noData)
{
  const std::int64_t step = SampleStep(grid);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(grid.Size() / step + 1));
  for (std::int64_t n = 0; n < grid.Size(); n += step)
  {
    const auto value = static_cast<double>(grid.Data[n]);
    if (std::isfinite(value) && (!noData || noData[n] == 0))
    {
      values.push_back(value);
    }
  }
  return values;
}

template <typename T>
bool IsSignedDistance(const GridView<const T>& grid, const unsigned char* noData)
{
  constexpr double within = 0.1, share = 0.8;
  constexpr std::int64_t fewest = 64; // nodes
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto isKnown = [&](std::int64_t n)
  { return std::isfinite(static_cast<double>(grid.Data[n])) && (!noData || noData[n] == 0); };
  for (std::int64_t n = 0; n < grid.Size(); ++n)
  {
    if (isKnown(n))
    {
      low = std::min(low, static_cast<double>(grid.Data[n]));
      high = std::max(high, static_cast<double>(grid.Data[n]));
    }
  }
  if (!(low < 0.0 && high > 0.0))
  {
    return false;
  }
  const auto& dimensions = grid.Dimensions;
  const std::array<std::int64_t, 3> steps{ 1, dimensions[0], dimensions[0] * dimensions[1] };
  const auto isWithin = [&](std::int64_t n)
  {
    const auto value = static_cast<double>(grid.Data[n]);
    return isKnown(n) && value > low && value < high;
  };
  std::int64_t count = 0, perLength = 0, perNode = 0;
  const std::int64_t step = SampleStep(grid);
  for (std::int64_t n = 0; n < grid.Size(); n += step)
  {
    double length = 0.0, node = 0.0; // squares of the two gradients
    bool isMeasured = isWithin(n);
    for (std::size_t a = 0; a < 3 && isMeasured; ++a)
    {
      const std::int64_t at = n / steps[a] % dimensions[a];
      if (dimensions[a] == 1)
      {
        continue;
      }
      isMeasured =
        at > 0 && at + 1 < dimensions[a] && isWithin(n - steps[a]) && isWithin(n + steps[a]);
      const double slope = isMeasured ? 0.5 *
          (static_cast<double>(grid.Data[n + steps[a]]) -
            static_cast<double>(grid.Data[n - steps[a]]))
                                      : 0.0;
      node += slope * slope;
      length += slope * slope / (grid.Spacing[a] * grid.Spacing[a]);
    }
    if (isMeasured)
    {
      ++count;
      perLength += std::abs(std::sqrt(length) - 1.0) <= within ? 1 : 0;
      perNode += std::abs(std::sqrt(node) - 1.0) <= within ? 1 : 0;
    }
  }
  return count >= fewest &&
    static_cast<double>(std::max(perLength, perNode)) >= share * static_cast<double>(count);
}

template <typename T>
MapContrast MeasureContrast(const GridView<const T>& grid, const unsigned char* noData)
{
  MapContrast contrast;
  const std::vector<double> values = SampleValues(grid, noData);
  const auto count = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  double squares = 0.0, cubes = 0.0;
  for (const double value : values)
  {
    const double difference = value - mean;
    squares += difference * difference;
    cubes += difference * difference * difference;
  }
  const double deviation = std::sqrt(squares / count);
  if (!(deviation > 0.0) || !std::isfinite(cubes))
  {
    return contrast;
  }
  contrast.Skewness = cubes / count / (deviation * deviation * deviation);
  // Dark density stays away from the border; a mask with a low value outside is adjacent to it.
  const double low = mean - 2.0 * deviation;
  contrast.LowShare = static_cast<double>(std::count_if(values.begin(), values.end(),
                        [low](double value) { return value < low; })) /
    count;
  double border = 0.0, borderLows = 0.0;
  const auto& dimensions = grid.Dimensions;
  for (std::int64_t k = 0; k < dimensions[2]; ++k)
  {
    for (std::int64_t j = 0; j < dimensions[1]; ++j)
    {
      const bool onFace = k == 0 || k + 1 == dimensions[2] || j == 0 || j + 1 == dimensions[1];
      const std::int64_t step = onFace ? 1 : std::max<std::int64_t>(dimensions[0] - 1, 1);
      for (std::int64_t i = 0; i < dimensions[0]; i += step)
      {
        border += 1.0;
        borderLows += static_cast<double>(grid(i, j, k)) < low ? 1.0 : 0.0;
      }
    }
  }
  contrast.BorderLowShare = borderLows / border;
  return contrast;
}

template std::vector<double> SampleValues(const GridView<const float>&, const unsigned char*);
template bool IsSignedDistance(const GridView<const float>&, const unsigned char*);
template bool IsSignedDistance(const GridView<const double>&, const unsigned char*);
template MapContrast MeasureContrast(const GridView<const float>&, const unsigned char*);
template MapContrast MeasureContrast(const GridView<const double>&, const unsigned char*);
template std::vector<double> SampleValues(const GridView<const double>&, const unsigned char*);

}
