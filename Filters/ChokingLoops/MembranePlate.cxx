#include "ChokingLoops/MembranePlate.h"

#include "Core/Index.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/SurfaceBoolean.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr double FewestPoints = 32.0;
constexpr double MostPoints = 256.0;

/// Each averages a direction with its two neighbours: over some two rims in all.
constexpr int SmoothingRounds = 8;

double LengthOf(const std::vector<Point3>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += Distance(loop[i], loop[(i + 1) % loop.size()]);
  }
  return length;
}

/// `count` points of a closed polyline, equally far apart along it.
std::vector<Point3> Evenly(const std::vector<Point3>& loop, double length, std::size_t count)
{
  std::vector<Point3> points;
  double passed = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point3& p = loop[i];
    const Point3& q = loop[(i + 1) % loop.size()];
    const double edge = Distance(p, q);
    while (points.size() < count)
    {
      const double along =
        static_cast<double>(points.size()) / static_cast<double>(count) * length - passed;
      if (along > edge || edge <= 0.0)
      {
        break;
      }
      points.push_back(p + (along / edge) * (q - p));
    }
    passed += edge;
  }
  return points;
}

Point3 Unit(const Point3& v)
{
  const double length = Length(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

/// Makes unit vectors along a closed loop change slowly: where it bends sharply, those of
/// neighbours would cross.
void Smooth(std::vector<Point3>& directions)
{
  const std::size_t n = directions.size();
  std::vector<Point3> before(n);
  for (int round = 0; round < SmoothingRounds; ++round)
  {
    std::transform(directions.begin(), directions.end(), before.begin(), Unit);
    for (std::size_t i = 0; i < n; ++i)
    {
      directions[i] = Unit(before[(i + n - 1) % n] + 2.0 * before[i] + before[(i + 1) % n]);
    }
  }
}

/// At each point of the loop: the membrane's normal, and where it goes on beyond the loop.
struct Frame
{
  std::vector<Point3> Normals;
  std::vector<Point3> Outward;
};

Frame FrameOf(const std::vector<Point3>& loop, const std::vector<Triangle>& filling)
{
  const std::size_t n = loop.size();
  Frame frame{ std::vector<Point3>(n, Point3{ 0, 0, 0 }),
    std::vector<Point3>(n, Point3{ 0, 0, 0 }) };
  for (const Triangle& t : filling)
  {
    const Point3& origin = loop[At(t[0])];
    const Point3 normal = Cross(loop[At(t[1])] - origin, loop[At(t[2])] - origin);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t from = At(t[k]);
      const std::size_t to = At(t[(k + 1) % 3]);
      frame.Normals[from] = frame.Normals[from] + normal;
      const std::size_t step = from < to ? to - from : from - to;
      if (step == 1 || step == n - 1) // an edge of the loop
      {
        const Point3 outward = Unit(Cross(loop[to] - loop[from], normal));
        frame.Outward[from] = frame.Outward[from] + outward;
        frame.Outward[to] = frame.Outward[to] + outward;
      }
    }
  }
  for (std::vector<Point3>* directions : { &frame.Normals, &frame.Outward })
  {
    Smooth(*directions);
  }
  return frame;
}

/// The filling of the rim, above and below, and a wall. Corners are off the loop, since many a wall
/// is straight enough for theirs to lie on it but for rounding.
TriangleMesh SolidOf(const MembranePlate& plate, const std::vector<Triangle>& filling,
  const Frame& frame, double rim, bool isAlong)
{
  const std::size_t n = plate.Loop.size();
  TriangleMesh solid;
  for (const double up : { 0.5 * plate.Thickness, -0.5 * plate.Thickness })
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      solid.Points.push_back(plate.Loop[i] + rim * frame.Outward[i] + up * frame.Normals[i]);
    }
  }
  const auto below = static_cast<std::int64_t>(n);
  for (const Triangle& t : filling)
  {
    solid.Triangles.push_back(t);
    solid.Triangles.push_back({ t[0] + below, t[2] + below, t[1] + below });
  }
  for (std::int64_t k = 0; k < below; ++k)
  {
    const std::int64_t i = isAlong ? k : (k + 1) % below; // an edge of the filling runs from i to j
    const std::int64_t j = isAlong ? (k + 1) % below : k;
    solid.Triangles.push_back({ j, i, i + below });
    solid.Triangles.push_back({ j, i + below, j + below });
  }
  return solid;
}

/// True where the filling runs along the loop from a point to the next.
bool RunsAlong(const std::vector<Triangle>& filling, std::size_t n)
{
  for (const Triangle& t : filling)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if ((At(t[k]) + 1) % n == At(t[(k + 1) % 3]))
      {
        return true;
      }
    }
  }
  return false;
}

}

std::optional<MembranePlate> PlateOn(const std::vector<Point3>& loop, double thickness, double rim)
{
  const double length = LengthOf(loop);
  if (loop.size() < 3 || !(length > 0.0))
  {
    return std::nullopt;
  }
  const double count = std::clamp(std::ceil(2.0 * length / rim), FewestPoints, MostPoints);
  MembranePlate plate;
  plate.Thickness = thickness;
  plate.Loop = Evenly(loop, length, static_cast<std::size_t>(count));
  const std::vector<Triangle> filling = PolygonFilling(plate.Loop);
  if (filling.size() + 2 != plate.Loop.size())
  {
    return std::nullopt;
  }
  plate.Area = SurfaceArea({ plate.Loop, filling });
  const Frame frame = FrameOf(plate.Loop, filling);
  plate.Solid = SolidOf(plate, filling, frame, rim, RunsAlong(filling, plate.Loop.size()));
  if (!SelfIntersections(plate.Solid).empty())
  {
    return std::nullopt;
  }
  return plate;
}

}
