// Nonpolar energies: one atom in a ball, whose integral is known; shares; far atoms by blocks.

#include "MolecularSurfaces/NonpolarEnergy.h"

#include "Atoms/NearestBall.h"
#include "FlowCases.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Distance to a ball, on a grid around it.
std::vector<float> BallDistances(const DensityGrid& grid, const Ball& ball)
{
  std::vector<float> distances;
  for (std::int64_t k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (std::int64_t j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (std::int64_t i = 0; i < grid.Dimensions[0]; ++i)
      {
        distances.push_back(static_cast<float>(
          std::hypot(grid.Origin[0] + grid.Spacing * static_cast<double>(i) - ball.Center[0],
            grid.Origin[1] + grid.Spacing * static_cast<double>(j) - ball.Center[1],
            grid.Origin[2] + grid.Spacing * static_cast<double>(k) - ball.Center[2]) -
          ball.Radius));
      }
    }
  }
  return distances;
}

/// int over r > R of u, by powers of r, for R beyond the minimum.
double Outside(double depth, double minimum, double radius)
{
  return 4.0 * Pi * depth *
    (std::pow(minimum, 12) / (9.0 * std::pow(radius, 9)) -
      2.0 * std::pow(minimum, 6) / (3.0 * std::pow(radius, 3)));
}

}

TEST(NonpolarEnergy, OneAtomInABall)
{
  SolventParameters solvent;
  const DispersionAtom atom{ { 0.1, 0.2, 0.3 }, 1.9, 0.11 };
  const double minimum = 1.9 + solvent.SolventRadius;
  const double depth = std::sqrt(0.11 * solvent.SolventWellDepth);
  std::vector<double> errors;
  for (const double h : { 0.5, 0.25 })
  {
    const Ball ball{ atom.Center, 4.5 };
    const DensityGrid grid = GridAroundBalls({ ball }, h, { 1.5, 1.5, 1.5 });
    const std::vector<float> distance = BallDistances(grid, ball);
    const NonpolarEnergies found =
      NonpolarEnergy({ ball }, { atom }, grid, distance.data(), solvent);
    const double exact = solvent.SolventDensity * Outside(depth, minimum, 4.5);
    errors.push_back(std::abs(found.Whole.DispersionEnergy / exact - 1.0));
    EXPECT_NEAR(found.Whole.Area / (4.0 * Pi * 4.5 * 4.5), 1.0, 5e-3);
    EXPECT_NEAR(found.Whole.Volume / (4.0 / 3.0 * Pi * std::pow(4.5, 3)), 1.0, 8e-3);
    EXPECT_DOUBLE_EQ(found.Whole.SurfaceEnergy, solvent.SurfaceTension * found.Whole.Area);
    EXPECT_DOUBLE_EQ(found.Whole.VolumeEnergy, solvent.Pressure * found.Whole.Volume);
  }
  EXPECT_LT(errors[0], 0.02);
  EXPECT_LT(errors[1], 0.005);
}

TEST(NonpolarEnergy, WellIsContinuousAndIntegrates)
{
  SolventParameters solvent;
  const DispersionPair pair({ { 0, 0, 0 }, 1.9, 0.11 }, solvent);
  EXPECT_EQ(pair.At(0.0), -pair.Depth);
  EXPECT_NEAR(pair.At(pair.Minimum * pair.Minimum * (1.0 + 1e-9)), -pair.Depth, 1e-8);
  double sum = 0.0;
  const double step = 1e-3;
  for (double r = 0.5 * step; r < 60.0; r += step)
  {
    sum += 4.0 * Pi * r * r * pair.At(r * r) * step;
  }
  EXPECT_NEAR(sum / pair.Integral(), 1.0, 1e-3);
}

TEST(NonpolarEnergy, FarAtomsByBlocksAndSharesThatSumUp)
{
  const Ball ball{ { 0.0, 0.0, 0.0 }, 3.0 };
  // No node has the same distance from both atoms.
  const DensityGrid grid = GridAroundBalls({ ball }, 0.5, { 1.75, 1.5, 1.5 });
  const std::vector<float> distance = BallDistances(grid, ball);
  SolventParameters solvent;
  // Two atoms in the ball, one far outside that interacts with it by blocks: volume x u at the
  // distance.
  const std::vector<Ball> balls{ { { -1.0, 0.0, 0.0 }, 1.5 }, { { 1.0, 0.0, 0.0 }, 1.5 },
    { { 30.0, 0.0, 0.0 }, 1.5 } };
  std::vector<DispersionAtom> atoms;
  for (const Ball& b : balls)
  {
    atoms.push_back({ b.Center, 1.9, 0.11 });
  }
  const NonpolarEnergies found = NonpolarEnergy(balls, atoms, grid, distance.data(), solvent);
  const DispersionPair pair(atoms[2], solvent);
  const double inside = pair.Integral() - found.Atoms[2].DispersionEnergy / solvent.SolventDensity;
  EXPECT_NEAR(inside / (found.Whole.Volume * pair.At(900.0)), 1.0, 0.06);
  EXPECT_NEAR(found.Atoms[0].Area / found.Atoms[1].Area, 1.0, 0.02);
  EXPECT_EQ(found.Atoms[2].Area, 0.0);
  EXPECT_NEAR(found.Atoms[0].Volume + found.Atoms[1].Volume, found.Whole.Volume, 1e-9);
  EXPECT_NEAR(found.Atoms[0].Area + found.Atoms[1].Area, found.Whole.Area, 1e-9);
  EXPECT_THROW(NonpolarEnergy(balls, {}, grid, distance.data(), solvent), std::invalid_argument);
}

TEST(NonpolarEnergy, DispersionChangesWithTheSurface)
{
  const Ball before{ { 0.0, 0.0, 0.0 }, 3.0 };
  const Ball now{ { 0.3, 0.0, 0.0 }, 3.4 };
  const DensityGrid grid = GridAroundBalls({ before }, 0.5, { 2.0, 2.0, 2.0 });
  const std::vector<float> from = BallDistances(grid, before);
  const std::vector<float> to = BallDistances(grid, now);
  SolventParameters solvent;
  std::vector<DispersionAtom> atoms{ { { -1.0, 0.0, 0.5 }, 1.9, 0.11 },
    { { 1.0, 0.3, 0.0 }, 1.7, 0.17 } };
  const auto energy = [&](const std::vector<float>& distance)
  {
    const std::vector<double> all = DispersionEnergies(atoms, grid, distance.data(), solvent);
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  const double change = DispersionChange(atoms, grid, from.data(), to.data(), solvent);
  EXPECT_NEAR(change, energy(to) - energy(from), 1e-10);
  EXPECT_GT(change, 0.01); // less solvent attracts less
  EXPECT_EQ(DispersionChange(atoms, grid, to.data(), to.data(), solvent), 0.0);
  // An atom that interacts with the surface by blocks: the change is summed by nodes.
  atoms = { { { 24.0, 0.0, 0.0 }, 1.9, 0.11 } };
  EXPECT_NEAR(
    DispersionChange(atoms, grid, from.data(), to.data(), solvent) / (energy(to) - energy(from)),
    1.0, 0.06);
}

TEST(NonpolarEnergy, NearestBallIsTheNearest)
{
  const std::vector<Ball> balls = RandomBalls(500, 30.0);
  const NearestBall nearest(balls);
  for (const Ball& place : RandomBalls(300, 90.0))
  {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < balls.size(); ++b)
    {
      const double d =
        std::hypot(place.Center[0] - balls[b].Center[0], place.Center[1] - balls[b].Center[1],
          place.Center[2] - balls[b].Center[2]) -
        balls[b].Radius;
      if (d < least)
      {
        least = d;
        best = b;
      }
    }
    EXPECT_EQ(nearest.At(place.Center), best);
  }
}

// (pressure - density U) / tension at each node, U by the pairs within 10 angstrom (Dispersion.h).
TEST(NonpolarEnergy, PullMatchesTheEquation)
{
  const std::vector<DispersionAtom> atoms{ { { 0.3, -0.2, 0.1 }, 1.9, 0.1 },
    { { 3.1, 0.4, -1.0 }, 1.5, 0.2 } };
  SolventParameters solvent;
  solvent.Pressure = 0.03;
  solvent.SurfaceTension = 0.05;
  const FlowGrid grid(DensityGrid{ { -8.0, -7.0, -6.0 }, { 21, 19, 17 }, 0.8 });
  std::vector<float> pull(static_cast<std::size_t>(grid.NumberOfNodes()), 0.0F);
  SolventPull(atoms, solvent)(grid, pull);
  for (std::int64_t n = 0; n < 21 * 19 * 17; n += 13)
  {
    const std::array<std::int64_t, 3> at{ n % 21, n / 21 % 19, n / (21 * 19) };
    double energy = 0.0;
    for (const DispersionAtom& atom : atoms)
    {
      double r2 = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const double x = grid.Inner().Origin[k] + 0.8 * static_cast<double>(at[k]);
        r2 += (x - atom.Center[k]) * (x - atom.Center[k]);
      }
      const double m = atom.Radius + solvent.SolventRadius;
      const double depth = std::sqrt(atom.WellDepth * solvent.SolventWellDepth);
      const double r = std::max(std::sqrt(r2), m); // constant where repulsion would begin
      energy += r < 10.0 ? depth * (std::pow(m / r, 12) - 2.0 * std::pow(m / r, 6)) : 0.0;
    }
    const double expected = (0.03 - solvent.SolventDensity * energy) / 0.05;
    EXPECT_NEAR(pull[static_cast<std::size_t>(grid.Index(at[0], at[1], at[2]))], expected, 1e-4);
  }
}

TEST(NonpolarEnergy, SolventPullsTheSurfaceToTheAtoms)
{
  const std::vector<Ball> balls = RandomBalls(60, 12.0);
  std::vector<DispersionAtom> atoms;
  for (const Ball& ball : balls)
  {
    atoms.push_back({ ball.Center, ball.Radius, 0.1 });
  }
  SurfaceFlowParameters parameters;
  parameters.Steady = true;
  SolventParameters solvent;
  const double plain = SurfaceFlow(balls, parameters).History.back().Volume;
  const double pulled =
    SurfaceFlow(balls, parameters, SolventPull(atoms, solvent)).History.back().Volume;
  EXPECT_LT(pulled, 0.98 * plain);
  // No pressure, and no attraction: nothing changes.
  solvent.Pressure = 0.0;
  solvent.SolventWellDepth = 0.0;
  const double still =
    SurfaceFlow(balls, parameters, SolventPull(atoms, solvent)).History.back().Volume;
  EXPECT_NEAR(still / plain, 1.0, 2e-3);
}
