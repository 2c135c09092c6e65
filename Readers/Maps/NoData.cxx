#include "Maps/NoData.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace isthmus
{
namespace
{

constexpr double Factor = 20.0; // between the magnitudes of the value and of all others
constexpr std::size_t Kinds = 32;
constexpr std::int64_t Grain = 65536;

/// The largest value, how often it occurs, and the second largest; of the negated values, the
/// smallest ones.
struct Peak
{
  double First = -std::numeric_limits<double>::infinity(), Second = First;
  std::int64_t Times = 0; ///< that First occurs

  void Add(double value, std::int64_t times)
  {
    if (value > this->First)
    {
      this->Second = this->First;
      this->First = value;
      this->Times = times;
    }
    else if (value == this->First)
    {
      this->Times += times;
    }
    else
    {
      this->Second = std::max(this->Second, value);
    }
  }

  void Add(const Peak& other)
  {
    this->Add(other.First, other.Times);
    this->Add(other.Second, 1);
  }
};

struct Extremes
{
  Peak High, Low; ///< Low of the negated values

  Extremes& operator+=(const Extremes& other)
  {
    this->High.Add(other.High);
    this->Low.Add(other.Low);
    return *this;
  }
};

template <typename T>
Extremes FindExtremes(const T* values, std::int64_t count)
{
  return ParallelReduce(count, Grain, Extremes{},
    [values](Extremes& part, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const auto value = static_cast<double>(values[i]);
        if (std::isfinite(value))
        {
          part.High.Add(value, 1);
          part.Low.Add(-value, 1);
        }
      }
    });
}

/// Whether there are enough different values besides `noData`.
template <typename T>
bool AreManyValues(const T* values, std::int64_t count, T noData)
{
  std::set<T> kinds;
  for (std::int64_t i = 0; i < count && kinds.size() < Kinds; ++i)
  {
    if (values[i] != noData && std::isfinite(static_cast<double>(values[i])))
    {
      kinds.insert(values[i]);
    }
  }
  return kinds.size() >= Kinds;
}

}

template <typename T>
std::optional<T> FindNoDataValue(const T* values, std::int64_t count)
{
  const Extremes found = FindExtremes(values, count);
  const auto stands = [&](const Peak& peak, double opposite, T value)
  {
    const double others = std::max(std::abs(peak.Second), std::abs(opposite));
    return peak.Times > 1 && std::isfinite(others) && std::abs(peak.First) >= Factor * others &&
      AreManyValues(values, count, value);
  };
  const T highest = static_cast<T>(found.High.First), lowest = static_cast<T>(-found.Low.First);
  if (stands(found.High, found.Low.First, highest))
  {
    return highest;
  }
  if (stands(found.Low, found.High.First, lowest))
  {
    return lowest;
  }
  return std::nullopt;
}

template <typename T>
NoDataReplacement ReplaceNoData(T* values, std::int64_t count, T noData, unsigned char* mask)
{
  double least = std::numeric_limits<double>::infinity(), most = -least;
  NoDataReplacement done;
  for (std::int64_t i = 0; i < count; ++i)
  {
    const auto value = static_cast<double>(values[i]);
    mask[i] = values[i] == noData ? 1 : 0;
    done.Voxels += mask[i];
    if (mask[i] == 0 && std::isfinite(value))
    {
      least = std::min(least, value);
      most = std::max(most, value);
    }
  }
  done.By = std::clamp(0.0, least, most);
  const T by = static_cast<T>(done.By);
  ParallelFor(0, count, Grain,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        values[i] = mask[i] != 0 ? by : values[i];
      }
    });
  return done;
}

#define ISTHMUS_NO_DATA(T)                                                                         \
  template std::optional<T> FindNoDataValue(const T*, std::int64_t);                               \
  template NoDataReplacement ReplaceNoData(T*, std::int64_t, T, unsigned char*)
ISTHMUS_NO_DATA(signed char);
ISTHMUS_NO_DATA(unsigned char);
ISTHMUS_NO_DATA(short);
ISTHMUS_NO_DATA(unsigned short);
ISTHMUS_NO_DATA(float);
#undef ISTHMUS_NO_DATA

}
