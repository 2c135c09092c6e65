/**
 * @file FirstEqual.h
 * @brief Where a number stands among eight, compared at once.
 */
#ifndef isthmus_FirstEqual_h
#define isthmus_FirstEqual_h

#include <cstdint>

#if defined(__SSE2__) && defined(__GNUC__)
#include <emmintrin.h>
#endif

namespace isthmus
{

/// The place of the first of the eight `numbers` that is `wanted`; 8 where none is.
template <typename Id>
inline unsigned FirstEqualOfEight(const Id* numbers, Id wanted)
{
  unsigned place = 0;
  while (place < 8 && numbers[place] != wanted)
  {
    ++place;
  }
  return place;
}

#if defined(__SSE2__) && defined(__GNUC__)
/// The same without branches, by the vectors that every x86-64 has.
inline unsigned FirstEqualOfEight(const std::uint32_t* numbers, std::uint32_t wanted)
{
  const __m128i all = _mm_set1_epi32(static_cast<int>(wanted));
  const auto* const fours = reinterpret_cast<const __m128i*>(numbers);
  const __m128i low = _mm_cmpeq_epi32(_mm_loadu_si128(fours), all);
  const __m128i high = _mm_cmpeq_epi32(_mm_loadu_si128(fours + 1), all);
  const int bytes = _mm_movemask_epi8(_mm_packs_epi16(_mm_packs_epi32(low, high), low));
  return static_cast<unsigned>(__builtin_ctz(static_cast<unsigned>(bytes & 0xff) | 0x100u));
}
#endif

}

#endif
