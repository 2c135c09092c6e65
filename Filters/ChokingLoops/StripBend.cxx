#include "ChokingLoops/StripBend.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Fractions this near to an end of the edge count as the end.
constexpr double Near = 1e-7;

const Point3& PointAt(const SurfaceAdjacency& s, SimplexId p)
{
  return s.Mesh().Points[static_cast<std::size_t>(p)];
}

}

double CornerAngle(const SurfaceAdjacency& s, HalfEdgeId h)
{
  const double a = s.Length(h);
  const double b = s.Length(SurfaceAdjacency::Previous(h));
  const double c = s.Length(SurfaceAdjacency::Next(h));
  return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0));
}

EdgeStrip OtherWayRound(
  const SurfaceAdjacency& s, HalfEdgeId enter, SurfaceTriangleId last, SimplexId p)
{
  const bool onRight = s.To(enter) == p;
  EdgeStrip other;
  for (HalfEdgeId h = s.Opposite(enter); SurfaceAdjacency::Triangle(h) != last;)
  {
    h = onRight ? s.Turn(h) : s.Opposite(SurfaceAdjacency::Next(h));
    other.push_back({ h, onRight ? 0.0 : 1.0 });
  }
  return other;
}

double AngleBeyond(const SurfaceAdjacency& s, const EdgeStrip& other, SimplexId p,
  const Point3& before, const Point3& after)
{
  const Point3& centre = PointAt(s, p);
  const auto between = [&centre](const Point3& x, const Point3& y)
  {
    const Point3 c = Cross(x - centre, y - centre);
    return std::atan2(Length(c), Dot(x - centre, y - centre));
  };
  if (other.empty())
  {
    return between(before, after);
  }
  const auto farEnd = [&s, p](HalfEdgeId h) -> const Point3&
  { return PointAt(s, s.From(h) == p ? s.To(h) : s.From(h)); };
  double angle =
    between(before, farEnd(other.front().HalfEdge)) + between(farEnd(other.back().HalfEdge), after);
  for (std::size_t i = 0; i + 1 < other.size(); ++i)
  {
    const HalfEdgeId h = other[i].HalfEdge;
    angle += CornerAngle(s, s.From(h) == p ? h : SurfaceAdjacency::Next(h));
  }
  return angle;
}

bool Touches(const SurfaceAdjacency& s, const SurfaceCurvePoint& c, SimplexId p)
{
  return (s.From(c.HalfEdge) == p && c.Fraction < Near) ||
    (s.To(c.HalfEdge) == p && c.Fraction > 1.0 - Near);
}

SimplexId TouchedBy(const SurfaceAdjacency& s, const SurfaceCurvePoint& c)
{
  return c.Fraction < Near ? s.From(c.HalfEdge) : c.Fraction > 1.0 - Near ? s.To(c.HalfEdge) : -1;
}

}
