/**
 * @file RootedSets.h
 * @brief Union-find over 32-bit numbers whose caller says which root stays.
 */
#ifndef isthmus_RootedSets_h
#define isthmus_RootedSets_h

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace isthmus
{

/**
 * Sets over 0..n-1 (n below 2^31), where the root means something: the elder of a class, the
 * deepest of a basin. 4 bytes a number. Paths are halved, sizes are not kept: logarithmic time at
 * worst, on average over all calls.
 */
class RootedSets
{
public:
  explicit RootedSets(std::size_t n)
    : Parent(n)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::int32_t{ 0 });
  }

  std::int32_t Find(std::int32_t i)
  {
    auto at = static_cast<std::size_t>(i);
    while (this->Parent[at] != static_cast<std::int32_t>(at))
    {
      this->Parent[at] = this->Parent[static_cast<std::size_t>(this->Parent[at])];
      at = static_cast<std::size_t>(this->Parent[at]);
    }
    return static_cast<std::int32_t>(at);
  }

  /// Puts the set of root `under` below root `root`.
  void Join(std::int32_t under, std::int32_t root)
  {
    this->Parent[static_cast<std::size_t>(under)] = root;
  }

private:
  std::vector<std::int32_t> Parent;
};

}

#endif
