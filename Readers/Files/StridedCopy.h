/**
 * @file StridedCopy.h
 * @brief Copies a box of elements from one order in memory to another.
 */
#ifndef isthmus_StridedCopy_h
#define isthmus_StridedCopy_h

#include <array>
#include <cstddef>
#include <cstdint>

namespace isthmus
{

/// Element (a, b, c) of the box lies at a From[0] + b From[1] + c From[2], and is copied to the
/// same expression with To; all are counted in elements. @pre one of To is 1.
struct StridedBox
{
  std::array<std::int64_t, 3> Count{};
  std::array<std::int64_t, 3> From{};
  std::array<std::int64_t, 3> To{};
};

/**
 * Copies elements whose size is `bytes` (1, 2, 3, 4 or 8) in tiles, so that both reading and
 * writing stay in the cache when axes are permuted.
 * @pre the memory areas do not overlap.
 * @throws std::invalid_argument for another number of bytes.
 */
void StridedCopy(
  const StridedBox& box, std::size_t bytes, const unsigned char* from, unsigned char* to);

}

#endif
