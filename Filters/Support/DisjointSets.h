/**
 * @file DisjointSets.h
 * @brief Union-find over the numbers 0 .. n - 1.
 */
#ifndef isthmus_DisjointSets_h
#define isthmus_DisjointSets_h

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace isthmus
{

/// Sets of numbers that can be joined. The root of a set is its lowest member. Amortised cost of a
/// call: O(log n), in practice constant, by halving paths.
class DisjointSets
{
public:
  explicit DisjointSets(std::int64_t count)
    : Parents(static_cast<std::size_t>(count))
    , Sizes(static_cast<std::size_t>(count), 1)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), std::int64_t{ 0 });
  }

  std::int64_t Find(std::int64_t member)
  {
    while (this->Parent(member) != member)
    {
      this->Parent(member) = this->Parent(this->Parent(member));
      member = this->Parent(member);
    }
    return member;
  }

  void Join(std::int64_t a, std::int64_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    if (a != b)
    {
      if (a > b)
      {
        std::swap(a, b);
      }
      this->Parent(b) = a;
      this->Sizes[static_cast<std::size_t>(a)] += this->Sizes[static_cast<std::size_t>(b)];
    }
  }

  /// Number of members of the set that `root` is the root of.
  std::int64_t Size(std::int64_t root) const { return this->Sizes[static_cast<std::size_t>(root)]; }

private:
  std::int64_t& Parent(std::int64_t member)
  {
    return this->Parents[static_cast<std::size_t>(member)];
  }

  std::vector<std::int64_t> Parents;
  std::vector<std::int64_t> Sizes;
};

}

#endif
