/**
 * @file BallBricks.h
 * @brief A grid in bricks, and the balls that reach into each of them.
 */
#ifndef isthmus_BallBricks_h
#define isthmus_BallBricks_h

#include "Ball.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Index3 = std::array<std::int64_t, 3>;

/// Nodes [First, Last) of the grid.
struct Brick
{
  Index3 First;
  Index3 Last;
};

/// The nodes along an axis within `reach` of `centre` (in spacings), kept within [first, last).
struct NodeRange
{
  NodeRange(double centre, double reach, std::int64_t first, std::int64_t last)
  {
    // The comparisons come before the conversion, which is undefined for what doesn't fit.
    const double from = std::ceil(centre - reach);
    const double to = std::floor(centre + reach) + 1.0;
    this->First = from > static_cast<double>(first)
      ? (from < static_cast<double>(last) ? static_cast<std::int64_t>(from) : last)
      : first;
    this->Last = to < static_cast<double>(last)
      ? (to > static_cast<double>(first) ? static_cast<std::int64_t>(to) : first)
      : last;
  }
  bool IsEmpty() const { return this->First >= this->Last; }

  std::int64_t First;
  std::int64_t Last;
};

/**
 * The bricks of a grid and which balls reach into each, in an order of the balls that does not
 * depend on that of the input. Time and memory O(balls log balls + bricks + pairs of both).
 */
class BallBricks
{
public:
  /// Nodes of a brick: its values in double fit into the second-level cache.
  static constexpr Index3 BrickSize{ 64, 32, 16 };

  /// Balls in spacings from the grid's first node; `reach` times the radius is covered. Throws
  /// std::invalid_argument for more than 2^31 pairs of ball and brick.
  BallBricks(std::vector<Ball> balls, double reach, const Index3& gridDimensions);

  std::int64_t Size() const { return this->Counts[0] * this->Counts[1] * this->Counts[2]; }

  Brick At(std::int64_t b) const;

  /// Calls `use(ball)` for those that reach into brick `b`.
  template <typename Use>
  void ForEachBall(std::int64_t b, Use use) const
  {
    this->ForEachIndex(b, [&](std::size_t ball) { use(this->Balls[ball]); });
  }

  /// Calls `use(index)` with their numbers in Sorted().
  template <typename Use>
  void ForEachIndex(std::int64_t b, Use use) const
  {
    const auto at = static_cast<std::size_t>(b);
    for (std::int64_t e = this->Start[at]; e < this->Start[at + 1]; ++e)
    {
      use(this->Entries[static_cast<std::size_t>(e)]);
    }
  }

  /// The balls in the order that does not depend on the input's.
  const std::vector<Ball>& Sorted() const { return this->Balls; }

private:
  template <typename Use>
  void ForEachEntry(Use use) const;

  std::vector<Ball> Balls;
  double Reach;
  Index3 Dimensions;
  Index3 Counts{ 0, 0, 0 };
  std::vector<std::int64_t> Start;
  std::vector<std::size_t> Entries;
};

}

#endif
