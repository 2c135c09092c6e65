// The choice by risk: its estimates compared with the truth, its result with a tuned Gaussian,
// noise of all kinds, the same bits on any number of threads.

#include "Core/Geometry.h"
#include "DiffusionTestTools.h"
#include "Imaging/ChebyshevFilter.h"
#include "Imaging/DenoiseMap.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace isthmus;
using namespace isthmus::testing;

TEST(DenoiseMapResult, StatesTheChoice)
{
  DenoiseMapResult result;
  EXPECT_EQ(result.Sentence(), "Nothing was changed.");
  result.Diffusion.Order = 2;
  result.Diffusion.Time = 0.05;
  result.Gain = 11.24;
  EXPECT_EQ(result.Sentence(), "Order 2, linear, time 0.05; estimated gain 11.2 dB");
  result.Diffusion.EdgeStopping = DiffusionParameters::EdgeStoppingType::Gaussian;
  EXPECT_NE(result.Sentence().find("edge stopping"), std::string::npos);
}

namespace
{

/// A ball, a ring and a fine lattice of density, between 0 and about 1.
std::vector<float> Phantom(const DiffusionGrid<float>& grid)
{
  std::vector<float> values;
  const double n = static_cast<double>(grid.Dimensions[0]);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const double x = double(node % grid.Dimensions[0]) - 0.35 * n;
    const double y = double(node / grid.Dimensions[0] % grid.Dimensions[1]) - 0.4 * n;
    const double z = double(node / (grid.Dimensions[0] * grid.Dimensions[1])) - 0.5 * n;
    const double ball = 1.0 / (1.0 + std::exp(std::hypot(x, y, z) - 0.15 * n));
    const double ring =
      1.0 / (1.0 + std::exp(std::hypot(std::hypot(x - 0.25 * n, y - 0.2 * n) - 0.18 * n, z) - 4.0));
    values.push_back(static_cast<float>(ball + ring));
  }
  return values;
}

std::vector<float> Sum(const std::vector<float>& a, const std::vector<float>& b)
{
  std::vector<float> sum(a.size());
  std::transform(a.begin(), a.end(), b.begin(), sum.begin(), std::plus<>());
  return sum;
}

double MeanSquare(const std::vector<float>& a, const std::vector<float>& b)
{
  return Distance(a, b) * Distance(a, b);
}

DenoiseMapResult Denoised(const DiffusionGrid<float>& grid, const DenoiseMapParameters& parameters,
  std::vector<float>& values)
{
  return DenoiseMap<float>(grid, parameters, values.data(), nullptr);
}

/// Without the errors of time steps if it is linear.
std::vector<float> DiffusedExactly(const DiffusionGrid<float>& grid,
  const DiffusionParameters& parameters, const std::vector<float>& values)
{
  if (parameters.EdgeStopping != DiffusionParameters::EdgeStoppingType::None)
  {
    return Diffused(grid, parameters, values);
  }
  const double bound = LaplacianBound<float>(grid.Spacing);
  const auto series = ChebyshevSeries([&](double s)
    { return std::exp(-parameters.Time * std::pow(s * bound, parameters.Order + 1)); },
    1e-7);
  std::vector<float> change(values.size());
  AddChebyshevSeries<float>(grid, { series }, values.data(), { change.data() }, {});
  return Sum(values, change);
}

/// White noise under a Gaussian of about `deviation` nodes, by heat flow.
std::vector<float> ColouredNoise(const DiffusionGrid<float>& grid, double level, double deviation)
{
  DiffusionParameters heat;
  heat.Order = 0;
  heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  heat.Time = deviation * deviation / 2.0;
  std::vector<float> noise = DiffusedExactly(grid, heat, Noise(grid));
  const auto scale = static_cast<float>(level / Deviation(noise));
  std::for_each(noise.begin(), noise.end(), [scale](float& value) { value *= scale; });
  return noise;
}

}

TEST(VolumeSample, BlocksForTheNoiseAreSpreadOverTheVolume)
{
  // Sides of a power of two: 16 blocks of 8^3 along each axis, of which an eighth is taken.
  const auto grid = Grid<float>(128, 128, 128);
  const std::vector<float> noise = Noise(grid, 0.01);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::vector<float> values = noise;
    const std::array<std::int64_t, 3> step{ 1, 128, 128 * 128 };
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(values.size()); ++n)
    {
      values[static_cast<std::size_t>(n)] += static_cast<float>(n / step[axis] % 128);
    }
    const VolumeSample sample = SampleVolume<float>(grid, values.data(), nullptr);
    std::vector<int> taken(16, 0);
    for (const std::vector<float>& block : sample.Small.Values)
    {
      const double first = block.front() * sample.Scale + sample.Offset;
      ++taken[static_cast<std::size_t>(std::lround(first)) / 8];
    }
    EXPECT_EQ(std::accumulate(taken.begin(), taken.end(), 0), 512);
    // 32 of each layer if they were spread perfectly.
    EXPECT_GT(*std::min_element(taken.begin(), taken.end()), 20) << axis;
    EXPECT_LT(*std::max_element(taken.begin(), taken.end()), 44) << axis;
  }
}

// Flat is a node that shares its value with three neighbours, as where a map was enlarged by
// repeating its nodes along three axes; along two axes the blocks still have noise.
TEST(VolumeSample, FlatBlocksAreNotUsedForTheNoise)
{
  const auto grid = Grid<float>(32, 32, 32);
  const std::vector<float> noise = Noise(grid, 1.0);
  for (int axes = 0; axes <= 3; ++axes)
  {
    std::vector<float> values;
    for (std::int64_t n = 0; n < grid.Size(); ++n)
    {
      Index3 at{ n % 32, n / 32 % 32, n / (32 * 32) };
      for (int axis = 0; axis < axes; ++axis)
      {
        at[static_cast<std::size_t>(axis)] &= ~std::int64_t{ 1 };
      }
      values.push_back(noise[static_cast<std::size_t>(at[0] + 32 * (at[1] + 32 * at[2]))]);
    }
    const VolumeSample sample = SampleVolume<float>(grid, values.data(), nullptr);
    EXPECT_EQ(sample.Small.Values.size(), axes < 3 ? 64U : 0U) << axes;
  }
}

TEST(VolumeSample, SixTilesOfALargeVolumeStandForAll)
{
  const auto grid = Grid<float>(70, 70, 70);
  const std::vector<float> noise = Noise(grid);
  const VolumeSample sample = SampleVolume<float>(grid, noise.data(), nullptr);
  ASSERT_EQ(sample.Trials.size(), 6u); // of 2^3 that are alike
  for (const TrialBlock& trial : sample.Trials)
  {
    EXPECT_EQ(trial.Inner.Size(), (Index3{ 35, 35, 35 }));
    EXPECT_EQ(trial.Box.Size(), (Index3{ 41, 41, 41 }));
    EXPECT_NEAR(trial.Weight * 6.0 * 35.0 * 35.0 * 35.0, 1.0, 0.2);
  }
}

TEST(DenoisingRisk, IsTheMeanSquaredErrorWithinItsStandardError)
{
  const auto grid = Grid<float>(40, 40, 40);
  const std::vector<float> truth = Phantom(grid), values = Sum(truth, Noise(grid, 0.2));
  const VolumeSample sample = SampleVolume<float>(grid, values.data(), nullptr);
  const NoiseSpectrum noise = WhiteNoise(0.2 / sample.Scale);
  std::vector<DiffusionParameters> all;
  for (const auto& [order, time] : { std::pair(0, 0.3), std::pair(1, 1.0), std::pair(3, 0.5) })
  {
    DiffusionParameters linear;
    linear.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
    linear.Order = order;
    linear.Time = time;
    all.push_back(linear);
  }
  DiffusionParameters edges;
  edges.Order = 1;
  edges.Sigma = 0.2 / sample.Scale;
  edges.PreSmoothing = 0.7;
  edges.Time = 0.3;
  all.push_back(edges);
  for (DiffusionParameters parameters : all)
  {
    const DenoisingChoice choice = EvaluateDenoising(sample, noise, grid.Spacing, parameters);
    parameters.Sigma *= sample.Scale;
    const double error = MeanSquare(DiffusedExactly(grid, parameters, values), truth);
    const double standard = 0.2 * 0.2 * std::sqrt(2.0 / 64000.0);
    EXPECT_NEAR(choice.Risk() * sample.Scale * sample.Scale, error, 3.0 * standard)
      << parameters.Order << ' ' << choice.IsLinear();
    EXPECT_LT(error, 0.5 * 0.04);
  }
}

TEST(DenoisingRisk, TheChoiceBeatsATunedGaussianAndKnowsItsGain)
{
  const auto grid = Grid<float>(40, 36, 36);
  const std::vector<float> truth = Phantom(grid);
  for (const double level : { 0.05, 0.3 })
  {
    const std::vector<float> values = Sum(truth, Noise(grid, level, 7));
    double gaussian = 1.0;
    for (double time = 0.1; time < 6.0; time *= 1.5)
    {
      DiffusionParameters heat;
      heat.Order = 0;
      heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
      heat.Time = time;
      gaussian = std::min(gaussian, MeanSquare(DiffusedExactly(grid, heat, values), truth));
    }
    for (const DenoisingGoal goal : { DenoisingGoal::Surfaces, DenoisingGoal::Volumes })
    {
      DenoiseMapParameters parameters;
      parameters.Goal = goal;
      parameters.KnownNoise = level;
      std::vector<float> known = values, estimated = values;
      const DenoiseMapResult result = Denoised(grid, parameters, known);
      parameters.KnownNoise = 0.0;
      const DenoiseMapResult unknown = Denoised(grid, parameters, estimated);
      const double error = MeanSquare(known, truth);
      const double gain = 10.0 * std::log10(MeanSquare(values, truth) / error);
      EXPECT_LT(error, goal == DenoisingGoal::Volumes ? 0.85 * gaussian : gaussian);
      EXPECT_NEAR(result.Gain, gain, std::max(0.3, 3.0 * result.GainError)) << result.Sentence();
      EXPECT_NEAR(unknown.NoiseLevel / level, 1.0, 0.06);
      EXPECT_TRUE(unknown.White);
      EXPECT_LT(MeanSquare(estimated, truth), 1.25 * error);
      if (goal == DenoisingGoal::Surfaces)
      {
        EXPECT_EQ(result.Diffusion.EdgeStopping, DiffusionParameters::EdgeStoppingType::None);
      }
      const auto least = std::min_element(result.RiskValue.begin(), result.RiskValue.end());
      const auto at = static_cast<std::size_t>(least - result.RiskValue.begin());
      EXPECT_NEAR(result.RiskTime.at(at) / result.Diffusion.Time, 1.0, 1e-9);
    }
  }
}

// A ball of atoms that are hardly wider than a voxel, which presmoothing by 0.7 voxels hides.
TEST(DenoisingRisk, KeepsAtomsNearlyAsWellAsItsFamilyCan)
{
  const auto grid = Grid<float>(36, 36, 36);
  std::vector<float> truth;
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::array<std::int64_t, 3> at{ node % 36, node / 36 % 36, node / (36 * 36) };
    double toAtom = 0.0, toCenter = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t cell = at[0] / 4 + 3 * (at[1] / 4) + 7 * (at[2] / 4);
      const double shift = 0.6 * std::sin(double(cell) + 2.0 * double(a));
      toAtom += std::pow(double(at[a] % 4) - 1.5 - shift, 2);
      toCenter += std::pow(double(at[a]) - 18.0, 2);
    }
    truth.push_back(
      toCenter < 13.0 * 13.0 ? static_cast<float>(std::exp(-toAtom / (2.0 * 0.56 * 0.56))) : 0.0f);
  }
  const double level = 0.15;
  const std::vector<float> values = Sum(truth, Noise(grid, level, 7));
  double best = 1.0;
  for (const double smoothing : { 0.0, 0.35, 0.7 })
  {
    for (const double sigma : { 0.5, 1.0, 2.0 })
    {
      for (const double time : { 1.0, 2.0, 4.0 })
      {
        DiffusionParameters parameters;
        parameters.Order = 0;
        parameters.EdgeStopping = DiffusionParameters::EdgeStoppingType::Gaussian;
        parameters.PreSmoothing = smoothing;
        parameters.Sigma = sigma * level;
        parameters.Time = time;
        best = std::min(best, MeanSquare(Diffused(grid, parameters, values), truth));
      }
    }
  }
  DenoiseMapParameters parameters;
  parameters.Goal = DenoisingGoal::Volumes;
  std::vector<float> result = values;
  Denoised(grid, parameters, result);
  EXPECT_LT(MeanSquare(result, truth), 1.07 * best); // 0.3 dB
}

namespace
{

/// The gradient at a node, by central differences.
Point3 GradientAt(const DiffusionGrid<float>& grid, const std::vector<float>& f, std::int64_t node)
{
  const auto& n = grid.Dimensions;
  const std::array<std::int64_t, 3> step{ 1, n[0], n[0] * n[1] };
  Point3 g;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto after = static_cast<std::size_t>(node + step[a]);
    const auto before = static_cast<std::size_t>(node - step[a]);
    g[a] = 0.5 * (static_cast<double>(f[after]) - static_cast<double>(f[before]));
  }
  return g;
}

/// Curvature of the level set at a node: the divergence of the unit gradient.
double CurvatureAt(const DiffusionGrid<float>& grid, const std::vector<float>& f, std::int64_t node)
{
  const auto& n = grid.Dimensions;
  const std::array<std::int64_t, 3> step{ 1, n[0], n[0] * n[1] };
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const Point3 after = GradientAt(grid, f, node + step[a]);
    const Point3 before = GradientAt(grid, f, node - step[a]);
    sum += 0.5 * (after[a] / Length(after) - before[a] / Length(before));
  }
  return sum;
}

/// Mean squared error of curvature times gradient where the gradient of `truth` is large.
double CurvatureError(const DiffusionGrid<float>& grid, const std::vector<float>& values,
  const std::vector<float>& truth)
{
  const auto& n = grid.Dimensions;
  double sum = 0.0;
  for (std::int64_t k = 2; k + 2 < n[2]; ++k)
  {
    for (std::int64_t j = 2; j + 2 < n[1]; ++j)
    {
      for (std::int64_t i = 2; i + 2 < n[0]; ++i)
      {
        const std::int64_t node = i + n[0] * (j + n[1] * k);
        const double gradient = Length(GradientAt(grid, truth, node));
        if (gradient > 0.1)
        {
          const double error = CurvatureAt(grid, values, node) - CurvatureAt(grid, truth, node);
          sum += gradient * gradient * error * error;
        }
      }
    }
  }
  return sum;
}

}

TEST(DenoisingRisk, SurfacesHaveNearlyTheLeastErrorOfCurvatureWithinADecibelOfTheValues)
{
  const auto grid = Grid<float>(32, 32, 32);
  const std::vector<float> truth = Phantom(grid), values = Sum(truth, Noise(grid, 0.2));
  const VolumeSample sample = SampleVolume<float>(grid, values.data(), nullptr);
  const DenoisingChoice choice =
    ChooseDenoising(sample, WhiteNoise(0.2 / sample.Scale), grid.Spacing, {});
  std::vector<std::array<double, 2>> errors; // of values and of curvature
  DiffusionParameters linear = choice.Parameters;
  for (linear.Order = 0; linear.Order < 4; ++linear.Order)
  {
    for (double length = 0.5; length < 2.5; length *= 1.3)
    {
      linear.Time = std::pow(length, 2 * linear.Order + 2);
      const std::vector<float> result = DiffusedExactly(grid, linear, values);
      errors.push_back({ MeanSquare(result, truth), CurvatureError(grid, result, truth) });
    }
  }
  const double mostOfValues = 1.26 * std::min_element(errors.begin(), errors.end())->at(0);
  double least = HUGE_VAL;
  for (const auto& [ofValues, ofCurvature] : errors)
  {
    least = ofValues < mostOfValues ? std::min(least, ofCurvature) : least;
  }
  const std::vector<float> result = DiffusedExactly(grid, choice.Parameters, values);
  EXPECT_LT(MeanSquare(result, truth), 1.1 * mostOfValues);
  EXPECT_LT(CurvatureError(grid, result, truth), 1.2 * least);
}

TEST(DenoisingRisk, SurfacesAreJudgedByTheirValuesWhereTheyHaveNoCurvature)
{
  // In two layers no node has all its neighbours.
  const auto grid = Grid<float>(40, 36, 2);
  const std::vector<float> values = Sum(ColouredNoise(grid, 1.0, 3.0), Noise(grid, 0.2));
  const VolumeSample sample = SampleVolume<float>(grid, values.data(), nullptr);
  const NoiseSpectrum noise = WhiteNoise(0.2 / sample.Scale);
  DenoisingSearch linear;
  linear.Goal = DenoisingGoal::Volumes;
  linear.LinearOnly = true;
  const DenoisingChoice ofValues = ChooseDenoising(sample, noise, grid.Spacing, linear);
  const DenoisingChoice ofSurfaces = ChooseDenoising(sample, noise, grid.Spacing, {});
  EXPECT_EQ(ofSurfaces.Parameters.Order, ofValues.Parameters.Order);
  EXPECT_EQ(ofSurfaces.Parameters.Time, ofValues.Parameters.Time);
  EXPECT_EQ(ofSurfaces.RiskValue, ofValues.RiskValue);
}

TEST(DenoisingRisk, MeasuresColouredNoiseInTheBackground)
{
  const auto grid = Grid<float>(64, 64, 64);
  const std::vector<float> truth = Phantom(grid);
  std::vector<float> values = Sum(truth, ColouredNoise(grid, 0.1, 1.0));
  const double before = MeanSquare(values, truth);
  const DenoiseMapResult result = Denoised(grid, {}, values);
  EXPECT_FALSE(result.White);
  EXPECT_NEAR(result.NoiseLevel / 0.1, 1.0, 0.15);
  EXPECT_LT(MeanSquare(values, truth), 0.5 * before);
}

TEST(DenoisingRisk, LeavesTheConstantBackgroundOfAMask)
{
  const auto grid = Grid<float>(48, 48, 48);
  std::vector<float> values = Sum(Phantom(grid), Noise(grid, 0.2));
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    values[n] = n % 48 < 16 ? -1.0f : values[n];
  }
  std::vector<float> result = values;
  EXPECT_GT(Denoised(grid, {}, result).Gain, 3.0);
  EXPECT_NEAR(Mean(result), Mean(values), 1e-6);
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    if (n % 48 < 16)
    {
      ASSERT_EQ(result[n], -1.0f);
    }
  }
}

TEST(DenoisingRisk, GivesTheSameBitsOnAnyNumberOfThreads)
{
  // The first has more than one trial block.
  for (const auto& [grid, goal] : { std::pair(Grid<float>(80, 72, 56), DenoisingGoal::Surfaces),
         std::pair(Grid<float>(24, 22, 20), DenoisingGoal::Volumes) })
  {
    const std::vector<float> values = Sum(Phantom(grid), Noise(grid, 0.3));
    DenoiseMapParameters parameters;
    parameters.Goal = goal;
    std::array<std::vector<float>, 2> results{ values, values };
    std::array<DenoiseMapResult, 2> told;
    for (const std::size_t n : { 0, 1 })
    {
      const int threads = n == 0 ? 1 : 3;
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
        [&, grid = grid]() { told[n] = Denoised(grid, parameters, results[n]); });
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(told[0].Gain, told[1].Gain);
    EXPECT_EQ(told[0].RiskValue, told[1].RiskValue);
  }
}

TEST(DenoisingRisk, StrongerMeansSmoother)
{
  const auto grid = Grid<float>(32, 32, 32);
  const std::vector<float> values = Sum(Phantom(grid), Noise(grid, 0.3));
  double last = Deviation(values);
  for (const double strength : { 0.0, 0.5, 1.0 })
  {
    DenoiseMapParameters parameters;
    parameters.Strength = strength;
    std::vector<float> result = values;
    Denoised(grid, parameters, result);
    EXPECT_LT(Deviation(result), last);
    last = Deviation(result);
  }
}
