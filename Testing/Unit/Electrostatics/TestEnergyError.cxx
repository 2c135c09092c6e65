// The stated error of the solvation energy compared with the true one in 200 random cases with
// exact energies: it is an upper bound, and not much larger. With --gtest_filter='EnergyError*' the
// program prints the table of the guide's page "How far to trust it".

#include "KirkwoodSphere.h"
#include "SphereProblem.h"
#include "TwoSpheres.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// A surface, charges and their exact energy, kT.
struct Trial
{
  double Spacing = 1.0, Exact = 0.0;
  std::function<double(const Point3&)> Level; ///< 0 on the surface, below 0 inside
  double Half = 1.0;                          ///< the volume is [-Half, Half]^3
  std::vector<ChargedAtom> Atoms;
  PoissonBoltzmannParameters Parameters;
};

struct Outcome
{
  double Error = 0.0, Estimate = 0.0; ///< relative to the energy, or kT for small contrasts
};

/// The same on every system, unlike the distributions of the standard library.
class Dice
{
public:
  explicit Dice(unsigned seed)
    : Random(seed)
  {
  }
  double Between(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Random()) / 4294967296.0);
  }
  bool Coin() { return this->Random() % 2 == 0; }
  int Below(unsigned n) { return static_cast<int>(this->Random() % n); }
  Point3 Direction()
  {
    const double z = this->Between(-1.0, 1.0);
    const double angle = this->Between(0.0, 2.0 * Pi);
    const double r = std::sqrt(1.0 - z * z);
    return { r * std::cos(angle), r * std::sin(angle), z };
  }
  Point3 Offset(double most)
  {
    return { this->Between(-most, most), this->Between(-most, most), this->Between(-most, most) };
  }

private:
  std::mt19937 Random;
};

/// A quadratic, like -log of the Gaussian of an atom.
double SphereLevel(const Point3& x, const Point3& center, double radius)
{
  const Point3 d = x - center;
  return Dot(d, d) / (radius * radius) - 1.0;
}

Trial OfSphere(const KirkwoodSphere& sphere, double h)
{
  Trial trial;
  trial.Spacing = h;
  trial.Exact = sphere.Energy();
  trial.Level = [=](const Point3& x) { return SphereLevel(x, sphere.Center, sphere.Radius); };
  trial.Half = sphere.Radius + 4.0 * h + 1.0;
  trial.Atoms = sphere.Charges;
  trial.Parameters.SoluteDielectric = sphere.Solute;
  trial.Parameters.SolventDielectric = sphere.Solvent;
  trial.Parameters.IonRadius = sphere.Layer;
  trial.Parameters.IonicStrength = StrengthFor(sphere.Kappa, sphere.Solvent);
  return trial;
}

KirkwoodSphere RandomSphere(Dice& dice, double least, double most)
{
  KirkwoodSphere sphere;
  sphere.Center = dice.Offset(0.5);
  sphere.Radius = dice.Between(least, most);
  sphere.Solute = dice.Coin() ? 2.0 : dice.Coin() ? 1.0 : 4.0;
  sphere.Layer = 2.0;
  sphere.Kappa = dice.Coin() ? 0.0 : dice.Between(0.03, 0.2);
  return sphere;
}

void AddCharge(KirkwoodSphere& sphere, Dice& dice, double depth)
{
  const Point3 d = (sphere.Radius - depth) * dice.Direction();
  const double charge = sphere.Charges.empty() ? 1.0 : dice.Between(-1.0, 1.0);
  sphere.Charges.push_back({ sphere.Center + d, charge, 1.0 });
}

Trial BornIon(Dice& dice)
{
  KirkwoodSphere sphere = RandomSphere(dice, 1.0, 3.0);
  AddCharge(sphere, dice, sphere.Radius);
  return OfSphere(sphere, dice.Between(0.3, 1.0));
}

Trial KirkwoodCharges(Dice& dice)
{
  KirkwoodSphere sphere = RandomSphere(dice, 3.0, 6.0);
  for (int q = 1 + dice.Below(6); q > 0; --q)
  {
    AddCharge(sphere, dice, dice.Between(1.5, sphere.Radius));
  }
  return OfSphere(sphere, dice.Between(0.3, 1.0));
}

Trial ChargesNearTheSurface(Dice& dice)
{
  const double h = dice.Between(0.3, 1.0);
  KirkwoodSphere sphere = RandomSphere(dice, 3.0, 6.0);
  for (int q = 1 + dice.Below(6); q > 0; --q)
  {
    AddCharge(sphere, dice, dice.Between(1.0, 3.0) * h);
  }
  return OfSphere(sphere, h);
}

Trial TwoIons(Dice& dice)
{
  const double gap = dice.Between(0.5, 4.0);
  const double low = dice.Between(1.5, 4.0), high = dice.Between(1.5, 4.0);
  const double charge = dice.Coin() ? 1.0 : -1.0;
  const TwoSpheres pair({ -0.5 * gap - low, low, 1.0, dice.Between(-0.6, 0.6) * low },
    { 0.5 * gap + high, high, charge, dice.Between(-0.6, 0.6) * high }, 2.0, 80.0);
  const Point3 middle = dice.Offset(0.5);
  const Point3 axis = dice.Direction();
  Trial trial;
  trial.Spacing = dice.Between(0.3, 0.8);
  trial.Exact = pair.Energy();
  std::vector<Point3> centers;
  for (const auto& s : pair.Spheres)
  {
    centers.push_back(middle + s.Z * axis);
    trial.Atoms.push_back({ middle + (s.Z + s.Offset) * axis, s.Charge, s.Radius });
  }
  trial.Level = [=](const Point3& x)
  { return std::min(SphereLevel(x, centers[0], low), SphereLevel(x, centers[1], high)); };
  trial.Half = 0.5 * gap + 2.0 * std::max(low, high) + 4.0 * trial.Spacing + 0.5;
  return trial;
}

/// The errors of the energy and its estimate, kT.
Outcome SolveInKT(Trial trial, double padding)
{
  const double h = trial.Spacing;
  const auto n = static_cast<std::int64_t>(std::ceil(2.0 * trial.Half / h)) + 1;
  const Point3 corner{ -trial.Half, -trial.Half, -trial.Half };
  std::vector<double> values;
  for (std::int64_t node = 0; node < n * n * n; ++node)
  {
    values.push_back(trial.Level(corner +
      h *
        Point3{ static_cast<double>(node % n), static_cast<double>(node / n % n),
          static_cast<double>(node / (n * n)) }));
  }
  for (ChargedAtom& atom : trial.Atoms)
  {
    atom.Position = atom.Position - corner;
  }
  LevelFunction level;
  level.Doubles = { values.data(), { n, n, n }, { h, h, h } };
  level.InsideIsHigher = false;
  const IonAtmosphere ions(trial.Parameters.AllIons(), trial.Parameters.Temperature);
  const auto solution =
    SolvePoissonBoltzmann(level, BoxAround(level, padding), trial.Atoms, trial.Parameters, ions);
  return { std::abs(solution->GetReport().SolvationEnergy - trial.Exact),
    EstimateEnergyError(level, *solution) };
}

Outcome Solve(const Trial& trial, double padding)
{
  const Outcome absolute = SolveInKT(trial, padding);
  const double size = std::abs(trial.Exact);
  return { absolute.Error / size, absolute.Estimate / size };
}

/// The ratios of estimates to errors. Ratios of errors below a thousandth are not counted.
struct Coverage
{
  explicit Coverage(const std::vector<Outcome>& outcomes)
  {
    std::vector<double> ratios;
    double covered = 0.0;
    for (const Outcome& o : outcomes)
    {
      covered += o.Estimate >= o.Error ? 1.0 : 0.0;
      if (o.Error >= 1e-3)
      {
        ratios.push_back(o.Estimate / o.Error);
      }
    }
    std::sort(ratios.begin(), ratios.end());
    this->Covered = covered / static_cast<double>(outcomes.size());
    this->Counted = ratios.size();
    this->MedianRatio = ratios.empty() ? 0.0 : ratios[ratios.size() / 2];
    const auto above =
      std::count_if(ratios.begin(), ratios.end(), [](double r) { return r > 10.0; });
    this->AboveTen =
      ratios.empty() ? 0.0 : static_cast<double>(above) / static_cast<double>(ratios.size());
  }

  double Covered = 0.0, MedianRatio = 0.0, AboveTen = 0.0;
  std::size_t Counted = 0;
};

void Print(const char* name, const std::vector<Outcome>& outcomes)
{
  std::vector<double> errors;
  for (const Outcome& o : outcomes)
  {
    errors.push_back(o.Error);
  }
  std::sort(errors.begin(), errors.end());
  const Coverage c(outcomes);
  std::printf("| %s | %zu | %.2f %% | %.2f %% | %.1f %% | %zu | %.1f | %.0f %% |\n", name,
    outcomes.size(), 100.0 * errors[errors.size() / 2], 100.0 * errors[errors.size() * 9 / 10],
    100.0 * c.Covered, c.Counted, c.MedianRatio, 100.0 * c.AboveTen);
}

TEST(EnergyError, CoversTheTruth)
{
  constexpr int each = 50;
  struct Family
  {
    const char* Name;
    Trial (*Draw)(Dice&);
  };
  const Family families[] = { { "Born ions", BornIon }, { "Kirkwood spheres", KirkwoodCharges },
    { "charges 1 to 3 spacings under the surface", ChargesNearTheSurface },
    { "two spheres", TwoIons } };
  const char* seed = std::getenv("ISTHMUS_SEED");
  Dice dice(seed ? static_cast<unsigned>(std::atoi(seed)) : 1);
  std::vector<Outcome> all;
  for (const Family& family : families)
  {
    std::vector<Outcome> outcomes;
    for (int i = 0; i < each; ++i)
    {
      const Trial trial = family.Draw(dice);
      outcomes.push_back(Solve(trial, dice.Between(4.0, 10.0)));
    }
    Print(family.Name, outcomes);
    all.insert(all.end(), outcomes.begin(), outcomes.end());
  }
  Print("all", all);
  const Coverage c(all);
  EXPECT_GE(c.Covered, 0.9);
  EXPECT_LE(c.MedianRatio, 5.0);
  EXPECT_LE(c.AboveTen, 0.25);
}

// Where both dielectrics are equal, the energy is that of the ions only, or 0, and an estimate in
// proportion to it would be 0.
TEST(EnergyError, CoversTheTruthWhereDielectricsAreAlike)
{
  const char* seed = std::getenv("ISTHMUS_SEED");
  Dice dice(seed ? static_cast<unsigned>(std::atoi(seed)) : 7);
  double covered = 0.0;
  constexpr int cases = 80;
  for (int i = 0; i < cases; ++i)
  {
    const bool isIon = i % 2 == 0;
    KirkwoodSphere sphere = RandomSphere(dice, 1.0, isIon ? 3.0 : 5.0);
    const double dielectrics[] = { 1.0, 2.0, 4.0, 20.0, 80.0 };
    sphere.Solute = dielectrics[dice.Below(5)];
    sphere.Solvent = sphere.Solute * (dice.Coin() ? 1.0 : std::exp(dice.Between(-0.3, 0.3)));
    sphere.Kappa = dice.Below(3) == 0 ? 0.1 : 0.0;
    for (int q = isIon ? 1 : 1 + dice.Below(4); q > 0; --q)
    {
      AddCharge(sphere, dice, isIon ? sphere.Radius : dice.Between(0.3, 1.0) * sphere.Radius);
    }
    const Trial trial = OfSphere(sphere, dice.Between(0.3, 1.0));
    const Outcome outcome = SolveInKT(trial, dice.Between(3.0, 10.0));
    covered += outcome.Estimate >= outcome.Error ? 1.0 : 0.0;
    // The energy of the charges in a medium of this dielectric, apart by the radius.
    const auto charge = static_cast<double>(sphere.Charges.size());
    const double scale = 0.5 * charge * charge * units::CoulombLength(sphere.Kelvin) /
      (std::min(sphere.Solute, sphere.Solvent) * sphere.Radius);
    EXPECT_LT(outcome.Estimate, 0.3 * scale);
  }
  std::printf("dielectrics alike: %d cases, %.0f %% covered\n", cases, 100.0 * covered / cases);
  EXPECT_GE(covered / cases, 0.9);
}

}
