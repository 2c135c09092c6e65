// Distances of nodes to a surface, against formulas and all triangles.

#include "GridChecks.h"
#include "SharedData.h"
#include "SurfaceModels.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/SurfaceCrossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The mesh moved and scaled so that its box lies in [margin, side - margin]^3, touching along one
/// axis.
Model FitIntoBox(Model model, double side, double margin)
{
  Vector low = model.Points[0], high = model.Points[0];
  for (const Vector& p : model.Points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const double size = std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] });
  const double scale = (side - 2.0 * margin) / size;
  for (Vector& p : model.Points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      p[a] = margin + scale * (p[a] - low[a]);
    }
  }
  return model;
}

}

TEST(GridDistance, Sphere)
{
  const Model sphere = Translate(Icosphere(30, 2.0), 3.0, 3.0, 3.0);
  const GridShape grid = Cube(49, 6.0);
  const auto distance = DistanceToSurface(sphere.View(), grid, 2.0 * grid.Spacing[0]);
  double worstNear = 0.0, worstFar = 0.0;
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const double h = grid.Spacing[0];
    const double r = std::hypot(static_cast<double>(node % 49) * h - 3.0,
      static_cast<double>(node / 49 % 49) * h - 3.0, static_cast<double>(node / 2401) * h - 3.0);
    const double error = std::abs(distance[static_cast<std::size_t>(node)] - std::abs(r - 2.0));
    double& worst = std::abs(r - 2.0) < 2.0 * h ? worstNear : worstFar;
    worst = std::max(worst, error);
  }
  const auto exact = ExactDistanceToSurface(sphere.View(), grid);
  for (std::size_t node = 0; node < exact.size(); ++node)
  {
    ASSERT_LE(exact[node], distance[node] + 1e-12);
    ASSERT_GT(exact[node], distance[node] - 0.25 * grid.Spacing[0]);
  }
  std::printf("sphere: largest error in the band %.2e, beyond %.2e\n", worstNear, worstFar);
  EXPECT_LT(worstNear, 2e-3) << "the sag of the triangles is 1.4e-3 to 1.6e-3";
  EXPECT_LT(worstFar, 0.25 * grid.Spacing[0]);
}

TEST(GridDistance, IsFiniteWhereNoLineOfTheGridIsCrossed)
{
  // A needle along y between the lines of the grid, and a ball within one cell.
  for (const double length : { 0.3, 8.0 })
  {
    Model needle = Icosphere(1, 0.1);
    for (auto& point : needle.Points)
    {
      point = { point[0] + 5.5, point[1] * 5.0 * length + 5.5, point[2] + 5.5 };
    }
    const GridShape grid{ { 12, length > 1.0 ? 4 : 12, 12 },
      { 1.0, length > 1.0 ? 11.0 : 1.0, 1.0 } };
    ASSERT_TRUE(SurfaceCrossings(needle.View(), grid, CrossingNormal::Triangles).empty());
    EXPECT_EQ(
      DistanceToSurface(needle.View(), grid, 2.0), ExactDistanceToSurface(needle.View(), grid));
  }
}

TEST(GridDistance, FertilityAgainstBruteForce)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const GridShape grid{ { 81, 65, 101 }, { 1.0 / 64, 1.0 / 64, 1.0 / 64 } };
  const Model mesh =
    FitIntoBox(ReadOFF((SharedDataFolder() / "surfaces/fertility.off").string()), 1.0, 0.05);
  const double h = grid.Spacing[0];
  const double band = 2.0 * h;
  const auto distance = DistanceToSurface(mesh.View(), grid, band);
  const auto everywhere = ExactDistanceToSurface(mesh.View(), grid);
  const auto inside = NodesInside(mesh.View(), grid);
  std::mt19937 random(3);
  std::uniform_int_distribution<std::int64_t> any(0, grid.Size() - 1);
  double worstNear = 0.0, worstFar = 0.0;
  int near = 0, far = 0, wrong = 0;
  for (int sample = 0; sample < 120; ++sample)
  {
    const std::int64_t node = any(random);
    const auto n = static_cast<std::size_t>(node);
    const Vector x{ static_cast<double>(node % 81) * h, static_cast<double>(node / 81 % 65) * h,
      static_cast<double>(node / (81 * 65)) * h };
    const double exact = BruteForce(mesh, x);
    EXPECT_NEAR(everywhere[n], exact, 1e-12);
    EXPECT_GE(distance[n], exact - 1e-9) << "never too small";
    (exact <= band ? near : far) += 1;
    double& worst = exact <= band ? worstNear : worstFar;
    worst = std::max(worst, distance[n] - exact);
    wrong += distance[n] > exact + 1e-9;
    EXPECT_NEAR(WindingNumber(mesh, x), inside[n], 1e-5);
  }
  std::printf("%d nodes in the band: largest error %.1e h; %d beyond: %d not exact, largest error "
              "%.1e h\n",
    near, worstNear / h, far, wrong, worstFar / h);
  EXPECT_LT(worstNear, 1e-12);
  EXPECT_LT(worstFar, 0.25 * h);
}
