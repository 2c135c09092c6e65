/**
 * @file HessianExample.h
 * @brief Values on a grid, and the result of the algorithm without VTK's data model.
 */
#ifndef isthmus_HessianExample_h
#define isthmus_HessianExample_h

#include "Curvature/HessianCurvature.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace isthmus::testing
{

using Size = std::array<std::int64_t, 3>;

/// Values on a grid, and the result of the algorithm.
template <typename T>
struct Example
{
  template <typename F>
  Example(const Size& size, const std::array<double, 3>& spacing, F&& f)
  {
    this->Grid.Dimensions = size;
    this->Grid.Spacing = spacing;
    for (std::int64_t k = 0; k < size[2]; ++k)
    {
      for (std::int64_t j = 0; j < size[1]; ++j)
      {
        for (std::int64_t i = 0; i < size[0]; ++i)
        {
          this->Data.push_back(static_cast<T>(f(static_cast<double>(i) * spacing[0],
            static_cast<double>(j) * spacing[1], static_cast<double>(k) * spacing[2])));
        }
      }
    }
    this->Grid.Data = this->Data.data();
  }

  CurvatureArrays<ResultType<T>> Arrays(std::size_t places)
  {
    for (auto& values : this->Results)
    {
      values.assign(places, -7);
    }
    this->Directions.assign(6 * places, -7);
    this->Type.assign(places, 99);
    this->Valid.assign(places, 99);
    auto& r = this->Results;
    return { r[0].data(), r[1].data(), r[2].data(), r[3].data(), r[4].data(), r[5].data(),
      this->Directions.data(), this->Directions.data() + 3 * places, this->Type.data(),
      this->Valid.data() };
  }

  void AtNodes(const HessianCurvatureOptions& options = {})
  {
    HessianCurvatureAtNodes(
      this->Grid, { { 0, 0, 0 }, this->Grid.Dimensions }, options, this->Arrays(this->Data.size()));
  }

  void AtPoints(
    const std::vector<std::array<double, 3>>& indices, const HessianCurvatureOptions& options = {})
  {
    HessianCurvatureAtPoints(
      this->Grid, static_cast<std::int64_t>(indices.size()),
      [&](std::int64_t first, std::int64_t count, std::array<double, 3>* out)
      { std::copy_n(indices.begin() + first, count, out); },
      options, this->Arrays(indices.size()));
  }

  double K(std::int64_t i) const { return this->Results[0][i]; }
  double H(std::int64_t i) const { return this->Results[1][i]; }
  double Maximum(std::int64_t i) const { return this->Results[2][i]; }
  double Minimum(std::int64_t i) const { return this->Results[3][i]; }

  std::vector<T> Data;
  GridView<const T> Grid;
  std::array<std::vector<ResultType<T>>, 6> Results;
  std::vector<ResultType<T>> Directions;
  std::vector<unsigned char> Type, Valid;
};

inline double Wavy(double x, double y, double z)
{
  return std::sin(1.3 * x + 0.2) * std::cos(0.9 * y) + std::sin(0.7 * z + 0.3 * x * y) + 0.1 * z;
}

inline HessianCurvatureOptions WithAccuracy(int accuracy)
{
  HessianCurvatureOptions options;
  options.Accuracy = accuracy;
  return options;
}

}

#endif
