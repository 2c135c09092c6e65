/**
 * @file LayerCuts.h
 * @brief Which edges and cells of a layer of nodes a level goes through.
 */
#ifndef isthmus_LayerCuts_h
#define isthmus_LayerCuts_h

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Flags = std::vector<std::uint8_t>; ///< inside or not, a layer of nodes

/// From a node to the next along each axis of a layer, and the edges that start at each node.
enum Axis : std::size_t
{
  X,
  Y,
  Z
};

/// The layers of a grid of `Nx` x `Ny` nodes, x fastest. Rows without a cut cost one comparison.
struct LayerCuts
{
  std::int64_t Nx = 0;
  std::int64_t Ny = 0;

  /// Calls visit(axis, i, j) for each cut edge within a layer, in the order of their numbers.
  template <typename Visit>
  void Within(const Flags& flags, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx, ny = this->Ny;
    for (std::int64_t j = 0; j < ny; ++j)
    {
      const std::uint8_t* row = flags.data() + nx * j;
      const std::uint8_t* next = j + 1 < ny ? row + nx : row;
      if (std::equal(row, row + nx, next) && std::equal(row + 1, row + nx, row))
      {
        continue;
      }
      for (std::int64_t i = 0; i < nx; ++i)
      {
        if (i + 1 < nx && row[i] != row[i + 1])
        {
          visit(X, i, j);
        }
        if (row[i] != next[i])
        {
          visit(Y, i, j);
        }
      }
    }
  }

  /// The same for the edges from a layer to the next.
  template <typename Visit>
  void Between(const Flags& flags, const Flags& above, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx;
    for (std::int64_t j = 0; j < this->Ny; ++j)
    {
      const std::uint8_t* row = flags.data() + nx * j;
      const std::uint8_t* top = above.data() + nx * j;
      if (std::equal(row, row + nx, top))
      {
        continue;
      }
      for (std::int64_t i = 0; i < nx; ++i)
      {
        if (row[i] != top[i])
        {
          visit(Z, i, j);
        }
      }
    }
  }

  /// Calls visit(case, i, j) for each cell between two layers that the level goes through.
  template <typename Visit>
  void Cells(
    const Flags& flags, const Flags& above, std::vector<std::uint8_t>& cases, Visit&& visit) const
  {
    const std::int64_t nx = this->Nx;
    cases.resize(static_cast<std::size_t>(nx));
    for (std::int64_t j = 0; j + 1 < this->Ny; ++j)
    {
      const std::uint8_t* a = flags.data() + nx * j;
      const std::uint8_t* b = above.data() + nx * j;
      std::uint8_t* cell = cases.data();
      for (std::int64_t i = 0; i + 1 < nx; ++i)
      {
        cell[i] = static_cast<std::uint8_t>(a[i] | a[i + 1] << 1 | a[i + nx + 1] << 2 |
          a[i + nx] << 3 | b[i] << 4 | b[i + 1] << 5 | b[i + nx + 1] << 6 | b[i + nx] << 7);
      }
      for (std::int64_t i = 0; i + 1 < nx; ++i)
      {
        if (cell[i] != 0 && cell[i] != 255)
        {
          visit(cell[i], i, j);
        }
      }
    }
  }
};

}

#endif
