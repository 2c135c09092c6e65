/**
 * @file BallNeighbours.h
 * @brief Overlaps of balls, and the parts of their spheres that are not covered.
 */
#ifndef isthmus_BallNeighbours_h
#define isthmus_BallNeighbours_h

#include "Atoms/Ball.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// For each ball, the balls that overlap with it. Time and memory O(balls log balls + pairs).
class BallNeighbours
{
public:
  /// Keeps a reference to `balls`.
  explicit BallNeighbours(const std::vector<Ball>& balls);

  const std::int64_t* begin(std::size_t ball) const
  {
    return this->Others.data() + this->Start[ball];
  }
  const std::int64_t* end(std::size_t ball) const
  {
    return this->Others.data() + this->Start[ball + 1];
  }

  /// Whether `place`, on the sphere of `ball`, is in none of the other balls. `last`, the ball that
  /// covered the previous place, is tried first and updated.
  bool IsFree(std::size_t ball, const std::array<double, 3>& place, std::int64_t& last) const;

private:
  void FindNeighbours(std::size_t ball, const std::vector<std::array<std::int64_t, 4>>& cells,
    std::vector<std::int64_t>& found) const;

  const std::vector<Ball>& Balls;
  double Cell = 1.0;
  std::vector<std::int64_t> Start;
  std::vector<std::int64_t> Others;
};

/// Places on the circles in which two spheres intersect, at most `step` apart, where no other ball
/// covers them, and the ends of these arcs.
std::vector<std::array<double, 3>> FreeCirclePoints(
  const std::vector<Ball>& balls, const BallNeighbours& neighbours, double step);

}

#endif
