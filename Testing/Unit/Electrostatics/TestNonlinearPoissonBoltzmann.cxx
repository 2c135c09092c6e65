// A highly charged sphere in salt against the radial equation, solved here by shooting on a fine
// mesh; small charges against the linear equation; salts of several valences.

#include "SphereProblem.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// phi(r) outside a sphere of charge q at its centre: (r^2 phi')' = r^2 f(phi) / eps_s from a on,
/// phi' = -C q / (eps_s r^2) before. Integrated inwards from the Debye-Hueckel tail, whose height
/// is found by bisection.
class RadialSolution
{
public:
  RadialSolution(double charge, double radius, double layer, const IonAtmosphere& ions)
    : Inner(radius + layer)
    , Solvent(80.0)
    , Strength(units::CoulombLength(298.15) * charge / this->Solvent)
    , Ions(ions)
  {
    double low = 0.0, high = 200.0 * std::abs(this->Strength);
    for (int step = 0; step < 200; ++step)
    {
      const double height = 0.5 * (low + high);
      (this->Integrate(height) > std::abs(this->Strength) ? high : low) = height;
    }
  }

  double operator()(double r) const
  {
    if (r < this->Inner)
    {
      return this->Values.front() + this->Strength * (1.0 / r - 1.0 / this->Inner);
    }
    const double place = (r - this->Inner) / Step;
    const auto i = std::min(static_cast<std::size_t>(place), this->Values.size() - 2);
    const double t = place - static_cast<double>(i);
    return (1.0 - t) * this->Values[i] + t * this->Values[i + 1];
  }

private:
  static constexpr double Step = 0.002;
  static constexpr std::size_t Count = 30000; // 60 angstrom

  /// -r^2 phi' at the inner radius for a tail of that height; Runge-Kutta inwards.
  double Integrate(double height)
  {
    const double kappa = std::sqrt(this->Ions.Linear() / this->Solvent);
    const double sign = this->Strength < 0.0 ? -1.0 : 1.0;
    double r = this->Inner + Step * static_cast<double>(Count);
    double phi = sign * height * std::exp(-kappa * (r - this->Inner)) / r;
    double flux = -r * (1.0 + kappa * r) * phi; // r^2 phi'
    this->Values.assign(Count + 1, 0.0);
    this->Values[Count] = phi;
    const auto slopes = [&](double x, double p, double f) {
      return std::pair<double, double>(f / (x * x), x * x * this->Ions.Charge(p) / this->Solvent);
    };
    for (std::size_t i = Count; i-- > 0;)
    {
      const double d = -Step;
      const auto k1 = slopes(r, phi, flux);
      const auto k2 = slopes(r + 0.5 * d, phi + 0.5 * d * k1.first, flux + 0.5 * d * k1.second);
      const auto k3 = slopes(r + 0.5 * d, phi + 0.5 * d * k2.first, flux + 0.5 * d * k2.second);
      const auto k4 = slopes(r + d, phi + d * k3.first, flux + d * k3.second);
      phi += d / 6.0 * (k1.first + 2.0 * k2.first + 2.0 * k3.first + k4.first);
      flux += d / 6.0 * (k1.second + 2.0 * k2.second + 2.0 * k3.second + k4.second);
      r += d;
      this->Values[i] = phi;
      if (std::abs(phi) > 40.0)
      {
        return 1e9;
      }
    }
    return std::abs(flux);
  }

  double Inner, Solvent, Strength;
  const IonAtmosphere& Ions;
  std::vector<double> Values;
};

/// Largest error outside of a sphere of 10 angstrom with 40 e in 0.15 M; Newton's steps.
double ChargedSphere(double layer, double h, int& steps, BoundaryCondition condition)
{
  KirkwoodSphere sphere;
  sphere.Centre = { 0.11, -0.07, 0.05 };
  sphere.Radius = 10.0;
  sphere.Charges.push_back({ sphere.Centre, 40.0, 10.0 });
  SphereProblem problem(sphere, 20, h);
  problem.Parameters.Ions = { { 1.0, 0.15 }, { -1.0, 0.15 } };
  problem.Parameters.IonRadius = layer;
  problem.Parameters.Nonlinear = true;
  problem.Parameters.Tolerance = 1e-7;
  problem.Parameters.Condition = condition;
  const IonAtmosphere ions(problem.Parameters.Ions, 298.15);
  const RadialSolution exact(40.0, 10.0, layer, ions);
  problem.Parameters.Boundary = [&](const Vector3& x)
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

TEST(NonlinearPoissonBoltzmann, BorderOfItsOwn)
{
  int steps = 0;
  EXPECT_LE(ChargedSphere(2.0, 1.0, steps, BoundaryCondition::SelfConsistent), 0.35);
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
  const double f0 =
    8.0 * units::Pi * units::CoulombLength(298.15) * 0.1 * units::IonsPerCubicAngstrom;
  for (const double u : { -3.0, -0.1, 0.0, 0.5, 4.0 })
  {
    EXPECT_NEAR(ions.Charge(u), f0 * std::sinh(u), 1e-12 * std::cosh(u));
    EXPECT_NEAR(ions.Derivative(u), f0 * std::cosh(u), 1e-12 * std::cosh(u));
    const double c = 0.1 * units::IonsPerCubicAngstrom;
    EXPECT_NEAR(
      ions.Energy(u), c * (u * std::sinh(u) - 2.0 * (std::cosh(u) - 1.0)), 1e-15 * std::cosh(u));
  }
  // Beyond 50 kT/e it goes on linearly, and stays finite.
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
