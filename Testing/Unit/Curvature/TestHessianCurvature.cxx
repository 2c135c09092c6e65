// The algorithm without VTK's data model: against the other route, at umbilics, under symmetries,
// on any number of threads, and at places that have no curvature.
#include "FiniteDifference.h"
#include "FundamentalForms.h"
#include "HessianCurvature.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace isthmus;
using isthmus::testing::FundamentalForms;
using isthmus::testing::Jet;

using Size = std::array<std::int64_t, 3>;

/// Values on a grid, and what the algorithm says about them.
template <typename T>
struct Example
{
  template <typename F>
  Example(const Size& size, const std::array<double, 3>& spacing, F&& f)
  {
    this->Grid.Dimensions = size;
    this->Grid.Spacing = spacing;
    for (std::int64_t k = 0; k < size[2]; ++k)
    {
      for (std::int64_t j = 0; j < size[1]; ++j)
      {
        for (std::int64_t i = 0; i < size[0]; ++i)
        {
          this->Data.push_back(static_cast<T>(f(static_cast<double>(i) * spacing[0],
            static_cast<double>(j) * spacing[1], static_cast<double>(k) * spacing[2])));
        }
      }
    }
    this->Grid.Data = this->Data.data();
  }

  CurvatureArrays<ResultType<T>> Arrays(std::size_t places)
  {
    for (auto& values : this->Results)
    {
      values.assign(places, -7);
    }
    this->Directions.assign(6 * places, -7);
    this->Type.assign(places, 99);
    this->Valid.assign(places, 99);
    auto& r = this->Results;
    return { r[0].data(), r[1].data(), r[2].data(), r[3].data(), r[4].data(), r[5].data(),
      this->Directions.data(), this->Directions.data() + 3 * places, this->Type.data(),
      this->Valid.data() };
  }

  void AtNodes(const HessianCurvatureOptions& options = {})
  {
    HessianCurvatureAtNodes(
      this->Grid, { { 0, 0, 0 }, this->Grid.Dimensions }, options, this->Arrays(this->Data.size()));
  }

  void AtPoints(
    const std::vector<std::array<double, 3>>& indices, const HessianCurvatureOptions& options = {})
  {
    HessianCurvatureAtPoints(
      this->Grid, static_cast<std::int64_t>(indices.size()),
      [&](std::int64_t first, std::int64_t count, std::array<double, 3>* out)
      { std::copy_n(indices.begin() + first, count, out); },
      options, this->Arrays(indices.size()));
  }

  double K(std::int64_t i) const { return this->Results[0][i]; }
  double H(std::int64_t i) const { return this->Results[1][i]; }
  double Maximum(std::int64_t i) const { return this->Results[2][i]; }
  double Minimum(std::int64_t i) const { return this->Results[3][i]; }

  std::vector<T> Data;
  GridView<const T> Grid;
  std::array<std::vector<ResultType<T>>, 6> Results;
  std::vector<ResultType<T>> Directions;
  std::vector<unsigned char> Type, Valid;
};

double Wavy(double x, double y, double z)
{
  return std::sin(1.3 * x + 0.2) * std::cos(0.9 * y) + std::sin(0.7 * z + 0.3 * x * y) + 0.1 * z;
}

HessianCurvatureOptions WithAccuracy(int accuracy)
{
  HessianCurvatureOptions options;
  options.Accuracy = accuracy;
  return options;
}

/// Random quadratic polynomials have exact differences: both routes get the same derivatives.
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

TEST(HessianCurvature, SameBitsOnAnyNumberOfThreads)
{
  for (const int accuracy : { 2, 4 })
  {
    ExpectSameOnAnyThreads<float>(accuracy);
    ExpectSameOnAnyThreads<double>(accuracy);
    ExpectSameOnAnyThreads<short>(accuracy);
  }
}

/// Whether everything is zero at place i.
template <typename T>
bool IsCleared(const Example<T>& example, std::size_t i)
{
  const std::size_t places = example.Valid.size();
  bool cleared = example.Valid[i] == 0 && example.Type[i] == 0;
  for (const auto& values : example.Results)
  {
    cleared = cleared && values[i] == 0;
  }
  for (std::size_t component = 0; component < 3; ++component)
  {
    cleared = cleared && example.Directions[3 * i + component] == 0 &&
      example.Directions[3 * places + 3 * i + component] == 0;
  }
  return cleared;
}

TEST(HessianCurvature, OuterLayersAreNotValid)
{
  for (const int accuracy : { 2, 4 })
  {
    Example<float> example({ 9, 8, 7 }, { 0.2, 0.2, 0.2 }, Wavy);
    example.AtNodes(WithAccuracy(accuracy));
    const int radius = StencilRadius(accuracy);
    for (std::int64_t i = 0; i < 9; ++i)
    {
      for (std::int64_t j = 0; j < 8; ++j)
      {
        for (std::int64_t k = 0; k < 7; ++k)
        {
          const bool inner = i >= radius && i < 9 - radius && j >= radius && j < 8 - radius &&
            k >= radius && k < 7 - radius;
          const auto id = static_cast<std::size_t>(example.Grid.Index(i, j, k));
          ASSERT_EQ(example.Valid[id] != 0, inner);
          ASSERT_TRUE(inner || IsCleared(example, id));
        }
      }
    }
  }
}

TEST(HessianCurvature, VanishingGradientsAreNotValid)
{
  Example<double> constant(
    { 5, 5, 5 }, { 0.1, 0.1, 0.1 }, [](double, double, double) { return 3.7; });
  constant.AtNodes();
  EXPECT_TRUE(IsCleared(constant, 62));

  const auto peak = [](double x, double y, double z)
  { return 1.0 - (x - 0.2) * (x - 0.2) - (y - 0.2) * (y - 0.2) - (z - 0.2) * (z - 0.2); };
  Example<double> critical({ 5, 5, 5 }, { 0.1, 0.1, 0.1 }, peak);
  critical.AtNodes();
  EXPECT_TRUE(IsCleared(critical, 62)) << "gradient zero to rounding at the peak";
  EXPECT_EQ(critical.Valid[63], 1) << "and not beside it";
  EXPECT_NEAR(critical.H(63), 10.0, 1e-9);

  Example<float> rounding(
    { 5, 5, 5 }, { 0.1, 0.1, 0.1 }, [](double x, double, double) { return 1000.0 + 1e-4 * x; });
  rounding.AtNodes();
  EXPECT_TRUE(IsCleared(rounding, 62)) << "a slope below the rounding of float";
}

TEST(HessianCurvature, NotANumberInTheStencilIsNotValid)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    Example<double> example({ 9, 9, 9 }, { 0.2, 0.2, 0.2 }, Wavy);
    example.Data[static_cast<std::size_t>(example.Grid.Index(4, 4, 4))] = bad;
    example.AtNodes();
    for (const auto& [i, j, k] : { Size{ 4, 4, 4 }, Size{ 5, 4, 4 }, Size{ 4, 3, 5 } })
    {
      EXPECT_TRUE(IsCleared(example, static_cast<std::size_t>(example.Grid.Index(i, j, k))));
    }
    EXPECT_EQ(example.Valid[static_cast<std::size_t>(example.Grid.Index(6, 4, 4))], 1);
    example.AtPoints({ { 4.3, 4.2, 3.9 }, { 1.5, 1.5, 1.5 } });
    EXPECT_TRUE(IsCleared(example, 0));
    EXPECT_EQ(example.Valid[1], 1);
  }
}

TEST(HessianCurvature, PointsOutsideAreNotValid)
{
  Example<float> example({ 9, 9, 9 }, { 0.2, 0.2, 0.2 }, Wavy);
  example.AtPoints({ { 4.0, 4.0, 4.0 }, { -1.0, 4.0, 4.0 }, { 4.0, 8.5, 4.0 }, { 4.0, 4.0, 0.5 },
    { std::numeric_limits<double>::quiet_NaN(), 4.0, 4.0 } });
  EXPECT_EQ(example.Valid[0], 1);
  for (std::size_t i = 1; i < 5; ++i)
  {
    EXPECT_TRUE(IsCleared(example, i)) << i;
  }
}

TEST(HessianCurvature, BoxesOfTheGrid)
{
  Example<float> whole({ 40, 12, 11 }, { 0.1, 0.2, 0.2 }, Wavy);
  whole.AtNodes();
  const NodeBox box{ { 5, 0, 3 }, { 20, 7, 8 } };
  Example<float> part = whole;
  part.Grid.Data = part.Data.data();
  HessianCurvatureAtNodes(part.Grid, box, {}, part.Arrays(20 * 7 * 8));
  for (std::int64_t k = 0; k < 8; ++k)
  {
    for (std::int64_t j = 0; j < 7; ++j)
    {
      for (std::int64_t i = 0; i < 20; ++i)
      {
        const std::int64_t a = i + 20 * (j + 7 * k);
        const std::int64_t b = whole.Grid.Index(i + 5, j, k + 3);
        ASSERT_EQ(part.Valid[a], whole.Valid[b]);
        ASSERT_FLOAT_EQ(part.Results[1][a], whole.Results[1][b]);
      }
    }
  }
}

TEST(HessianCurvature, WrongArgumentsAreRefused)
{
  Example<float> example({ 5, 5, 5 }, { 0.1, 0.1, 0.1 }, Wavy);
  EXPECT_THROW(example.AtNodes(WithAccuracy(3)), std::invalid_argument);
  EXPECT_THROW(
    HessianCurvatureAtNodes(example.Grid, { { 0, 0, 1 }, { 5, 5, 5 } }, {}, example.Arrays(125)),
    std::invalid_argument);
  example.Grid.Spacing[1] = 0.0;
  EXPECT_THROW(example.AtNodes(), std::invalid_argument);
  EXPECT_THROW(example.AtPoints({}), std::invalid_argument);
}

}
