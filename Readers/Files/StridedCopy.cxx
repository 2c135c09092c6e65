#include "Files/StridedCopy.h"

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

/// Rows that remain contiguous in the target.
template <std::size_t Bytes>
void CopyRows(const StridedBox& box, const unsigned char* from, unsigned char* to)
{
  constexpr auto size = static_cast<std::int64_t>(Bytes);
  for (std::int64_t b = 0; b < box.Count[2]; ++b)
  {
    for (std::int64_t a = 0; a < box.Count[1]; ++a)
    {
      CopyRow<Bytes>(box.Count[0], box.From[0], from + (b * box.From[2] + a * box.From[1]) * size,
        to + (b * box.To[2] + a * box.To[1]) * size);
    }
  }
}

/**
 * Rows that become columns: `x` is the axis that is contiguous in the target, axis 0 in the source.
 *
 * Every line of the source is read once into a tile of 4 to 16 KB and leaves it in runs of 256
 * bytes. Reading down the source instead would visit lines whose distance is often a power of two,
 * which the first cache can't hold together.
 */
template <std::size_t Bytes>
void Transpose(const StridedBox& box, std::size_t x, const unsigned char* from, unsigned char* to)
{
  constexpr auto size = static_cast<std::int64_t>(Bytes);
  constexpr std::int64_t width = std::max<std::int64_t>(8, 64 / size);
  constexpr std::int64_t length = std::max<std::int64_t>(32, 256 / size);
  const std::size_t outer = 3 - x;
  alignas(64) unsigned char tile[width * length * size];
  for (std::int64_t o = 0; o < box.Count[outer]; ++o)
  {
    for (std::int64_t c0 = 0; c0 < box.Count[0]; c0 += width)
    {
      const std::int64_t columns = std::min(width, box.Count[0] - c0);
      for (std::int64_t x0 = 0; x0 < box.Count[x]; x0 += length)
      {
        const std::int64_t run = std::min(length, box.Count[x] - x0);
        const unsigned char* const source =
          from + (o * box.From[outer] + c0 * box.From[0] + x0 * box.From[x]) * size;
        for (std::int64_t i = 0; i < run; ++i)
        {
          for (std::int64_t c = 0; c < columns; ++c)
          {
            std::memcpy(tile + (c * length + i) * size,
              source + (i * box.From[x] + c * box.From[0]) * size, Bytes);
          }
        }
        unsigned char* const target = to + (o * box.To[outer] + c0 * box.To[0] + x0) * size;
        for (std::int64_t c = 0; c < columns; ++c)
        {
          std::memcpy(target + c * box.To[0] * size, tile + c * length * size,
            static_cast<std::size_t>(run * size));
        }
      }
    }
  }
}

template <std::size_t Bytes>
void CopyBox(const StridedBox& box, const unsigned char* from, unsigned char* to)
{
  if (box.To[0] == 1)
  {
    CopyRows<Bytes>(box, from, to);
  }
  else
  {
    Transpose<Bytes>(box, box.To[1] == 1 ? 1 : 2, from, to);
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
      throw std::invalid_argument("StridedCopy: elements must have 1, 2, 3, 4 or 8 bytes.");
  }
}

}
