#include "Atoms/BallNeighbours.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

using Place = std::array<double, 3>;
using Cell = std::array<std::int64_t, 4>; // z, y, x, ball

double SquaredDistance(const Place& a, const Place& b)
{
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
    (a[2] - b[2]) * (a[2] - b[2]);
}

Cell FindCell(const Ball& ball, double size, std::int64_t number)
{
  const auto at = [&](std::size_t axis)
  { return static_cast<std::int64_t>(std::floor(ball.Center[axis] / size)); };
  return { at(2), at(1), at(0), number };
}

/// The circle in which two spheres meet.
struct Circle
{
  Place Center;
  Place First;  ///< from the center to the circle
  Place Second; ///< the same, turned by a right angle
  double Radius = 0.0;

  Circle(const Ball& a, const Ball& b)
  {
    const double distance = std::sqrt(SquaredDistance(a.Center, b.Center));
    const double along =
      (distance * distance + a.Radius * a.Radius - b.Radius * b.Radius) / (2.0 * distance);
    const double squared = a.Radius * a.Radius - along * along;
    if (!(distance > 1e-9 * a.Radius) || !(squared > 0.0))
    {
      return; // Radius 0: no circle
    }
    this->Radius = std::sqrt(squared);
    Place axis;
    for (std::size_t i = 0; i < 3; ++i)
    {
      axis[i] = (b.Center[i] - a.Center[i]) / distance;
      this->Center[i] = a.Center[i] + along * axis[i];
    }
    const std::size_t least = std::abs(axis[0]) < std::abs(axis[1])
      ? (std::abs(axis[0]) < std::abs(axis[2]) ? 0 : 2)
      : (std::abs(axis[1]) < std::abs(axis[2]) ? 1 : 2);
    Place other{};
    other[least] = 1.0;
    const double part = axis[least];
    const double norm = std::sqrt(1.0 - part * part);
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->First[i] = this->Radius * (other[i] - part * axis[i]) / norm;
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      this->Second[i] = axis[j] * this->First[k] - axis[k] * this->First[j];
    }
  }

  Place At(double angle) const
  {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return { this->Center[0] + c * this->First[0] + s * this->Second[0],
      this->Center[1] + c * this->First[1] + s * this->Second[1],
      this->Center[2] + c * this->First[2] + s * this->Second[2] };
  }
};

/// Adds the free places of one circle; between a free and a covered one, the end of the arc.
template <typename IsFree>
void AddCircle(const Circle& circle, double step, IsFree isFree, std::vector<Place>& places)
{
  constexpr int halvings = 20;
  constexpr double turn = 6.283185307179586;
  const int count = std::max(8, static_cast<int>(std::ceil(turn * circle.Radius / step)));
  bool before = isFree(circle.At(0.0));
  for (int i = 1; i <= count; ++i)
  {
    const double from = turn * (i - 1) / count;
    const double to = turn * i / count;
    const Place place = circle.At(to);
    const bool now = isFree(place);
    if (now)
    {
      places.push_back(place);
    }
    if (now != before)
    {
      double low = now ? to : from; // free
      double high = now ? from : to;
      for (int h = 0; h < halvings; ++h)
      {
        const double middle = 0.5 * (low + high);
        (isFree(circle.At(middle)) ? low : high) = middle;
      }
      places.push_back(circle.At(low));
    }
    before = now;
  }
}

}

BallNeighbours::BallNeighbours(const std::vector<Ball>& balls)
  : Balls(balls)
{
  double largest = 0.0;
  for (const Ball& ball : balls)
  {
    largest = std::max(largest, ball.Radius);
  }
  this->Cell = std::max(2.0 * largest, 1e-300);
  std::vector<isthmus::Cell> cells(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b)
  {
    cells[b] = FindCell(balls[b], this->Cell, static_cast<std::int64_t>(b));
  }
  std::sort(cells.begin(), cells.end());
  std::vector<std::vector<std::int64_t>> of(balls.size());
  ParallelFor(0, static_cast<std::int64_t>(balls.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        this->FindNeighbours(static_cast<std::size_t>(b), cells, of[static_cast<std::size_t>(b)]);
      }
    });
  this->Start.push_back(0);
  for (const std::vector<std::int64_t>& found : of)
  {
    this->Others.insert(this->Others.end(), found.begin(), found.end());
    this->Start.push_back(static_cast<std::int64_t>(this->Others.size()));
  }
}

void BallNeighbours::FindNeighbours(
  std::size_t ball, const std::vector<isthmus::Cell>& cells, std::vector<std::int64_t>& found) const
{
  const Ball& self = this->Balls[ball];
  const isthmus::Cell cell = FindCell(self, this->Cell, 0);
  for (std::int64_t row = 0; row < 9; ++row)
  {
    // The three cells along x lie together.
    const std::int64_t z = cell[0] + row / 3 - 1;
    const std::int64_t y = cell[1] + row % 3 - 1;
    auto at = std::lower_bound(cells.begin(), cells.end(), isthmus::Cell{ z, y, cell[2] - 1, 0 });
    const isthmus::Cell end{ z, y, cell[2] + 2, 0 };
    for (; at != cells.end() && *at < end; ++at)
    {
      const auto other = static_cast<std::size_t>((*at)[3]);
      const double reach = self.Radius + this->Balls[other].Radius;
      if (other != ball && SquaredDistance(self.Center, this->Balls[other].Center) < reach * reach)
      {
        found.push_back((*at)[3]);
      }
    }
  }
}

bool BallNeighbours::IsFree(std::size_t ball, const Place& place, std::int64_t& last) const
{
  const auto covers = [&](std::int64_t other)
  {
    // A sphere through the place does not cover it.
    const Ball& by = this->Balls[static_cast<std::size_t>(other)];
    const double reach = by.Radius * (1.0 - 1e-9);
    return SquaredDistance(place, by.Center) < reach * reach;
  };
  if (last >= 0 && covers(last))
  {
    return false;
  }
  for (const std::int64_t* other = this->begin(ball); other != this->end(ball); ++other)
  {
    if (covers(*other))
    {
      last = *other;
      return false;
    }
  }
  return true;
}

std::vector<Place> FreeCirclePoints(
  const std::vector<Ball>& balls, const BallNeighbours& neighbours, double step)
{
  std::vector<std::vector<Place>> of(balls.size());
  ParallelFor(0, static_cast<std::int64_t>(balls.size()), 32,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        const auto ball = static_cast<std::size_t>(b);
        std::int64_t by = -1;
        for (const std::int64_t* o = neighbours.begin(ball); o != neighbours.end(ball); ++o)
        {
          const Circle circle(balls[ball], balls[static_cast<std::size_t>(*o)]);
          if (*o > b && circle.Radius > 0.0)
          {
            AddCircle(
              circle, step, [&](const Place& place) { return neighbours.IsFree(ball, place, by); },
              of[ball]);
          }
        }
      }
    });
  std::vector<Place> places;
  for (const std::vector<Place>& some : of)
  {
    places.insert(places.end(), some.begin(), some.end());
  }
  return places;
}

}
