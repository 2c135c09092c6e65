// The total force on each atom compared with the slope of the solvation energy when the atom and
// the surface move; the ions' part in strong salt; shares of atoms in a surface's motion.

#include "Electrostatics/BoundaryForces.h"

#include "Core/Geometry.h"
#include "Electrostatics/PoissonBoltzmann.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace isthmus;

namespace
{

constexpr double Decay = 2.3;
constexpr Point3 Fine{ 0.3, 0.3, 0.3 };

std::vector<ChargedAtom> Molecule()
{
  return { { { 8.1, 9.3, 8.9 }, 1.0, 1.9 }, { { 10.4, 8.8, 9.2 }, -0.6, 1.5 },
    { { 9.3, 10.9, 9.6 }, 0.7, 1.7 }, { { 9.0, 8.6, 11.0 }, 0.4, 1.4 } };
}

/// Energy and forces, kT and angstrom, on the level of the atoms' Gaussians on a fixed grid.
struct Result
{
  double Energy;
  std::vector<Point3> Reaction;
  BoundaryForces Boundary;
};

Result Solve(const std::vector<ChargedAtom>& atoms, const PoissonBoltzmannParameters& parameters,
  const Point3& spacing = { 0.4, 0.4, 0.4 })
{
  std::array<std::int64_t, 3> n;
  for (std::size_t a = 0; a < 3; ++a)
  {
    n[a] = static_cast<std::int64_t>(std::lround(19.2 / spacing[a])) + 1;
  }
  // By hand, since MolecularDensity's cells are cubes and its sums float.
  std::vector<double> density(static_cast<std::size_t>(n[0] * n[1] * n[2]), 0.0);
  for (std::size_t node = 0; node < density.size(); ++node)
  {
    const auto p = static_cast<std::int64_t>(node);
    const Point3 x{ static_cast<double>(p % n[0]) * spacing[0],
      static_cast<double>(p / n[0] % n[1]) * spacing[1],
      static_cast<double>(p / (n[0] * n[1])) * spacing[2] };
    for (const ChargedAtom& ball : atoms)
    {
      const double d =
        std::hypot(x[0] - ball.Position[0], x[1] - ball.Position[1], x[2] - ball.Position[2]);
      density[node] += std::exp(-Decay * (d * d / (ball.Radius * ball.Radius) - 1.0));
    }
  }
  LevelFunction level;
  level.Doubles = { density.data(), n, { spacing[0], spacing[1], spacing[2] } };
  level.Level = 1.0;
  level.Logarithm = true;
  const IonAtmosphere ions(parameters.Ions, parameters.Temperature);
  const auto solution =
    SolvePoissonBoltzmann(level, BoxAround(level, 5.0), atoms, parameters, ions);
  return { solution->GetReport().SolvationEnergy, solution->GetReport().AtomForces,
    ForcesOnBoundary(*solution, SurfaceMotion(atoms, Decay)) };
}

Point3 Whole(const Result& result, std::size_t atom)
{
  Point3 force;
  for (std::size_t a = 0; a < 3; ++a)
  {
    force[a] = result.Reaction[atom][a] + result.Boundary.Dielectric[atom][a] +
      result.Boundary.Ionic[atom][a];
  }
  return force;
}

/// Minus the slope of the energy along an axis.
double Slope(const PoissonBoltzmannParameters& parameters, std::size_t atom, std::size_t axis,
  const Point3& spacing = { 0.4, 0.4, 0.4 })
{
  constexpr double step = 0.05;
  auto atoms = Molecule();
  atoms[atom].Position[axis] += step;
  const double up = Solve(atoms, parameters, spacing).Energy;
  atoms[atom].Position[axis] -= 2.0 * step;
  return -(up - Solve(atoms, parameters, spacing).Energy) / (2.0 * step);
}

double Length(const Point3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

PoissonBoltzmannParameters Water()
{
  PoissonBoltzmannParameters parameters;
  parameters.Tolerance = 1e-9;
  return parameters;
}

TEST(BoundaryForces, WithTheReactionForceTheyAreTheEnergyGradient)
{
  const PoissonBoltzmannParameters parameters = Water();
  const Result result = Solve(Molecule(), parameters);
  double largest = 0.0, error = 0.0, reaction = 0.0;
  for (const auto& [atom, axis] :
    { std::pair<std::size_t, std::size_t>{ 0, 0 }, { 1, 0 }, { 2, 1 }, { 3, 2 } })
  {
    const double slope = Slope(parameters, atom, axis);
    largest = std::max(largest, std::abs(slope));
    error = std::max(error, std::abs(Whole(result, atom)[axis] - slope));
    reaction = std::max(reaction, std::abs(result.Reaction[atom][axis] - slope));
  }
  std::printf(
    "force: error %.3f of %.2f kT/angstrom; without the boundary %.2f\n", error, largest, reaction);
  EXPECT_LT(error, 0.03 * largest);
  EXPECT_GT(reaction, 0.2 * largest); // so the boundary's part is needed
}

TEST(BoundaryForces, TheNetForceIsZero)
{
  for (const Point3& spacing : { Point3{ 0.4, 0.4, 0.4 }, Point3{ 0.3, 0.4, 0.48 } })
  {
    PoissonBoltzmannParameters parameters = Water();
    parameters.Ions = { { 1.0, 0.5 }, { -1.0, 0.5 } };
    const Result result = Solve(Molecule(), parameters, spacing);
    Point3 net{ 0.0, 0.0, 0.0 };
    double sum = 0.0;
    for (std::size_t atom = 0; atom < result.Reaction.size(); ++atom)
    {
      const Point3 force = Whole(result, atom);
      sum += Length(force);
      for (std::size_t a = 0; a < 3; ++a)
      {
        net[a] += force[a];
      }
    }
    std::printf("net %.3f of %.2f kT/angstrom\n", Length(net), sum);
    EXPECT_LT(Length(net), 0.02 * sum);
  }
}

/// The dielectric constant of water inside as well, and a high ionic strength: the surface only
/// affects the ions.
void ExpectIonsForce(double radius, bool nonlinear, double tolerance)
{
  PoissonBoltzmannParameters parameters = Water();
  parameters.SoluteDielectric = parameters.SolventDielectric;
  parameters.Ions = { { 1.0, 5.0 }, { -1.0, 5.0 } };
  parameters.IonRadius = radius;
  parameters.Nonlinear = nonlinear;
  const Result result = Solve(Molecule(), parameters, Fine);
  const double error = Whole(result, 0)[0] - Slope(parameters, 0, 0, Fine);
  const double ions = result.Boundary.Ionic[0][0];
  std::printf("ions' boundary force %.4f, error %.4f\n", ions, error);
  EXPECT_EQ(result.Boundary.Dielectric[0][0], 0.0);
  EXPECT_LT(std::abs(error), tolerance * std::abs(ions));
}

TEST(BoundaryForces, IonsUnderALayerExertPressure)
{
  ExpectIonsForce(0.6, false, 0.06);
  ExpectIonsForce(0.6, true, 0.06);
}

TEST(BoundaryForces, IonsAtTheSurfaceExertPressure)
{
  ExpectIonsForce(0.0, false, 0.06);
  // 12 % if the energy's sum counted cells cut by the surface as whole cells.
  ExpectIonsForce(0.0, true, 0.03);
}

TEST(BoundaryForces, CutCellsSumToTheVolume)
{
  constexpr double h = 0.5, radius = 4.0;
  constexpr std::int64_t n = 31;
  std::vector<double> distance;
  for (std::int64_t node = 0; node < n * n * n; ++node)
  {
    const auto at = [&](std::int64_t i, double center)
    { return h * static_cast<double>(i) - center; };
    distance.push_back(
      std::hypot(at(node % n, 7.41), at(node / n % n, 7.63), at(node / n / n, 7.55)) - radius);
  }
  LevelFunction level;
  level.Doubles = { distance.data(), { n, n, n }, { h, h, h } };
  level.InsideIsHigher = false;
  const SolverBox box = BoxAround(level, 2.0);
  const auto inside = ClassifyNodes(level, box);
  double cells = 0.0, whole = 0.0;
  for (const unsigned char in : inside)
  {
    whole += in ? 1.0 : 0.0;
  }
  for (const CutCell& cell : CutCells(box, inside, FindCrossings(level, box, inside)))
  {
    cells -= cell.Excess;
  }
  const double exact = 4.0 / 3.0 * Pi * std::pow(radius / h, 3);
  // A border of width h has an excess of h^2 / (4 R^2) over a sphere.
  EXPECT_NEAR((whole + cells) / exact, 1.0 + 0.25 * h * h / (radius * radius), 2e-4);
}

TEST(SurfaceMotion, SharesSumToTheNormal)
{
  const auto atoms = Molecule();
  const SurfaceMotion motion(atoms, Decay);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(6.0, 13.0);
  std::vector<SurfaceShare> shares;
  for (int i = 0; i < 200; ++i)
  {
    const Point3 x{ place(random), place(random), place(random) };
    motion.At(x, { 0.0, 0.0, 1.0 }, shares);
    Point3 sum{ 0.0, 0.0, 0.0 };
    for (const SurfaceShare& share : shares)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        sum[a] += share.Part[a];
      }
    }
    EXPECT_NEAR(Length(sum), 1.0, 1e-12);
  }
}

TEST(SurfaceMotion, OtherSurfacesMoveWithTheNearestBall)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-20.0, 20.0), size(0.0, 3.0);
  std::vector<ChargedAtom> atoms;
  for (int i = 0; i < 300; ++i)
  {
    atoms.push_back({ { place(random), place(random), 0.1 * place(random) }, 0.0, size(random) });
  }
  const SurfaceMotion motion(atoms, 0.0);
  std::vector<SurfaceShare> shares;
  for (int i = 0; i < 500; ++i)
  {
    const double far = i % 5 == 0 ? 8.0 : 1.0;
    const Point3 x{ far * place(random), place(random), far * place(random) };
    std::size_t nearest = 0;
    const auto distance = [&](std::size_t a)
    {
      const Point3& p = atoms[a].Position;
      return std::hypot(x[0] - p[0], x[1] - p[1], x[2] - p[2]) - atoms[a].Radius;
    };
    for (std::size_t a = 1; a < atoms.size(); ++a)
    {
      nearest = distance(a) < distance(nearest) ? a : nearest;
    }
    motion.At(x, { 1.0, 0.0, 0.0 }, shares);
    ASSERT_EQ(shares.size(), 1U);
    EXPECT_EQ(shares.front().Atom, nearest);
  }
}

}
