/**
 * @file TrilinearField.h
 * @brief The trilinear interpolation of node values, closed off outside the grid.
 */
#ifndef isthmus_TrilinearField_h
#define isthmus_TrilinearField_h

#include "Core/GridView.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace isthmus
{

/**
 * The value at any point in space, in the frame of the grid (node (0,0,0) at the origin, axes along
 * the grid): trilinear between nodes, with a layer of `Outside` around the grid and `Outside`
 * beyond. It is continuous everywhere; level sets of levels beyond Outside are closed.
 */
template <typename T>
struct TrilinearField
{
  GridView<const T> Grid;
  double Outside = 0.0;

  double operator()(const std::array<double, 3>& p) const
  {
    std::int64_t low[3];
    double t[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double x = p[a] / this->Grid.Spacing[a];
      if (!(x > -1.0 && x < static_cast<double>(this->Grid.Dimensions[a])))
      {
        return this->Outside;
      }
      const double floor = std::floor(x);
      low[a] = static_cast<std::int64_t>(floor);
      t[a] = x - floor;
    }
    double plane[2];
    for (std::int64_t k = 0; k < 2; ++k)
    {
      const double near = this->Row(low[0], low[1], low[2] + k, t[0]);
      const double far = this->Row(low[0], low[1] + 1, low[2] + k, t[0]);
      plane[k] = near + t[1] * (far - near);
    }
    return plane[0] + t[2] * (plane[1] - plane[0]);
  }

private:
  double Node(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto& n = this->Grid.Dimensions;
    const bool inside = i >= 0 && j >= 0 && k >= 0 && i < n[0] && j < n[1] && k < n[2];
    return inside ? static_cast<double>(this->Grid(i, j, k)) : this->Outside;
  }

  double Row(std::int64_t i, std::int64_t j, std::int64_t k, double t) const
  {
    const double near = this->Node(i, j, k);
    return near + t * (this->Node(i + 1, j, k) - near);
  }
};

}

#endif
