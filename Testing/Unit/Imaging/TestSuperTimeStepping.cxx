// Lengths of steps, refusals, reports, and independence of the number of threads.

#include "DiffusionTestTools.h"
#include "Imaging/SuperTimeStepping.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <functional>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;
using Edge = DiffusionParameters::EdgeStoppingType;
using Flow = DiffusionParameters::FlowType;
using Integrator = DiffusionParameters::IntegratorType;

std::string Refusal(const DiffusionParameters& parameters)
{
  const auto grid = Grid<float>(8, 8, 8);
  try
  {
    Diffused(grid, parameters, Noise(grid));
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

}

TEST(SuperTimeStepping, SuperStepsDoubleUpToTheirLastLength)
{
  for (const double time : { 0.5, 12.0, 30.0, 1000.0, 40000.0 })
  {
    constexpr double limit = 0.25;
    const std::vector<TimeStep> steps = SuperSteps(time, limit, 0);
    const double last =
      std::max(7.0 * limit, time / std::max(12.0, 0.19 * std::sqrt(time / limit)));
    // Steps that begin with an explicit one, all shortened alike to end at `time`.
    double length = limit, sum = 0.0, made = 0.0;
    std::size_t count = 0;
    for (; sum < time; ++count, length = std::min(last, 2.0 * length))
    {
      sum += length;
    }
    ASSERT_EQ(steps.size(), count) << time;
    length = limit;
    for (const TimeStep& step : steps)
    {
      EXPECT_NEAR(step.Length, length * time / sum, 1e-9 * step.Length);
      EXPECT_EQ(step.Stages % 2, 1);
      EXPECT_GE((step.Stages * step.Stages + step.Stages - 2) / 4.0, step.Length / limit - 1e-9);
      length = std::min(last, 2.0 * length);
      made += step.Length;
    }
    EXPECT_NEAR(made, time, 1e-9 * time);
  }
}

TEST(DiffusionSteps, TheLargestStepIsStableAndTheNextIsRefused)
{
  const auto grid = Grid<double>(24, 24, 24);
  const std::vector<double> start = Noise(grid);
  for (const Flow flow : { Flow::Hyperdiffusion, Flow::GeometricFlow })
  {
    for (int order = 0; order <= 3; ++order)
    {
      DiffusionParameters parameters;
      parameters.Flow = flow;
      parameters.Order = order;
      parameters.Sigma = 1.0;
      parameters.Integrator = Integrator::ForwardEuler;
      parameters.Steps = 60;
      const double limit = ExplicitStepLimit(parameters, grid.Spacing);
      EXPECT_NEAR(limit, 2.0 / std::pow(12.0, order + 1), 1e-15);
      parameters.Time = 60 * limit;
      EXPECT_LT(Deviation(Diffused(grid, parameters, start)), 0.9 * Deviation(start));
      parameters.Time *= 1.01;
      const std::string refusal = Refusal(parameters);
      std::ostringstream named;
      named << limit;
      EXPECT_NE(refusal.find(named.str()), std::string::npos) << refusal;
    }
  }
}

TEST(DiffusionSteps, TheLongestSuperStepIsStableAndTheNextIsRefused)
{
  const auto grid = Grid<float>(24, 24, 24);
  const std::vector<float> start = Noise(grid);
  for (int order = 0; order <= 3; ++order)
  {
    DiffusionParameters parameters;
    parameters.Order = order;
    parameters.Sigma = 1.0;
    const double s = MaximumStages;
    const double limit = ExplicitStepLimit(parameters, grid.Spacing) * (s * s + s - 2) / 4;
    parameters.Steps = 4;
    parameters.Time = 4 * limit;
    EXPECT_LT(Deviation(Diffused(grid, parameters, start)), 0.5 * Deviation(start)) << order;
    parameters.Time *= 1.01;
    std::ostringstream named;
    named << limit;
    EXPECT_NE(Refusal(parameters).find(named.str()), std::string::npos) << Refusal(parameters);
  }
}

TEST(DiffusionSteps, AutomaticStepsEndAtTheTime)
{
  for (const double time : { 1e-3, 0.1, 3.0, 5000.0 })
  {
    for (const auto& steps : { EulerSteps(time, 0.01, 0), SuperSteps(time, 0.01, 0) })
    {
      double sum = 0.0;
      for (const TimeStep& step : steps)
      {
        sum += step.Length;
        EXPECT_LE(step.Stages, MaximumStages);
      }
      EXPECT_NEAR(sum, time, 1e-9 * time);
    }
  }
}

TEST(DiffusionSteps, SuperStepsReachTheEndOfForwardEulerWithATenthOfItsWork)
{
  const auto grid = Grid<float>(32, 32, 32);
  std::vector<float> start = Noise(grid, 0.5);
  for (std::int64_t n = 0; n < grid.Size(); ++n)
  {
    start[static_cast<std::size_t>(n)] += static_cast<float>(n % 32 / 8 % 2) * 2.0f; // slabs
  }
  for (const double sigma : { 1.0, 0.3 }) // of a signal with standard deviation 1
  {
    DiffusionParameters parameters;
    parameters.Order = 1;
    parameters.Sigma = sigma;
    parameters.PreSmoothing = 1.0;
    parameters.Time = 20.0;
    DiffusionReport super, euler;
    const auto fast = Diffused(grid, parameters, start, &super);
    parameters.Integrator = Integrator::ForwardEuler;
    const auto slow = Diffused(grid, parameters, start, &euler);
    const double difference = Distance(fast, slow) / Deviation(slow);
    std::printf("q = 1, sigma %.1f, time 20: evaluations %lld and %lld, difference %.2f %%\n",
      sigma, static_cast<long long>(euler.Evaluations), static_cast<long long>(super.Evaluations),
      100 * difference);
    EXPECT_LT(difference, 0.01);
    EXPECT_GT(euler.Evaluations, 10 * super.Evaluations);
  }
}

TEST(DiffusionSteps, ResultsDoNotDependOnThreads)
{
  auto grid = Grid<float>(37, 300, 70);
  const std::vector<float> start = Noise(grid);
  for (const Edge edge : { Edge::Gaussian, Edge::LocalVariance })
  {
    DiffusionParameters parameters;
    parameters.Order = 1;
    parameters.EdgeStopping = edge;
    parameters.Sigma = 1.0;
    parameters.Time = 0.2;
    DiffusionReport reports[2];
    std::vector<float> results[2];
    for (const int threads : { 1, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
        [&]() { results[threads / 2] = Diffused(grid, parameters, start, &reports[threads / 2]); });
    }
    EXPECT_EQ(results[0], results[1]);
    EXPECT_EQ(reports[0].Change, reports[1].Change);
  }
}

// Where halos must be exchanged each stage is a pass of its own, here with nothing to exchange;
// otherwise several stages share one, tile by tile, with the surroundings of each tile computed
// again.
TEST(DiffusionSteps, StagesSharingAPassGiveTheBitsOfStagesAlone)
{
  for (const auto& n : std::vector<std::array<std::int64_t, 3>>{
         { 33, 19, 23 }, { 40, 1, 1 }, { 5, 2, 3 }, { 80, 150, 30 }, { 9, 7, 300 } })
  {
    auto shared = Grid<float>(n[0], n[1], n[2]);
    shared.Spacing = { 1.0, 1.3, 0.8 };
    auto alone = shared;
    alone.ExchangeHalo = [](float*) {};
    const std::vector<float> start = Noise(shared);
    for (int order = 0; order <= 3; ++order)
    {
      for (const double smoothing : { 0.0, 1.2 })
      {
        DiffusionParameters parameters;
        parameters.Order = order;
        parameters.Sigma = 0.5;
        parameters.PreSmoothing = smoothing;
        parameters.LowerOrders = order == 2;
        parameters.Fidelity = order == 1 ? 0.3 : 0.0;
        parameters.Time = 20 * ExplicitStepLimit(parameters, shared.Spacing);
        EXPECT_EQ(Diffused(shared, parameters, start), Diffused(alone, parameters, start))
          << "order " << order << " on " << n[0] << " x " << n[1] << " x " << n[2];
        parameters.Flow = DiffusionParameters::FlowType::GeometricFlow;
        EXPECT_EQ(Diffused(shared, parameters, start), Diffused(alone, parameters, start));
      }
    }
  }
}

TEST(DiffusionSteps, TheReportIsACurveThatFalls)
{
  const auto grid = Grid<float>(16, 16, 16);
  for (const Integrator integrator : { Integrator::ForwardEuler, Integrator::SuperTimeStepping })
  {
    DiffusionParameters parameters;
    parameters.Order = 1;
    parameters.Integrator = integrator;
    parameters.EdgeStopping = Edge::None;
    parameters.Time = 40.0;
    DiffusionReport report;
    Diffused(grid, parameters, Noise(grid), &report);
    ASSERT_GE(report.Time.size(), 4u);
    EXPECT_LE(report.Time.size(), 100u);
    EXPECT_NEAR(report.Time.back(), 40.0, 1e-9);
    EXPECT_TRUE(std::is_sorted(report.Residual.rbegin(), report.Residual.rend()));
    EXPECT_TRUE(std::is_sorted(report.Time.begin(), report.Time.end()));
    EXPECT_EQ(report.Change.size(), report.Residual.size());
  }
}

TEST(DiffusionSteps, BadParametersAreRefusedWithAMessage)
{
  const std::vector<std::pair<const char*, std::function<void(DiffusionParameters&)>>> cases{
    { "Order is 4", [](auto& p) { p.Order = 4; } },
    { "Order is -1", [](auto& p) { p.Order = -1; } },
    { "Time is 0, but it must be a finite number above 0. The equation needs an end time. Denoise "
      "Map chooses",
      [](auto& p) { p.Time = DiffusionParameters().Time; } },
    { "Time is -1", [](auto& p) { p.Time = -1.0; } },
    { "Time is not a number", [](auto& p) { p.Time = std::nan(""); } },
    { "Steps is -2", [](auto& p) { p.Steps = -2; } },
    { "Sigma is 0", [](auto& p) { p.Sigma = 0.0; } },
    { "Flow is 2", [](auto& p) { p.Flow = static_cast<Flow>(2); } },
    { "Fidelity is -1", [](auto& p) { p.Fidelity = -1.0; } },
    { "PreSmoothing is -1", [](auto& p) { p.PreSmoothing = -1.0; } },
    { "ResidualSmoothing is -1", [](auto& p) { p.ResidualSmoothing = -1.0; } },
    { "Diffusivity of the highest order is 0", [](auto& p) { p.Diffusivity[1] = 0.0; } },
    { "Diffusivity is -1", [](auto& p) { p.Diffusivity[0] = -1.0; } },
    { "Window is 4",
      [](auto& p)
      {
        p.EdgeStopping = Edge::LocalVariance;
        p.Window = 4;
      } },
  };
  for (const auto& [words, spoil] : cases)
  {
    DiffusionParameters parameters;
    parameters.Order = 1;
    parameters.Sigma = 1.0;
    parameters.Time = 1.0;
    spoil(parameters);
    EXPECT_NE(Refusal(parameters).find(words), std::string::npos) << Refusal(parameters);
  }
}

TEST(DiffusionSteps, ValuesTooLargeForTheTypeAreReported)
{
  const auto grid = Grid<float>(8, 8, 8);
  DiffusionParameters parameters;
  parameters.Order = 3;
  parameters.EdgeStopping = Edge::None;
  parameters.Time = 1.0;
  EXPECT_THROW(Diffused(grid, parameters, Noise(grid, 1e36)), std::runtime_error);
}
