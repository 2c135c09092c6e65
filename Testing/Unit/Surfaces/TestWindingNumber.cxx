// The winding number of a triangle soup around a point, compared with the sum of all its solid
// angles.

#include "Surfaces/WindingNumber.h"

#include "Core/Geometry.h"
#include "SphereMesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

double SumOfSolidAngles(const TriangleMesh& mesh, const Point3& x)
{
  double sum = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])] - x; };
    sum += SolidAngle(at(0), at(1), at(2));
  }
  return sum / (4.0 * Pi);
}

TEST(WindingNumber, IsOneInsideZeroOutsideAndInBetweenAtHoles)
{
  TriangleMesh sphere = Sphere({ 0, 0, 0 }, 1.0, 40);
  const WindingNumber closed(sphere);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  for (int i = 0; i < 500; ++i)
  {
    const Point3 x{ place(random), place(random), place(random) };
    const double r = std::sqrt(Dot(x, x));
    EXPECT_NEAR(closed(x), SumOfSolidAngles(sphere, x), 0.02);
    if (std::abs(r - 1.0) > 0.02)
    {
      EXPECT_NEAR(closed(x), r < 1.0 ? 1.0 : 0.0, 0.02) << r;
    }
  }
  // From its center, a hemisphere covers half of all directions.
  TriangleMesh half = sphere;
  half.Triangles.clear();
  for (const Triangle& t : sphere.Triangles)
  {
    double z = 0.0;
    for (const std::int64_t id : t)
    {
      z += sphere.Points[static_cast<std::size_t>(id)][2];
    }
    if (z > 0.0)
    {
      half.Triangles.push_back(t);
    }
  }
  EXPECT_NEAR(WindingNumber(half)({ 0, 0, 0 }), 0.5, 0.05);
  EXPECT_EQ(WindingNumber({})({ 0, 0, 0 }), 0.0);
}

// A few large triangles around the point, whose solid angles add up to several full ones: the sum
// is exact to rounding.
TEST(WindingNumber, OfASoupIsTheSumOfItsSolidAngles)
{
  std::mt19937 random(2);
  std::normal_distribution<double> place;
  double most = 0.0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    TriangleMesh soup;
    for (std::int64_t i = 0; i < 1 + trial % 8; ++i)
    {
      const Point3 a{ place(random), place(random), place(random) };
      const Point3 b{ place(random), place(random), place(random) };
      const Point3 c{ place(random), place(random), place(random) };
      const bool isFacing = trial % 2 == 0 && Dot(a, Cross(b, c)) < 0.0; // then all add up
      soup.Points.insert(soup.Points.end(), { a, isFacing ? c : b, isFacing ? b : c });
      soup.Triangles.push_back({ 3 * i, 3 * i + 1, 3 * i + 2 });
    }
    const double exact = SumOfSolidAngles(soup, { 0, 0, 0 });
    EXPECT_NEAR(WindingNumber(soup)({ 0, 0, 0 }), exact, 1e-12);
    most = std::max(most, std::abs(exact));
  }
  EXPECT_GT(most, 1.0);
}

// Seen from a corner a triangle has no angle; the others keep theirs.
TEST(WindingNumber, OfACornerMatchesTheOtherTriangles)
{
  TriangleMesh soup;
  soup.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  soup.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  EXPECT_NEAR(WindingNumber(soup)({ 0, 0, 0 }), 0.125, 1e-15);
}

}
