/**
 * @file LinkForest.h
 * @brief Union-find over the nodes of a grid whose first links are known only when asked for.
 */
#ifndef isthmus_LinkForest_h
#define isthmus_LinkForest_h

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

namespace isthmus
{

/**
 * `first(x)` is what x points to before anything is joined (x itself for a root). Memory that is
 * never asked for is never touched, so a volume with few critical points costs next to nothing.
 */
template <typename Link, typename FirstLink>
class LinkForest
{
public:
  LinkForest(std::int64_t count, FirstLink first)
    : First(first)
    , Links(static_cast<Link*>(std::calloc(static_cast<std::size_t>(count), sizeof(Link))))
  {
    if (!this->Links)
    {
      throw std::bad_alloc();
    }
  }

  /// Amortised O(log n), by halving paths.
  std::int64_t Root(std::int64_t x)
  {
    for (std::int64_t next = this->Next(x); next != x; next = this->Next(x))
    {
      const std::int64_t after = this->Next(next);
      this->Join(x, after);
      x = after;
    }
    return x;
  }

  /// Lets x point to `to`.
  void Join(std::int64_t x, std::int64_t to) { this->Links.get()[x] = static_cast<Link>(to + 1); }

private:
  std::int64_t Next(std::int64_t x)
  {
    const Link link = this->Links.get()[x];
    if (link != 0)
    {
      return static_cast<std::int64_t>(link) - 1;
    }
    const std::int64_t first = this->First(x);
    this->Join(x, first);
    return first;
  }

  struct Freed
  {
    void operator()(Link* links) const { std::free(links); }
  };

  FirstLink First;
  std::unique_ptr<Link, Freed> Links; ///< one more than the target; 0: not asked for yet
};

}

#endif
