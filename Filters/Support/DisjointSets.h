/**
 * @file DisjointSets.h
 * @brief Union-find over the numbers 0 .. n - 1.
 */
#ifndef isthmus_DisjointSets_h
#define isthmus_DisjointSets_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isthmus
{

/// Sets of numbers that can be joined. The root of a set is its lowest member, or, by JoinUnder,
/// the one that means something: the elder of a class, the deepest of a basin. Amortised cost of a
/// call: O(log n), in practice constant, by halving paths (R. Tarjan and J. van Leeuwen, 1984);
/// memory: one `Index` a number, so 32 bits do for less than 2^32 of them.
/// @tparam Index an integer that holds n
template <class Index>
class DisjointSets
{
public:
  explicit DisjointSets(Index count)
    : Parents(static_cast<std::size_t>(count))
  {
    std::iota(this->Parents.begin(), this->Parents.end(), Index{ 0 });
  }

  Index Find(Index member)
  {
    while (this->Parent(member) != member)
    {
      this->Parent(member) = this->Parent(this->Parent(member));
      member = this->Parent(member);
    }
    return member;
  }

  /// Joins the sets of `a` and `b`, and returns the root of both.
  Index Join(Index a, Index b)
  {
    const auto [low, high] = std::minmax({ this->Find(a), this->Find(b) });
    this->Parent(high) = low;
    return low;
  }

  /// Puts the set of root `under` below root `root`.
  void JoinUnder(Index under, Index root) { this->Parent(under) = root; }

private:
  Index& Parent(Index member) { return this->Parents[static_cast<std::size_t>(member)]; }

  std::vector<Index> Parents;
};

}

#endif
