#include "Curvature/FiniteDifference.h"
#include "Curvature/PointDerivative.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

using namespace isthmus;

using Values = std::array<double, 10>; // value, x, y, z, xx, yy, zz, xy, xz, yz

Values At(const DerivativeRows& r, std::int64_t i)
{
  return { r.Value[i], r.X[i], r.Y[i], r.Z[i], r.XX[i], r.YY[i], r.ZZ[i], r.XY[i], r.XZ[i],
    r.YZ[i] };
}

double LargestDifference(const Values& a, const Values& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// A field with its derivatives: the product of one function of x, y and z each.
struct Field
{
  /// Value, first and second derivative at u.
  std::array<double, 3> (*Factor)(double u);

  Values operator()(double x, double y, double z) const
  {
    const auto a = this->Factor(x);
    const auto b = this->Factor(0.3 + 1.1 * y);
    const auto c = this->Factor(-0.2 + 0.9 * z);
    return { a[0] * b[0] * c[0], a[1] * b[0] * c[0], 1.1 * a[0] * b[1] * c[0],
      0.9 * a[0] * b[0] * c[1], a[2] * b[0] * c[0], 1.21 * a[0] * b[2] * c[0],
      0.81 * a[0] * b[0] * c[2], 1.1 * a[1] * b[1] * c[0], 0.9 * a[1] * b[0] * c[1],
      0.99 * a[0] * b[1] * c[1] };
  }
};

std::array<double, 3> Sine(double u)
{
  return { std::sin(u), std::cos(u), -std::sin(u) };
}

std::array<double, 3> Square(double u)
{
  return { 1.0 + u - 0.5 * u * u, 1.0 - u, -1.0 };
}

std::array<double, 3> Quartic(double u)
{
  return { 1.0 + u - 0.5 * u * u + 0.2 * u * u * u - 0.1 * u * u * u * u,
    1.0 - u + 0.6 * u * u - 0.4 * u * u * u, -1.0 + 1.2 * u - 1.2 * u * u };
}

/// The field on nodes -half ... half of an anisotropic grid.
struct SampledField
{
  SampledField(const Field& field, std::array<std::int64_t, 3> dimensions, double half)
  {
    this->Grid.Dimensions = dimensions;
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Grid.Spacing[axis] = 2.0 * half / static_cast<double>(dimensions[axis] - 1);
    }
    this->Half = half;
    for (std::int64_t k = 0; k < dimensions[2]; ++k)
    {
      for (std::int64_t j = 0; j < dimensions[1]; ++j)
      {
        for (std::int64_t i = 0; i < dimensions[0]; ++i)
        {
          this->Data.push_back(field(this->Position(0, static_cast<double>(i)),
            this->Position(1, static_cast<double>(j)),
            this->Position(2, static_cast<double>(k)))[0]);
        }
      }
    }
    this->Grid.Data = this->Data.data();
  }

  double Position(int axis, double index) const
  {
    return index * this->Grid.Spacing[axis] - this->Half;
  }

  std::vector<double> Data;
  GridView<const double> Grid;
  double Half = 0.0;
};

double WorstAtNodes(const Field& field, const SampledField& sampled, int accuracy)
{
  const int radius = StencilRadius(accuracy);
  DerivativeRows rows;
  double worst = 0.0;
  const auto& n = sampled.Grid.Dimensions;
  for (std::int64_t k = radius; k < n[2] - radius; ++k)
  {
    for (std::int64_t j = radius; j < n[1] - radius; ++j)
    {
      const std::int64_t count = n[0] - 2 * radius;
      DifferentiateAtNodes(sampled.Grid, { radius, j, k }, count, accuracy, rows);
      for (std::int64_t i = 0; i < count; ++i)
      {
        const Values exact = field(sampled.Position(0, static_cast<double>(i + radius)),
          sampled.Position(1, static_cast<double>(j)), sampled.Position(2, static_cast<double>(k)));
        worst = std::max(worst, LargestDifference(At(rows, i), exact));
      }
    }
  }
  return worst;
}

double WorstAtPoints(const Field& field, const SampledField& sampled, int accuracy, double inset)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> inside(-sampled.Half + inset, sampled.Half - inset);
  DerivativeRows rows;
  double worst = 0.0;
  for (int n = 0; n < 2000; ++n)
  {
    std::array<double, 3> x{};
    std::array<double, 3> index{};
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = inside(random);
      index[axis] = (x[axis] + sampled.Half) / sampled.Grid.Spacing[axis];
    }
    EXPECT_TRUE(DifferentiateAtPoint(sampled.Grid, index, accuracy, 0, rows));
    worst = std::max(worst, LargestDifference(At(rows, 0), field(x[0], x[1], x[2])));
  }
  return worst;
}

TEST(FiniteDifference, PolynomialsOfTheOrdersDegreeAreExact)
{
  const SampledField square({ Square }, { 11, 12, 13 }, 1.0);
  EXPECT_LT(WorstAtNodes({ Square }, square, 2), 2e-12);
  EXPECT_LT(WorstAtPoints({ Square }, square, 2, 0.2), 2e-12);
  const SampledField quartic({ Quartic }, { 11, 12, 13 }, 1.0);
  EXPECT_LT(WorstAtNodes({ Quartic }, quartic, 4), 2e-12);
  EXPECT_LT(WorstAtPoints({ Quartic }, quartic, 4, 0.4), 2e-12);
}

TEST(FiniteDifference, OrderOfConvergence)
{
  for (const int accuracy : { 2, 4 })
  {
    const SampledField coarse({ Sine }, { 21, 23, 25 }, 1.0);
    const SampledField fine({ Sine }, { 41, 45, 49 }, 1.0);
    const double nodes =
      std::log2(WorstAtNodes({ Sine }, coarse, accuracy) / WorstAtNodes({ Sine }, fine, accuracy));
    const double points = std::log2(WorstAtPoints({ Sine }, coarse, accuracy, 0.2) /
      WorstAtPoints({ Sine }, fine, accuracy, 0.2));
    EXPECT_GT(nodes, accuracy - 0.1);
    EXPECT_GT(points, accuracy - 0.1);
    std::cout << "accuracy " << accuracy << ": order " << nodes << " at nodes, " << points
              << " at points\n";
  }
}

TEST(FiniteDifference, APointOnANodeGetsTheNodesDerivatives)
{
  const SampledField sampled({ Sine }, { 12, 11, 10 }, 1.0);
  DerivativeRows node;
  DerivativeRows point;
  for (const int accuracy : { 2, 4 })
  {
    const std::int64_t first = StencilRadius(accuracy); // the outermost node, too
    DifferentiateAtNodes(sampled.Grid, { first, 4, first }, 5, accuracy, node);
    for (std::int64_t i = 0; i < 5; ++i)
    {
      const auto x = static_cast<double>(first + i);
      const auto z = static_cast<double>(first);
      ASSERT_TRUE(DifferentiateAtPoint(sampled.Grid, { x, 4.0, z }, accuracy, i, point));
      EXPECT_LT(LargestDifference(At(point, i), At(node, i)), 1e-12);
    }
  }
}

TEST(FiniteDifference, ContinuousAcrossCells)
{
  const SampledField sampled({ Sine }, { 12, 11, 10 }, 1.0);
  DerivativeRows rows;
  for (const int accuracy : { 2, 4 })
  {
    ASSERT_TRUE(DifferentiateAtPoint(sampled.Grid, { 5.0 - 1e-9, 4.3, 5.7 }, accuracy, 0, rows));
    ASSERT_TRUE(DifferentiateAtPoint(sampled.Grid, { 5.0 + 1e-9, 4.3, 5.7 }, accuracy, 1, rows));
    EXPECT_LT(LargestDifference(At(rows, 0), At(rows, 1)), 1e-8);
  }
}

TEST(FiniteDifference, PointsOutsideAreRefused)
{
  const SampledField sampled({ Sine }, { 12, 11, 10 }, 1.0);
  DerivativeRows rows;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const int accuracy : { 2, 4 })
  {
    const double edge = StencilRadius(accuracy);
    for (const double bad : { edge - 0.01, 11.01 - edge, -3.0, 1e300, -1e300, nan, infinity })
    {
      EXPECT_FALSE(DifferentiateAtPoint(sampled.Grid, { bad, 4.0, 4.0 }, accuracy, 0, rows)) << bad;
    }
    EXPECT_TRUE(DifferentiateAtPoint(sampled.Grid, { 11.0 - edge, 4.0, 4.0 }, accuracy, 0, rows));
  }
}

TEST(FiniteDifference, AccuracyIsTwoOrFour)
{
  EXPECT_EQ(StencilRadius(2), 1);
  EXPECT_EQ(StencilRadius(4), 2);
  EXPECT_THROW(StencilRadius(3), std::invalid_argument);
}

}
