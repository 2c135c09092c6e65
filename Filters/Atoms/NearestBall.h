/**
 * @file NearestBall.h
 * @brief Finds the ball that is nearest to a place.
 */
#ifndef isthmus_NearestBall_h
#define isthmus_NearestBall_h

#include "Atoms/Ball.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Balls in cells. Memory: O(balls + cells), with at most eight cells for each ball.
class NearestBall
{
public:
  explicit NearestBall(const std::vector<Ball>& balls);

  /// Id of the ball with the least |place - center| - radius; the lowest id if several are equal.
  std::size_t At(const std::array<double, 3>& place) const;

private:
  using Cell = std::array<std::int64_t, 3>;
  Cell FindCell(const std::array<double, 3>& place) const;

  std::vector<Ball> Balls;
  std::array<double, 3> Low{};
  double Size = 1.0;
  double Largest = 0.0;
  Cell Counts{};
  std::vector<std::vector<std::size_t>> Members;
};

}

#endif
