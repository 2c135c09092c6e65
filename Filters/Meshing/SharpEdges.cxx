#include "SharpEdges.h"

#include "Index.h"
#include "SurfaceIntake.h"

#include <tuple>

namespace isthmus
{
namespace
{

/// A side of a triangle with an area.
struct Side
{
  std::array<std::int64_t, 2> Ends; ///< ascending
  Point3 Normal;
};

Point3 PointOf(const SurfaceView& surface, std::int64_t id)
{
  const double* const p = surface.Point(id);
  return { p[0], p[1], p[2] };
}

std::vector<Side> SidesOf(const SurfaceView& surface)
{
  const std::vector<vtkIdType> corners = MergedCorners(surface);
  std::vector<Side> sides;
  sides.reserve(corners.size());
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3)
  {
    const Point3 first = PointOf(surface, corners[t]);
    const Point3 n =
      Cross(PointOf(surface, corners[t + 1]) - first, PointOf(surface, corners[t + 2]) - first);
    const double length = Length(n);
    for (std::size_t c = 0; c < 3 && length > 0.0; ++c)
    {
      const std::int64_t a = corners[t + c], b = corners[t + (c + 1) % 3];
      sides.push_back({ { std::min(a, b), std::max(a, b) }, (1.0 / length) * n });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.Ends, a.Normal) < std::tie(b.Ends, b.Normal); });
  return sides;
}

/// A segment's end: its point, and the other end.
using End = std::array<std::int64_t, 2>;

std::vector<Point3> CornersOf(const SurfaceView& surface, std::vector<End> ends, double cosine)
{
  std::sort(ends.begin(), ends.end());
  const auto along = [&](const End& end)
  {
    const Point3 d = PointOf(surface, end[1]) - PointOf(surface, end[0]);
    return (1.0 / Length(d)) * d;
  };
  std::vector<Point3> corners;
  for (std::size_t i = 0, next = 0; i < ends.size(); i = next)
  {
    while (next < ends.size() && ends[next][0] == ends[i][0])
    {
      ++next;
    }
    if (next - i != 2 || -Dot(along(ends[i]), along(ends[i + 1])) < cosine)
    {
      corners.push_back(PointOf(surface, ends[i][0]));
    }
  }
  return corners;
}

}

SharpEdges FindSharpEdges(const SurfaceView& surface, double cosine)
{
  const std::vector<Side> sides = SidesOf(surface);
  SharpEdges sharp;
  std::vector<End> ends;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next)
  {
    while (next < sides.size() && sides[next].Ends == sides[i].Ends)
    {
      ++next;
    }
    if (next - i > 2 || (next - i == 2 && Dot(sides[i].Normal, sides[i + 1].Normal) < cosine))
    {
      const auto [a, b] = sides[i].Ends;
      sharp.Segments.push_back({ PointOf(surface, a), PointOf(surface, b) });
      ends.push_back({ a, b });
      ends.push_back({ b, a });
    }
  }
  sharp.Corners = CornersOf(surface, std::move(ends), cosine);
  return sharp;
}

}
