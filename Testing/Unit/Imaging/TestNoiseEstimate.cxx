#include "Imaging/NoiseEstimate.h"

#include "DiffusionTestTools.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

TEST(NoiseEstimate, FindsTheNoiseUnderEdges)
{
  const auto grid = Grid<float>(48, 48, 48);
  for (const double noise : { 1e-6, 0.1, 1.0, 1e5 })
  {
    std::vector<float> values = Noise(grid, noise);
    for (std::int64_t n = 0; n < grid.Size(); ++n)
    {
      const bool inside = n % 48 > 10 && n % 48 < 20 && n / 48 % 48 > 10 && n / 48 % 48 < 30;
      values[static_cast<std::size_t>(n)] += inside ? static_cast<float>(20 * noise) : 0.0f;
    }
    const NoiseEstimate estimate = EstimateNoise(grid, values.data());
    EXPECT_NEAR(estimate.Noise / noise, 1.0, 0.05);
    EXPECT_NEAR(estimate.Deviation / Deviation(values), 1.0, 1e-3);
  }
}

TEST(NoiseEstimate, IsZeroWhereThereIsNone)
{
  const auto grid = Grid<double>(10, 10, 10);
  const std::vector<double> flat(1000, 5.0);
  EXPECT_EQ(EstimateNoise(grid, flat.data()).Noise, 0.0);
  EXPECT_NEAR(EstimateNoise(grid, flat.data()).Deviation, 0.0, 1e-6);
}

// 90 % of the nodes are one value, as where a map was masked: the median of all residuals is 0.
TEST(NoiseEstimate, LooksWithinTheMask)
{
  const auto grid = Grid<float>(48, 48, 48);
  std::vector<float> values = Noise(grid, 0.3);
  for (std::int64_t n = 0; n < grid.Size(); ++n)
  {
    const std::int64_t i = n % 48, j = n / 48 % 48, k = n / (48 * 48);
    if (i < 13 || i > 34 || j < 13 || j > 34 || k < 13 || k > 34)
    {
      values[static_cast<std::size_t>(n)] = 0.0f;
    }
    else
    {
      values[static_cast<std::size_t>(n)] +=
        static_cast<float>(std::sin(0.2 * static_cast<double>(i)));
    }
  }
  const NoiseEstimate estimate = EstimateNoise(grid, values.data());
  EXPECT_NEAR(estimate.Noise / 0.3, 1.0, 0.06);
  EXPECT_NEAR(estimate.Counted, std::pow(22.0 / 48.0, 3), 0.005);
  EXPECT_FALSE(estimate.FewValues);
}

TEST(NoiseEstimate, AMaskOrLabelsHaveNone)
{
  const auto grid = Grid<float>(20, 20, 20);
  std::vector<float> labels(8000);
  for (std::size_t n = 0; n < labels.size(); ++n)
  {
    labels[n] = static_cast<float>((n % 20 / 5) + (n / 20 % 20 / 3));
  }
  const NoiseEstimate estimate = EstimateNoise(grid, labels.data());
  EXPECT_EQ(estimate.Noise, 0.0);
  EXPECT_TRUE(estimate.FewValues);
}
