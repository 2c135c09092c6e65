/**
 * @file SampledGrid.h
 * @brief Functions at the nodes of a grid, and their level sets.
 */
#ifndef isthmus_SampledGrid_h
#define isthmus_SampledGrid_h

#include "Contouring/MarchingCubes.h"
#include "Surfaces/SurfaceDefects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace isthmus::testing
{

struct Grid
{
  std::vector<double> Values;
  GridView<const double> View;
};

/// `f(x, y, z)` at the nodes, in the grid's own frame.
template <typename Function>
Grid SampleGrid(std::array<std::int64_t, 3> n, std::array<double, 3> h, Function&& f)
{
  Grid grid;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        grid.Values.push_back(f(static_cast<double>(i) * h[0], static_cast<double>(j) * h[1],
          static_cast<double>(k) * h[2]));
      }
    }
  }
  grid.View = { grid.Values.data(), n, h };
  return grid;
}

inline double Ball(double x, double y, double z, const Point3& c, double r)
{
  return r - std::hypot(x - c[0], y - c[1], z - c[2]);
}

inline TriangleMesh At(const Grid& grid, double level, bool close = true, bool higher = true)
{
  MarchingCubesParameters parameters;
  parameters.Level = level;
  parameters.CloseAtBorder = close;
  parameters.InsideIsHigher = higher;
  return MarchingCubes(grid.View, parameters);
}

inline std::string DescribeDefects(const TriangleMesh& mesh)
{
  return FindDefects(mesh).Message();
}

/// Two balls of radius 6 and 3, 100 inside of them and -1 outside, smooth in between.
inline Grid TwoBalls()
{
  return SampleGrid({ 40, 30, 30 }, { 1, 1, 1 },
    [](double x, double y, double z)
    {
      const double depth =
        std::max(Ball(x, y, z, { 12, 15, 15 }, 6), Ball(x, y, z, { 30, 15, 15 }, 3));
      return 49.5 + 50.5 * std::tanh(depth);
    });
}

}

#endif
