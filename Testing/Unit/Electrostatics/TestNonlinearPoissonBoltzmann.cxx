// A highly charged sphere in salt against the radial equation, solved here by shooting on a fine
// mesh; small charges against the linear equation; salts of several valences.

#include "RadialSolution.h"
#include "SphereProblem.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Largest error outside of a sphere of 10 angstrom with 40 e in 0.15 M; Newton's steps.
double ChargedSphere(double layer, double h, int& steps, BoundaryCondition condition,
  const std::vector<IonSpecies>& salt = { { 1.0, 0.15 }, { -1.0, 0.15 } },
  DielectricModel model = DielectricModel::SharpInterface)
{
  KirkwoodSphere sphere;
  sphere.Center = { 0.11, -0.07, 0.05 };
  sphere.Radius = 10.0;
  sphere.Charges.push_back({ sphere.Center, 40.0, 10.0 });
  SphereProblem problem(sphere, 20, h);
  problem.Parameters.DielectricModel = model;
  problem.Parameters.Ions = salt;
  problem.Parameters.IonRadius = layer;
  problem.Parameters.Nonlinear = true;
  problem.Parameters.Tolerance = 1e-7;
  problem.Parameters.BoundaryCondition = condition;
  const IonAtmosphere ions(problem.Parameters.Ions, 298.15);
  const RadialSolution exact(40.0, 10.0, layer, ions);
  problem.Parameters.Boundary = [&](const Point3& x)
  { return exact(problem.Sphere.Distance(problem.World(x))); };
  const auto solution = problem.Solve();
  double error = 0.0;
  for (std::int64_t node = 0; node < solution->GetBox().Size(); ++node)
  {
    const double r = problem.Sphere.Distance(problem.World(solution->GetBox().Position(node)));
    if (r > 10.0 && r < 20.0)
    {
      const double u = solution->GetPotential()[static_cast<std::size_t>(node)];
      error = std::max(error, std::abs(u - exact(r)));
    }
  }
  steps = solution->GetReport().NewtonSteps;
  std::printf("layer %g h %g: error %.4f of %.2f at the surface, %d Newton steps, %d iterations\n",
    layer, h, error, exact(10.0), steps, solution->GetReport().Iterations);
  return error;
}

TEST(NonlinearPoissonBoltzmann, SphereOf40ChargesUnderALayer)
{
  int steps = 0;
  const double coarse = ChargedSphere(2.0, 1.0, steps, BoundaryCondition::Given);
  const double fine = ChargedSphere(2.0, 0.5, steps, BoundaryCondition::Given);
  EXPECT_LE(fine, 0.1);
  EXPECT_LE(steps, 8);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(NonlinearPoissonBoltzmann, SphereOf40ChargesWithoutALayer)
{
  int steps = 0;
  EXPECT_LE(ChargedSphere(0.0, 0.5, steps, BoundaryCondition::Given), 0.2);
  EXPECT_LE(steps, 8);
}

TEST(NonlinearPoissonBoltzmann, SphereInTheSmoothMode)
{
  int steps = 0;
  EXPECT_LE(ChargedSphere(0.0, 1.0, steps, BoundaryCondition::Given,
              { { 1.0, 0.15 }, { -1.0, 0.15 } }, DielectricModel::SmoothDielectric),
    0.6);
  EXPECT_LE(steps, 8);
}

TEST(NonlinearPoissonBoltzmann, IonsOfThreeRadii)
{
  // Chloride at 2, sulphate at 4, sodium at 3: between these the salt alone is not neutral.
  const std::vector<IonSpecies> salt{ { -1.0, 0.1 }, { -2.0, 0.05, 4.0 }, { 1.0, 0.2, 3.0 } };
  int steps = 0;
  EXPECT_LE(ChargedSphere(2.0, 0.5, steps, BoundaryCondition::Given, salt), 0.1);
  EXPECT_LE(steps, 8);
}

TEST(NonlinearPoissonBoltzmann, SelfConsistentBorder)
{
  int steps = 0;
  EXPECT_LE(ChargedSphere(2.0, 1.0, steps, BoundaryCondition::SelfConsistent), 0.35);
}

/// phi(r) outside an endless cylinder with `perLength` e/angstrom on its axis: (r phi')' =
/// r f(phi) / eps_s beyond `radius`, by shooting inwards from the tail of the linear equation.
class CylinderSolution
{
public:
  CylinderSolution(double perLength, double radius, const IonAtmosphere& ions)
    : Inner(radius)
    , Ions(ions)
  {
    const double flux = 2.0 * units::CoulombLength(298.15) * std::abs(perLength) / Solvent;
    double low = 0.0, high = 100.0;
    for (int step = 0; step < 100; ++step)
    {
      const double height = 0.5 * (low + high);
      (this->Integrate(height) > flux ? high : low) = height;
    }
  }
  double operator()(double r) const
  {
    const double place = (r - this->Inner) / Step;
    const auto i = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(i);
    return (1.0 - t) * this->Values[i] + t * this->Values[i + 1];
  }

private:
  static constexpr double Step = 0.002, Solvent = 80.0;
  static constexpr std::size_t Count = 30000; // 60 angstrom

  /// r |phi'| at the cylinder for a tail of that height, an asymptotic K_0.
  double Integrate(double height)
  {
    const double kappa = std::sqrt(this->Ions.Linear() / Solvent);
    double r = this->Inner + Step * static_cast<double>(Count);
    double phi = -height * std::exp(-kappa * (r - this->Inner)) / std::sqrt(r);
    double flux = -r * phi * (kappa + 0.5 / r);
    this->Values.assign(Count + 1, phi);
    for (std::size_t i = Count; i-- > 0;)
    {
      const auto slope = [&](double x, double p) { return x * this->Ions.Charge(p) / Solvent; };
      // Midpoint rule; 60 angstrom in steps of a five-hundredth leave 1e-6.
      const double middle = phi - 0.5 * Step * flux / r;
      const double half = flux - 0.5 * Step * slope(r, phi);
      phi -= Step * half / (r - 0.5 * Step);
      flux -= Step * slope(r - 0.5 * Step, middle);
      r -= Step;
      this->Values[i] = phi;
      if (phi < -30.0)
      {
        return 1e9;
      }
    }
    return std::abs(flux);
  }

  double Inner;
  const IonAtmosphere& Ions;
  std::vector<double> Values;
};

/// 24 base pairs of B-DNA by their phosphates (S. Arnott and D. W. L. Hukins, Biochem. Biophys.
/// Res. Commun. 47 (1972) 1504: 8.91 angstrom off the axis, 3.38 angstrom and 36 degrees a pair),
/// under the surface of a rod of 10.4 angstrom, in 0.15 mol/l.
void CheckDNA(double phosphate, double layer, double demand)
{
  constexpr int pairs = 24;
  constexpr double rise = 3.38, radius = 10.4, h = 1.0, margin = 6.0;
  const double middle = radius + margin + 0.31;
  const std::array<std::int64_t, 3> n{ 34, 34, 116 };
  const double low = middle, high = middle + rise * (pairs - 1);
  std::vector<double> distance;
  for (std::int64_t node = 0; node < n[0] * n[1] * n[2]; ++node)
  {
    const double x = h * static_cast<double>(node % n[0]) - middle;
    const double y = h * static_cast<double>(node / n[0] % n[1]) - middle;
    const double z = h * static_cast<double>(node / (n[0] * n[1]));
    distance.push_back(std::hypot(x, y, z - std::clamp(z, low, high)) - radius);
  }
  LevelFunction level;
  level.Doubles = { distance.data(), n, { h, h, h } };
  level.InsideIsHigher = false;
  std::vector<ChargedAtom> atoms;
  for (int pair = 0; pair < pairs; ++pair)
  {
    for (const double strand : { 0.0, 155.0 }) // degrees across the minor groove
    {
      const double turn = (36.0 * pair + strand) * Pi / 180.0;
      atoms.push_back({ { middle + phosphate * std::cos(turn), middle + phosphate * std::sin(turn),
                          low + rise * pair },
        -1.0, 2.0 });
    }
  }
  PoissonBoltzmannParameters parameters;
  parameters.Ions = { { 1.0, 0.15 }, { -1.0, 0.15 } };
  parameters.IonRadius = layer;
  parameters.Nonlinear = true;
  parameters.Padding = 16.0;
  const IonAtmosphere ions(parameters.Ions, 298.15);
  const auto solution =
    SolvePoissonBoltzmann(level, BoxAround(level, parameters.Padding), atoms, parameters, ions);
  EXPECT_LE(solution->GetReport().NewtonSteps, 8);
  // Halfway along the rod, at four angstrom and more from it, the grooves have been averaged out.
  const CylinderSolution exact(-2.0 / rise, radius + layer, ions);
  for (const double r : { 15.0, 17.0, 20.0 })
  {
    double sum = 0.0, count = 0.0;
    for (std::int64_t node = 0; node < solution->GetBox().Size(); ++node)
    {
      const Point3 x = solution->GetBox().Position(node);
      const double off = std::hypot(x[0] - middle, x[1] - middle);
      if (std::abs(x[2] - 0.5 * (low + high)) < 8.45 && std::abs(off - r) < 0.5)
      {
        sum += solution->GetPotential()[static_cast<std::size_t>(node)] - exact(off);
        count += 1.0;
      }
    }
    std::printf("DNA, layer %g: %d Newton steps, %d iterations; at %g angstrom %.4f kT/e, off by "
                "%.4f\n",
      layer, solution->GetReport().NewtonSteps, solution->GetReport().Iterations, r, exact(r),
      sum / count);
    EXPECT_NEAR(sum / count / exact(r), 0.0, demand);
  }
}

TEST(NonlinearPoissonBoltzmann, StretchOfDNA)
{
  // Near the axis they act like a line of charge; as a helix they attract a few more ions.
  CheckDNA(2.0, 2.0, 0.02);
  CheckDNA(2.0, 0.0, 0.02);
  CheckDNA(8.91, 2.0, 0.1);
  CheckDNA(8.91, 0.0, 0.1);
}

TEST(NonlinearPoissonBoltzmann, SmallChargesAreLinear)
{
  KirkwoodSphere sphere = Kirkwood(3);
  for (ChargedAtom& atom : sphere.Charges)
  {
    atom.Charge *= 1e-3;
  }
  double energies[2];
  for (const bool nonlinear : { false, true })
  {
    SphereProblem problem(sphere, 10, 1.0);
    problem.Parameters.Nonlinear = nonlinear;
    energies[nonlinear ? 1 : 0] = problem.Solve()->GetReport().SolvationEnergy;
  }
  EXPECT_NEAR(energies[1] / energies[0], 1.0, 1e-5);
}

TEST(IonAtmosphere, OneToOneSaltIsASinh)
{
  const IonAtmosphere ions({ { 1.0, 0.1 }, { -1.0, 0.1 } }, 298.15);
  const double f0 = 8.0 * Pi * units::CoulombLength(298.15) * 0.1 * units::IonsPerCubicAngstrom;
  for (const double u : { -3.0, -0.1, 0.0, 0.5, 4.0 })
  {
    EXPECT_NEAR(ions.Charge(u), f0 * std::sinh(u), 1e-12 * std::cosh(u));
    EXPECT_NEAR(ions.Derivative(u), f0 * std::cosh(u), 1e-12 * std::cosh(u));
    const double c = 0.1 * units::IonsPerCubicAngstrom;
    EXPECT_NEAR(
      ions.Energy(u), c * (u * std::sinh(u) - 2.0 * (std::cosh(u) - 1.0)), 1e-15 * std::cosh(u));
  }
  // Beyond 50 kT/e it is continued linearly, and stays finite.
  EXPECT_TRUE(std::isfinite(ions.Charge(1e4)));
  EXPECT_NEAR(
    ions.Charge(60.0) - ions.Charge(50.0), 10.0 * ions.Derivative(50.0), 1e-6 * ions.Charge(60.0));
  // Debye length at 0.1 M: 9.6 angstrom.
  EXPECT_NEAR(1.0 / std::sqrt(ions.Linear() / 80.0), 9.7, 0.15);
}

TEST(IonAtmosphere, MixedSaltsNeedToBeNeutral)
{
  const IonAtmosphere magnesium({ { 2.0, 0.05 }, { -1.0, 0.1 } }, 298.15);
  EXPECT_NEAR(magnesium.Charge(0.0), 0.0, 1e-12);
  EXPECT_LT(magnesium.Charge(-1.0), -magnesium.Charge(1.0)); // divalent ions gather more
  EXPECT_THROW(IonAtmosphere({ { 2.0, 0.1 }, { -1.0, 0.1 } }, 298.15), std::invalid_argument);
  EXPECT_THROW(IonAtmosphere({ { 1.0, -0.1 } }, 298.15), std::invalid_argument);
}

}
