#include "Contouring/SharpEdges.h"

#include "Core/Index.h"
#include "Surfaces/SurfaceCleaning.h"

#include <tuple>

namespace isthmus
{
namespace
{

/// A side of a triangle with an area.
struct Side
{
  std::array<vtkIdType, 2> Ends; ///< ascending
  Point3 Normal;
};

std::vector<Side> SidesOf(const SurfaceView& surface)
{
  std::vector<Side> sides;
  sides.reserve(3 * surface.Triangles.size());
  for (const Triangle& t : MergedCorners(surface))
  {
    const Point3& first = surface.Point(t[0]);
    const Point3 n = Cross(surface.Point(t[1]) - first, surface.Point(t[2]) - first);
    const double length = Length(n);
    for (std::size_t c = 0; c < 3 && length > 0.0; ++c)
    {
      const vtkIdType a = t[c], b = t[(c + 1) % 3];
      sides.push_back({ { std::min(a, b), std::max(a, b) }, (1.0 / length) * n });
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.Ends, a.Normal) < std::tie(b.Ends, b.Normal); });
  return sides;
}

/// A segment's end: its point, and the other end.
using End = std::array<vtkIdType, 2>;

std::vector<Point3> CornersOf(const SurfaceView& surface, std::vector<End> ends, double cosine)
{
  std::sort(ends.begin(), ends.end());
  const auto along = [&](const End& end)
  {
    const Point3 d = surface.Point(end[1]) - surface.Point(end[0]);
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
      corners.push_back(surface.Point(ends[i][0]));
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
      sharp.Segments.push_back({ surface.Point(a), surface.Point(b) });
      ends.push_back({ a, b });
      ends.push_back({ b, a });
    }
  }
  sharp.Corners = CornersOf(surface, std::move(ends), cosine);
  return sharp;
}

}
