#include "ChokingLoops/ChokeFit.h"

#include "Core/Pi.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Points of the hull tried; the nearest is known to a hundredth long before.
constexpr int Steps = 200;

}

double UncertaintyOf(const ShapeFeature& feature)
{
  const double d = feature.Distance();
  return d - std::sqrt(std::max(0.0, d * d - feature.Error * feature.Error));
}

double ShortestGirth(const ShapeFeature& feature)
{
  return 2.0 * Pi * (feature.Distance() - UncertaintyOf(feature));
}

bool IsSurrounded(const Point3& centre, double reach, const std::vector<Point3>& points)
{
  if (points.empty())
  {
    return false;
  }
  Point3 nearest = points.front() - centre; // a point of the hull, moved towards the centre
  for (int step = 0; step < Steps && Length(nearest) > reach; ++step)
  {
    const auto along = [&](const Point3& p) { return Dot(p - centre, nearest); };
    const Point3 support =
      *std::min_element(points.begin(), points.end(),
        [&](const Point3& a, const Point3& b) { return along(a) < along(b); }) -
      centre;
    if (Dot(support, nearest) > reach * Length(nearest))
    {
      return false; // a plane parts the hull from the ball
    }
    const Point3 way = support - nearest;
    const double length2 = Dot(way, way);
    if (length2 <= 0.0)
    {
      break;
    }
    nearest = nearest + std::clamp(-Dot(nearest, way) / length2, 0.0, 1.0) * way;
  }
  return Length(nearest) <= reach;
}

double SharpestTurn(const std::vector<Point3>& polygon, double least)
{
  std::vector<Point3> corners;
  for (const Point3& p : polygon)
  {
    if (corners.empty() || Length(p - corners.back()) > least)
    {
      corners.push_back(p);
    }
  }
  while (corners.size() > 1 && Length(corners.front() - corners.back()) <= least)
  {
    corners.pop_back();
  }
  double sharpest = 0.0;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n > 2 && i < n; ++i)
  {
    const Point3 in = corners[i] - corners[(i + n - 1) % n];
    const Point3 out = corners[(i + 1) % n] - corners[i];
    const Point3 c = Cross(in, out);
    sharpest = std::max(sharpest, std::atan2(Length(c), Dot(in, out)));
  }
  return sharpest;
}

}
