// Kirkwood's spheres against their series, within the required errors; salts and layers; the
// self-consistent border; invariances; refusals.

#include "SphereProblem.h"

#include "Electrostatics/SurfacePotential.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

struct Demand
{
  int Number;
  double Half, Spacing, Energy, Outside, Inside;
};

class KirkwoodTest : public ::testing::TestWithParam<Demand>
{
};

TEST_P(KirkwoodTest, SolutionIsWithinTolerance)
{
  const Demand demand = GetParam();
  SphereProblem problem(Kirkwood(demand.Number), demand.Half, demand.Spacing);
  const auto solution = problem.Solve();
  const SphereErrors errors = RecordErrors(problem, *solution);
  std::printf("K%d h=%g: energy %.2e outside %.4f inside %.4f iterations %d\n", demand.Number,
    demand.Spacing, errors.Energy, errors.Outside, errors.Inside, solution->GetReport().Iterations);
  EXPECT_LE(errors.Energy, demand.Energy);
  EXPECT_LE(errors.Outside, demand.Outside);
  EXPECT_LE(errors.Inside, demand.Inside);
  EXPECT_LE(solution->GetReport().Iterations, 12);
  EXPECT_EQ(solution->GetReport().LinearFits + solution->GetReport().GhostFits, 0);
}

INSTANTIATE_TEST_SUITE_P(All, KirkwoodTest,
  ::testing::Values(Demand{ 1, 8, 0.5, 5e-4, 0.08, 0.12 }, Demand{ 1, 8, 0.25, 1e-4, 0.02, 0.03 },
    Demand{ 2, 12, 0.5, 1e-3, 0.1, 0.2 }, Demand{ 2, 12, 0.25, 2.5e-4, 0.04, 0.08 },
    Demand{ 3, 12, 0.5, 1e-3, 0.1, 0.2 }, Demand{ 4, 12, 0.5, 1.5e-3, 1.0, 1.5 }));

double EnergyWithLayer(double layer, double h, SphereErrors& errors)
{
  KirkwoodSphere sphere = Kirkwood(2);
  sphere.Kappa = 0.2;
  sphere.Layer = layer;
  SphereProblem problem(sphere, 10, h);
  const auto solution = problem.Solve();
  errors = RecordErrors(problem, *solution);
  return solution->GetReport().SolvationEnergy;
}

TEST(PoissonBoltzmann, IonLayerMatchesKirkwood)
{
  SphereErrors coarse, fine, none;
  const double layered = EnergyWithLayer(2.0, 1.0, coarse);
  EnergyWithLayer(2.0, 0.5, fine);
  const double bare = EnergyWithLayer(0.0, 1.0, none);
  EXPECT_LT(fine.Energy, 1e-3);
  EXPECT_LT(fine.Outside, 0.1);
  EXPECT_GT(layered, bare); // ions that approach closer are bound more strongly
}

/// The mean factor by which halving the spacing reduces the largest error outside.
double OrderOutside(int number, double half, double coarse, double fine)
{
  double errors[2];
  for (const double h : { coarse, fine })
  {
    SphereProblem problem(Kirkwood(number), half, h);
    errors[h == fine ? 1 : 0] = RecordErrors(problem, *problem.Solve()).Outside;
  }
  const double order = std::log(errors[0] / errors[1]) / std::log(coarse / fine);
  std::printf("K%d: order %.2f from %g to %g\n", number, order, coarse, fine);
  return order;
}

TEST(PoissonBoltzmann, ErrorsFallWithTheSquareOfTheSpacing)
{
  // K1 over two halvings: the nearest node's place on the surface changes from grid to grid.
  EXPECT_GE(OrderOutside(1, 4.0, 0.5, 0.125), 1.7);
  EXPECT_GE(OrderOutside(2, 6.0, 0.5, 0.125), 1.7);
}

TEST(PoissonBoltzmann, SelfConsistentBorderMatchesTheSeries)
{
  SphereProblem exact(Kirkwood(2), 12, 0.5);
  const SphereErrors with = RecordErrors(exact, *exact.Solve());
  SphereProblem own(Kirkwood(2), 12, 0.5);
  own.Parameters.BoundaryCondition = BoundaryCondition::SelfConsistent;
  const SphereErrors without = RecordErrors(own, *own.Solve());
  EXPECT_LT(without.Outside, with.Outside + 0.015);
  SphereProblem sum(Kirkwood(2), 12, 0.5);
  sum.Parameters.BoundaryCondition = BoundaryCondition::MultipleDebyeHueckel;
  // A known weakness of the sum: it ignores the cavity.
  EXPECT_GT(RecordErrors(sum, *sum.Solve()).Outside, 0.1);
}

TEST(PoissonBoltzmann, SurfaceValuesComeFromBothSides)
{
  SphereProblem problem(Kirkwood(2), 8, 0.25);
  const auto solution = problem.Solve();
  std::vector<Point3> points;
  for (int i = 0; i < 200; ++i)
  {
    const double z = -0.995 + 0.01 * i, t = 2.4 * i, r = std::sqrt(1.0 - z * z);
    points.push_back({ 8.0 + problem.Sphere.Center[0] + 5.0 * r * std::cos(t),
      8.0 + problem.Sphere.Center[1] + 5.0 * r * std::sin(t),
      8.0 + problem.Sphere.Center[2] + 5.0 * z });
  }
  const SurfaceValues values = EvaluateAtSurface(*solution, problem.Level, points, 298.15);
  EXPECT_EQ(values.Failed, 0);
  double sum = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point3 x = problem.World(points[i]);
    EXPECT_NEAR(values.Potential[i], problem.Sphere.Outside(x), 0.05);
    Point3 beyond = x;
    for (std::size_t a = 0; a < 3; ++a)
    {
      beyond[a] += 1e-3 * values.Normal[i][a];
    }
    const double field = -(problem.Sphere.Outside(beyond) - problem.Sphere.Outside(x)) / 1e-3;
    EXPECT_NEAR(values.NormalField[i], field, 0.06);
    sum += values.ChargeDensity[i] * 4.0 * Pi * 25.0 / static_cast<double>(points.size());
  }
  // Gauss: the induced charge is -(1/eps_m - 1/eps_s) times the charge within.
  EXPECT_NEAR(sum, -(1.0 / 2.0 - 1.0 / 80.0), 0.01);
}

TEST(PoissonBoltzmann, IdenticalOnOneAndTwoThreads)
{
  std::vector<double> potentials[2];
  for (int threads = 1; threads <= 2; ++threads)
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]()
      {
        SphereProblem problem(Kirkwood(3), 10, 0.625);
        problem.Parameters.BoundaryCondition = BoundaryCondition::SelfConsistent;
        potentials[threads - 1] = problem.Solve()->GetPotential();
      });
  }
  EXPECT_EQ(potentials[0], potentials[1]);
}

TEST(PoissonBoltzmann, ResolvingMatchesAFreshStart)
{
  SphereProblem problem(Kirkwood(3), 10, 0.5);
  const auto first = problem.Solve();
  first->Release();
  // The surface moves only on one side: there, crossings and the potentials of charges at them
  // change.
  for (std::size_t node = 0; node < problem.Distance.size(); ++node)
  {
    const Point3 x = problem.World(first->GetBox().Position(static_cast<std::int64_t>(node)));
    problem.Distance[node] += x[0] > 2.0 ? 0.02 * std::pow(x[0] - 2.0, 3) : 0.0;
  }
  const auto again = SolveAgain(problem.Level, *first);
  const auto fresh = problem.Solve();
  const std::size_t crossings = fresh->GetCrossings().size();
  ASSERT_EQ(again->GetCrossings().size(), crossings);
  std::size_t kept = 0;
  for (std::size_t c = 0; c < crossings; ++c)
  {
    const SecondOrderTaylor& a = again->GetChargesAtCrossings()[c];
    const SecondOrderTaylor& b = fresh->GetChargesAtCrossings()[c];
    ASSERT_EQ(a.Value, b.Value);
    ASSERT_EQ(a.Hessian, b.Hessian);
    for (const SecondOrderTaylor& old : first->GetChargesAtCrossings())
    {
      kept += old.Value == b.Value ? 1 : 0;
    }
  }
  EXPECT_GT(kept, crossings / 2);
  EXPECT_LT(kept, crossings);
  EXPECT_NEAR(again->GetReport().SolvationEnergy / fresh->GetReport().SolvationEnergy, 1.0, 1e-8);
  EXPECT_GT(
    std::abs(again->GetReport().SolvationEnergy / first->GetReport().SolvationEnergy - 1.0), 1e-3);
  double apart = 0.0;
  for (std::size_t node = 0; node < problem.Distance.size(); ++node)
  {
    apart = std::max(apart, std::abs(again->GetPotential()[node] - fresh->GetPotential()[node]));
  }
  EXPECT_LT(apart, 1e-5);
}

TEST(PoissonBoltzmann, ChargesScaleAndAdd)
{
  SphereProblem one(Kirkwood(2), 8, 1.0);
  const double energy = one.Solve()->GetReport().SolvationEnergy;
  SphereProblem three(Kirkwood(2), 8, 1.0);
  for (std::size_t i = 0; i < three.Atoms.size(); ++i)
  {
    three.Atoms[i].Charge *= -3.0;
    three.Sphere.Charges[i].Charge *= -3.0;
  }
  EXPECT_NEAR(three.Solve()->GetReport().SolvationEnergy / energy, 9.0, 1e-6);
}

TEST(PoissonBoltzmann, ForcesAreTheSlopeOfTheSeriesEnergy)
{
  SphereProblem problem(Kirkwood(3), 12, 0.5);
  const auto solution = problem.Solve();
  const auto& forces = solution->GetReport().AtomForces;
  double largest = 0.0, error = 0.0;
  for (std::size_t atom = 0; atom < problem.Atoms.size(); ++atom)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      double energies[2];
      for (const double side : { -1.0, 1.0 })
      {
        KirkwoodSphere moved = problem.Sphere;
        moved.Charges[atom].Position[a] += 1e-3 * side;
        energies[side > 0.0 ? 1 : 0] = moved.Energy();
      }
      const double exact = -(energies[1] - energies[0]) / 2e-3;
      largest = std::max(largest, std::abs(exact));
      error = std::max(error, std::abs(forces[atom][a] - exact));
    }
  }
  std::printf("forces: error %.3f of %.2f kT/angstrom\n", error, largest);
  EXPECT_LT(error, 0.01 * largest);
}

TEST(PoissonBoltzmann, IterationsOfTheBorderAreCounted)
{
  SphereProblem problem(Kirkwood(2), 12, 1.0);
  problem.Parameters.BoundaryCondition = BoundaryCondition::SelfConsistent;
  problem.Parameters.Padding = 8.0;
  problem.Parameters.Tolerance = 1e-3;
  const auto same = problem.Solve(); // the border from the same grid
  EXPECT_EQ(same->GetReport().BorderIterations, 0);
  EXPECT_GT(same->GetReport().Iterations, static_cast<int>(same->GetReport().Residuals.size()));
  SphereProblem fine(Kirkwood(2), 12, 0.5);
  fine.Parameters.BoundaryCondition = BoundaryCondition::SelfConsistent;
  const auto coarser = fine.Solve();
  EXPECT_GT(coarser->GetReport().BorderIterations, 1);
  EXPECT_EQ(
    coarser->GetReport().Iterations, static_cast<int>(coarser->GetReport().Residuals.size()));
}

TEST(PoissonBoltzmann, NoJumpNoReaction)
{
  KirkwoodSphere sphere = Kirkwood(2);
  sphere.Solvent = sphere.Solute;
  SphereProblem problem(sphere, 8, 0.5);
  const auto solution = problem.Solve();
  // u is 0 inside, except for the truncation error of G outside, which is the potential there.
  EXPECT_LT(std::abs(solution->GetReport().SolvationEnergy), 0.05);
}

void ExpectRefusal(SphereProblem& problem, const std::string& words)
{
  try
  {
    problem.Solve();
    ADD_FAILURE() << "not refused: " << words;
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(PoissonBoltzmann, RefusesInvalidInput)
{
  const double nan = std::nan("");
  const auto with = [](auto&& change, const char* words)
  {
    SphereProblem problem(Kirkwood(1), 6, 1.0);
    change(problem);
    ExpectRefusal(problem, words);
  };
  with([&](SphereProblem& p) { p.Parameters.SoluteDielectric = nan; }, "SoluteDielectric");
  with([&](SphereProblem& p) { p.Parameters.SolventDielectric = -80.0; }, "SolventDielectric");
  with([&](SphereProblem& p) { p.Parameters.Temperature = 0.0; }, "Temperature");
  with([&](SphereProblem& p) { p.Parameters.IonRadius = -1.0; }, "IonRadius");
  with([&](SphereProblem& p) { p.Parameters.Tolerance = 0.0; }, "Tolerance");
  with([&](SphereProblem& p) { p.Parameters.Ions = { { 2.0, 0.1 }, { -1.0, 0.1 } }; }, "neutral");
  with([&](SphereProblem& p) { p.Level.Level = -100.0; }, "No node is inside");
  with([&](SphereProblem& p) { p.Level.Level = 100.0; }, "leaves the volume");
  with(
    [&](SphereProblem& p) {
      p.Atoms.front().Position = { 1e4, 0.0, 0.0 };
    },
    "near the charge of atom 0");
}

}
