// Two interacting charged spheres, compared with their multipoles: the narrow solvent between them,
// energies and potentials; far apart they are Kirkwood's.

#include "Electrostatics/PoissonBoltzmann.h"
#include "KirkwoodSphere.h"
#include "TwoSpheres.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Charges off the centers, towards each other, and a gap.
TwoSpheres Pair(double gap)
{
  return { { -0.5 * gap - 3.0, 3.0, 1.0, 1.2 }, { 0.5 * gap + 2.5, 2.5, -1.0, -0.8 }, 2.0, 80.0 };
}

struct PairErrors
{
  double Energy = 0.0, Outside = 0.0;
  int Iterations = 0;
};

/// The pair on an axis along no axis of the grid, off its nodes.
PairErrors SolvePair(const TwoSpheres& pair, double half, double h)
{
  const Point3 axis{ 2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0 };
  const Point3 middle{ half + 0.11, half - 0.07, half + 0.05 };
  const auto n = static_cast<std::int64_t>(std::llround(2.0 * half / h)) + 1;
  const auto along = [&](double z) {
    return Point3{ middle[0] + z * axis[0], middle[1] + z * axis[1], middle[2] + z * axis[2] };
  };
  std::vector<double> distance;
  LevelFunction level;
  std::vector<ChargedAtom> atoms;
  for (const auto& s : pair.Spheres)
  {
    atoms.push_back({ along(s.Z + s.Offset), s.Charge, s.Radius });
  }
  for (std::int64_t node = 0; node < n * n * n; ++node)
  {
    double least = 1e300;
    for (const auto& s : pair.Spheres)
    {
      const Point3 c = along(s.Z);
      least = std::min(least,
        std::hypot(h * static_cast<double>(node % n) - c[0],
          h * static_cast<double>(node / n % n) - c[1],
          h * static_cast<double>(node / (n * n)) - c[2]) -
          s.Radius);
    }
    distance.push_back(least);
  }
  level.Doubles = { distance.data(), { n, n, n }, { h, h, h } };
  level.InsideIsHigher = false;
  /// In cylindrical coordinates: z along the axis, x the distance from it.
  const auto onAxis = [&](const Point3& x)
  {
    const Point3 y{ x[0] - middle[0], x[1] - middle[1], x[2] - middle[2] };
    const double z = y[0] * axis[0] + y[1] * axis[1] + y[2] * axis[2];
    const double r2 = y[0] * y[0] + y[1] * y[1] + y[2] * y[2] - z * z;
    return Point3{ std::sqrt(std::max(0.0, r2)), 0.0, z };
  };
  PoissonBoltzmannParameters parameters;
  parameters.Tolerance = 1e-9;
  parameters.Padding = 0.0;
  parameters.BoundaryCondition = BoundaryCondition::Given;
  parameters.Boundary = [&](const Point3& x) { return pair.Outside(onAxis(x)); };
  const IonAtmosphere ions({}, parameters.Temperature);
  const auto solution =
    SolvePoissonBoltzmann(level, BoxAround(level, 0.0), atoms, parameters, ions);
  PairErrors errors;
  for (std::int64_t node = 0; node < solution->GetBox().Size(); ++node)
  {
    const auto i = static_cast<std::size_t>(node);
    if (!solution->GetInside()[i])
    {
      const double exact = pair.Outside(onAxis(solution->GetBox().Position(node)));
      errors.Outside = std::max(errors.Outside, std::abs(solution->GetPotential()[i] - exact));
    }
  }
  errors.Energy = std::abs(solution->GetReport().SolvationEnergy / pair.Energy() - 1.0);
  errors.Iterations = solution->GetReport().Iterations;
  return errors;
}

TEST(TwoSpheres, ReferenceIsKirkwoodsFarApart)
{
  const TwoSpheres far = Pair(4000.0);
  KirkwoodSphere one;
  one.Radius = 3.0;
  one.Charges = { { { 0.0, 0.0, 1.2 }, 1.0, 1.0 } };
  EXPECT_NEAR(far.ReactionAtCharge(0) / one.Reaction(one.Charges[0].Position), 1.0, 1e-4);
}

TEST(TwoSpheres, ReferenceKeepsChargeAndMirrors)
{
  const TwoSpheres pair = Pair(2.0);
  const double far = 1e4;
  EXPECT_NEAR(pair.Outside({ far, 0.0, 0.0 }) * far, 0.0, 0.05); // charges cancel
  // Mirrored along the axis: the same values.
  const TwoSpheres mirror{ { -1.0 - 2.5, 2.5, -1.0, 0.8 }, { 1.0 + 3.0, 3.0, 1.0, -1.2 }, 2.0,
    80.0 };
  EXPECT_NEAR(mirror.Energy() / pair.Energy(), 1.0, 1e-12);
  EXPECT_NEAR(mirror.Outside({ 3.0, 0.0, 1.0 }) / pair.Outside({ 3.0, 0.0, -1.0 }), 1.0, 1e-10);
}

TEST(TwoSpheres, SolutionConvergesToTheMultipoles)
{
  const TwoSpheres pair = Pair(2.0);
  PairErrors errors[3];
  for (int i = 0; i < 3; ++i)
  {
    errors[i] = SolvePair(pair, 11.0, 1.0 / (1 << i));
    std::printf("two spheres h=%g: energy %.2e outside %.4f iterations %d\n", 1.0 / (1 << i),
      errors[i].Energy, errors[i].Outside, errors[i].Iterations);
    EXPECT_LE(errors[i].Iterations, 12);
  }
  EXPECT_LE(errors[1].Energy, 1e-3);
  EXPECT_LE(errors[2].Energy, 2.5e-4);
  EXPECT_LE(errors[1].Outside, 0.1);
  EXPECT_LE(errors[2].Outside, 0.04);
  EXPECT_GT(0.5 * std::log2(errors[0].Outside / errors[2].Outside), 1.3);
}

}
