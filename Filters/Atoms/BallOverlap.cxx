#include "Atoms/BallOverlap.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// One of the two points that the three spheres share; their midpoint where the spheres just touch.
Point3 CommonPoint(const Ball& a, const Ball& b, const Ball& c)
{
  const Point3 u = b.Center - a.Center;
  const Point3 v = c.Center - a.Center;
  const Point3 n = Cross(u, v);
  const double nn = Dot(n, n);
  const double w = a.Radius * a.Radius;
  const Point3 foot = (0.5 / nn) *
    ((Dot(u, u) + w - b.Radius * b.Radius) * Cross(v, n) +
      (Dot(v, v) + w - c.Radius * c.Radius) * Cross(n, u));
  const double height = std::sqrt(std::max(0.0, w - Dot(foot, foot)));
  return a.Center + foot + (height / std::sqrt(nn)) * n;
}

}

Overlap<1> WholeBall(const Ball& a)
{
  const double area = 4.0 * Pi * a.Radius * a.Radius;
  return { area * a.Radius / 3.0, { area } };
}

Overlap<2> Lens(const Ball& a, const Ball& b)
{
  const double d = Length(b.Center - a.Center);
  const double plane = 0.5 * (d + (a.Radius - b.Radius) * (a.Radius + b.Radius) / d);
  const double ha = a.Radius - plane;
  const double hb = b.Radius - (d - plane);
  return { Pi / 3.0 * (ha * ha * (3.0 * a.Radius - ha) + hb * hb * (3.0 * b.Radius - hb)),
    { 2.0 * Pi * a.Radius * ha, 2.0 * Pi * b.Radius * hb } };
}

Overlap<3> HalfTripleIntersection(const Ball& a, const Ball& b, const Ball& c)
{
  const Ball* balls[3] = { &a, &b, &c };
  const Point3 x = CommonPoint(a, b, c);
  Overlap<3> half;
  half.Volume = std::fabs(Dot(x - a.Center, Cross(b.Center - a.Center, c.Center - a.Center))) / 6.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double sector = SolidAngle(balls[i]->Center, balls[j]->Center, balls[k]->Center, x);
    const Overlap<1> ball = WholeBall(*balls[i]);
    half.Volume -= sector * ball.Volume;
    half.Area[i] -= sector * ball.Area[0];
    const double slice = DihedralAngle(balls[i]->Center, balls[j]->Center, balls[k]->Center, x);
    const Overlap<2> lens = Lens(*balls[i], *balls[j]);
    half.Volume += slice * lens.Volume;
    half.Area[i] += slice * lens.Area[0];
    half.Area[j] += slice * lens.Area[1];
  }
  return half;
}

double SolidAngle(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 u = a - p;
  const Point3 v = b - p;
  const Point3 w = c - p;
  const double lu = Length(u);
  const double lv = Length(v);
  const double lw = Length(w);
  const double numerator = std::fabs(Dot(u, Cross(v, w)));
  const double denominator = lu * lv * lw + Dot(u, v) * lw + Dot(u, w) * lv + Dot(v, w) * lu;
  return std::atan2(numerator, denominator) / (2.0 * Pi);
}

double DihedralAngle(const Point3& p, const Point3& q, const Point3& a, const Point3& b)
{
  const Point3 axis = q - p;
  const Point3 m = Cross(axis, a - p);
  const Point3 n = Cross(axis, b - p);
  return std::atan2(Length(Cross(m, n)), Dot(m, n)) / (2.0 * Pi);
}

}
