/**
 * @file RadixSort.h
 * @brief A stable sort by the bits of a whole number, in parallel.
 */
#ifndef isthmus_RadixSort_h
#define isthmus_RadixSort_h

#include "Core/Index.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

constexpr unsigned int RadixBits = 11; ///< of one pass

namespace radix
{

constexpr std::int64_t Grain = 1 << 16;
constexpr std::size_t Digits = std::size_t{ 1 } << RadixBits;

/// Converts the counts of each piece and digit to the positions at which they begin; false if all
/// entries have the same digit.
inline bool CountsToOffsets(std::vector<std::array<std::uint64_t, Digits>>& next, std::uint64_t all)
{
  std::uint64_t before = 0;
  bool several = false;
  for (std::size_t d = 0; d < Digits; ++d)
  {
    const std::uint64_t start = before;
    for (auto& piece : next)
    {
      const std::uint64_t count = piece[d];
      piece[d] = before;
      before += count;
    }
    several = several || (before > start && before - start < all);
  }
  return several;
}

/// One stable pass: sorts the entries of `from` into `to`, by RadixBits bits of key(entry) from
/// `bit` on. Returns false and moves nothing if these bits are the same in all entries.
template <typename Entry, typename Key>
bool Pass(const std::vector<Entry>& from, std::vector<Entry>& to, unsigned int bit, const Key& key)
{
  const auto digit = [&key, bit](const Entry& entry)
  { return static_cast<std::size_t>(key(entry) >> bit) % Digits; };
  const auto n = static_cast<std::int64_t>(from.size());
  const std::int64_t pieces = (n + Grain - 1) / Grain;
  std::vector<std::array<std::uint64_t, Digits>> next(At(pieces));
  const auto forPieces = [n, pieces](auto&& work)
  {
    ParallelFor(0, pieces, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t p = begin; p < end; ++p)
        {
          work(At(p), At(p * Grain), At(std::min(n, (p + 1) * Grain)));
        }
      });
  };
  forPieces(
    [&](std::size_t p, std::size_t begin, std::size_t end)
    {
      next[p].fill(0);
      for (std::size_t i = begin; i < end; ++i)
      {
        ++next[p][digit(from[i])];
      }
    });
  if (!CountsToOffsets(next, from.size()))
  {
    return false;
  }
  forPieces(
    [&](std::size_t p, std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        to[next[p][digit(from[i])]++] = from[i];
      }
    });
  return true;
}

}

/**
 * `entries` in ascending order of the bits [first, last) of key(entry), an unsigned number; equal
 * ones stay in their order. The least significant digit is sorted first, with 11 bits in each pass
 * (H. H. Seward, 1954); a pass in which all digits are equal is skipped. Each pass takes O(n) time;
 * a second copy of the entries is needed while it runs. The result is the same on any number of
 * threads. (Boost.Sort has no stable parallel sort by the bits of a key.)
 */
template <typename Entry, typename Key>
void RadixSort(std::vector<Entry>& entries, unsigned int first, unsigned int last, const Key& key)
{
  std::vector<Entry> other(entries.size());
  for (unsigned int bit = first; bit < last; bit += RadixBits)
  {
    if (radix::Pass(entries, other, bit, key))
    {
      entries.swap(other);
    }
  }
}

}

#endif
