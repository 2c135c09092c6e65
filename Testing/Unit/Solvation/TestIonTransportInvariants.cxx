// Invariants of ion transport in unusual channels: channels of atoms that are their own mirror
// image, ions of every valence, narrow domains, high voltages, strong charges, membranes off the
// center: the sign of the current, one current in all sections, no negative concentrations.

#include "ChannelTube.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "LongTests.h"
#include "Solvation/ChannelPassage.h"
#include "Solvation/IonTransportOutput.h"
#include "Solvation/TransportCurrents.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <random>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TransportGrid MakeGrid(const Tube& tube, const IonTransportParameters& p)
{
  const TransportDomain domain = DomainAround(tube.Balls, p);
  TransportGrid grid =
    MakeTransportGrid(domain, DistanceToAtoms(domain, tube.Balls, p.ProbeRadius), tube.Charges, p);
  RequireOpen(FindPassage(grid));
  CloseIsolatedPockets(grid);
  return grid;
}

/// Solves, checks what holds for every solution, and returns the currents.
CurrentProfile SolveAndCheck(PoissonNernstPlanck& solution, const char* name)
{
  EXPECT_TRUE(solution.Solve().Converged) << name;
  EXPECT_LE(solution.GetReport().Imbalance, 1e-4) << name;
  for (std::int64_t node = 0; node < solution.GetGrid().Domain.Size(); ++node)
  {
    EXPECT_TRUE(std::isfinite(solution.GetPotential()[static_cast<std::size_t>(node)]));
    for (std::size_t k = 0; k < solution.GetParameters().Species.size(); ++k)
    {
      EXPECT_GE(solution.Concentration(SpeciesId(k), node), 0.0) << name;
    }
  }
  const CurrentProfile currents = ComputeCurrents(solution);
  EXPECT_LT(currents.Spread(), 1e-4) << name;
  return currents;
}

/// The tube of MakeTube() around an axis in another direction, and turned around it.
Tube TurnedTube(const Tube& straight, const Point3& normal, double angle)
{
  const auto [n, u, v] = FrameAlong(normal);
  Tube tube = straight;
  for (std::size_t i = 0; i < tube.Balls.size(); ++i)
  {
    const Point3& from = straight.Balls[i].Center;
    const double x = std::cos(angle) * from[0] - std::sin(angle) * from[1];
    const double y = std::sin(angle) * from[0] + std::cos(angle) * from[1];
    for (std::size_t a = 0; a < 3; ++a)
    {
      tube.Balls[i].Center[a] = x * u[a] + y * v[a] + from[2] * n[a];
    }
    tube.Charges[i].Position = tube.Balls[i].Center;
  }
  return tube;
}

}

TEST(IonTransportInvariants, SymmetricChannelOfAtomsHasASymmetricCurve)
{
  IonTransportParameters p = TubeParameters(2.5);
  p.Tolerance = 1e-6;
  const TransportGrid grid = MakeGrid(MakeTube(p, 2.5, -0.05), p);
  PoissonNernstPlanck solution(grid, p);
  double least = 0.0;
  for (const double voltage : { 40.0, 120.0 })
  {
    solution.SetVoltage(voltage);
    const double forth = SolveAndCheck(solution, "forth").Mean();
    solution.SetVoltage(-voltage);
    const double back = SolveAndCheck(solution, "back").Mean();
    std::cout << voltage << " mV: " << forth << " pA, " << back << " pA\n";
    EXPECT_GT(forth, least);
    EXPECT_NEAR(back / forth, -1.0, 1e-3)
      << voltage; // the assignment of cut cubes is not symmetric
    least = forth;
  }
  solution.SetVoltage(0.0);
  EXPECT_NEAR(SolveAndCheck(solution, "none").Mean(), 0.0, 1e-6 * least);
}

TEST(IonTransportInvariants, IonsOfEveryValenceAreConserved)
{
  struct Case
  {
    const char* Name;
    std::vector<TransportSpecies> Species;
    double Voltage, Charge;
  };
  const Case cases[] = {
    { "calcium chloride",
      { { "Ca", 2.0, 0.1, 0.05, 0.79, 1.0 }, { "Cl", -1.0, 0.2, 0.1, 2.03, 1.0 } }, 100.0, -0.1 },
    { "magnesium sulphate",
      { { "Mg", 2.0, 0.1, 0.1, 0.71, 1.0 }, { "SO4", -2.0, 0.1, 0.1, 1.07, 1.0 } }, -150.0, 0.05 },
    { "aluminium, trivalent",
      { { "Al", 3.0, 0.02, 0.02, 0.54, 0.5 }, { "Cl", -1.0, 0.06, 0.06, 2.03, 0.5 } }, 100.0,
      -0.1 },
    { "four species",
      { { "K", 1.0, 0.1, 0.0, 1.96, 0.3 }, { "Na", 1.0, 0.0, 0.1, 1.33, 0.2 },
        { "Ca", 2.0, 0.001, 0.001, 0.79, 0.1 }, { "Cl", -1.0, 0.102, 0.102, 2.03, 0.4 } },
      0.0, -0.05 },
    { "one bath without ions",
      { { "K", 1.0, 0.1, 0.0, 1.96, 1.0 }, { "Cl", -1.0, 0.1, 0.0, 2.03, 1.0 } }, 50.0, 0.0 },
    { "no ions at all", { { "K", 1.0, 0.0, 0.0, 1.96, 1.0 } }, 100.0, -0.05 },
    { "a volt", { { "K", 1.0, 0.1, 0.1, 1.96, 1.0 }, { "Cl", -1.0, 0.1, 0.1, 2.03, 1.0 } }, 1000.0,
      -0.05 },
    { "strong charges",
      { { "K", 1.0, 1.0, 0.01, 1.96, 1.0 }, { "Cl", -1.0, 1.0, 0.01, 2.03, 1.0 } }, -200.0, -0.6 },
  };
  for (const Case& c : cases)
  {
    IonTransportParameters p = TubeParameters(2.5);
    p.Species = c.Species;
    p.Voltage = c.Voltage;
    const TransportGrid grid = MakeGrid(MakeTube(p, 2.5, c.Charge), p);
    PoissonNernstPlanck solution(grid, p);
    const CurrentProfile currents = SolveAndCheck(solution, c.Name);
    std::cout << c.Name << ":";
    for (std::size_t k = 0; k < p.Species.size(); ++k)
    {
      std::cout << " " << p.Species[k].Name << " " << currents.Mean(k);
    }
    std::cout << " pA, spread " << currents.Spread() << ", lost " << solution.GetReport().Imbalance
              << ", " << solution.GetReport().Iterations << " iterations\n";
    for (std::size_t k = 0; k < p.Species.size(); ++k)
    {
      // Each species flows down its own gradient of z V + ln c between the baths.
      const TransportSpecies& s = p.Species[k];
      const double volt = s.Valence * 1e-3 * c.Voltage * units::ElementaryCharge /
        (units::BoltzmannConstant * p.Temperature);
      const double drive = s.Below * std::exp(volt) - s.Above;
      EXPECT_GE(currents.Mean(k) * s.Valence * drive, 0.0) << c.Name << ", " << s.Name;
    }
  }
}

TEST(IonTransportInvariants, MembranesLieAnywhere)
{
  // Off the origin, along no axis, with a normal of any length, as deep in the channel as it may
  // be.
  double straight = 0.0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int trial = 0; trial < 3; ++trial)
  {
    IonTransportParameters p = TubeParameters(3.0);
    if (trial > 0)
    {
      p.MembraneCenter = { 300.0 * part(random), -50.0 * part(random), 7.7 };
      p.MembraneNormal = { 40.0 * part(random), 40.0 * part(random), -20.0 };
    }
    const TransportGrid grid = MakeGrid(MakeTube(p, 3.0, -0.05), p);
    PoissonNernstPlanck solution(grid, p);
    const double current = SolveAndCheck(solution, "anywhere").Mean();
    std::cout << "trial " << trial << ": " << current << " pA\n";
    straight = trial == 0 ? current : straight;
    EXPECT_NEAR(current / straight, 1.0, 0.08) << trial; // the rings are rotated around the axis
  }
}

TEST(IonTransportInvariants, TurningMoleculeAndMembraneChangesTheCurrentByLessThanOnePercent)
{
  // The grid turns with the membrane, but the molecule about the normal in it. The header of
  // vtkIonTransport states the ranges of all tubes in 15 poses, of which each run does a share.
  struct TubeCase
  {
    double Radius, Charge;
  };
  const TubeCase cases[] = { { 2.5, -0.05 }, { 2.2, -0.05 }, { 2.2, 0.0 }, { 2.5, 0.0 },
    { 2.8, -0.05 }, { 2.8, 0.0 } };
  const LongCases longCases("TurningTubes", 5);
  for (std::size_t i = 0; i < std::size(cases); ++i)
  {
    const TubeCase& c = cases[i];
    const int poses = longCases.Has(i) ? 15 : i == 0 ? 4 : 0;
    if (poses == 0)
    {
      continue;
    }
    std::mt19937 random(3);
    std::normal_distribution<double> part;
    IonTransportParameters p = TubeParameters(c.Radius);
    p.Spacing = 0.5;
    p.Padding = 2.0;
    const Tube tube = MakeTube(p, c.Radius, c.Charge);
    double least = HUGE_VAL, most = 0.0;
    for (int pose = 0; pose < poses; ++pose)
    {
      const Tube turned = pose == 0
        ? tube
        : TurnedTube(tube, p.MembraneNormal = { part(random), part(random), part(random) },
            2.0 * Pi * part(random));
      const TransportGrid grid = MakeGrid(turned, p);
      PoissonNernstPlanck solution(grid, p);
      const double current = SolveAndCheck(solution, "turned").Mean();
      least = std::min(least, current);
      most = std::max(most, current);
    }
    std::cout << "radius " << c.Radius << ", charge " << c.Charge << ": " << least << " to " << most
              << " pA, range " << 100.0 * (most / least - 1.0) << " %\n";
    EXPECT_LT(most / least, 1.01);
  }
}

TEST(IonTransportInvariants, OverflowIsReported)
{
  // Charges in the water itself: thousands of kT/e between neighbours. The result has one current
  // in all sections, or there is an error message, or it is marked as not converged.
  for (const double charge : { 40.0, -4000.0, 4e5 })
  {
    IonTransportParameters p = TubeParameters(2.5);
    p.Species = { { "Al", 3.0, 0.1, 0.1, 0.5, 1.0 }, { "Cl", -1.0, 0.3, 0.3, 2.0, 1.0 } };
    p.Voltage = 1000.0;
    p.MaximumIterations = 10;
    Tube tube = MakeTube(p, 2.5, 0.0);
    tube.Charges.assign(1, { { 0.3, 0.2, 0.1 }, charge, 1.0 });
    const TransportGrid grid = MakeGrid(tube, p);
    PoissonNernstPlanck solution(grid, p);
    try
    {
      const IonTransportReport report = solution.Solve();
      const CurrentProfile currents = ComputeCurrents(solution);
      std::cout << charge << " e: converged " << report.Converged << ", lost " << report.Imbalance
                << ", spread " << currents.Spread() << ", last change " << report.Changes.back()
                << "\n";
      EXPECT_TRUE(!report.Converged || currents.Spread() < 1e-4) << charge;
    }
    catch (const std::runtime_error& error)
    {
      std::cout << charge << " e: " << error.what() << "\n";
      EXPECT_NE(std::string(error.what()).find("iteration diverged"), std::string::npos);
    }
  }
}

TEST(IonTransportInvariants, MoreIonsThanFloatsCountAreRefused)
{
  // The concentration of ions around a charge in the water is proportional to it: 837 mol/l for
  // each e here.
  for (const double charge : { 1.0, 1e20, 1e38 })
  {
    IonTransportParameters p = TubeParameters(2.5);
    p.MaximumIterations = 10;
    Tube tube = MakeTube(p, 2.5, 0.0);
    tube.Charges.assign(1, { { 0.3, 0.2, 0.1 }, charge, 1.0 });
    const TransportGrid grid = MakeGrid(tube, p);
    PoissonNernstPlanck solution(grid, p);
    solution.Solve();
    vtkNew<vtkImageData> image;
    try
    {
      FillTransportImage(solution, image);
      EXPECT_LT(charge, 1e38);
      EXPECT_TRUE(
        std::isfinite(image->GetPointData()->GetArray("Concentration_Cl")->GetRange()[1]));
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(charge, 1e38);
      EXPECT_NE(
        std::string(error.what()).find("Concentration_Cl leaves the range"), std::string::npos);
    }
  }
}

TEST(IonTransportInvariants, LostCurrentIsReported)
{
  // A barrier before a well, for trivalent ions in very little salt: the current is smaller than
  // the rounding error of the exchange in the well. The potential converges nevertheless.
  IonTransportParameters p = TubeParameters(2.5);
  p.Species = { { "Al", 3.0, 1e-6, 1e-6, 0.5, 1.0 }, { "Cl", -1.0, 3e-6, 3e-6, 2.0, 1.0 } };
  Tube tube = MakeTube(p, 2.5, 1.0);
  for (std::size_t i = tube.Charges.size() / 2; i < tube.Charges.size(); ++i)
  {
    tube.Charges[i].Charge = -1.0;
  }
  const TransportGrid grid = MakeGrid(tube, p);
  PoissonNernstPlanck solution(grid, p);
  const IonTransportReport report = solution.Solve();
  std::cout << "a part of " << report.Imbalance << " is lost\n";
  EXPECT_FALSE(report.Converged);
  EXPECT_LE(report.Changes.back(), p.Tolerance);
  EXPECT_GT(report.Imbalance, 1e-3);
}
