// The equations themselves: compared with a plain reference, by Fourier modes, by invariants.
// Residual smoothing: long waves are those of the input again, short ones are not.

#include "DiffusionReference.h"
#include "DiffusionTestTools.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Edge = DiffusionParameters::EdgeStoppingType;
using Flow = DiffusionParameters::FlowType;
using Integrator = DiffusionParameters::IntegratorType;

/// One explicit step of half the limit's length.
DiffusionParameters OneEulerStep(DiffusionParameters parameters, const std::array<double, 3>& h)
{
  parameters.Integrator = Integrator::ForwardEuler;
  parameters.Steps = 1;
  parameters.Time = 0.5 * ExplicitStepLimit(parameters, h);
  return parameters;
}

void ExpectOneStepAsReference(const DiffusionParameters& parameters)
{
  DiffusionGrid<double> grid = Grid<double>(11, 9, 7);
  grid.Spacing = { 1.0, 1.3, 0.8 };
  const std::vector<double> input = Noise(grid);
  const DiffusionParameters step = OneEulerStep(parameters, grid.Spacing);
  const std::vector<double> result = Diffused(grid, step, input);
  const ReferenceVolume rate = ReferenceRate({ grid, input }, parameters);
  double scale = 0.0;
  for (std::size_t n = 0; n < input.size(); ++n)
  {
    scale = std::max(scale, std::abs(step.Time * rate.Values[n]));
  }
  for (std::size_t n = 0; n < input.size(); ++n)
  {
    ASSERT_NEAR(result[n] - input[n], step.Time * rate.Values[n], 1e-11 * scale) << "node " << n;
  }
}

/// Neumann's modes cos(pi m (i + 1/2) / n) are exact eigenvectors of the discrete operators.
struct Mode
{
  std::vector<double> Values;
  double Symbol; ///< of -L
};

Mode NeumannMode(const DiffusionGrid<double>& grid, const std::array<int, 3>& wave)
{
  Mode mode{ std::vector<double>(static_cast<std::size_t>(grid.Size()), 1.0), 0.0 };
  const auto& n = grid.Dimensions;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double angle = std::acos(-1.0) * wave[axis] / static_cast<double>(n[axis]);
    mode.Symbol += (2 - 2 * std::cos(angle)) / (grid.Spacing[axis] * grid.Spacing[axis]);
    for (std::int64_t node = 0; node < grid.Size(); ++node)
    {
      const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / n[0] / n[1] };
      mode.Values[static_cast<std::size_t>(node)] *=
        std::cos(angle * (static_cast<double>(at[axis]) + 0.5));
    }
  }
  return mode;
}

/// The factor by which the mode was multiplied; fails if it is no longer the same mode.
double Decay(const std::vector<double>& after, const std::vector<double>& before)
{
  const double factor = std::inner_product(after.begin(), after.end(), before.begin(), 0.0) /
    std::inner_product(before.begin(), before.end(), before.begin(), 0.0);
  for (std::size_t n = 0; n < after.size(); ++n)
  {
    EXPECT_NEAR(after[n], factor * before[n], 1e-9);
  }
  return factor;
}

}

TEST(HighOrderDiffusion, OneStepIsTheEquation)
{
  for (int order = 0; order <= 3; ++order)
  {
    for (const Edge edge : { Edge::None, Edge::Gaussian, Edge::LocalVariance })
    {
      for (const bool lower : { false, true })
      {
        SCOPED_TRACE(::testing::Message() << "order " << order << " edge stopping "
                                          << static_cast<int>(edge) << " lower orders " << lower);
        DiffusionParameters parameters;
        parameters.Order = order;
        parameters.EdgeStopping = edge;
        parameters.LowerOrders = lower;
        parameters.Sigma = 0.7;
        parameters.Diffusivity = { 0.5, 0.3, 0.2, 0.1 };
        ExpectOneStepAsReference(parameters);
      }
    }
    DiffusionParameters geometric;
    geometric.Flow = Flow::GeometricFlow;
    geometric.Order = order;
    geometric.Sigma = 1.5;
    SCOPED_TRACE(::testing::Message() << "geometric flow of order " << order);
    ExpectOneStepAsReference(geometric);
  }
}

TEST(HighOrderDiffusion, FidelityAndSourceAddTheirRates)
{
  const auto grid = Grid<double>(6, 5, 4);
  std::vector<double> values = Noise(grid), input = Noise(grid, 1.0, 2),
                      source = Noise(grid, 1.0, 3);
  DiffusionParameters parameters;
  parameters.EdgeStopping = Edge::None;
  const DiffusionParameters plain = OneEulerStep(parameters, grid.Spacing);
  const std::vector<double> without = Diffused(grid, plain, values);
  DiffusionParameters with = plain;
  with.Fidelity = 0.4;
  std::vector<double> result = values;
  Diffuse<double>(grid, with, result.data(), input.data(), source.data());
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    const double rate = 0.4 * (input[n] - values[n]) + source[n];
    EXPECT_NEAR(result[n], without[n] + plain.Time * rate, 1e-13);
  }
}

TEST(HighOrderDiffusion, FourierModesDecayBySymbol)
{
  DiffusionGrid<double> grid = Grid<double>(16, 12, 10);
  grid.Spacing = { 1.0, 1.2, 1.5 };
  for (int order = 0; order <= 3; ++order)
  {
    for (const auto& wave :
      std::vector<std::array<int, 3>>{ { 2, 0, 0 }, { 2, 3, 1 }, { 5, 4, 6 } })
    {
      const Mode mode = NeumannMode(grid, wave);
      DiffusionParameters parameters;
      parameters.EdgeStopping = Edge::None;
      parameters.Order = order;
      const double rate = std::pow(mode.Symbol, order + 1);
      parameters.Time = 1.0 / rate;
      // Modes that decay within a few explicit steps' time need more than the automatic steps.
      parameters.Steps =
        parameters.Time < 100 * ExplicitStepLimit(parameters, grid.Spacing) ? 16 : 0;
      const double decay = Decay(Diffused(grid, parameters, mode.Values), mode.Values);
      EXPECT_NEAR(-std::log(decay), 1.0, 1e-3) << "order " << order << " rate " << rate;
    }
  }
}

namespace
{

/// Order in time between `few` and four times as many super steps.
double TimeOrder(const DiffusionParameters& start, const DiffusionGrid<double>& grid,
  const std::vector<double>& values, int few)
{
  auto solution = [&](int steps)
  {
    DiffusionParameters parameters = start;
    parameters.Steps = steps;
    return Diffused(grid, parameters, values);
  };
  const std::vector<double> exact = solution(16 * few);
  return std::log(Distance(solution(few), exact) / Distance(solution(4 * few), exact)) /
    std::log(4.0);
}

}

TEST(HighOrderDiffusion, TimeOrderIsTwo)
{
  const auto grid = Grid<double>(14, 12, 10);
  std::vector<double> start = NeumannMode(grid, { 2, 1, 1 }).Values;
  const std::vector<double> other = NeumannMode(grid, { 1, 3, 2 }).Values;
  std::transform(start.begin(), start.end(), other.begin(), start.begin(), std::plus<double>());
  for (int order = 0; order <= 3; ++order)
  {
    DiffusionParameters parameters;
    parameters.Order = order;
    parameters.Sigma = 0.3;
    parameters.Time = 0.4 * std::min(12.0, std::pow(3.0, order + 1));
    parameters.EdgeStopping = Edge::None;
    const int few = order < 3 ? 8 : 16; // q = 3 can't take longer steps
    const double constant = TimeOrder(parameters, grid, start, few);
    parameters.EdgeStopping = Edge::Gaussian;
    const double changing = TimeOrder(parameters, grid, start, 2 * few);
    std::printf("q = %d: time order %.2f, with edge stopping %.2f\n", order, constant, changing);
    EXPECT_GT(constant, 1.9);
    EXPECT_GT(changing, 1.9);
  }
}

TEST(HighOrderDiffusion, TimeOrderIsTwoUnderPreSmoothing)
{
  const auto grid = Grid<double>(7, 6, 5);
  std::vector<double> start = NeumannMode(grid, { 2, 1, 1 }).Values;
  const std::vector<double> other = NeumannMode(grid, { 1, 3, 2 }).Values;
  std::transform(start.begin(), start.end(), other.begin(), start.begin(), std::plus<double>());
  for (const Edge edge : { Edge::Gaussian, Edge::LocalVariance })
  {
    DiffusionParameters parameters;
    parameters.Order = 0;
    parameters.Sigma = 0.3;
    parameters.Time = 1.2;
    parameters.EdgeStopping = edge;
    parameters.Window = 3;
    parameters.PreSmoothing = 0.8;
    EXPECT_GT(TimeOrder(parameters, grid, start, 8), 1.8) << static_cast<int>(edge);
  }
}

TEST(HighOrderDiffusion, EvaluationsAreThoseOfTheStages)
{
  // s stages are as long as (s^2 + s - 2) / 4 explicit steps; those of the first order, as (s^2 +
  // s) / 2. Odd numbers of stages, three and one at least.
  const auto grid = Grid<double>(6, 5, 4);
  DiffusionParameters parameters;
  parameters.Order = 0;
  parameters.Sigma = 1.0;
  parameters.Steps = 1;
  const double limit = ExplicitStepLimit(parameters, grid.Spacing);
  const struct
  {
    double Length; ///< in explicit steps
    int Stages, Ahead;
  } cases[] = { { 0.5, 3, 1 }, { 1.99, 3, 1 }, { 2.49, 3, 3 }, { 2.51, 5, 3 }, { 6.99, 5, 3 },
    { 7.01, 7, 3 }, { 11.99, 7, 3 }, { 12.01, 7, 5 } };
  for (const auto& step : cases)
  {
    parameters.Time = step.Length * limit;
    DiffusionReport report;
    parameters.EdgeStopping = Edge::None;
    Diffused(grid, parameters, Noise(grid), &report);
    EXPECT_EQ(report.Evaluations, step.Stages) << step.Length;
    parameters.EdgeStopping = Edge::Gaussian;
    Diffused(grid, parameters, Noise(grid), &report);
    EXPECT_EQ(report.Evaluations, step.Stages + step.Ahead + 1) << step.Length; // the coefficient
  }
}

TEST(HighOrderDiffusion, HaloHoldsTheWindowAtTheEndsAndTheGradient)
{
  DiffusionParameters parameters;
  parameters.Order = 0;
  EXPECT_GE(HaloWidth(parameters), 2); // of the gradients at the faces
  EXPECT_LE(HaloWidth(parameters), 4);
  parameters.EdgeStopping = Edge::LocalVariance;
  for (const int window : { 5, 7, 11 })
  {
    // A whole window lies to one side of a node at the image's end; gradients need one more.
    parameters.Window = window;
    EXPECT_EQ(HaloWidth(parameters), window + 1);
  }
}

TEST(HighOrderDiffusion, MeanIsKept)
{
  const auto grid = Grid<float>(40, 31, 22);
  std::vector<float> start = Noise(grid);
  std::for_each(start.begin(), start.end(), [](float& value) { value += 3.0f; });
  for (int order = 0; order <= 3; ++order)
  {
    for (const Edge edge : { Edge::None, Edge::Gaussian, Edge::LocalVariance })
    {
      DiffusionParameters parameters;
      parameters.Order = order;
      parameters.EdgeStopping = edge;
      parameters.Sigma = 1.0;
      parameters.Time = 2.0;
      EXPECT_NEAR(Mean(Diffused(grid, parameters, start)) / Mean(start), 1.0, 1e-6);
    }
  }
}

namespace
{

/// Every flow and coefficient.
std::vector<DiffusionParameters> AllCoefficients(int order)
{
  std::vector<DiffusionParameters> all(4);
  all[0].EdgeStopping = Edge::None;
  all[1].EdgeStopping = Edge::Gaussian;
  all[2].EdgeStopping = Edge::LocalVariance;
  all[3].Flow = Flow::GeometricFlow;
  for (DiffusionParameters& parameters : all)
  {
    parameters.Order = order;
    parameters.Sigma = 1.0;
  }
  return all;
}

/// Slopes that binary fractions hold exactly, along all axes.
std::vector<double> LinearField(const DiffusionGrid<double>& grid)
{
  std::vector<double> values;
  const auto& n = grid.Dimensions;
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    values.push_back(0.25 * static_cast<double>(node % n[0]) -
      0.5 * static_cast<double>(node / n[0] % n[1]) +
      0.125 * static_cast<double>(node / (n[0] * n[1])));
  }
  return values;
}

/// The number of nodes from the boundary within which the two fields differ at all.
std::int64_t LayersChanged(const DiffusionGrid<double>& grid, const std::vector<double>& before,
  const std::vector<double>& after)
{
  const auto& n = grid.Dimensions;
  std::int64_t layers = 0;
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
    std::int64_t depth = n[0];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      depth = std::min({ depth, at[axis], n[axis] - 1 - at[axis] });
    }
    const auto index = static_cast<std::size_t>(node);
    layers = before[index] == after[index] ? layers : std::max(layers, depth + 1);
  }
  return layers;
}

}

TEST(HighOrderDiffusion, ConstantsStay)
{
  const auto grid = Grid<double>(20, 20, 20);
  const std::vector<double> constant(static_cast<std::size_t>(grid.Size()), 1.0 / 3.0);
  for (int order = 0; order <= 3; ++order)
  {
    for (DiffusionParameters parameters : AllCoefficients(order))
    {
      parameters.Time = 0.5;
      EXPECT_EQ(Diffused(grid, parameters, constant), constant);
    }
  }
}

TEST(HighOrderDiffusion, LinearFieldsStayBeyondTheReachOfTheBoundary)
{
  const auto grid = Grid<double>(30, 28, 26);
  const std::vector<double> linear = LinearField(grid);
  for (int order = 0; order <= 3; ++order)
  {
    for (const DiffusionParameters& parameters : AllCoefficients(order))
    {
      SCOPED_TRACE(::testing::Message()
        << "order " << order << " flow " << static_cast<int>(parameters.Flow) << " edge stopping "
        << static_cast<int>(parameters.EdgeStopping));
      DiffusionParameters steps = OneEulerStep(parameters, grid.Spacing);
      const bool local = parameters.EdgeStopping == Edge::LocalVariance;
      const std::int64_t first = LayersChanged(grid, linear, Diffused(grid, steps, linear));
      EXPECT_LE(first, order + 1);
      // The gradient has no variance, and of order 1 to 3 this stops everything.
      EXPECT_EQ(first, local && order > 0 ? 0 : order + 1);
      // Then the field is curved, and the coefficient of a node depends on its neighbours.
      const bool stepsFarther = order == 0 && parameters.EdgeStopping != Edge::None;
      steps.Time *= 2;
      steps.Steps = 2;
      if (!local) // whose window is wider
      {
        EXPECT_LE(LayersChanged(grid, linear, Diffused(grid, steps, linear)),
          2 * (order + 1) + std::int64_t(stepsFarther));
      }
    }
  }
}

TEST(HighOrderDiffusion, FloatVolumesAreComputedInFloat)
{
  const auto single = Grid<float>(24, 20, 16);
  const auto twice = Grid<double>(24, 20, 16);
  const std::vector<float> start = Noise(single);
  DiffusionParameters parameters;
  parameters.Order = 2;
  parameters.Sigma = 1.0;
  parameters.Time = 20.0;
  const std::vector<double> exact =
    Diffused(twice, parameters, std::vector<double>(start.begin(), start.end()));
  EXPECT_LT(Distance(Diffused(single, parameters, start), exact), 2e-5);
}

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
