/**
 * @file GridView.h
 * @brief The algorithms' view of a regular grid: a pointer, three sizes, three spacings.
 */
#ifndef isthmus_GridView_h
#define isthmus_GridView_h

#include <array>
#include <cstdint>

namespace isthmus
{

/**
 * View of node values on a regular, axis-aligned grid; x runs fastest. It owns nothing.
 *
 * Dimensions count nodes. Spacing is in the units of the data (angstrom for molecular maps) and
 * positive. Indices are 64 bit throughout, so grids beyond 2^31 nodes work.
 */
template <typename T>
struct GridView
{
  T* Data = nullptr;
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }

  std::int64_t Index(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return i + this->Dimensions[0] * (j + this->Dimensions[1] * k);
  }

  T& operator()(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return this->Data[this->Index(i, j, k)];
  }
};

}

#endif
