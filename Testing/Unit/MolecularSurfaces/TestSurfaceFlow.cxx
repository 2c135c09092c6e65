// The flow alone: invariances, coarse-to-fine, threads, the thesis' scheme, the probe's surface.

#include "MolecularSurfaces/SurfaceFlow.h"

#include "FlowCases.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"
#include "MolecularSurfaces/ThesisFlow.h"
#include "SharedData.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

FlowRecord Last(const SurfaceFlowResult& result)
{
  return result.History.back();
}

std::vector<Ball> Translate(std::vector<Ball> balls,
  const std::array<std::array<double, 3>, 3>& turn, const std::array<double, 3>& by)
{
  for (Ball& ball : balls)
  {
    const auto from = ball.Center;
    for (std::size_t i = 0; i < 3; ++i)
    {
      ball.Center[i] = by[i] + turn[i][0] * from[0] + turn[i][1] * from[1] + turn[i][2] * from[2];
    }
  }
  return balls;
}

constexpr std::array<std::array<double, 3>, 3> Straight{ { { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 } } };

double Trilinear(const SurfaceFlowResult& field, const std::array<double, 3>& at)
{
  double sum = 0.0;
  std::array<std::int64_t, 3> low;
  std::array<double, 3> t;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double x = (at[a] - field.Grid.Origin[a]) / field.Grid.Spacing;
    low[a] = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(std::floor(x)), 0, field.Grid.Dimensions[a] - 2);
    t[a] = x - static_cast<double>(low[a]);
  }
  for (std::int64_t c = 0; c < 8; ++c)
  {
    const std::array<std::int64_t, 3> d{ c & 1, c >> 1 & 1, c >> 2 };
    double weight = 1.0;
    std::int64_t node = 0;
    std::int64_t stride = 1;
    for (std::size_t a = 0; a < 3; ++a)
    {
      weight *= d[a] == 1 ? t[a] : 1.0 - t[a];
      node += stride * (low[a] + d[a]);
      stride *= field.Grid.Dimensions[a];
    }
    sum += weight * static_cast<double>(field.Distance[static_cast<std::size_t>(node)]);
  }
  return sum;
}

/// rms over the nodes within one spacing of `a`'s surface of the difference of distances.
double RmsDifference(const SurfaceFlowResult& a, const SurfaceFlowResult& b)
{
  double sum = 0.0;
  double count = 0.0;
  const auto& n = a.Grid.Dimensions;
  for (std::size_t node = 0; node < a.Distance.size(); ++node)
  {
    if (std::abs(static_cast<double>(a.Distance[node])) < a.Grid.Spacing)
    {
      const auto i = static_cast<std::int64_t>(node);
      const std::array<double, 3> at{ a.Grid.Origin[0] +
          a.Grid.Spacing * static_cast<double>(i % n[0]),
        a.Grid.Origin[1] + a.Grid.Spacing * static_cast<double>(i / n[0] % n[1]),
        a.Grid.Origin[2] + a.Grid.Spacing * static_cast<double>(i / n[0] / n[1]) };
      const double by = static_cast<double>(a.Distance[node]) - Trilinear(b, at);
      sum += by * by;
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

}

TEST(SurfaceFlow, DoesNotDependOnPlaceTurnAndOrder)
{
  const std::vector<Ball> balls = RandomBalls(80, 14.0);
  SurfaceFlowParameters parameters;
  const SurfaceFlowResult plain = SurfaceFlow(balls, parameters);
  // The grid moves with the atoms, so shifts by a fraction of a spacing are made by the padding.
  parameters.Padding = 1.7 + 0.37 * parameters.Spacing;
  const SurfaceFlowResult shifted =
    SurfaceFlow(Translate(balls, Straight, { 0.19, -5.3, 100.1 }), parameters);
  EXPECT_NEAR(Last(shifted).Area / Last(plain).Area, 1.0, 5e-3);
  EXPECT_NEAR(Last(shifted).Volume / Last(plain).Volume, 1.0, 5e-3);
  const double c = std::cos(0.6);
  const double s = std::sin(0.6);
  parameters.Padding = 1.7;
  const SurfaceFlowResult turned = SurfaceFlow(
    Translate(balls, { { { c, -s * c, s * s }, { s, c * c, -s * c }, { 0, s, c } } }, { 0, 0, 0 }),
    parameters);
  EXPECT_NEAR(Last(turned).Area / Last(plain).Area, 1.0, 5e-3);
  EXPECT_NEAR(Last(turned).Volume / Last(plain).Volume, 1.0, 5e-3);
  // Axes exchanged: the same values up to rounding in another order.
  const SurfaceFlowResult exchanged = SurfaceFlow(
    Translate(balls, { { { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 } } }, { 0, 0, 0 }), parameters);
  EXPECT_NEAR(Last(exchanged).Area / Last(plain).Area, 1.0, 1e-4);
  std::vector<Ball> shuffled = balls;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
  EXPECT_EQ(SurfaceFlow(shuffled, parameters).Distance, plain.Distance);
}

TEST(SurfaceFlow, DoesNotDependOnThreads)
{
  const std::vector<Ball> balls = RandomBalls(300, 20.0);
  for (const double probe : { 0.0, 1.4 })
  {
    SurfaceFlowParameters parameters;
    parameters.Steady = true;
    parameters.ProbeRadius = probe;
    SurfaceFlowResult first;
    for (const int threads : { 1, 3 })
    {
      vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
        [&]
        {
          const SurfaceFlowResult result = SurfaceFlow(balls, parameters);
          if (threads == 1)
          {
            first = result;
          }
          EXPECT_EQ(result.Distance, first.Distance);
          EXPECT_EQ(result.History.size(), first.History.size());
          EXPECT_EQ(Last(result).Area, Last(first).Area);
          EXPECT_EQ(Last(result).Volume, Last(first).Volume);
        });
    }
  }
}

TEST(SurfaceFlow, CoarseToFineEndsWhereTheFineFlowDoes)
{
  const std::vector<Ball> balls = RandomBalls(700, 24.0);
  SurfaceFlowParameters parameters;
  parameters.Steady = true;
  parameters.Spacing = 0.6;
  const SurfaceFlowResult coarse = SurfaceFlow(balls, parameters);
  EXPECT_GT(coarse.History.front().Spacing, 1.0);
  parameters.CoarseToFine = false;
  const SurfaceFlowResult fine = SurfaceFlow(balls, parameters);
  EXPECT_EQ(fine.History.front().Spacing, 0.6);
  const double rms = RmsDifference(fine, coarse);
  std::cout << "coarse-to-fine to explicit: " << rms << " angstrom rms\n";
  EXPECT_LT(rms, 0.05);
  EXPECT_NEAR(Last(coarse).Area / Last(fine).Area, 1.0, 1e-3);
}

TEST(SurfaceFlow, ASingleBallIsStationary)
{
  SurfaceFlowParameters parameters;
  parameters.Steady = true;
  parameters.Spacing = 0.25;
  const SurfaceFlowResult ball = SurfaceFlow({ { { 0.1, 0.2, 0.3 }, 2.0 } }, parameters);
  EXPECT_NEAR(Last(ball).Area / (16.0 * Pi), 1.0, 5e-3);
  EXPECT_NEAR(Last(ball).Volume / (32.0 / 3.0 * Pi), 1.0, 8e-3);
  EXPECT_TRUE(ball.Converged);
}

TEST(SurfaceFlow, AFreeSphereShrinksAsItShould)
{
  // A small atom in a large ball: r^2 = r0^2 - 4 T until the surface reaches it.
  SurfaceFlowParameters parameters;
  parameters.Spacing = 0.25;
  parameters.Enlargement = 4.0;
  parameters.EvolutionTime = 2.0;
  const SurfaceFlowResult shrunk = SurfaceFlow({ { { 0.1, 0.2, 0.3 }, 1.0 } }, parameters);
  const double radius = std::sqrt(16.0 - 8.0);
  EXPECT_NEAR(std::sqrt(Last(shrunk).Area / (4.0 * Pi)) / radius, 1.0, 0.01);
}

TEST(SurfaceFlow, ProbeStopsTheFlowEarly)
{
  const std::vector<Ball> balls = RandomBalls(200, 18.0);
  SurfaceFlowParameters parameters;
  parameters.ProbeRadius = 1.4;
  parameters.EvolutionTime = 2.0;
  const SurfaceFlowResult two = SurfaceFlow(balls, parameters);
  parameters.EvolutionTime = 6.0;
  const SurfaceFlowResult six = SurfaceFlow(balls, parameters);
  EXPECT_NEAR(Last(six).Area / Last(two).Area, 1.0, 4e-3);
  EXPECT_NEAR(Last(six).Volume / Last(two).Volume, 1.0, 5e-3);
  const SurfaceFlowResult excluded = SolventExcludedSurface(balls, parameters);
  EXPECT_LT(Last(six).Area, Last(excluded).Area);
  for (std::size_t node = 0; node < six.Distance.size(); ++node)
  {
    ASSERT_GE(six.Distance[node], excluded.Distance[node] - 1e-5F);
  }
}

TEST(SolventExcludedSurface, TwoBallsAndTheProbesSaddle)
{
  // Balls of radius r at +-a, probe p: caps, and the torus that the probe rolls along.
  const double r = 2.0;
  const double a = 2.2;
  const double p = 1.4;
  const double ring = std::sqrt((r + p) * (r + p) - a * a); // where the probe's center goes
  const double angle = std::asin(a / (r + p));
  const double cap = 2.0 * Pi * r * r * (1.0 + a / (r + p));
  const double saddle = 4.0 * Pi * p * (ring * angle - p * std::sin(angle));
  const double exact = 2.0 * cap + saddle;
  std::vector<double> errors;
  for (const double h : { 0.4, 0.2, 0.1 })
  {
    SurfaceFlowParameters parameters;
    parameters.Spacing = h;
    parameters.ProbeRadius = p;
    const SurfaceFlowResult found =
      SolventExcludedSurface({ { { -a, 0.03, 0.01 }, r }, { { a, 0.03, 0.01 }, r } }, parameters);
    errors.push_back(Last(found).Area / exact - 1.0);
    std::cout << "solvent-excluded, h " << h << ": " << errors.back() << "\n";
  }
  EXPECT_LT(std::abs(errors[1]), 5e-3);
  EXPECT_GT(0.5 * std::log2(std::abs(errors[0] / errors[2])), 1.7);
}

TEST(SolventExcludedSurface, ProbeBetweenThreeBallsMeetsItsDistance)
{
  // Random balls: beside the definition, by brute force over fine samples of the center's places.
  const std::vector<Ball> balls = RandomBalls(12, 5.0);
  SurfaceFlowParameters parameters;
  parameters.Spacing = 0.5;
  parameters.ProbeRadius = 1.4;
  const SurfaceFlowResult found = SolventExcludedSurface(balls, parameters);
  std::vector<std::array<double, 3>> centers;
  const double step = 0.1;
  const auto clear = [&](const std::array<double, 3>& at)
  {
    return std::all_of(balls.begin(), balls.end(),
      [&](const Ball& ball)
      {
        return std::hypot(at[0] - ball.Center[0], at[1] - ball.Center[1], at[2] - ball.Center[2]) >
          ball.Radius + 1.4;
      });
  };
  for (double x = -5.0; x < 10.0; x += step)
  {
    for (double y = -5.0; y < 10.0; y += step)
    {
      for (double z = -5.0; z < 10.0; z += step)
      {
        if (clear({ x, y, z }))
        {
          centers.push_back({ x, y, z });
        }
      }
    }
  }
  const auto& n = found.Grid.Dimensions;
  std::size_t compared = 0;
  for (std::size_t node = 0; node < found.Distance.size(); node += 7)
  {
    const double value = static_cast<double>(found.Distance[node]);
    if (std::abs(value) > 0.8)
    {
      continue;
    }
    const auto i = static_cast<std::int64_t>(node);
    const std::array<double, 3> at{ found.Grid.Origin[0] + 0.5 * static_cast<double>(i % n[0]),
      found.Grid.Origin[1] + 0.5 * static_cast<double>(i / n[0] % n[1]),
      found.Grid.Origin[2] + 0.5 * static_cast<double>(i / n[0] / n[1]) };
    double nearest = 1e9;
    for (const auto& center : centers)
    {
      nearest =
        std::min(nearest, std::hypot(at[0] - center[0], at[1] - center[1], at[2] - center[2]));
    }
    // A sample of the center's places lies within a cell of the nearest one.
    ASSERT_LT(1.4 - nearest, value + 1e-3) << node;
    ASSERT_GT(1.4 - nearest, value - 0.2) << node;
    ++compared;
  }
  EXPECT_GT(compared, 30u);
}

TEST(ThesisFlow, ConvergesOutsideTheMinimalSurface)
{
  // Why it is not the default: at rest, area and volume are this much too large (order 1/2).
  const Catenoid exact;
  std::array<double, 3> area{};
  const std::array<double, 3> spacings{ 0.5, 0.25, 0.125 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    SurfaceFlowParameters parameters;
    parameters.Spacing = spacings[i];
    parameters.EvolutionTime = 6.0;
    const SurfaceFlowResult thesis = ThesisFlow(exact.Balls(), parameters);
    area[i] = Last(thesis).Area / exact.Area() - 1.0;
    std::cout << "thesis' scheme, h " << spacings[i] << ": area " << area[i] << ", volume "
              << Last(thesis).Volume / exact.Volume() - 1.0 << "\n";
    // S = 1 in the balls, and 0 on the border.
    const auto& n = thesis.Grid.Dimensions;
    EXPECT_EQ(thesis.S.front(), 0.0F);
    const auto middle =
      static_cast<std::size_t>(std::lround((-2.2 - thesis.Grid.Origin[0]) / spacings[i]) +
        n[0] *
          (std::lround(-thesis.Grid.Origin[1] / spacings[i]) +
            n[1] * std::lround(-thesis.Grid.Origin[2] / spacings[i])));
    EXPECT_EQ(thesis.S[middle], 1.0F);
  }
  EXPECT_NEAR(area[0], 0.148, 0.03);
  EXPECT_NEAR(area[1], 0.104, 0.03);
  EXPECT_NEAR(area[2], 0.069, 0.03);
}

TEST(SurfaceFlow, LysozymeIsQuick)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew/1hew.pqr");
  const std::vector<Ball> balls =
    BallsOfPQR((SharedDataFolder() / "molecules/1hew/1hew.pqr").string());
  SurfaceFlowParameters parameters;
  double bytes = 0.0;
  const DensityGrid grid = FlowResultGrid(balls, parameters, &bytes);
  const auto& n = grid.Dimensions;
  EXPECT_EQ(n, (std::array<std::int64_t, 3>{ 96, 84, 99 }));
  const double perNode = bytes / static_cast<double>(n[0] * n[1] * n[2]);
  std::cout << perNode << " bytes per node\n"; // the margin weighs on small grids
  EXPECT_LT(perNode, 60.0);
}
