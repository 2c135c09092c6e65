/**
 * @file GradientPaths.h
 * @brief Follows the paths of the gradient from many places to their ends, on all threads.
 */
#ifndef isthmus_GradientPaths_h
#define isthmus_GradientPaths_h

#include "Core/ParallelFor.h"
#include "Persistence/RankedSet.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace isthmus
{

/**
 * Ends of paths over 0 .. places - 1 on which next(x) is the place after x, and x itself at an end.
 *
 * One place in each group of eight, chosen pseudo-randomly, is a milestone that stores its end once
 * it is known. A path is followed about eight places beyond its new part, and all paths together
 * cost at most O(places + 8 paths). The ends are the same regardless of the order. `Link` must be
 * able to hold places + 1; there is one Link for each eight places.
 */
template <typename Link, typename Next>
class PathWalker
{
public:
  PathWalker(std::int64_t places, const Next& next)
    : After(next)
    , EndOf(static_cast<std::size_t>(places / apart + 1))
  {
  }

  /// Can be called by any number of threads, each with its own working list.
  std::int64_t operator()(std::int64_t place, std::vector<std::int64_t>& passed)
  {
    passed.clear();
    for (std::int64_t from = -1; from != place;)
    {
      if (IsMilestone(place))
      {
        const Link known = this->Milestone(place).load(std::memory_order_relaxed);
        if (known != 0)
        {
          place = static_cast<std::int64_t>(known - 1);
          break;
        }
        passed.push_back(place);
      }
      from = place;
      place = this->After(place);
    }
    for (const std::int64_t milestone : passed)
    {
      this->Milestone(milestone).store(static_cast<Link>(place + 1), std::memory_order_relaxed);
    }
    return place;
  }

private:
  static constexpr std::int64_t apart = 8;

  /// The milestone is not at the same position in each group, since a path along an axis could miss
  /// all of them.
  static bool IsMilestone(std::int64_t place)
  {
    const auto mixed = static_cast<std::uint64_t>(place / apart) * 0x9e3779b97f4a7c15U;
    return place % apart == static_cast<std::int64_t>(mixed >> 61U);
  }
  std::atomic<Link>& Milestone(std::int64_t place)
  {
    return this->EndOf[static_cast<std::size_t>(place / apart)];
  }

  const Next& After;
  std::vector<std::atomic<Link>> EndOf; ///< one more than the end; 0: not known
};

/// The ends of paths, numbered in the order of places.
template <typename Link>
struct PathEnds
{
  std::vector<std::array<Link, 2>> Numbers; ///< for each requested pair of places
  std::vector<Link> Places;                 ///< by number

  /// starts(i): the i-th of `count` pairs of places.
  template <typename Starts, typename Next>
  PathEnds(std::int64_t count, const Starts& starts, std::int64_t places, const Next& next)
    : Numbers(static_cast<std::size_t>(count))
  {
    constexpr std::int64_t grain = 1024;
    PathWalker<Link, Next> walk(places, next);
    RankedSet ends(places);
    ParallelFor(0, count, grain,
      [&](std::int64_t first, std::int64_t last)
      {
        std::vector<std::int64_t> passed;
        for (std::int64_t i = first; i < last; ++i)
        {
          const std::array<std::int64_t, 2> both = starts(i);
          for (std::size_t side = 0; side < 2; ++side)
          {
            const std::int64_t end = walk(both[side], passed);
            ends.Add(end);
            this->Numbers[static_cast<std::size_t>(i)][side] = static_cast<Link>(end);
          }
        }
      });
    ends.Rank([this](std::int64_t place) { this->Places.push_back(static_cast<Link>(place)); });
    ParallelFor(0, count, 16 * grain,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t i = first; i < last; ++i)
        {
          for (Link& end : this->Numbers[static_cast<std::size_t>(i)])
          {
            end = ends.FindRank(static_cast<std::int64_t>(end));
          }
        }
      });
  }
};

}

#endif
