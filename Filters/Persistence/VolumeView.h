/**
 * @file VolumeView.h
 * @brief View of a scalar volume of any type, for the persistence of volumes.
 */
#ifndef isthmus_VolumeView_h
#define isthmus_VolumeView_h

#include "vtkIsthmusFiltersPersistenceModule.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace isthmus
{

/**
 * Values at the nodes of a grid, with x varying fastest: float, double or an integer of 1, 2, 4 or
 * 8 bytes. It owns nothing.
 */
struct VolumeView
{
  const void* Data = nullptr;
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  int Bytes = 4;
  bool Floating = true;
  bool Signed = true;

  VolumeView() = default;
  template <typename T>
  VolumeView(const T* data, const std::array<std::int64_t, 3>& dimensions)
    : Data(data)
    , Dimensions(dimensions)
    , Bytes(static_cast<int>(sizeof(T)))
    , Floating(std::is_floating_point_v<T>)
    , Signed(std::is_signed_v<T>)
  {
    static_assert(std::is_arithmetic_v<T> && sizeof(T) <= 8, "a type of VTK's arrays");
  }

  std::int64_t NodeCount() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }

  /// Integers beyond 2^53 are rounded.
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT double Value(std::int64_t node) const;
};

/// Calls `work` with a typed pointer to the values: `const float*`, `const std::int16_t*`, ...
template <typename Work>
decltype(auto) WithTypedValues(const VolumeView& volume, Work&& work)
{
  const auto as = [&](auto zero) -> decltype(auto)
  { return work(static_cast<const decltype(zero)*>(volume.Data)); };
  if (volume.Floating)
  {
    return volume.Bytes == 4 ? as(0.0F) : as(0.0);
  }
  switch (volume.Bytes)
  {
    case 1:
      return volume.Signed ? as(std::int8_t{}) : as(std::uint8_t{});
    case 2:
      return volume.Signed ? as(std::int16_t{}) : as(std::uint16_t{});
    case 4:
      return volume.Signed ? as(std::int32_t{}) : as(std::uint32_t{});
    default:
      return volume.Signed ? as(std::int64_t{}) : as(std::uint64_t{});
  }
}

/// Throws std::invalid_argument with the position of the first value that is not a number.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void RejectNaN(const VolumeView& volume);

/// Statistics of the finite values; a volume without finite values has an empty range (Minimum
/// above Maximum).
struct VolumeStatistics
{
  double Minimum = 1.0;
  double Maximum = 0.0;
  double Mean = 0.0;
  double StandardDeviation = 0.0;
};

/// Two passes in parallel, bitwise the same on any number of threads. Throws as RejectNaN does.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT VolumeStatistics MeasureVolume(const VolumeView& volume);

}

#endif
