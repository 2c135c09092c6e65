/**
 * @file PlaneRing.h
 * @brief The last few planes of a quantity, as far as a tile of rows needs them.
 */
#ifndef isthmus_PlaneRing_h
#define isthmus_PlaneRing_h

#include "Imaging/DiffusionRows.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Each row has margins. A ring of depth 0 holds nothing and may not be asked for rows.
template <typename T>
class PlaneRing
{
public:
  PlaneRing() = default;
  PlaneRing(std::int64_t rowLength, std::int64_t tileRows, int depth)
    : RowCount(tileRows)
    , Depth(depth)
    , Stride(StrideOf(rowLength))
    , Values(static_cast<std::size_t>(depth * tileRows * this->Stride))
  {
  }

  static std::int64_t StrideOf(std::int64_t rowLength)
  {
    return PaddedLength(rowLength) + 2 * RowMargin;
  }

  /// The rows held from now on: those from `first`, of a grid with `rows` rows and `planes` planes.
  void Place(std::int64_t first, std::int64_t rows, std::int64_t planes)
  {
    this->FirstRow = std::max<std::int64_t>(first, 0);
    this->GridRows = rows;
    this->GridPlanes = planes;
  }

  T* Row(std::int64_t row, std::int64_t plane)
  {
    // 32 bits: this is done for every row, and dividing 64 costs as much as a tenth of the row.
    const auto slot = static_cast<std::uint32_t>(plane) % static_cast<std::uint32_t>(this->Depth);
    return this->Values.data() +
      (static_cast<std::int64_t>(slot) * this->RowCount + (row - this->FirstRow)) * this->Stride +
      RowMargin;
  }

  /// The row with its neighbours; beyond the grid's ends, the outermost ones again (Neumann).
  RowStencil<T> Stencil(std::int64_t row, std::int64_t plane)
  {
    const std::int64_t lastRow = this->GridRows - 1, lastPlane = this->GridPlanes - 1;
    const T* centre = this->Row(row, plane);
    return { centre, row > 0 ? centre - this->Stride : centre,
      row < lastRow ? centre + this->Stride : centre,
      this->Row(row, std::max<std::int64_t>(plane - 1, 0)),
      this->Row(row, std::min(plane + 1, lastPlane)) };
  }

private:
  std::int64_t RowCount = 0, Depth = 0, Stride = 0;
  std::int64_t FirstRow = 0, GridRows = 0, GridPlanes = 0;
  std::vector<T> Values;
};

}

#endif
