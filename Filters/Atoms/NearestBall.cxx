#include "Atoms/NearestBall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{

NearestBall::NearestBall(const std::vector<Ball>& balls)
  : Balls(balls)
{
  std::array<double, 3> high{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = std::numeric_limits<double>::infinity();
    high[axis] = -this->Low[axis];
    for (const Ball& ball : balls)
    {
      this->Low[axis] = std::min(this->Low[axis], ball.Center[axis]);
      high[axis] = std::max(high[axis], ball.Center[axis]);
      this->Largest = std::max(this->Largest, ball.Radius);
    }
  }
  // Cells as wide as a ball, or wider if the balls are far apart.
  this->Size = std::max(2.0 * this->Largest, 1e-6);
  const double most = 8.0 * static_cast<double>(balls.size()) + 8.0;
  const auto cells = [&](std::size_t axis)
  { return std::floor((high[axis] - this->Low[axis]) / this->Size) + 1.0; };
  while (cells(0) * cells(1) * cells(2) > most)
  {
    this->Size *= 1.5;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Counts[axis] = static_cast<std::int64_t>(cells(axis));
  }
  this->Members.resize(
    static_cast<std::size_t>(this->Counts[0] * this->Counts[1] * this->Counts[2]));
  for (std::size_t ball = 0; ball < balls.size(); ++ball)
  {
    const Cell c = this->FindCell(balls[ball].Center);
    this
      ->Members[static_cast<std::size_t>(c[0] + this->Counts[0] * (c[1] + this->Counts[1] * c[2]))]
      .push_back(ball);
  }
}

NearestBall::Cell NearestBall::FindCell(const std::array<double, 3>& place) const
{
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double at = std::floor((place[axis] - this->Low[axis]) / this->Size);
    cell[axis] =
      static_cast<std::int64_t>(std::clamp(at, 0.0, static_cast<double>(this->Counts[axis] - 1)));
  }
  return cell;
}

std::size_t NearestBall::At(const std::array<double, 3>& place) const
{
  const Cell center = this->FindCell(place);
  const std::int64_t last = std::max({ this->Counts[0], this->Counts[1], this->Counts[2] });
  double best = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::int64_t shell = 0; shell <= last; ++shell)
  {
    // Lower bound of the distance of everything in this shell and beyond.
    if (static_cast<double>(shell - 1) * this->Size - this->Largest > best)
    {
      break;
    }
    Cell first;
    Cell end;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = std::max<std::int64_t>(center[axis] - shell, 0);
      end[axis] = std::min(center[axis] + shell + 1, this->Counts[axis]);
    }
    for (std::int64_t k = first[2]; k < end[2]; ++k)
    {
      for (std::int64_t j = first[1]; j < end[1]; ++j)
      {
        const bool side = std::abs(k - center[2]) == shell || std::abs(j - center[1]) == shell;
        for (std::int64_t i = first[0]; i < end[0]; ++i)
        {
          if (!side && std::abs(i - center[0]) != shell)
          {
            continue;
          }
          for (const std::size_t ball :
            this
              ->Members[static_cast<std::size_t>(i + this->Counts[0] * (j + this->Counts[1] * k))])
          {
            const auto& c = this->Balls[ball].Center;
            const double distance = std::hypot(place[0] - c[0], place[1] - c[1], place[2] - c[2]) -
              this->Balls[ball].Radius;
            if (distance < best || (distance == best && ball < nearest))
            {
              best = distance;
              nearest = ball;
            }
          }
        }
      }
    }
  }
  return nearest;
}

}
