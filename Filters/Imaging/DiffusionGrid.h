/**
 * @file DiffusionGrid.h
 * @brief The grid of an iterated volume filter, or one rank's part of it.
 */
#ifndef isthmus_DiffusionGrid_h
#define isthmus_DiffusionGrid_h

#include "Core/ParallelFor.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/**
 * Sizes of the local arrays, and the communication between the parts of a distributed grid.
 *
 * On one rank the defaults are sufficient. On several ranks, an array holds the rank's own nodes
 * and a halo around them that belongs to other ranks. Algorithms compute on all of these nodes,
 * call ExchangeHalo before they read neighbours, and include only owned nodes in sums (each node of
 * the whole grid is owned by one rank).
 */
template <typename T>
struct DiffusionGrid
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<std::int64_t, 3> OwnedBegin{ 0, 0, 0 };
  std::array<std::int64_t, 3> OwnedEnd{ 0, 0, 0 };             ///< All zero if every node is owned.
  std::array<std::int64_t, 3> GlobalBegin{ 0, 0, 0 };          ///< First node in the whole grid.
  std::array<std::int64_t, 3> GlobalDimensions{ 0, 0, 0 };     ///< All zero: Dimensions.
  std::function<void(T* values)> ExchangeHalo;                 ///< Empty on a single rank.
  std::function<void(double* values, int count)> SumOverRanks; ///< Sums in place; may be empty.

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }

  /// Sizes of the whole grid.
  const std::array<std::int64_t, 3>& Whole() const
  {
    const bool parts = this->GlobalDimensions != std::array<std::int64_t, 3>{ 0, 0, 0 };
    return parts ? this->GlobalDimensions : this->Dimensions;
  }

  void Exchange(T* values) const
  {
    if (this->ExchangeHalo)
    {
      this->ExchangeHalo(values);
    }
  }
};

/**
 * Sums N numbers that `addRow` computes for each owned row, over all threads and ranks.
 *
 * `addRow(begin, end, sums)` adds what the nodes [begin, end) of the array contribute. Planes are
 * added up in their order, so the result does not depend on the number of threads.
 */
template <std::size_t N, typename T, typename AddRow>
std::array<double, N> SumRows(const DiffusionGrid<T>& grid, AddRow&& addRow)
{
  auto begin = grid.OwnedBegin, end = grid.OwnedEnd;
  if (end == std::array<std::int64_t, 3>{ 0, 0, 0 } && !grid.SumOverRanks)
  {
    end = grid.Dimensions;
  }
  std::vector<std::array<double, N>> ofPlanes(static_cast<std::size_t>(grid.Dimensions[2]));
  ParallelFor(begin[2], end[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = begin[1]; j < end[1]; ++j)
        {
          const std::int64_t row = grid.Dimensions[0] * (j + grid.Dimensions[1] * k);
          addRow(row + begin[0], row + end[0], ofPlanes[static_cast<std::size_t>(k)]);
        }
      }
    });
  std::array<double, N> sums{};
  for (const auto& plane : ofPlanes)
  {
    for (std::size_t n = 0; n < N; ++n)
    {
      sums[n] += plane[n];
    }
  }
  if (grid.SumOverRanks)
  {
    grid.SumOverRanks(sums.data(), static_cast<int>(N));
  }
  return sums;
}

}

#endif
