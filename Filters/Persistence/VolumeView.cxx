#include "Persistence/VolumeView.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t Block = 65536;

struct Extremes
{
  double Minimum = std::numeric_limits<double>::infinity();
  double Maximum = -std::numeric_limits<double>::infinity();
  std::int64_t Count = 0; ///< of finite values

  Extremes& operator+=(const Extremes& other)
  {
    this->Minimum = std::min(this->Minimum, other.Minimum);
    this->Maximum = std::max(this->Maximum, other.Maximum);
    this->Count += other.Count;
    return *this;
  }
};

/// Moments of the values less the minimum, in units of the width.
struct Moments
{
  double Sum = 0.0;
  double Squares = 0.0;

  Moments& operator+=(const Moments& other)
  {
    this->Sum += other.Sum;
    this->Squares += other.Squares;
    return *this;
  }
};

struct FirstIndex
{
  std::int64_t Index = std::numeric_limits<std::int64_t>::max();

  FirstIndex& operator+=(const FirstIndex& other)
  {
    this->Index = std::min(this->Index, other.Index);
    return *this;
  }
};

template <typename T>
Extremes FindExtremes(const T* values, std::int64_t count)
{
  return ParallelReduce(count, Block, Extremes{},
    [&](Extremes& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const auto value = static_cast<double>(values[i]);
        if (std::isfinite(value))
        {
          part.Minimum = std::min(part.Minimum, value);
          part.Maximum = std::max(part.Maximum, value);
          ++part.Count;
        }
      }
    });
}

/// `half`: values, minimum and width are halved, for a width beyond the range of doubles.
template <typename T>
Moments ComputeMoments(const T* values, std::int64_t count, double minimum, double width, bool half)
{
  const double scale = half ? 0.5 : 1.0;
  return ParallelReduce(count, Block, Moments{},
    [&](Moments& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const auto value = static_cast<double>(values[i]);
        if (std::isfinite(value))
        {
          const double off = (scale * value - minimum) / width;
          part.Sum += off;
          part.Squares += off * off;
        }
      }
    });
}

template <typename T>
std::int64_t FirstNaN(const T* values, std::int64_t count)
{
  return ParallelReduce(count, Block, FirstIndex{},
    [&](FirstIndex& part, std::int64_t first, std::int64_t last)
    {
      // Most blocks have none: without an early exit the loop is vectorised.
      bool any = false;
      for (std::int64_t i = first; i < last; ++i)
      {
        any |= values[i] != values[i];
      }
      for (std::int64_t i = first; any && i < last; ++i)
      {
        if (values[i] != values[i])
        {
          part.Index = std::min(part.Index, i);
        }
      }
    })
    .Index;
}

}

double VolumeView::Value(std::int64_t node) const
{
  return WithTypedValues(
    *this, [node](const auto* values) { return static_cast<double>(values[node]); });
}

void RejectNaN(const VolumeView& volume)
{
  if (!volume.Floating)
  {
    return;
  }
  const std::int64_t first = volume.Bytes == 4
    ? FirstNaN(static_cast<const float*>(volume.Data), volume.NodeCount())
    : FirstNaN(static_cast<const double*>(volume.Data), volume.NodeCount());
  if (first < volume.NodeCount())
  {
    const auto& n = volume.Dimensions;
    throw std::invalid_argument("The value at node (" + std::to_string(first % n[0]) + ", " +
      std::to_string(first / n[0] % n[1]) + ", " + std::to_string(first / (n[0] * n[1])) +
      ") is not a number, so it has no place in the order of the levels: replace such values "
      "first, by the lowest of the volume for instance.");
  }
}

VolumeStatistics MeasureVolume(const VolumeView& volume)
{
  RejectNaN(volume);
  const Extremes range = WithTypedValues(
    volume, [&](const auto* values) { return FindExtremes(values, volume.NodeCount()); });
  VolumeStatistics statistics;
  if (range.Count == 0)
  {
    return statistics;
  }
  statistics.Minimum = range.Minimum;
  statistics.Maximum = range.Maximum;
  statistics.Mean = range.Minimum;
  const bool half = !std::isfinite(range.Maximum - range.Minimum);
  const double scale = half ? 0.5 : 1.0;
  const double width = scale * range.Maximum - scale * range.Minimum;
  if (width > 0.0)
  {
    // Relative to the lowest value and in units of the width, so that nothing overflows or cancels.
    const Moments moments = WithTypedValues(volume,
      [&](const auto* values)
      { return ComputeMoments(values, volume.NodeCount(), scale * range.Minimum, width, half); });
    const auto count = static_cast<double>(range.Count);
    const double mean = moments.Sum / count;
    statistics.Mean = (scale * range.Minimum + mean * width) / scale;
    statistics.StandardDeviation =
      width * std::sqrt(std::max(0.0, moments.Squares / count - mean * mean)) / scale;
  }
  return statistics;
}

}
