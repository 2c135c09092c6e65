#include "Curvature/CurvatureDescriptors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <string>

namespace
{

using namespace isthmus;

TEST(CurvatureDescriptors, ArcTangentAgreesWithTheLibrary)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0);
  double worst = 0.0;
  for (int i = 0; i < 200000; ++i)
  {
    const double x = std::pow(10.0, exponent(random));
    const double y = std::pow(10.0, exponent(random)) * (i % 2 ? 1.0 : -1.0);
    worst = std::max(worst, std::abs(ArcTangent(y, x) - std::atan2(y, x)));
  }
  for (int i = -100000; i <= 100000; ++i)
  {
    const double y = i / 25000.0; // covers all pieces of the formula
    worst = std::max(worst, std::abs(ArcTangent(y, 1.0) - std::atan(y)));
  }
  EXPECT_LT(worst, 1e-15);
}

TEST(CurvatureDescriptors, ArcTangentOnTheAxes)
{
  EXPECT_EQ(ArcTangent(0.0, 0.0), 0.0);
  EXPECT_EQ(ArcTangent(0.0, 3.0), 0.0);
  EXPECT_DOUBLE_EQ(ArcTangent(2.0, 0.0), std::acos(0.0));
  EXPECT_DOUBLE_EQ(ArcTangent(-2.0, 0.0), -std::acos(0.0));
  EXPECT_DOUBLE_EQ(ArcTangent(1e308, 1e308), std::atan(1.0));
}

TEST(CurvatureDescriptors, ShapeIndexOfTheFiveShapes)
{
  struct Case
  {
    double Maximum, Minimum, Thesis;
  };
  const Case cases[] = { { 2.0, 2.0, -1.0 }, { 2.0, 0.0, -0.5 }, { 2.0, -2.0, 0.0 },
    { 0.0, -2.0, 0.5 }, { -2.0, -2.0, 1.0 }, { 0.0, 0.0, 0.0 } };
  for (const Case& c : cases)
  {
    const double mean = 0.5 * (c.Maximum + c.Minimum);
    const double half = 0.5 * (c.Maximum - c.Minimum);
    EXPECT_NEAR(ShapeIndex(mean, half, ShapeIndexConvention::Thesis), c.Thesis, 1e-15);
    EXPECT_NEAR(ShapeIndex(mean, half, ShapeIndexConvention::Koenderink), -c.Thesis, 1e-15);
  }
}

TEST(CurvatureDescriptors, HalfDifferenceAndCurvedness)
{
  const double maximum = 3.0;
  const double minimum = -1.0;
  const double mean = 0.5 * (maximum + minimum);
  EXPECT_DOUBLE_EQ(HalfDifference(maximum * minimum, mean), 2.0);
  EXPECT_DOUBLE_EQ(Curvedness(mean, 2.0), std::sqrt((9.0 + 1.0) / 2.0));
  EXPECT_EQ(HalfDifference(1.0 + 1e-15, 1.0), 0.0) << "K > H^2 by rounding is an umbilic";
}

TEST(CurvatureDescriptors, SurfaceTypesOfTable21)
{
  struct Case
  {
    double Maximum, Minimum;
    SurfaceType Type;
  };
  const Case cases[] = { { 2.0, 1.0, SurfaceType::Peak }, { 2.0, 0.0, SurfaceType::Ridge },
    { 2.0, -1.0, SurfaceType::SaddleRidge }, { 2.0, -2.0, SurfaceType::MinimalSurface },
    { 1.0, -2.0, SurfaceType::SaddleValley }, { 0.0, -2.0, SurfaceType::Valley },
    { -1.0, -2.0, SurfaceType::Pit }, { 0.0, 0.0, SurfaceType::Flat },
    { 5e-4, 5e-4, SurfaceType::Flat }, { 2.0, 1e-4, SurfaceType::Ridge },
    { 2.0, -2.0005, SurfaceType::MinimalSurface } };
  for (const Case& c : cases)
  {
    const SurfaceType type = ClassifySurface(
      0.5 * (c.Maximum + c.Minimum), 0.5 * (c.Maximum - c.Minimum), 1.0, SurfaceTypeTolerance());
    EXPECT_EQ(type, c.Type) << c.Maximum << " " << c.Minimum << " gave " << SurfaceTypeName(type);
  }
}

TEST(CurvatureDescriptors, ImpossibleSignsHaveNoType)
{
  // K > 0 with H = 0 requires a tolerance that treats every H as zero.
  SurfaceTypeTolerance tolerance;
  tolerance.MeanTolerance = 10.0;
  EXPECT_EQ(ClassifySurface(1.0, 0.0, 1.0, tolerance), SurfaceType::None);
}

TEST(CurvatureDescriptors, EveryTypeHasAName)
{
  std::set<std::string> names;
  for (unsigned char type = 0; type < NumberOfSurfaceTypes; ++type)
  {
    names.insert(SurfaceTypeName(static_cast<SurfaceType>(type)));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(NumberOfSurfaceTypes));
}

TEST(CurvatureDescriptors, FlatUpToTheToleranceItself)
{
  SurfaceTypeTolerance tolerance;
  tolerance.FlatTolerance = 2.0;
  EXPECT_EQ(ClassifySurface(2.0, 0.0, 1.0, tolerance), SurfaceType::Flat);
  EXPECT_NE(ClassifySurface(2.5, 0.0, 1.0, tolerance), SurfaceType::Flat);
}

}
