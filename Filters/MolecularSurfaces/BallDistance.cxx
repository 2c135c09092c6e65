#include "MolecularSurfaces/BallDistance.h"

#include "Atoms/BallBricks.h"
#include "Core/ParallelFor.h"
#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

ISTHMUS_VECTOR_CLONES
void LowerRow(float* row, std::int64_t nodes, float firstX, float restSquared, float radius)
{
  for (std::int64_t i = 0; i < nodes; ++i)
  {
    const float x = firstX + static_cast<float>(i);
    const float distance = std::sqrt(x * x + restSquared) - radius;
    row[i] = distance < row[i] ? distance : row[i];
  }
}

/// Lowers the brick's nodes within the ball's radius to their distance from radius - band.
void LowerBrick(
  const FlowGrid& grid, const Ball& ball, double band, const Brick& brick, float* values)
{
  ForEachRow(ball, brick,
    [&](const NodeRange& row, std::int64_t j, std::int64_t k, double y, double z)
    {
      LowerRow(values + row.First + grid.Row() * j + grid.Plane() * k, row.Last - row.First,
        static_cast<float>(static_cast<double>(row.First) - ball.Center[0]),
        static_cast<float>(y * y + z * z), static_cast<float>(ball.Radius - band));
    });
}

}

void DistanceToBalls(const FlowGrid& grid, const std::vector<Ball>& balls, double scale,
  double more, double band, std::vector<float>& to, const ProgressCallback& progress)
{
  const double h = grid.Spacing();
  const std::array<double, 3> origin = grid.Origin();
  std::vector<Ball> reaching; // in spacings, out to where the distance is cut
  reaching.reserve(balls.size());
  for (const Ball& ball : balls)
  {
    Ball scaled{ {}, (scale * ball.Radius + more) / h + band };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      scaled.Center[axis] = (ball.Center[axis] - origin[axis]) / h;
    }
    reaching.push_back(scaled);
  }
  std::fill(to.begin(), to.end(), static_cast<float>(band));
  const BallBricks bricks(std::move(reaching), 1.0, grid.Dimensions());
  ParallelFor(
    0, bricks.Size(), 4,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const Brick brick = bricks.At(b);
        bricks.ForEachBall(
          b, [&](const Ball& ball) { LowerBrick(grid, ball, band, brick, to.data()); });
      }
    },
    progress);
  const auto lowest = static_cast<float>(-band);
  ParallelFor(0, static_cast<std::int64_t>(to.size()), 1 << 18,
    [&](std::int64_t first, std::int64_t last)
    {
      std::transform(to.data() + first, to.data() + last, to.data() + first,
        [lowest](float value) { return std::max(value, lowest); });
    });
}

}
