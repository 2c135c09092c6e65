#include "Atoms/BallBricks.h"

#include "Core/Handles.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t MostEntries = std::int64_t{ 1 } << 31;

using BrickNumber = Handle<struct BrickKind, std::int64_t>;

/// Bricks [First, Last) along each axis; none where `Empty`.
struct BrickBox
{
  Index3 First{ 0, 0, 0 };
  Index3 Last{ 0, 0, 0 };
  bool Empty = false;

  BrickBox(const Ball& ball, double reach, const Index3& dimensions)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const NodeRange nodes(ball.Center[axis], reach, 0, dimensions[axis]);
      this->Empty = this->Empty || nodes.IsEmpty();
      this->First[axis] = nodes.First / BallBricks::BrickSize[axis];
      this->Last[axis] = (nodes.Last - 1) / BallBricks::BrickSize[axis] + 1;
    }
  }
  std::int64_t Size() const
  {
    return (this->Last[0] - this->First[0]) * (this->Last[1] - this->First[1]) *
      (this->Last[2] - this->First[2]);
  }
};

}

BallBricks::BallBricks(
  std::vector<Ball> balls, double reach, const Index3& gridDimensions, double margin)
  : Balls(std::move(balls))
  , Reach(reach)
  , Margin(margin)
  , Dimensions(gridDimensions)
{
  std::sort(this->Balls.begin(), this->Balls.end(),
    [](const Ball& a, const Ball& b)
    {
      return std::tie(a.Center[2], a.Center[1], a.Center[0], a.Radius) <
        std::tie(b.Center[2], b.Center[1], b.Center[0], b.Radius);
    });
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Counts[axis] = (gridDimensions[axis] + BrickSize[axis] - 1) / BrickSize[axis];
  }
  this->Start.assign(static_cast<std::size_t>(this->Size()) + 1, 0);
  this->ForEachEntry([this](BrickNumber brick, std::size_t) { ++this->Start[brick.Index() + 1]; });
  for (std::size_t b = 1; b < this->Start.size(); ++b)
  {
    this->Start[b] += this->Start[b - 1];
  }
  this->Entries.resize(static_cast<std::size_t>(this->Start.back()));
  std::vector<std::int64_t> next(this->Start);
  this->ForEachEntry([&](BrickNumber brick, std::size_t ball)
    { this->Entries[static_cast<std::size_t>(next[brick.Index()]++)] = ball; });
}

Brick BallBricks::At(std::int64_t b) const
{
  const Index3 place{ b % this->Counts[0], b / this->Counts[0] % this->Counts[1],
    b / (this->Counts[0] * this->Counts[1]) };
  Brick brick;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    brick.First[axis] = place[axis] * BrickSize[axis];
    brick.Last[axis] = std::min(brick.First[axis] + BrickSize[axis], this->Dimensions[axis]);
  }
  return brick;
}

template <typename Use>
void BallBricks::ForEachEntry(Use use) const
{
  std::int64_t entries = 0;
  for (std::size_t ball = 0; ball < this->Balls.size(); ++ball)
  {
    const BrickBox box(
      this->Balls[ball], this->Reach * this->Balls[ball].Radius + this->Margin, this->Dimensions);
    if (box.Empty)
    {
      continue;
    }
    entries += box.Size();
    if (entries > MostEntries)
    {
      throw std::invalid_argument("The balls are so large compared with the spacing that too many "
                                  "of them reach each node: choose a larger spacing.");
    }
    for (std::int64_t k = box.First[2]; k < box.Last[2]; ++k)
    {
      for (std::int64_t j = box.First[1]; j < box.Last[1]; ++j)
      {
        for (std::int64_t i = box.First[0]; i < box.Last[0]; ++i)
        {
          use(BrickNumber(i + this->Counts[0] * (j + this->Counts[1] * k)), ball);
        }
      }
    }
  }
}

}
