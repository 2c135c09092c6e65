// Coordinates of any magnitude, scaled to about 1 by powers of two and back.

#include "Core/UnitScale.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

using namespace isthmus;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

}

TEST(UnitScale, ScalesByPowersOfTwoOnlyIfNecessary)
{
  const std::vector<Point3> usual{ { 1.0, -300.0, 0.1 } };
  EXPECT_TRUE(UnitScale(usual).IsOne());
  std::vector<Point3> points{ { 1.1e-50, -3.3e-51, 0.0 }, { NaN, 0.0, 0.0 } };
  const auto before = points;
  const UnitScale scale(points);
  scale.Apply(points);
  EXPECT_GT(points[0][0], 0.5);
  EXPECT_LT(points[0][0], 1.0);
  scale.Undo(points);
  EXPECT_EQ(points[0], before[0]);
  EXPECT_THROW(UnitScale(std::vector<Point3>{ { 0.0, 2e100, 0.0 } }), std::invalid_argument);
  EXPECT_THROW(UnitScale(std::vector<Point3>{ { 0.0, 1e-101, 0.0 } }), std::invalid_argument);
}

TEST(UnitScale, OrdinaryDataAreUnchanged)
{
  const auto factor = [](double largest) {
    return UnitScale(std::vector<Point3>{ { 0.0, -largest, 0.0 } }).Factor();
  };
  for (const double usual : { 0x1p-20, 0x1p-3, 1.0, 0x1.fp19 })
  {
    EXPECT_EQ(factor(usual), 1.0) << usual;
  }
  EXPECT_EQ(factor(0x1p-30), 0x1p29);
  EXPECT_EQ(factor(0x1p30), 0x1p-31);
  EXPECT_EQ(factor(0x1.8p40), 0x1p-41);
  EXPECT_EQ(UnitScale(std::vector<Point3>()).Factor(), 1.0);
  EXPECT_EQ(factor(0.0), 1.0);
}

TEST(UnitScale, RoundsCoordinatesFarBelowTheLargestToZero)
{
  std::vector<Point3> points{ { 1.0, 6e-17, -1e-51 }, { 0.5, 1e-300, 0.0 } };
  const UnitScale scale(points);
  EXPECT_FALSE(scale.IsOne());
  scale.Apply(points);
  EXPECT_EQ(points, (std::vector<Point3>{ { 1.0, 6e-17, 0.0 }, { 0.5, 0.0, 0.0 } }));
  EXPECT_TRUE(UnitScale(points).IsOne());
  points = { { 1e60, 1.0, 1e11 }, { 0.0, -1e9, 0.0 } };
  const auto before = points;
  const UnitScale far(points);
  far.Apply(points);
  far.Undo(points);
  EXPECT_EQ(points, (std::vector<Point3>{ { before[0][0], 0.0, 1e11 }, { 0, 0, 0 } }));
}

TEST(UnitScale, SurfacesFarAwayAreMovedWithoutRounding)
{
  const std::vector<Point3> near{ { -0.7, 0.1, 3.0 }, { 0.3, 1.1, 3.9 }, { 0.0, 0.0, 3.25 } };
  for (const Point3& shift :
    { Point3{ 1e7, 0.0, -3e7 }, Point3{ 1e12, 1e12, 1e12 }, Point3{ 0.0, -200.0, 0.0 } })
  {
    std::vector<Point3> points;
    for (const Point3& p : near)
    {
      points.push_back(p + shift);
    }
    const std::vector<Point3> before = points;
    const UnitScale scale(points);
    EXPECT_FALSE(scale.IsOne());
    EXPECT_EQ(scale.Factor(), 1.0);
    scale.Apply(points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      EXPECT_LT(Length(points[i]), 10.0);
      EXPECT_EQ(points[i] - points[0], before[i] - before[0]);
    }
    scale.Undo(points);
    EXPECT_EQ(points, before);
  }
  std::vector<Point3> points{ { 10.0, 5.0, 0.0 }, { 11.0, 6.0, 1.0 } };
  EXPECT_TRUE(UnitScale(points).IsOne()) << "ten times its extent away";
  points = { { 1.0, 0.0, 0.0 }, { 1.0 + 0x1p-30, 0x1p-30, 0x1p-30 } };
  EXPECT_GT(UnitScale(points).Factor(), 1.0);
}
