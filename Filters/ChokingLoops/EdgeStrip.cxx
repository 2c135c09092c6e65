#include "ChokingLoops/EdgeStrip.h"

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

EdgeStrip WithoutReturns(const SurfaceAdjacency& s, const EdgeStrip& strip)
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
  return kept;
}

namespace
{

/// The edges at path[i] left of the way from path[i - 1] to path[i + 1], added to the strip.
void AddLeftOf(
  const SurfaceAdjacency& s, const std::vector<SimplexId>& path, std::size_t i, EdgeStrip& strip)
{
  const std::size_t n = path.size();
  const HalfEdgeId in = s.Find(path[(i + n - 1) % n], path[i]);
  const HalfEdgeId out = s.Find(path[i], path[(i + 1) % n]);
  if (!in.Exists() || !out.Exists())
  {
    throw std::invalid_argument("Points " + std::to_string(path[i]) + " and " +
      std::to_string(path[(in.Exists() ? i + 1 : i + n - 1) % n]) +
      " of the loop are not joined by an edge of the surface.");
  }
  for (HalfEdgeId h = s.Next(in); h != out; h = s.Next(s.Opposite(h)))
  {
    strip.push_back({ s.Opposite(h), 1.0 });
  }
}

}

void CancelReturns(const SurfaceAdjacency& s, EdgeStrip& strip)
{
  EdgeStrip kept = WithoutReturns(s, strip);
  std::size_t first = 0;
  while (kept.size() - first >= 2 && s.Opposite(kept.back().HalfEdge) == kept[first].HalfEdge)
  {
    kept.pop_back();
    ++first;
  }
  strip.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

void CancelReturns(const SurfaceAdjacency& s, EdgeStrip& strip, SimplexId from, SimplexId to)
{
  const EdgeStrip kept = WithoutReturns(s, strip);
  const auto endsAt = [&s](const SurfaceCurvePoint& c, SimplexId p)
  { return s.From(c.HalfEdge) == p || s.To(c.HalfEdge) == p; };
  const auto first =
    std::find_if(kept.begin(), kept.end(), [&](const auto& c) { return !endsAt(c, from); });
  const auto last = std::find_if(kept.rbegin(), std::make_reverse_iterator(first),
    [&](const auto& c) { return !endsAt(c, to); });
  strip.assign(first, last.base());
}

EdgeStrip StripLeftOf(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  EdgeStrip strip;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    AddLeftOf(s, loop, i, strip);
  }
  CancelReturns(s, strip);
  return strip;
}

EdgeStrip StripLeftOfPath(const SurfaceAdjacency& s, const std::vector<SimplexId>& path)
{
  EdgeStrip strip;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    AddLeftOf(s, path, i, strip);
  }
  CancelReturns(s, strip, path.front(), path.back());
  return strip;
}

namespace
{

/// Lays down the triangle beyond the last edge, up to the edge over which the strip goes on.
void UnfoldOver(const SurfaceAdjacency& s, HalfEdgeId h, HalfEdgeId next, UnfoldedStrip& plane)
{
  const HalfEdgeId second = SurfaceAdjacency::Next(h);
  const Point2 from = plane.From.back();
  const Point2 to = plane.To.back();
  const Point2 apex = Corner(from, to, s.Length(SurfaceAdjacency::Previous(h)), s.Length(second));
  const bool keepsTo = s.Opposite(next) == second;
  plane.From.push_back(keepsTo ? apex : from);
  plane.To.push_back(keepsTo ? to : apex);
}

}

UnfoldedStrip UnfoldPath(const SurfaceAdjacency& s, const EdgeStrip& strip)
{
  const HalfEdgeId first = strip.front().HalfEdge;
  const HalfEdgeId behind = s.Opposite(first);
  const Point2 from{ 0.0, 0.0 };
  const Point2 to{ s.Length(first), 0.0 };
  const Point2 start = Corner(to, from, s.Length(SurfaceAdjacency::Previous(behind)),
    s.Length(SurfaceAdjacency::Next(behind)));
  UnfoldedStrip plane{ { start, from }, { start, to } };
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
  {
    UnfoldOver(s, strip[i].HalfEdge, strip[i + 1].HalfEdge, plane);
  }
  const HalfEdgeId last = strip.back().HalfEdge;
  const Point2 end = Corner(plane.From.back(), plane.To.back(),
    s.Length(SurfaceAdjacency::Previous(last)), s.Length(SurfaceAdjacency::Next(last)));
  plane.From.push_back(end);
  plane.To.push_back(end);
  return plane;
}

UnfoldedStrip UnfoldOpen(const SurfaceAdjacency& s, const EdgeStrip& strip)
{
  UnfoldedStrip plane{ { { 0.0, 0.0 } }, { { s.Length(strip.front().HalfEdge), 0.0 } } };
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
  {
    UnfoldOver(s, strip[i].HalfEdge, strip[i + 1].HalfEdge, plane);
  }
  return plane;
}

UnfoldedStrip Unfold(const SurfaceAdjacency& s, const EdgeStrip& strip, std::size_t start)
{
  UnfoldedStrip plane;
  const std::size_t n = strip.size();
  plane.From.reserve(n + 1);
  plane.To.reserve(n + 1);
  plane.From.push_back({ 0.0, 0.0 });
  plane.To.push_back({ s.Length(strip[start].HalfEdge), 0.0 });
  std::size_t here = start;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = here + 1 < n ? here + 1 : 0;
    UnfoldOver(s, strip[here].HalfEdge, strip[next].HalfEdge, plane);
    here = next;
  }
  return plane;
}

}
