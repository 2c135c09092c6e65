#include "Atoms/MolecularDensity.h"

#include "Atoms/BallBricks.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double SmallestTerm = 1e-6;

/// The values of a brick, x fastest.
using BrickValues = std::vector<double>;

constexpr std::int64_t IndexInBrick(std::int64_t i, std::int64_t j, std::int64_t k)
{
  return i + BallBricks::BrickSize[0] * (j + BallBricks::BrickSize[1] * k);
}

/// Calls row(j, k, rest) for each row of nodes that the sphere may meet, where the nodes within are
/// those with dx^2 <= rest.
template <typename Row>
inline void ForEachRow(const Ball& ball, double reach, const Brick& brick, Row row)
{
  const NodeRange z(ball.Center[2], reach, brick.First[2], brick.Last[2]);
  const NodeRange y(ball.Center[1], reach, brick.First[1], brick.Last[1]);
  for (std::int64_t k = z.First; k < z.Last; ++k)
  {
    const double dz = static_cast<double>(k) - ball.Center[2];
    for (std::int64_t j = y.First; j < y.Last; ++j)
    {
      const double dy = static_cast<double>(j) - ball.Center[1];
      const double rest = reach * reach - dy * dy - dz * dz;
      if (rest >= 0.0)
      {
        row(j, k, rest);
      }
    }
  }
}

/// Values of the nodes of a brick along its longest axis, or another.
using AxisValues = std::array<double, BallBricks::BrickSize[0]>;

/// exp(-decay (node - center)^2 / radius^2) of the nodes of a brick along an axis that are in
/// reach, which are returned; 0 of the others.
NodeRange Gaussian(const Ball& ball, std::size_t axis, double decay, double reach,
  const Brick& brick, AxisValues& values)
{
  values.fill(0.0);
  const NodeRange nodes(ball.Center[axis], reach, brick.First[axis], brick.Last[axis]);
  for (std::int64_t i = nodes.First; i < nodes.Last; ++i)
  {
    const double t = (static_cast<double>(i) - ball.Center[axis]) / ball.Radius;
    values[static_cast<std::size_t>(i - brick.First[axis])] = std::exp(-decay * t * t);
  }
  return nodes;
}

/// Number of nodes processed together along x, so that the compiler needs no remainder loop.
constexpr std::int64_t Chunk = 8;
static_assert(BallBricks::BrickSize[0] % Chunk == 0);

/// Adds the products of the three axes' values: no exponential and no root in the loops. `x` is for
/// nodes [firstChunk, lastChunk) in chunks; beyond the ball it adds zeros.
ISTHMUS_VECTOR_CLONES
void AddProduct(const Ball& ball, double reach, const Brick& brick, const AxisValues& x,
  std::int64_t firstChunk, std::int64_t lastChunk, const AxisValues& y, const AxisValues& z,
  double* values)
{
  ForEachRow(ball, reach, brick,
    [&](std::int64_t j, std::int64_t k, double)
    {
      const std::int64_t y0 = j - brick.First[1];
      const std::int64_t z0 = k - brick.First[2];
      const double factor = y[static_cast<std::size_t>(y0)] * z[static_cast<std::size_t>(z0)];
      for (std::int64_t chunk = firstChunk; chunk < lastChunk; ++chunk)
      {
        const double* along = x.data() + Chunk * chunk;
        double* to = values + IndexInBrick(Chunk * chunk, y0, z0);
        for (std::int64_t i = 0; i < Chunk; ++i)
        {
          to[i] += factor * along[i];
        }
      }
    });
}

void AddGaussian(const Ball& ball, double decay, double reach, const Brick& brick, double* values)
{
  AxisValues x;
  AxisValues y;
  AxisValues z;
  const NodeRange nodes = Gaussian(ball, 0, decay, reach, brick, x);
  Gaussian(ball, 1, decay, reach, brick, y);
  Gaussian(ball, 2, decay, reach, brick, z);
  const double top = std::exp(decay);
  std::for_each(x.begin(), x.end(), [top](double& value) { value *= top; });
  AddProduct(ball, reach, brick, x, (nodes.First - brick.First[0]) / Chunk,
    (nodes.Last - brick.First[0] + Chunk - 1) / Chunk, y, z, values);
}

void AddBall(const Ball& ball, const Brick& brick, double* values)
{
  const Index3& first = brick.First;
  ForEachRow(ball, ball.Radius, brick,
    [&](std::int64_t j, std::int64_t k, double rest)
    {
      const NodeRange row(ball.Center[0], std::sqrt(rest), first[0], brick.Last[0]);
      if (!row.IsEmpty())
      {
        double* to = values + IndexInBrick(-first[0], j - first[1], k - first[2]);
        std::fill(to + row.First, to + row.Last, 1.0);
      }
    });
}

template <typename Convert>
void Store(
  const BrickValues& values, const Brick& brick, const GridView<float>& to, const Convert& convert)
{
  for (std::int64_t k = brick.First[2]; k < brick.Last[2]; ++k)
  {
    for (std::int64_t j = brick.First[1]; j < brick.Last[1]; ++j)
    {
      const double* from = values.data() + IndexInBrick(0, j - brick.First[1], k - brick.First[2]);
      std::transform(from, from + (brick.Last[0] - brick.First[0]), &to(brick.First[0], j, k),
        [&](double value) { return static_cast<float>(convert(value)); });
    }
  }
}

void CheckBalls(const std::vector<Ball>& balls)
{
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const Ball& ball = balls[i];
    if (!std::isfinite(ball.Center[0]) || !std::isfinite(ball.Center[1]) ||
      !std::isfinite(ball.Center[2]) || !std::isfinite(ball.Radius) || ball.Radius < 0.0)
    {
      throw std::invalid_argument("Atom " + std::to_string(i) +
        " has a coordinate or radius that is not finite, or a negative radius: correct or remove "
        "it.");
    }
  }
}

/// How far balls have an effect: `Factor` times the radius plus `Margin` spacings.
struct BallReach
{
  double Factor;
  double Margin;

  double Of(const Ball& ball) const { return this->Factor * ball.Radius + this->Margin; }
};

/// Calls `add(ball, brick, values)` for the balls of each brick and stores the brick's values,
/// converted.
template <typename Add, typename Convert>
void Fill(const std::vector<Ball>& balls, const BallReach& reach,
  const std::array<double, 3>& origin, const GridView<float>& to, const ProgressCallback& progress,
  Add add, Convert convert)
{
  CheckBalls(balls);
  const double h = to.Spacing[0];
  std::vector<Ball> inSpacings;
  inSpacings.reserve(balls.size());
  for (const Ball& ball : balls)
  {
    if (ball.Radius / h > 0.0)
    {
      inSpacings.push_back({ { (ball.Center[0] - origin[0]) / h, (ball.Center[1] - origin[1]) / h,
                               (ball.Center[2] - origin[2]) / h },
        ball.Radius / h });
    }
  }
  const BallBricks bricks(std::move(inSpacings), reach.Factor, to.Dimensions, reach.Margin);
  Report(progress, 0.1);
  constexpr std::int64_t bricksAtOnce = 4; // their memory is allocated once
  ParallelFor(
    0, bricks.Size(), bricksAtOnce,
    [&](std::int64_t firstBrick, std::int64_t lastBrick)
    {
      BrickValues values;
      for (std::int64_t b = firstBrick; b < lastBrick; ++b)
      {
        values.assign(static_cast<std::size_t>(BallBricks::BrickSize[0] * BallBricks::BrickSize[1] *
                        BallBricks::BrickSize[2]),
          0.0);
        const Brick brick = bricks.At(b);
        bricks.ForEachBall(b, [&](const Ball& ball) { add(ball, brick, values.data()); });
        Store(values, brick, to, convert);
      }
    },
    Between(progress, 0.1, 1.0));
}

template <typename Convert>
void SumGaussians(const std::vector<Ball>& balls, double decay, double margin,
  const std::array<double, 3>& origin, const GridView<float>& to, const ProgressCallback& progress,
  Convert convert)
{
  constexpr double steepest = 500.0; // exp(709) is the largest double
  RequireAbove("Decay", decay, 0.0, steepest);
  // exp(-d (factor^2 - 1)) is the smallest term.
  const BallReach reach{ std::sqrt(1.0 - std::log(SmallestTerm) / decay), margin };
  Fill(
    balls, reach, origin, to, progress,
    [=](const Ball& ball, const Brick& brick, double* values)
    { AddGaussian(ball, decay, reach.Of(ball), brick, values); },
    convert);
}

}

DensityGrid GridAroundBalls(
  const std::vector<Ball>& balls, double spacing, const std::array<double, 3>& padding)
{
  RequireAbove("Spacing", spacing, 0.0, LargestLength, "It is a length.");
  CheckBalls(balls);
  DensityGrid grid;
  grid.Spacing = spacing;
  for (std::size_t axis = 0; axis < 3 && !balls.empty(); ++axis)
  {
    RequireRange("Padding", padding[axis], 0.0, LargestLength,
      "It is the margin around the atoms along an axis.");
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Ball& ball : balls)
    {
      low = std::min(low, ball.Center[axis] - ball.Radius);
      high = std::max(high, ball.Center[axis] + ball.Radius);
    }
    grid.Origin[axis] = low - padding[axis];
    const double nodes = std::ceil((high + padding[axis] - grid.Origin[axis]) / spacing) + 1.0;
    if (!(nodes < std::numeric_limits<std::int32_t>::max()))
    {
      throw std::invalid_argument("A Spacing of " + FormatNumber(spacing) +
        " would make more than 2^31 nodes along an axis: choose a larger one.");
    }
    // At least two, so that contours and gradients exist.
    grid.Dimensions[axis] = std::max<std::int64_t>(2, static_cast<std::int64_t>(nodes));
  }
  return grid;
}

void UnionOfBalls(const std::vector<Ball>& balls, const std::array<double, 3>& origin,
  GridView<float> to, const ProgressCallback& progress)
{
  Fill(
    balls, { 1.0, 0.0 }, origin, to, progress,
    [](const Ball& ball, const Brick& brick, double* values) { AddBall(ball, brick, values); },
    [](double value) { return value; });
}

void GaussianSum(const std::vector<Ball>& balls, double decay, const std::array<double, 3>& origin,
  GridView<float> to, const ProgressCallback& progress)
{
  SumGaussians(balls, decay, 0.0, origin, to, progress, [](double value) { return value; });
}

void GaussianLevel(const std::vector<Ball>& balls, double decay, double margin,
  const std::array<double, 3>& origin, GridView<float> to, const ProgressCallback& progress)
{
  SumGaussians(balls, decay, margin, origin, to, progress,
    [](double value)
    { return value > 0.0 ? -std::log(value) : static_cast<double>(FarFromBalls); });
}

}
