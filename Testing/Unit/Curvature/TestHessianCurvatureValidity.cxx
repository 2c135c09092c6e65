// The algorithm without VTK's data model at nodes without curvature, in boxes of the grid,
// and with wrong arguments.

#include "Curvature/FiniteDifference.h"
#include "Curvature/HessianCurvature.h"
#include "HessianExample.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

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
