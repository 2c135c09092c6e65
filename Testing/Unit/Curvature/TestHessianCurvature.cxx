// The algorithm without VTK's data model: compared with the other method, at umbilics, under
// symmetries, on any number of threads.

#include "Curvature/HessianCurvature.h"
#include "FundamentalForms.h"
#include "HessianExample.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

using isthmus::testing::FundamentalForms;

using isthmus::testing::Jet;

/// Random quadratic polynomials have exact differences: both methods use the same derivatives.
TEST(HessianCurvature, AgreesWithTheFundamentalForms)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int n = 0; n < 2000; ++n)
  {
    const Jet s{ any(random), any(random), any(random), any(random), any(random), any(random),
      any(random), any(random), any(random) };
    const auto quadratic = [&](double x, double y, double z)
    {
      x -= 1.0, y -= 1.0, z -= 1.0;
      return s.X * x + s.Y * y + s.Z * z + s.XY * x * y + s.XZ * x * z + s.YZ * y * z +
        0.5 * (s.XX * x * x + s.YY * y * y + s.ZZ * z * z);
    };
    Example<double> example({ 3, 3, 3 }, { 1.0, 1.0, 1.0 }, quadratic);
    example.AtNodes();
    const auto reference = FundamentalForms(s);
    const double c = std::max(example.Results[5][13], 1e-3);
    ASSERT_EQ(example.Valid[13], 1);
    EXPECT_NEAR(example.K(13), reference.Gaussian, 1e-12 * c * c);
    EXPECT_NEAR(example.H(13), reference.Mean, 1e-12 * c);
  }
}

/// At an umbilic, sqrt(H^2 - K) of the fundamental forms loses half of the digits; ours must not.
TEST(HessianCurvature, UmbilicsKeepFullPrecision)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double ours = 0.0;
  double other = 0.0;
  for (int n = 0; n < 500; ++n)
  {
    const Jet s{ any(random), any(random), any(random), -2.0, -2.0, -2.0, 0.0, 0.0, 0.0 };
    const auto sphere = [&](double x, double y, double z)
    {
      x -= 1.0, y -= 1.0, z -= 1.0;
      return s.X * x + s.Y * y + s.Z * z - x * x - y * y - z * z;
    };
    Example<double> example({ 3, 3, 3 }, { 1.0, 1.0, 1.0 }, sphere);
    example.AtNodes();
    const auto reference = FundamentalForms(s);
    ours = std::max(ours, (example.Maximum(13) - example.Minimum(13)) / example.H(13));
    other =
      std::max(other, 2.0 * HalfDifference(reference.Gaussian, reference.Mean) / reference.Mean);
    EXPECT_NEAR(example.Results[4][13], -1.0, 1e-14);
    EXPECT_EQ(static_cast<SurfaceType>(example.Type[13]), SurfaceType::Peak);
  }
  std::printf("kappa_1 - kappa_2 on spheres, relative: %.1e; from K and H %.1e\n", ours, other);
  EXPECT_LT(ours, 1e-14);
  EXPECT_GT(other, 1e-9);
}

TEST(HessianCurvature, DescriptorsFitTogether)
{
  Example<double> example({ 20, 18, 16 }, { 0.2, 0.25, 0.15 }, Wavy);
  example.AtNodes(WithAccuracy(4));
  for (std::size_t i = 0; i < example.Data.size(); ++i)
  {
    const double maximum = example.Results[2][i];
    const double minimum = example.Results[3][i];
    const double c2 = 0.5 * (maximum * maximum + minimum * minimum);
    ASSERT_GE(maximum, minimum);
    ASSERT_NEAR(example.Results[0][i], maximum * minimum, 1e-12 * c2);
    ASSERT_NEAR(example.Results[1][i], 0.5 * (maximum + minimum), 1e-12 * std::sqrt(c2));
    ASSERT_NEAR(example.Results[5][i], std::sqrt(c2), 1e-12 * std::sqrt(c2));
    ASSERT_NEAR(example.Results[4][i],
      -std::atan2(maximum + minimum, maximum - minimum) / std::acos(0.0), 1e-14);
  }
}

/// Curvature at node (i, j, k) of the field with axes taken in the order `axis` must be that at the
/// permuted node of the original.
TEST(HessianCurvature, AxisPermutation)
{
  const Size n{ 14, 12, 10 };
  const std::array<double, 3> h{ 0.2, 0.25, 0.15 };
  for (const int accuracy : { 2, 4 })
  {
    Example<double> original(n, h, Wavy);
    original.AtNodes(WithAccuracy(accuracy));
    Example<double> permuted({ n[2], n[0], n[1] }, { h[2], h[0], h[1] },
      [](double z, double x, double y) { return Wavy(x, y, z); });
    permuted.AtNodes(WithAccuracy(accuracy));
    for (std::int64_t k = 2; k < n[2] - 2; ++k)
    {
      for (std::int64_t j = 2; j < n[1] - 2; ++j)
      {
        for (std::int64_t i = 2; i < n[0] - 2; ++i)
        {
          const std::int64_t a = original.Grid.Index(i, j, k);
          const std::int64_t b = permuted.Grid.Index(k, i, j);
          const double c = std::max(1.0, original.Results[5][a]);
          ASSERT_NEAR(original.K(a), permuted.K(b), 1e-11 * c * c);
          ASSERT_NEAR(original.H(a), permuted.H(b), 1e-11 * c);
        }
      }
    }
  }
}

TEST(HessianCurvature, ScalingAndShifting)
{
  Example<double> original({ 12, 12, 12 }, { 0.2, 0.2, 0.2 }, Wavy);
  original.AtNodes();
  // Ten times as long, values mapped by 3 S + 5, further nodes in front.
  Example<double> other({ 14, 13, 12 }, { 2.0, 2.0, 2.0 },
    [](double x, double y, double z)
    { return 3.0 * Wavy(0.1 * x - 0.4, 0.1 * y - 0.2, 0.1 * z) + 5.0; });
  other.AtNodes();
  for (std::int64_t k = 1; k < 11; ++k)
  {
    for (std::int64_t j = 1; j < 11; ++j)
    {
      for (std::int64_t i = 1; i < 11; ++i)
      {
        const std::int64_t a = original.Grid.Index(i, j, k);
        const std::int64_t b = other.Grid.Index(i + 2, j + 1, k);
        const double c = original.Results[5][a];
        ASSERT_NEAR(original.H(a), 10.0 * other.H(b), 1e-10 * c);
        ASSERT_NEAR(original.K(a), 100.0 * other.K(b), 1e-10 * c * c);
      }
    }
  }
}

TEST(HessianCurvature, InsideLowerTurnsTheSign)
{
  Example<double> higher({ 12, 12, 12 }, { 0.2, 0.2, 0.2 }, Wavy);
  higher.AtNodes();
  HessianCurvatureOptions options;
  options.InsideIsHigher = false;
  Example<double> lower(
    { 12, 12, 12 }, { 0.2, 0.2, 0.2 }, [](double x, double y, double z) { return -Wavy(x, y, z); });
  lower.AtNodes(options);
  for (std::size_t array = 0; array < higher.Results.size(); ++array)
  {
    EXPECT_EQ(higher.Results[array], lower.Results[array]);
  }
  Example<double> turned = higher;
  turned.Grid.Data = turned.Data.data();
  turned.AtNodes(options);
  EXPECT_EQ(turned.H(800), -higher.H(800));
  EXPECT_EQ(turned.K(800), higher.K(800));
  EXPECT_EQ(turned.Maximum(800), -higher.Minimum(800));
}

namespace
{

template <typename T>
void ExpectSameOnAnyThreads(int accuracy)
{
  std::vector<std::array<double, 3>> points;
  for (int n = 0; n < 3000; ++n)
  {
    points.push_back({ 3.0 + 0.011 * n, 4.0 + 0.003 * n, 20.0 - 0.005 * n });
  }
  const auto run = [&](int threads, bool atPoints)
  {
    Example<T> example({ 150, 31, 27 }, { 0.2, 0.25, 0.15 },
      [](double x, double y, double z) { return 100.0 * Wavy(x, y, z); });
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]()
      {
        atPoints ? example.AtPoints(points, WithAccuracy(accuracy))
                 : example.AtNodes(WithAccuracy(accuracy));
      });
    return example;
  };
  for (const bool atPoints : { false, true })
  {
    const Example<T> one = run(1, atPoints);
    const Example<T> two = run(2, atPoints);
    EXPECT_EQ(one.Results, two.Results);
    EXPECT_EQ(one.Directions, two.Directions);
    EXPECT_EQ(one.Type, two.Type);
    EXPECT_EQ(one.Valid, two.Valid);
  }
}

}

TEST(HessianCurvature, IdenticalOnAnyNumberOfThreads)
{
  for (const int accuracy : { 2, 4 })
  {
    ExpectSameOnAnyThreads<float>(accuracy);
    ExpectSameOnAnyThreads<double>(accuracy);
    ExpectSameOnAnyThreads<short>(accuracy);
  }
}
