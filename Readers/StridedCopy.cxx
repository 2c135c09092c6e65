#include "StridedCopy.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// One row of elements that lie side by side in the target.
template <std::size_t Bytes>
void CopyRow(std::int64_t count, std::int64_t step, const unsigned char* from, unsigned char* to)
{
  if (step == 1)
  {
    std::memcpy(to, from, static_cast<std::size_t>(count) * Bytes);
    return;
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    std::memcpy(to + i * static_cast<std::int64_t>(Bytes),
      from + i * step * static_cast<std::int64_t>(Bytes), Bytes);
  }
}

template <std::size_t Bytes>
void CopyBox(const StridedBox& box, const unsigned char* from, unsigned char* to)
{
  // Along x the target is contiguous, along column the source (nearly); outer is the axis left.
  const std::size_t x = box.To[0] == 1 ? 0 : (box.To[1] == 1 ? 1 : 2);
  const std::size_t column = x == 0 ? 1 : 0;
  const std::size_t outer = 3 - x - column;
  // Short runs would pay for a page of the target each.
  const std::int64_t xTile = x == 0 ? box.Count[0] : std::max<std::int64_t>(32, 256 / Bytes);
  constexpr std::int64_t columnTile = 16; // of 4 bytes: one cache line of the source
  constexpr auto size = static_cast<std::int64_t>(Bytes);
  for (std::int64_t o = 0; o < box.Count[outer]; ++o)
  {
    for (std::int64_t c0 = 0; c0 < box.Count[column]; c0 += columnTile)
    {
      const std::int64_t c1 = std::min(c0 + columnTile, box.Count[column]);
      for (std::int64_t x0 = 0; x0 < box.Count[x]; x0 += xTile)
      {
        const std::int64_t length = std::min(xTile, box.Count[x] - x0);
        for (std::int64_t c = c0; c < c1; ++c)
        {
          CopyRow<Bytes>(length, box.From[x],
            from + (o * box.From[outer] + c * box.From[column] + x0 * box.From[x]) * size,
            to + (o * box.To[outer] + c * box.To[column] + x0) * size);
        }
      }
    }
  }
}

}

void StridedCopy(
  const StridedBox& box, std::size_t bytes, const unsigned char* from, unsigned char* to)
{
  switch (bytes)
  {
    case 1:
      return CopyBox<1>(box, from, to);
    case 2:
      return CopyBox<2>(box, from, to);
    case 3:
      return CopyBox<3>(box, from, to);
    case 4:
      return CopyBox<4>(box, from, to);
    case 8:
      return CopyBox<8>(box, from, to);
    default:
      throw std::invalid_argument("StridedCopy: elements have 1, 2, 3, 4 or 8 bytes.");
  }
}

}
