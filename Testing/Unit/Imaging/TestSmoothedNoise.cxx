// Noise smoothed by a Gaussian: its length and its variance, alone and under signal; textures and
// clean densities are not mistaken for it.

#include "DiffusionTestTools.h"
#include "Imaging/SmoothedNoise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr std::int64_t side = 64;

/// Convolves with a Gaussian of `width` nodes along an axis, periodically.
void SmoothAxis(std::vector<double>& values, std::size_t axis, double width)
{
  const auto radius = static_cast<std::int64_t>(std::ceil(6.0 * width));
  const std::array<std::int64_t, 3> steps{ 1, side, side * side };
  const std::int64_t step = steps.at(axis);
  const std::vector<double> before = values;
  for (std::int64_t n = 0; n < side * side * side; ++n)
  {
    const std::int64_t at = n / step % side;
    double sum = 0.0;
    for (std::int64_t d = -radius; d <= radius; ++d)
    {
      const std::int64_t other = n + ((at + d + 2 * side) % side - at) * step;
      sum += before[static_cast<std::size_t>(other)] *
        std::exp(-static_cast<double>(d * d) / (2.0 * width * width));
    }
    values[static_cast<std::size_t>(n)] = sum;
  }
}

/// White noise under a Gaussian of these widths in nodes, of standard deviation 1.
std::vector<double> Smoothed(const std::array<double, 3>& widths, unsigned seed)
{
  std::vector<double> values = Noise(Grid<double>(side, side, side), 1.0, seed);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    SmoothAxis(values, axis, widths.at(axis));
  }
  const double deviation = Deviation(values);
  std::for_each(values.begin(), values.end(), [=](double& value) { value /= deviation; });
  return values;
}

/// A value for each node from its place.
template <typename Function>
std::vector<double> Volume(Function&& function)
{
  std::vector<double> values;
  for (std::int64_t n = 0; n < side * side * side; ++n)
  {
    values.push_back(function(static_cast<double>(n % side), static_cast<double>(n / side % side),
      static_cast<double>(n / (side * side))));
  }
  return values;
}

/// 40 Gaussians of 3 to 5 nodes at random places, of about the variance 1.
std::vector<double> Blobs()
{
  std::mt19937 bits(3);
  auto uniform = [&bits](double low, double high)
  { return low + (high - low) * static_cast<double>(bits()) / 4294967296.0; };
  std::vector<double> values(static_cast<std::size_t>(side * side * side), 0.0);
  for (int blob = 0; blob < 40; ++blob)
  {
    const double x = uniform(8, 56), y = uniform(8, 56), z = uniform(8, 56), w = uniform(3, 5);
    const std::vector<double> one = Volume(
      [=](double i, double j, double k) {
        return std::exp(-((i - x) * (i - x) + (j - y) * (j - y) + (k - z) * (k - z)) / (2 * w * w));
      });
    std::transform(values.begin(), values.end(), one.begin(), values.begin(), std::plus<>());
  }
  const double deviation = Deviation(values);
  std::for_each(values.begin(), values.end(), [=](double& value) { value /= deviation; });
  return values;
}

std::vector<double> Sum(std::vector<double> a, const std::vector<double>& b, double factor)
{
  std::transform(
    a.begin(), a.end(), b.begin(), a.begin(), [=](double x, double y) { return x + factor * y; });
  return a;
}

SmoothedNoise Found(const std::vector<double>& values, std::int64_t blockSide = 16,
  const std::array<double, 3>& spacing = { 1.0, 1.0, 1.0 })
{
  NoiseBlocks blocks;
  blocks.Size = { blockSide, blockSide, blockSide };
  const std::int64_t parts = side / blockSide;
  for (std::int64_t block = 0; block < parts * parts * parts; ++block)
  {
    const std::array<std::int64_t, 3> begin{ block % parts * blockSide,
      block / parts % parts * blockSide, block / (parts * parts) * blockSide };
    std::vector<float> part;
    for (std::int64_t n = 0; n < blockSide * blockSide * blockSide; ++n)
    {
      const std::int64_t i = begin[0] + n % blockSide, j = begin[1] + n / blockSide % blockSide,
                         k = begin[2] + n / (blockSide * blockSide);
      part.push_back(
        static_cast<float>(values[static_cast<std::size_t>(i + side * (j + side * k))]));
    }
    blocks.Values.push_back(part);
  }
  const double deviation = Deviation(values);
  return FindSmoothedNoise(TransformBlocks(blocks, spacing), spacing, deviation * deviation);
}

}

// Noise that fills a volume is refused, since it might be a texture, so it is added to a few strong
// waves of the whole volume.
TEST(SmoothedNoise, HasItsLengthAndVariance)
{
  const std::vector<double> wave =
    Volume([](double x, double y, double) { return std::cos(0.05 * x) + std::cos(0.05 * y); });
  // 64 blocks: the lower quartile of a bin's power is known to about 3 %.
  for (const double length : { 1.0, 1.5, 2.0, 2.5 })
  {
    const SmoothedNoise noise = Found(Sum(Smoothed({ length, length, length }, 5), wave, 1.0));
    ASSERT_TRUE(noise.Found) << length;
    EXPECT_NEAR(noise.Length / length, 1.0, 0.04) << length;
    EXPECT_NEAR(noise.Variance, 1.0, 0.15) << length;
    EXPECT_GT(noise.Share, 0.5) << length;
  }
}

TEST(SmoothedNoise, HasTheDensityOfAGaussian)
{
  const std::vector<double> wave =
    Volume([](double x, double y, double) { return std::cos(0.05 * x) + std::cos(0.05 * y); });
  const double length = 1.2;
  const SmoothedNoise noise = Found(Sum(Smoothed({ length, length, length }, 6), wave, 1.0));
  ASSERT_TRUE(noise.Found);
  // Along an axis s = 4 sin^2(omega / 2) / 12; A = (2 sqrt(pi) length)^3 for a variance of 1.
  const double level = std::pow(2.0 * std::sqrt(std::acos(-1.0)) * length, 3);
  for (const std::size_t bin : { 2, 5, 8 })
  {
    const double s = std::pow((static_cast<double>(bin) + 0.5) / double(waveBins), 2);
    // In an isotropic mean, |omega|^2 is a little above 12 s.
    const double least = level * std::exp(-length * length * 12.0 * s * (1.0 + s));
    const double most = level * std::exp(-length * length * 12.0 * s);
    EXPECT_GT(noise.Density.at(bin), 0.75 * least) << bin;
    EXPECT_LT(noise.Density.at(bin), 1.25 * most) << bin;
  }
}

TEST(SmoothedNoise, IsFoundUnderSignal)
{
  const std::vector<double> blobs = Blobs();
  for (const double length : { 1.0, 1.5 })
  {
    for (const double level : { 0.1, 0.3, 1.0 })
    {
      const SmoothedNoise noise = Found(Sum(blobs, Smoothed({ length, length, length }, 7), level));
      ASSERT_TRUE(noise.Found) << length << " " << level;
      EXPECT_NEAR(noise.Length / length, 1.0, 0.06) << length << " " << level;
      EXPECT_NEAR(std::sqrt(noise.Variance) / level, 1.0, 0.2) << length << " " << level;
    }
  }
}

TEST(SmoothedNoise, HasALengthInTheUnitOfTheSpacing)
{
  const std::vector<double> noise = Sum(Blobs(), Smoothed({ 1.5, 1.5, 0.75 }, 8), 0.5);
  const SmoothedNoise found = Found(noise, 16, { 2.0, 2.0, 4.0 });
  ASSERT_TRUE(found.Found);
  EXPECT_NEAR(found.Length / 3.0, 1.0, 0.06);
  EXPECT_NEAR(std::sqrt(found.Variance) / 0.5, 1.0, 0.2);
}

TEST(SmoothedNoise, IsFoundInSmallBlocks)
{
  const SmoothedNoise noise = Found(Sum(Blobs(), Smoothed({ 1.0, 1.0, 1.0 }, 9), 0.5), 8);
  ASSERT_TRUE(noise.Found);
  EXPECT_NEAR(noise.Length, 1.0, 0.06);
  EXPECT_NEAR(std::sqrt(noise.Variance) / 0.5, 1.0, 0.2);
}

TEST(SmoothedNoise, IsNotSeenInSignal)
{
  EXPECT_FALSE(Found(Blobs()).Found);
  EXPECT_FALSE(Found(Blobs(), 8).Found);
  const double pitch = 2.0 * std::acos(-1.0) / 24.0;
  EXPECT_FALSE(Found(
    Volume(
      [=](double x, double y, double z)
      {
        return std::tanh(2.0 *
          (std::sin(pitch * x) * std::cos(pitch * y) + std::sin(pitch * y) * std::cos(pitch * z) +
            std::sin(pitch * z) * std::cos(pitch * x)));
      })).Found);
}

// The volume is nothing but smooth noise: a texture may look the same.
TEST(SmoothedNoise, IsNotTheWholeVolume)
{
  EXPECT_FALSE(Found(Smoothed({ 1.0, 1.0, 1.0 }, 10)).Found);
}

TEST(SmoothedNoise, IsNotFoundInAFewBlocks)
{
  NoiseBlocks blocks;
  blocks.Size = { 16, 16, 16 };
  const std::vector<double> noise = Smoothed({ 1.0, 1.0, 1.0 }, 11);
  blocks.Values.assign(15, std::vector<float>(noise.begin(), noise.begin() + 4096));
  const std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  EXPECT_FALSE(FindSmoothedNoise(TransformBlocks(blocks, spacing), spacing, 10.0).Found);
  EXPECT_FALSE(FindSmoothedNoise({}, spacing, 1.0).Found);
}
