#include "MolecularSurfaces/SolventExcludedSurface.h"

#include "Atoms/BallBricks.h"
#include "Atoms/BallNeighbours.h"
#include "Core/ParallelFor.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr std::size_t BrickNodes = static_cast<std::size_t>(
  BallBricks::BrickSize[0] * BallBricks::BrickSize[1] * BallBricks::BrickSize[2]);

/// The data of the nodes of a brick.
struct BrickScratch
{
  std::vector<float> Depth = std::vector<float>(BrickNodes); // to the spheres, < 0 within
  std::vector<std::int32_t> Deepest = std::vector<std::int32_t>(BrickNodes);
  std::vector<float> ToCircle = std::vector<float>(BrickNodes); // squared distance
};

/// Calls `use(place in the brick, squared distance)` for the nodes within `reach` of `center`.
template <typename Use>
void ForEachNodeNear(const std::array<double, 3>& center, double reach, const Brick& brick, Use use)
{
  const NodeRange planes(center[2], reach, brick.First[2], brick.Last[2]);
  for (std::int64_t k = planes.First; k < planes.Last; ++k)
  {
    const double z = static_cast<double>(k) - center[2];
    const double left = std::max(0.0, reach * reach - z * z);
    const NodeRange rows(center[1], std::sqrt(left), brick.First[1], brick.Last[1]);
    for (std::int64_t j = rows.First; j < rows.Last; ++j)
    {
      const double y = static_cast<double>(j) - center[1];
      const double reachX = std::sqrt(std::max(0.0, left - y * y));
      const NodeRange row(center[0], reachX, brick.First[0], brick.Last[0]);
      const std::int64_t line = BallBricks::BrickSize[0] *
        ((j - brick.First[1]) + BallBricks::BrickSize[1] * (k - brick.First[2]));
      const auto x0 = static_cast<float>(static_cast<double>(row.First) - center[0]);
      const auto rest = static_cast<float>(y * y + z * z);
      for (std::int64_t i = row.First; i < row.Last; ++i)
      {
        const float x = x0 + static_cast<float>(i - row.First);
        use(static_cast<std::size_t>(line + i - brick.First[0]), x * x + rest);
      }
    }
  }
}

class ExcludedDistance
{
public:
  ExcludedDistance(const FlowGrid& grid, std::vector<Ball> rolled, double probe)
    : Grid(grid)
    , Probe(probe)
    , Outside(std::max(0.0, static_cast<double>(FlowGrid::Band) - probe))
    , Spheres(GrowBalls(std::move(rolled), this->Outside), 1.0, grid.Dimensions())
    , Rolled(GrowBalls(this->Spheres.GetSortedBalls(), -this->Outside))
    , Neighbours(this->Rolled)
    , Circles(CircleBalls(), 1.0, grid.Dimensions())
  {
  }

  std::int64_t Size() const { return this->Spheres.Size(); }

  void FillBrick(std::int64_t b, BrickScratch& scratch, std::vector<float>& to) const
  {
    const Brick brick = this->Spheres.At(b);
    this->FindDepths(b, brick, scratch);
    std::fill(scratch.ToCircle.begin(), scratch.ToCircle.end(), 1e12F);
    const double reach = this->CircleReach();
    this->Circles.ForEachBall(b,
      [&](const Ball& ball)
      {
        ForEachNodeNear(ball.Center, reach, brick,
          [&](std::size_t node, float squared)
          { scratch.ToCircle[node] = std::min(scratch.ToCircle[node], squared); });
      });
    for (std::int64_t k = brick.First[2]; k < brick.Last[2]; ++k)
    {
      for (std::int64_t j = brick.First[1]; j < brick.Last[1]; ++j)
      {
        const std::int64_t line = BallBricks::BrickSize[0] *
          ((j - brick.First[1]) + BallBricks::BrickSize[1] * (k - brick.First[2]));
        float* row = to.data() + this->Grid.Row() * j + this->Grid.Plane() * k;
        for (std::int64_t i = brick.First[0]; i < brick.Last[0]; ++i)
        {
          const auto node = static_cast<std::size_t>(line + i - brick.First[0]);
          row[i] = this->ValueAt(
            { static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) }, node,
            scratch);
        }
      }
    }
  }

private:
  static std::vector<Ball> GrowBalls(std::vector<Ball> balls, double by)
  {
    std::for_each(balls.begin(), balls.end(), [by](Ball& ball) { ball.Radius += by; });
    return balls;
  }

  double CircleReach() const { return this->Probe + static_cast<double>(FlowGrid::Band); }

  std::vector<Ball> CircleBalls() const
  {
    // At most half a step from the nearest point of a circle: an error of (step / 2)^2 / (2 probe).
    constexpr double step = 0.25; // spacings
    std::vector<Ball> balls;
    for (const auto& place : FreeCirclePoints(this->Rolled, this->Neighbours, step))
    {
      balls.push_back({ place, this->CircleReach() });
    }
    return balls;
  }

  void FindDepths(std::int64_t b, const Brick& brick, BrickScratch& scratch) const
  {
    std::fill(scratch.Depth.begin(), scratch.Depth.end(), 1e6F);
    this->Spheres.ForEachIndex(b,
      [&](std::size_t index)
      {
        const Ball& ball = this->Rolled[index];
        const auto radius = static_cast<float>(ball.Radius);
        ForEachNodeNear(ball.Center, ball.Radius + this->Outside, brick,
          [&](std::size_t node, float squared)
          {
            const float depth = std::sqrt(squared) - radius;
            if (depth < scratch.Depth[node])
            {
              scratch.Depth[node] = depth;
              scratch.Deepest[node] = static_cast<std::int32_t>(index);
            }
          });
      });
  }

  float ValueAt(
    const std::array<double, 3>& place, std::size_t node, const BrickScratch& scratch) const
  {
    const auto probe = static_cast<float>(this->Probe);
    const float depth = scratch.Depth[node];
    const float plain = std::clamp(probe + depth, -FlowGrid::Band, FlowGrid::Band);
    // Outside of the spheres the distance is known; deep inside it is beyond the band either way.
    if (depth >= 0.0F || plain == -FlowGrid::Band)
    {
      return plain;
    }
    const auto ball = static_cast<std::size_t>(scratch.Deepest[node]);
    if (this->IsOnFreeSphere(place, ball))
    {
      return plain;
    }
    return std::clamp(probe - std::sqrt(scratch.ToCircle[node]), -FlowGrid::Band, FlowGrid::Band);
  }

  /// Whether the sphere is free at its point nearest to `place`.
  bool IsOnFreeSphere(const std::array<double, 3>& place, std::size_t ball) const
  {
    const Ball& sphere = this->Rolled[ball];
    std::array<double, 3> out{ place[0] - sphere.Center[0], place[1] - sphere.Center[1],
      place[2] - sphere.Center[2] };
    const double length = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    if (length > 0.0)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        out[axis] = sphere.Center[axis] + sphere.Radius / length * out[axis];
      }
      std::int64_t by = -1;
      return this->Neighbours.IsFree(ball, out, by);
    }
    return false;
  }

  const FlowGrid& Grid;
  double Probe;   // spacings, as all lengths here
  double Outside; // how far beyond the spheres distances are needed
  BallBricks Spheres;
  std::vector<Ball> Rolled; // balls of radius plus probe
  BallNeighbours Neighbours;
  BallBricks Circles;
};

}

void SolventExcludedDistance(const FlowGrid& grid, const std::vector<Ball>& balls, double probe,
  std::vector<float>& to, const ProgressCallback& progress)
{
  const double h = grid.Spacing();
  const std::array<double, 3> origin = grid.Origin();
  std::vector<Ball> rolled;
  rolled.reserve(balls.size());
  for (const Ball& ball : balls)
  {
    rolled.push_back({ { (ball.Center[0] - origin[0]) / h, (ball.Center[1] - origin[1]) / h,
                         (ball.Center[2] - origin[2]) / h },
      (ball.Radius + probe) / h });
  }
  const ExcludedDistance distance(grid, std::move(rolled), probe / h);
  Report(progress, 0.5);
  ParallelFor(
    0, distance.Size(), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      BrickScratch scratch;
      for (std::int64_t b = first; b < last; ++b)
      {
        distance.FillBrick(b, scratch, to);
      }
    },
    Between(progress, 0.5, 1.0));
}

SurfaceFlowResult SolventExcludedSurface(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const ProgressCallback& progress)
{
  SurfaceFlowResult result;
  CheckFlow(balls, parameters);
  if (balls.empty())
  {
    return result;
  }
  CheckFlowMemory(balls, FlowGridAround(balls, parameters));
  FlowField field(FlowGrid(FlowGridAround(balls, parameters)));
  DistanceToBalls(field.Grid, balls, 1.0, 0.0, static_cast<double>(FlowGrid::Band), field.Ceiling,
    Between(progress, 0.0, 0.2));
  CheckGridResolvesAtoms(field, balls, parameters);
  if (parameters.ProbeRadius > 0.0)
  {
    SolventExcludedDistance(
      field.Grid, balls, parameters.ProbeRadius, field.Distance, Between(progress, 0.2, 0.9));
  }
  else
  {
    field.Distance = field.Ceiling;
  }
  FindBand(field);
  RecordMeasures(field, 0.0, result);
  StoreDistances(field, result);
  Report(progress, 1.0);
  return result;
}

}
