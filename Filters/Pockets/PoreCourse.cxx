#include "Pockets/PoreCourse.h"

#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Running means with a Gaussian of the given width; towards the ends it gets narrower, so that
/// they stay.
std::vector<Point3> Smooth(const std::vector<Point3>& points, double width)
{
  const auto n = static_cast<std::int64_t>(points.size());
  std::vector<Point3> smooth(points.size());
  for (std::int64_t i = 0; i < n; ++i)
  {
    const std::int64_t reach = std::min({ static_cast<std::int64_t>(3.0 * width), i, n - 1 - i });
    const double sigma = std::max(1e-3, static_cast<double>(reach) / 3.0);
    Point3 sum{ 0.0, 0.0, 0.0 };
    double weights = 0.0;
    for (std::int64_t k = -reach; k <= reach; ++k)
    {
      const double x = static_cast<double>(k) / sigma;
      const double weight = std::exp(-0.5 * x * x);
      sum = sum + weight * points[static_cast<std::size_t>(i + k)];
      weights += weight;
    }
    smooth[static_cast<std::size_t>(i)] = (1.0 / weights) * sum;
  }
  return smooth;
}

}

std::vector<Point3> Resample(const std::vector<Point3>& way, double spacing)
{
  constexpr double mostPlanes = 1e5;
  double whole = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    whole += Length(way[i + 1] - way[i]);
  }
  if (!(whole / spacing <= mostPlanes))
  {
    throw std::invalid_argument("A pore here is " + std::to_string(whole) +
      " angstrom long, which takes more than 100000 planes at this Spacing: raise it, or check the "
      "unit of the atoms' coordinates.");
  }
  std::vector<Point3> points{ way.front() };
  double rest = spacing;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    const Point3 step = way[i + 1] - way[i];
    const double length = Length(step);
    double at = rest;
    for (; at <= length; at += spacing)
    {
      points.push_back(way[i] + (at / length) * step);
    }
    rest = at - length;
  }
  return points;
}

Course CourseAlong(const std::vector<Point3>& points, double width)
{
  const std::vector<Point3> smooth = Smooth(points, width);
  Course course;
  for (std::size_t i = 0; i < smooth.size(); ++i)
  {
    const Point3 d =
      smooth[std::min(i + 1, smooth.size() - 1)] - smooth[i > 0 ? i - 1 : std::size_t{ 0 }];
    const double length = Length(d);
    if (length > 0.0)
    {
      course.Planes.push_back({ smooth[i], (1.0 / length) * d });
      course.Way.push_back(points[i]);
    }
  }
  return course;
}

Point3 Foot(const Plane& plane, const Point3& p)
{
  return p - Dot(p - plane.Origin, plane.Normal) * plane.Normal;
}

std::vector<PlaneBall> MarchAlong(const AtomField& atoms, const Course& course, std::size_t from,
  std::int64_t step, PlaneBall ball, const ProgressCallback& progress)
{
  std::vector<PlaneBall> balls;
  const auto n = static_cast<std::int64_t>(course.Planes.size());
  for (auto i = static_cast<std::int64_t>(from) + step;
       i >= 0 && i < n && ball.Radius <= course.End; i += step)
  {
    Report(progress,
      static_cast<double>(std::abs(i - static_cast<std::int64_t>(from))) / static_cast<double>(n));
    const Plane& plane = course.Planes[static_cast<std::size_t>(i)];
    std::vector<Point3> starts{ Foot(plane, ball.Centre) };
    if (!course.Way.empty())
    {
      starts.push_back(Foot(plane, course.Way[static_cast<std::size_t>(i)]));
    }
    ball = LargestBallInPlane(atoms, plane, starts, ball.Radius, course.Enough);
    if (ball.Radius < course.Least)
    {
      // The way is wider than that everywhere: this is a dead end beside it.
      const PlaneBall other =
        LargestBallInPlane(atoms, plane, { starts.back() }, course.Least, course.Enough);
      ball = other.Radius > ball.Radius ? other : ball;
    }
    balls.push_back(ball);
  }
  return balls;
}

}
