#include "NoiseEstimate.h"

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
