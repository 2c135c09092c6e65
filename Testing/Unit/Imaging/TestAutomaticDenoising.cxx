// What is given back: long waves whole, short ones not, by the Gaussian's factor in between.

#include "DiffusionTestTools.h"
#include "Imaging/AutomaticDenoising.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// A Neumann mode along x: cos(pi m (i + 1/2) / n), an eigenvector of the discrete Laplacian.
std::vector<double> Wave(const DiffusionGrid<double>& grid, int m)
{
  std::vector<double> values;
  const double angle = std::acos(-1.0) * m / static_cast<double>(grid.Dimensions[0]);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    values.push_back(std::cos(angle * (static_cast<double>(node % grid.Dimensions[0]) + 0.5)));
  }
  return values;
}

}

TEST(ResidualSmoothing, EachWaveComesBackByTheGaussiansFactor)
{
  const auto grid = Grid<double>(96, 5, 4);
  const double deviation = 2.0, kept = 0.3;
  for (const int m : { 0, 2, 5, 10, 30 })
  {
    std::vector<double> input = Wave(grid, m), result = input;
    std::for_each(result.begin(), result.end(), [=](double& value) { value *= kept; });
    const std::vector<double> wave = input;
    AddSmoothedResidual<double>(grid, deviation, input.data(), result.data());
    const double symbol = 2.0 - 2.0 * std::cos(std::acos(-1.0) * m / 96.0);
    const double expected = kept + (1.0 - kept) * std::exp(-symbol * deviation * deviation / 2.0);
    for (std::size_t node = 0; node < wave.size(); ++node)
    {
      ASSERT_NEAR(result[node], expected * wave[node], 1e-2) << "wave " << m;
    }
  }
}

TEST(ResidualSmoothing, GivesTheInputsMeanBack)
{
  const auto grid = Grid<double>(20, 18, 16);
  std::vector<double> input = Noise(grid), result = Noise(grid, 1.0, 2);
  const double mean = Mean(input) + 3.0;
  std::for_each(input.begin(), input.end(), [](double& value) { value += 3.0; });
  AddSmoothedResidual<double>(grid, 1.5, input.data(), result.data());
  EXPECT_NEAR(Mean(result), mean, 1e-12);
}
