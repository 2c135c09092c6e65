#include "Persistence/ExactOrthosphere.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace isthmus
{
namespace
{

/// By rational numbers of any size.
Orthosphere RationalOrthosphere(
  const std::array<Point3, 4>& centers, const std::array<double, 4>& squaredRadii)
{
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const auto ball = [&](std::size_t k)
  {
    const Point3& p = centers[k];
    return Kernel::Weighted_point_3(Kernel::Point_3(p[0], p[1], p[2]), squaredRadii[k]);
  };
  const auto center = CGAL::weighted_circumcenter(ball(0), ball(1), ball(2), ball(3));
  const auto power = CGAL::squared_distance(center, ball(0).point()) - ball(0).weight();
  return { { CGAL::to_double(center.x()), CGAL::to_double(center.y()),
             CGAL::to_double(center.z()) },
    CGAL::to_double(power) };
}

}

// Numerators and denominators apart: rational numbers look for common divisors after each operation
// and take 14 times as long.
Orthosphere ExactOrthosphere(
  const std::array<Point3, 4>& centers, const std::array<double, 4>& squaredRadii)
{
  using Number = CGAL::Mpzf; // sums and products of doubles, without rounding
  using Vector = CGAL::Simple_cartesian<Number>::Vector_3;
  const auto edge = [&](std::size_t k)
  {
    const auto along = [&](std::size_t axis)
    { return Number(centers[k][axis]) - Number(centers[0][axis]); };
    return Vector(along(0), along(1), along(2));
  };
  const Number w = squaredRadii[0];
  const auto lifted = [&](const Vector& to, std::size_t k)
  { return to.squared_length() + w - Number(squaredRadii[k]); };
  const Vector a = edge(1);
  const Vector b = edge(2);
  const Vector c = edge(3);
  const Vector bc = CGAL::cross_product(b, c);
  const Vector numerator = lifted(a, 1) * bc + lifted(b, 2) * CGAL::cross_product(c, a) +
    lifted(c, 3) * CGAL::cross_product(a, b);
  const Number denominator = Number(2.0) * (a * bc);
  const Number squared = denominator * denominator;
  const double divisor = CGAL::to_double(squared);
  const double power = CGAL::to_double(numerator.squared_length() - w * squared) / divisor;
  if (!(divisor > 1e-200 && std::isfinite(power)))
  {
    return RationalOrthosphere(centers, squaredRadii); // beyond the range of doubles
  }
  const auto place = [&](std::size_t axis, const Number& from)
  { return centers[0][axis] + CGAL::to_double(from) / CGAL::to_double(denominator); };
  return { { place(0, numerator.x()), place(1, numerator.y()), place(2, numerator.z()) }, power };
}

}
