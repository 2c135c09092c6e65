#include "Persistence/ExactOrthosphere.h"

using namespace isthmus;

namespace
{

/// Four balls to which the sphere around `center` that passes through the origin is orthogonal. The
/// last one lies `height` above the plane of the others.
Orthosphere Found(const Point3& center, double height)
{
  const std::array<Point3, 4> centers{ { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 1.0, 1.0, height } } };
  std::array<double, 4> squaredRadii{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    squaredRadii[k] = Dot(centers[k], centers[k]) - 2.0 * Dot(centers[k], center);
  }
  return ExactOrthosphere(centers, squaredRadii);
}

void ExpectSphere(const Point3& center, double height)
{
  const Orthosphere found = Found(center, height);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(found.Center[axis], center[axis]) << height;
  }
  EXPECT_EQ(found.Power, Dot(center, center)) << height;
}

}

/// All numbers, also the squared radii and the power, are sums of few powers of 2.
TEST(ExactOrthosphere, FlatTetrahedra)
{
  ExpectSphere({ 3.0, 5.0, 7.0 }, 1.0);
  ExpectSphere({ 3.0, 5.0, std::ldexp(7.0, 20) }, std::ldexp(1.0, -12));
  ExpectSphere({ 3.0, 5.0, -std::ldexp(7.0, 20) }, std::ldexp(1.0, -20));
}

/// Products of four lengths underflow.
TEST(ExactOrthosphere, BeyondTheRangeOfDoubles)
{
  ExpectSphere({ 3.0, 5.0, std::ldexp(1.0, 503) }, std::ldexp(1.0, -550));
}

TEST(ExactOrthosphere, IsCircumscribedWithoutRadii)
{
  // On the sphere of radius 1105 around (1105, 0, 0): 1105^2 = 1104^2 + 47^2 = 1073^2 + 264^2 = ...
  const std::array<Point3, 4> corners{ { { 0.0, 0.0, 0.0 }, { 1.0, 47.0, 0.0 }, { 1.0, 0.0, 47.0 },
    { 32.0, 264.0, 0.0 } } };
  const Orthosphere found = ExactOrthosphere(corners, {});
  EXPECT_EQ(found.Center, (Point3{ 1105.0, 0.0, 0.0 }));
  EXPECT_EQ(found.Power, 1105.0 * 1105.0);
}
