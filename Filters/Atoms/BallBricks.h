/**
 * @file BallBricks.h
 * @brief Division of a grid into bricks, and the balls that reach into each of them.
 */
#ifndef isthmus_BallBricks_h
#define isthmus_BallBricks_h

#include "Atoms/Ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Index3 = std::array<std::int64_t, 3>;

/// The nodes [First, Last) of the grid.
struct Brick
{
  Index3 First;
  Index3 Last;
};

/// The nodes along an axis within `reach` of `center` (in spacings), kept within [first, last).
struct NodeRange
{
  NodeRange(double center, double reach, std::int64_t first, std::int64_t last)
  {
    // The comparisons come before the conversion, which is undefined for numbers that do not fit.
    const double from = std::ceil(center - reach);
    const double to = std::floor(center + reach) + 1.0;
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

/// Calls `use(row, j, k, y, z)` for the nodes of each row of `brick` within the ball's radius: j
/// and k are the indices of the row along the second and third axis, y and z its distances from the
/// center along these axes.
template <typename Use>
void ForEachRow(const Ball& ball, const Brick& brick, Use&& use)
{
  const NodeRange planes(ball.Center[2], ball.Radius, brick.First[2], brick.Last[2]);
  for (std::int64_t k = planes.First; k < planes.Last; ++k)
  {
    const double z = static_cast<double>(k) - ball.Center[2];
    const double left = std::max(0.0, ball.Radius * ball.Radius - z * z);
    const NodeRange rows(ball.Center[1], std::sqrt(left), brick.First[1], brick.Last[1]);
    for (std::int64_t j = rows.First; j < rows.Last; ++j)
    {
      const double y = static_cast<double>(j) - ball.Center[1];
      const NodeRange row(
        ball.Center[0], std::sqrt(std::max(0.0, left - y * y)), brick.First[0], brick.Last[0]);
      if (!row.IsEmpty())
      {
        use(row, j, k, y, z);
      }
    }
  }
}

/**
 * The bricks of a grid and the balls that reach into each, in an order of the balls that does not
 * depend on that of the input. Time and memory O(balls log balls + bricks + pairs of both).
 */
class BallBricks
{
public:
  /// Number of nodes of a brick along each axis; its values in double fit into the second-level
  /// cache.
  static constexpr Index3 BrickSize{ 64, 32, 16 };

  /// `balls` are in units of the spacing, relative to the first node of the grid; `reach` times the
  /// radius plus `margin` is covered. Throws std::invalid_argument for more than 2^31 pairs of ball
  /// and brick.
  BallBricks(
    std::vector<Ball> balls, double reach, const Index3& gridDimensions, double margin = 0.0);

  std::int64_t Size() const { return this->Counts[0] * this->Counts[1] * this->Counts[2]; }

  Brick At(std::int64_t b) const;

  /// Calls `use(ball)` for those that reach into brick `b`.
  template <typename Use>
  void ForEachBall(std::int64_t b, Use use) const
  {
    this->ForEachIndex(b, [&](std::size_t ball) { use(this->Balls[ball]); });
  }

  /// Calls `use(index)` with their numbers in GetSortedBalls().
  template <typename Use>
  void ForEachIndex(std::int64_t b, Use use) const
  {
    const auto at = static_cast<std::size_t>(b);
    for (std::int64_t e = this->Start[at]; e < this->Start[at + 1]; ++e)
    {
      use(this->Entries[static_cast<std::size_t>(e)]);
    }
  }

  /// The balls in an order that does not depend on that of the input.
  const std::vector<Ball>& GetSortedBalls() const { return this->Balls; }

private:
  template <typename Use>
  void ForEachEntry(Use use) const;

  std::vector<Ball> Balls;
  double Reach;
  double Margin;
  Index3 Dimensions;
  Index3 Counts{ 0, 0, 0 };
  std::vector<std::int64_t> Start;
  std::vector<std::size_t> Entries;
};

}

#endif
