/**
 * @file BallNeighbours.h
 * @brief Which balls cut which, and what that leaves free of their spheres.
 */
#ifndef isthmus_BallNeighbours_h
#define isthmus_BallNeighbours_h

#include "Atoms/Ball.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// For each ball those that overlap with it. Time and memory O(balls log balls + pairs).
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

  /// Is `place`, on the sphere of `ball`, in none of the other balls? `last`, the one that covered
  /// the place asked for before, is tried first and set.
  bool IsFree(std::size_t ball, const std::array<double, 3>& place, std::int64_t& last) const;

private:
  void FindOf(std::size_t ball, const std::vector<std::array<std::int64_t, 4>>& cells,
    std::vector<std::int64_t>& found) const;

  const std::vector<Ball>& Balls;
  double Cell = 1.0;
  std::vector<std::int64_t> Start;
  std::vector<std::int64_t> Others;
};

/// Places on the circles in which two spheres meet, where no other ball covers them, at most `step`
/// apart, and the ends of such arcs.
std::vector<std::array<double, 3>> FreeCirclePoints(
  const std::vector<Ball>& balls, const BallNeighbours& neighbours, double step);

}

#endif
