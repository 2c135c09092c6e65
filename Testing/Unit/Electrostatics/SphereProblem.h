/**
 * @file SphereProblem.h
 * @brief Kirkwood's spheres on grids, and the deviation of a solution from the series.
 */
#ifndef isthmus_SphereProblem_h
#define isthmus_SphereProblem_h

#include "Electrostatics/PoissonBoltzmann.h"
#include "KirkwoodSphere.h"

#include <algorithm>

namespace isthmus::testing
{

/// K1: Born's ion. K2: three charges off the center; K3 the same with kappa 0.1; K4: charges one
/// angstrom under the surface. Centers are not at nodes.
inline KirkwoodSphere Kirkwood(int number)
{
  KirkwoodSphere s;
  s.Center = { 0.11, -0.07, 0.05 };
  const auto add = [&](double q, double x, double y, double z) {
    s.Charges.push_back({ { s.Center[0] + x, s.Center[1] + y, s.Center[2] + z }, q, 1.0 });
  };
  s.Radius = number == 1 ? 2.0 : 5.0;
  s.Solute = number == 1 ? 1.0 : 2.0;
  s.Kappa = number == 3 ? 0.1 : 0.0;
  if (number == 1)
  {
    add(1, 0, 0, 0);
  }
  else if (number < 4)
  {
    add(1, 2.5, 0, 0);
    add(-1, 0, -3, 0.5);
    add(1, -1, 1.5, 3);
  }
  else
  {
    add(1, 4, 0, 0);
    add(-1, 0, -3.2, 2.4);
    add(1, -2.31, 2.31, 2.31);
  }
  return s;
}

/// The ionic strength, mol/l, that gives kappa.
inline double StrengthFor(double kappa, double solvent, double kelvin = 298.15)
{
  return kappa * kappa * solvent /
    (8.0 * Pi * units::CoulombLength(kelvin) * units::IonsPerCubicAngstrom);
}

/// A sphere as a signed distance on nodes of [-half, half]^3.
struct SphereProblem
{
  KirkwoodSphere Sphere;
  double Half;
  std::vector<double> Distance;
  LevelFunction Level;
  std::vector<ChargedAtom> Atoms; ///< in the frame of the grid
  PoissonBoltzmannParameters Parameters;
  std::unique_ptr<IonAtmosphere> Ions;

  SphereProblem(KirkwoodSphere sphere, double half, double h)
    : Sphere(std::move(sphere))
    , Half(half)
  {
    const auto n = static_cast<std::int64_t>(std::llround(2.0 * half / h)) + 1;
    for (std::int64_t node = 0; node < n * n * n; ++node)
    {
      this->Distance.push_back(
        this->Sphere.Distance(this->World({ h * static_cast<double>(node % n),
          h * static_cast<double>(node / n % n), h * static_cast<double>(node / (n * n)) })) -
        this->Sphere.Radius);
    }
    this->Level.Doubles = { this->Distance.data(), { n, n, n }, { h, h, h } };
    this->Level.InsideIsHigher = false;
    this->Atoms = this->Sphere.Charges;
    for (ChargedAtom& atom : this->Atoms)
    {
      for (double& x : atom.Position)
      {
        x += half;
      }
    }
    auto& p = this->Parameters;
    p.SoluteDielectric = this->Sphere.Solute;
    p.SolventDielectric = this->Sphere.Solvent;
    p.IonRadius = this->Sphere.Layer;
    p.Tolerance = 1e-9;
    if (this->Sphere.Kappa > 0.0)
    {
      const double c = StrengthFor(this->Sphere.Kappa, this->Sphere.Solvent);
      p.Ions = { { 1.0, c }, { -1.0, c } };
    }
    // The series on the border, unless a test sets another condition.
    p.BoundaryCondition = BoundaryCondition::Given;
    p.Boundary = [this](const Point3& x) { return this->Sphere.Outside(this->World(x)); };
    p.Padding = 0.0;
  }
  SphereProblem(const SphereProblem&) = delete;
  void operator=(const SphereProblem&) = delete;

  Point3 World(const Point3& x) const
  {
    return { x[0] - this->Half, x[1] - this->Half, x[2] - this->Half };
  }

  std::unique_ptr<GridPotential> Solve()
  {
    this->Ions =
      std::make_unique<IonAtmosphere>(this->Parameters.Ions, this->Parameters.Temperature);
    return SolvePoissonBoltzmann(this->Level, BoxAround(this->Level, this->Parameters.Padding),
      this->Atoms, this->Parameters, *this->Ions);
  }
};

/// Largest errors at nodes of the volume, kT/e, and the energy's relative error.
struct SphereErrors
{
  double Outside = 0.0, Inside = 0.0, Energy = 0.0;
};

inline SphereErrors RecordErrors(const SphereProblem& problem, const GridPotential& solution)
{
  SphereErrors errors;
  const SolverBox& box = solution.GetBox();
  for (std::int64_t node = 0; node < box.Size(); ++node)
  {
    const Point3 x = problem.World(box.Position(node));
    const double most = std::max({ std::abs(x[0]), std::abs(x[1]), std::abs(x[2]) });
    if (most > problem.Half + 1e-9)
    {
      continue;
    }
    const auto i = static_cast<std::size_t>(node);
    const bool inside = solution.GetInside()[i] != 0;
    const double exact = inside ? problem.Sphere.Reaction(x) : problem.Sphere.Outside(x);
    double& error = inside ? errors.Inside : errors.Outside;
    error = std::max(error, std::abs(solution.GetPotential()[i] - exact));
  }
  errors.Energy = std::abs(solution.GetReport().SolvationEnergy / problem.Sphere.Energy() - 1.0);
  return errors;
}

}

#endif
