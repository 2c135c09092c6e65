#include "EdgeStrip.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// The corner left of (a, b), from the three lengths.
Point2 Corner(const Point2& a, const Point2& b, double toA, double toB)
{
  const double c = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double x = (toA * toA - toB * toB + c * c) / (2.0 * c);
  const double y = std::sqrt(std::max(0.0, toA * toA - x * x));
  const Point2 u{ (b[0] - a[0]) / c, (b[1] - a[1]) / c };
  return { a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0] };
}

}

Point3 PositionOf(const SurfaceAdjacency& s, const SurfaceCurvePoint& p)
{
  const Point3& a = s.Mesh().Points[static_cast<std::size_t>(s.From(p.HalfEdge))];
  const Point3& b = s.Mesh().Points[static_cast<std::size_t>(s.To(p.HalfEdge))];
  return (1.0 - p.Fraction) * a + p.Fraction * b;
}

void CancelReturns(const SurfaceAdjacency& s, EdgeStrip& strip)
{
  EdgeStrip kept;
  for (const SurfaceCurvePoint& c : strip)
  {
    if (!kept.empty() && s.Opposite(kept.back().HalfEdge) == c.HalfEdge)
    {
      kept.pop_back();
    }
    else
    {
      kept.push_back(c);
    }
  }
  std::size_t first = 0;
  while (kept.size() - first >= 2 && s.Opposite(kept.back().HalfEdge) == kept[first].HalfEdge)
  {
    kept.pop_back();
    ++first;
  }
  strip.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

EdgeStrip StripLeftOf(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  EdgeStrip strip;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const SimplexId in = s.Find(loop[(i + n - 1) % n], loop[i]);
    const SimplexId out = s.Find(loop[i], loop[(i + 1) % n]);
    if (in < 0 || out < 0)
    {
      throw std::invalid_argument("Points " + std::to_string(loop[i]) + " and " +
        std::to_string(loop[(in < 0 ? i + n - 1 : i + 1) % n]) +
        " of the loop are not joined by an edge of the surface.");
    }
    for (SimplexId h = s.Next(in); h != out; h = s.Next(s.Opposite(h)))
    {
      strip.push_back({ s.Opposite(h), 1.0 });
    }
  }
  CancelReturns(s, strip);
  return strip;
}

UnfoldedStrip Unfold(const SurfaceAdjacency& s, const EdgeStrip& strip, std::size_t start)
{
  UnfoldedStrip plane;
  const std::size_t n = strip.size();
  plane.From.push_back({ 0.0, 0.0 });
  plane.To.push_back({ s.Length(strip[start].HalfEdge), 0.0 });
  for (std::size_t i = 0; i < n; ++i)
  {
    const SimplexId h = strip[(start + i) % n].HalfEdge;
    const SimplexId next = strip[(start + i + 1) % n].HalfEdge;
    const SimplexId second = SurfaceAdjacency::Next(h);
    const SimplexId third = SurfaceAdjacency::Previous(h);
    const Point2 from = plane.From.back();
    const Point2 to = plane.To.back();
    const Point2 apex = Corner(from, to, s.Length(third), s.Length(second));
    const bool keepsTo = s.Opposite(next) == second;
    plane.From.push_back(keepsTo ? apex : from);
    plane.To.push_back(keepsTo ? to : apex);
  }
  return plane;
}

}
