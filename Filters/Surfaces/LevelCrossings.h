/**
 * @file LevelCrossings.h
 * @brief Crossings of a level of a volume with the lines of its grid, with normals.
 *
 * A grid edge from node i to node i+1 along an axis is crossed if one end is inside and the other
 * is not; nodes exactly at the level count as outside, so no crossing is missed or counted twice.
 * Then
 *
 *     t   = (level - S_i) / (S_{i+1} - S_i),     position = x_i + t h
 *     n   = normalised( n_i + t (n_{i+1} - n_i) )
 *
 * with n_i the raw gradient by central differences (one-sided ones of second order in the outermost
 * layer). Source: X. Feng's thesis, 5.21 to 5.23. Normals here point outwards.
 */
#ifndef isthmus_LevelCrossings_h
#define isthmus_LevelCrossings_h

#include "Core/GridView.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A level set of a volume.
template <typename T>
struct LevelView
{
  GridView<const T> Grid;
  double Level = 0.0;
  bool InsideIsHigher = true;

  /// Values exactly at the level are outside.
  bool IsInside(double value) const
  {
    return this->InsideIsHigher ? value > this->Level : value < this->Level;
  }
};

/// Crossing of a surface with a line of the grid.
struct GridCrossing
{
  std::int64_t Node = 0;                         ///< id of the node below it on the line
  int Axis = 0;                                  ///< direction of the line: 0, 1, 2 for x, y, z
  double Fraction = 0.0;                         ///< how far it is to the next node, in [0, 1]
  std::array<double, 3> Normal{ 0.0, 0.0, 0.0 }; ///< outward unit normal of the surface
};

/// Gradient at a node, in value per length. The component along an axis with a single node is 0.
template <typename T>
std::array<double, 3> GradientAtNode(
  const GridView<const T>& grid, std::int64_t i, std::int64_t j, std::int64_t k);

/// Appends the crossings on edges that start in layer `k`, ordered by node, then axis. T is float
/// or double. Where the interpolated gradient vanishes, the normal is along the line. O(layer).
template <typename T>
void AppendLevelCrossings(
  const LevelView<T>& level, std::int64_t k, std::vector<GridCrossing>& crossings);

}

#endif
