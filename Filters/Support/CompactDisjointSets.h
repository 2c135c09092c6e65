/**
 * @file CompactDisjointSets.h
 * @brief Union-find over 32-bit numbers, by size, of roots the caller has found.
 */
#ifndef isthmus_CompactDisjointSets_h
#define isthmus_CompactDisjointSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace isthmus
{

/// Sets over 0..n-1 (n below 2^32); both operations take near constant time.
class CompactDisjointSets
{
public:
  explicit CompactDisjointSets(std::size_t n)
    : Parent(n)
    , Size(n, 1)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::uint32_t{ 0 });
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }

  /// Joins the sets of roots `a` and `b` and returns the root of both.
  std::size_t Join(std::size_t a, std::size_t b)
  {
    if (this->Size[a] < this->Size[b])
    {
      std::swap(a, b);
    }
    this->Parent[b] = static_cast<std::uint32_t>(a);
    this->Size[a] += a == b ? 0 : this->Size[b];
    return a;
  }

private:
  std::vector<std::uint32_t> Parent;
  std::vector<std::uint32_t> Size;
};

}

#endif
