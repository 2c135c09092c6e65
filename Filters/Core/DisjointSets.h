/**
 * @file DisjointSets.h
 * @brief Union-find over the numbers 0 .. n - 1.
 */
#ifndef isthmus_DisjointSets_h
#define isthmus_DisjointSets_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace isthmus
{

/// Sets of numbers that can be joined. The root of a set is its lowest member, or, with JoinUnder,
/// a member chosen by the caller, e.g. the elder of a class or the deepest node of a basin.
/// (boost::disjoint_sets chooses roots by rank, and ranks take memory.) Amortised cost of a call:
/// O(log n), in practice constant, by path halving (R. Tarjan and J. van Leeuwen, 1984); memory:
/// one `Index` for each number, so 32 bits suffice for fewer than 2^32 numbers.
/// @tparam Index an integer that holds n, or a Handle (Handles.h) of such
template <class Index>
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parents(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if constexpr (std::is_integral_v<Index>)
      {
        this->Parents[i] = static_cast<Index>(i);
      }
      else
      {
        this->Parents[i] = Index::At(i);
      }
    }
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

  /// Joins the set with the root `under` to that with the root `root`, which stays a root.
  void JoinUnder(Index under, Index root) { this->Parent(under) = root; }

private:
  Index& Parent(Index member)
  {
    if constexpr (std::is_integral_v<Index>)
    {
      return this->Parents[static_cast<std::size_t>(member)];
    }
    else
    {
      return this->Parents[member.Index()];
    }
  }

  std::vector<Index> Parents;
};

}

#endif
