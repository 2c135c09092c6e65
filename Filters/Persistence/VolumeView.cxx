#include "VolumeView.h"

#include "ParallelReduce.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

struct Sums
{
  double Minimum = std::numeric_limits<double>::infinity();
  double Maximum = -std::numeric_limits<double>::infinity();
  double Sum = 0.0;
  double Squares = 0.0; ///< of values less Shift
  std::int64_t Count = 0;
  std::int64_t FirstNaN = std::numeric_limits<std::int64_t>::max();

  Sums& operator+=(const Sums& other)
  {
    this->Minimum = std::min(this->Minimum, other.Minimum);
    this->Maximum = std::max(this->Maximum, other.Maximum);
    this->Sum += other.Sum;
    this->Squares += other.Squares;
    this->Count += other.Count;
    this->FirstNaN = std::min(this->FirstNaN, other.FirstNaN);
    return *this;
  }
};

constexpr std::int64_t Block = 65536;

/// Extremes and NaNs; and the sum of (value - shift) / scale, and of its square.
template <typename T>
Sums Measure(const T* values, std::int64_t count, double shift, double scale)
{
  return ParallelReduce(count, Block, Sums{},
    [&](Sums& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const double value = static_cast<double>(values[i]);
        if (std::isfinite(value))
        {
          const double off = value / scale - shift / scale;
          part.Minimum = std::min(part.Minimum, value);
          part.Maximum = std::max(part.Maximum, value);
          part.Sum += off;
          part.Squares += off * off;
          ++part.Count;
        }
        else if (std::isnan(value))
        {
          part.FirstNaN = std::min(part.FirstNaN, i);
        }
      }
    });
}

}

double VolumeView::Value(std::int64_t node) const
{
  return WithTypedValues(
    *this, [node](const auto* values) { return static_cast<double>(values[node]); });
}

VolumeStatistics MeasureVolume(const VolumeView& volume)
{
  const auto measure = [&](double shift, double scale)
  {
    return WithTypedValues(volume,
      [&](const auto* values) { return Measure(values, volume.NodeCount(), shift, scale); });
  };
  const Sums first = measure(0.0, 1.0);
  if (first.FirstNaN < volume.NodeCount())
  {
    const auto& n = volume.Dimensions;
    throw std::invalid_argument("The value at node (" + std::to_string(first.FirstNaN % n[0]) +
      ", " + std::to_string(first.FirstNaN / n[0] % n[1]) + ", " +
      std::to_string(first.FirstNaN / (n[0] * n[1])) +
      ") is not a number, so it has no place in the order of the levels: replace such values "
      "first, by the lowest of the volume for instance.");
  }
  VolumeStatistics statistics;
  if (first.Count == 0)
  {
    return statistics;
  }
  statistics.Minimum = first.Minimum;
  statistics.Maximum = first.Maximum;
  statistics.Mean = first.Minimum;
  const double width = first.Maximum - first.Minimum;
  if (width > 0.0)
  {
    // Relative to the lowest value and in units of the width, so that nothing overflows or cancels.
    const double scale = std::isfinite(width) ? width : std::numeric_limits<double>::max();
    const Sums second = measure(first.Minimum, scale);
    const auto count = static_cast<double>(second.Count);
    const double mean = second.Sum / count;
    statistics.Mean = first.Minimum + scale * mean;
    statistics.StandardDeviation =
      scale * std::sqrt(std::max(0.0, second.Squares / count - mean * mean));
  }
  return statistics;
}

}
