// Alternate updates of surface and field: ions compared with Born's formula, pairs, policies of
// updating, the force of the field.

#include "KirkwoodSphere.h"
#include "Solvation/CoupledFlow.h"
#include "Solvation/SolvationFlow.h"
#include "TwoSpheres.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr Point3 Off{ 0.11, -0.07, 0.05 }; // off the nodes

SolvationParameters IonParameters(double spacing)
{
  SolvationParameters p;
  p.Flow.Spacing = spacing;
  p.Flow.ProbeRadius = 0.0;
  p.Potential.SoluteDielectric = 1.0;
  p.Potential.SolventDielectric = 80.0;
  return p;
}

SolvationAtoms Ion(double radius)
{
  return { { { Off, radius } }, { { Off, 1.9, 0.1 } }, { { Off, 1.0, radius } } };
}

SolvationAtoms IonPair(double distance)
{
  SolvationAtoms atoms;
  for (const double side : { -1.0, 1.0 })
  {
    const Point3 at{ Off[0] + 0.5 * side * distance, Off[1], Off[2] };
    atoms.Balls.push_back({ at, 2.0 });
    atoms.Dispersion.push_back({ at, 1.9, 0.1 });
    atoms.Charges.push_back({ at, side, 2.0 });
  }
  return atoms;
}

double Born(double radius)
{
  return -0.5 * units::CoulombLength(298.15) * units::ThermalKilocalorie(298.15) / radius *
    (1.0 - 1.0 / 80.0);
}

}

TEST(SolvationFlow, IonsHaveBornsEnergy)
{
  for (const double radius : { 1.0, 2.0, 3.0 })
  {
    SolvationFlow flow(Ion(radius), IonParameters(0.25));
    flow.Run();
    const SolvationUpdate& last = flow.GetUpdates().back();
    std::cout << "R " << radius << ": " << last.PolarEnergy << " (Born " << Born(radius) << ", "
              << last.PolarEnergy / Born(radius) - 1.0 << ") after " << flow.GetUpdates().size()
              << " updates\n";
    EXPECT_TRUE(flow.HasConverged());
    EXPECT_LE(flow.GetUpdates().size(), 10u);
    EXPECT_GT(last.OnObstacle, 0.99);
    EXPECT_LE(last.OnObstacle, 1.0);
    EXPECT_NEAR(last.PolarEnergy / Born(radius), 1.0, 1e-3);
    const SolvationErrors errors = flow.EstimateErrors();
    std::printf("R %g: polar error %.4f, stated %.4f; of the area %.4f, stated in total %.4f\n",
      radius, last.PolarEnergy - Born(radius), errors.Polar,
      last.SurfaceEnergy * (1.0 - 4.0 * Pi * radius * radius / last.Area), errors.Total);
    EXPECT_GE(errors.Polar, std::abs(last.PolarEnergy - Born(radius)));
    EXPECT_LE(errors.Polar, 0.02 * std::abs(Born(radius)));
    const double tension = last.SurfaceEnergy / last.Area;
    EXPECT_GE(errors.Total, tension * std::abs(last.Area - 4.0 * Pi * radius * radius));
    EXPECT_GE(errors.Total, errors.Polar);
  }
}

TEST(SolvationFlow, IonsInTheSmoothModeEndWithTheSharpEnergy)
{
  const double radii[] = { 1.0, 2.0, 3.0 };
  const double smooth[] = { 0.01, 0.0025, 0.001 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    SolvationParameters p = IonParameters(0.25);
    p.Potential.DielectricModel = DielectricModel::SmoothDielectric;
    p.Potential.Padding = 5.0;
    SolvationFlow flow(Ion(radii[i]), p);
    flow.Run();
    const std::vector<SolvationUpdate>& updates = flow.GetUpdates();
    const double onTheWay = updates[updates.size() - 2].PolarEnergy / Born(radii[i]) - 1.0;
    const double last = updates.back().PolarEnergy / Born(radii[i]) - 1.0;
    std::cout << "R " << radii[i] << ": " << onTheWay << " by edges, " << last
              << " by the jump, after " << updates.size() << " updates\n";
    EXPECT_TRUE(flow.HasConverged());
    EXPECT_LE(updates.size(), 10u);
    EXPECT_EQ(updates.back().Area, updates[updates.size() - 2].Area);
    EXPECT_LT(std::abs(onTheWay), smooth[i]);
    EXPECT_LT(std::abs(last), 1e-3);
  }
}

// The first field is applied in full, later ones by their share: results agree up to the second
// field, and then lie between those of shares 0 and 1.
TEST(SolvationFlow, RelaxationTakesItsShare)
{
  std::vector<std::vector<SolvationUpdate>> runs;
  for (const double share : { 1e-9, 0.5, 1.0 })
  {
    SolvationParameters p = IonParameters(0.25);
    p.Flow.ProbeRadius = 0.0;
    p.Policy.FieldRelaxation = share;
    p.Policy.AdaptiveUpdate = false;
    p.Policy.UpdatePeriod = 10;
    p.Policy.MaximumUpdates = 3;
    SolvationFlow flow(IonPair(4.5), p);
    flow.Run();
    runs.push_back(flow.GetUpdates());
    ASSERT_EQ(runs.back().size(), 3U);
  }
  for (const std::size_t update : { 0, 1 })
  {
    EXPECT_EQ(runs[0][update].Area, runs[2][update].Area);
  }
  const double none = runs[0][2].Area, half = runs[1][2].Area, whole = runs[2][2].Area;
  std::cout << "area by none, half and all of the second field: " << none << ", " << half << ", "
            << whole << "\n";
  EXPECT_GT(std::abs(whole - none), 1e-4 * none);
  const double way = (half - none) / (whole - none);
  EXPECT_GT(way, 0.1);
  EXPECT_LT(way, 0.9);
}

TEST(CoupledFlow, OfAnIonIsKnown)
{
  // E just outside is C / (eps_s r^2), and the force per area is the energy's derivative by r over
  // the area.
  SolvationFlow flow(Ion(2.0), IonParameters(0.25));
  flow.Run();
  EXPECT_GT(flow.GetUpdates().back().OnObstacle, 0.99);
  EXPECT_LE(flow.GetUpdates().back().OnObstacle, 1.0);
  const std::vector<double> pull = PullAtCrossings(flow.GetSolution(), flow.GetTemperature());
  const double expected = -Born(2.0) / 2.0 / (4.0 * Pi * 4.0);
  for (const double value : pull)
  {
    ASSERT_NEAR(value / expected, 1.0, 0.05);
  }
  EXPECT_GT(pull.size(), 1000u);
}

TEST(SolvationFlow, IonPairHasTheEnergyOfTwoSpheres)
{
  // Without a probe the field draws the surface onto the two balls, whose energy is known from
  // multipoles.
  SolvationParameters p = IonParameters(0.3);
  p.Flow.ProbeRadius = 0.0;
  SolvationFlow flow(IonPair(6.0), p);
  flow.Run();
  const TwoSpheres pair({ -3.0, 2.0, -1.0, 0.0 }, { 3.0, 2.0, 1.0, 0.0 }, 1.0, 80.0);
  const double exact = pair.Energy() * units::ThermalKilocalorie(298.15);
  const SolvationUpdate& last = flow.GetUpdates().back();
  std::cout << "pair: " << last.PolarEnergy << " (by multipoles " << exact << ", "
            << last.PolarEnergy / exact - 1.0 << ") after " << flow.GetUpdates().size()
            << " updates\n";
  EXPECT_TRUE(flow.HasConverged());
  EXPECT_LE(flow.GetUpdates().size(), 10u);
  EXPECT_NEAR(last.PolarEnergy / exact, 1.0, 1e-3);
  EXPECT_GE(flow.EstimateErrors().Polar, std::abs(last.PolarEnergy - exact));
}

TEST(SolvationFlow, ChargesInOneBallHaveKirkwoodsEnergy)
{
  KirkwoodSphere sphere;
  sphere.Center = Off;
  sphere.Radius = 4.0;
  sphere.Charges = { { { Off[0] + 2.0, Off[1], Off[2] }, 1.0, 0.0 },
    { { Off[0] - 1.2, Off[1] + 1.6, Off[2] }, -1.0, 0.0 } };
  SolvationParameters p = IonParameters(0.4);
  p.Potential.SoluteDielectric = sphere.Solute;
  SolvationFlow flow({ { { Off, sphere.Radius } }, { { Off, 1.9, 0.1 } }, sphere.Charges }, p);
  flow.Run();
  const double exact = sphere.Energy() * units::ThermalKilocalorie(298.15);
  const SolvationUpdate& last = flow.GetUpdates().back();
  std::cout << "two charges in a ball: " << last.PolarEnergy << " (Kirkwood " << exact << ", "
            << last.PolarEnergy / exact - 1.0 << ") after " << flow.GetUpdates().size()
            << " updates\n";
  EXPECT_TRUE(flow.HasConverged());
  EXPECT_LE(flow.GetUpdates().size(), 10u);
  EXPECT_NEAR(last.PolarEnergy / exact, 1.0, 2e-3);
  EXPECT_GE(flow.EstimateErrors().Polar, std::abs(last.PolarEnergy - exact));
}

TEST(SolvationFlow, UpdatePoliciesConvergeToTheSameResult)
{
  // Water as in TIP3P (W. L. Jorgensen et al., J. Chem. Phys. 79 (1983) 926), with Bondi's radii.
  constexpr double bond = 0.9572;
  const double half = 0.5 * 104.52 * Pi / 180.0;
  SolvationAtoms water;
  const auto put = [&water](double along, double across, double charge, double radius)
  {
    const Point3 at{ Off[0] + along, Off[1] + across, Off[2] };
    water.Balls.push_back({ at, radius });
    water.Dispersion.push_back({ at, radius, 0.1 });
    water.Charges.push_back({ at, charge, radius });
  };
  put(0.0, 0.0, -0.834, 1.52);
  put(bond * std::cos(half), bond * std::sin(half), 0.417, 1.2);
  put(bond * std::cos(half), -bond * std::sin(half), 0.417, 1.2);
  std::vector<double> energies;
  struct Policy
  {
    int Period;
    double Relaxation;
  };
  for (const Policy policy : { Policy{ 10, 1.0 }, Policy{ 20, 1.0 }, Policy{ 50, 1.0 },
         Policy{ 100, 1.0 }, Policy{ 10, 0.5 }, Policy{ 50, 0.5 } })
  {
    SolvationParameters p = IonParameters(0.4);
    p.Potential.Padding = 6.0;
    p.Policy.UpdatePeriod = policy.Period;
    p.Policy.AdaptiveUpdate = false;
    p.Policy.FieldRelaxation = policy.Relaxation;
    SolvationFlow flow(water, p);
    flow.Run();
    energies.push_back(flow.GetUpdates().back().Total());
    std::cout << "water, period " << policy.Period << ", alpha' " << policy.Relaxation << ": "
              << energies.back() << " after " << flow.GetUpdates().size() << " updates\n";
    EXPECT_TRUE(flow.HasConverged());
    EXPECT_LE(flow.GetUpdates().size(), 10u);
    EXPECT_NEAR(energies.back() / energies.front(), 1.0, 5e-3);
  }
}

TEST(SolvationFlow, DoesNotDependOnThreads)
{
  std::vector<float> first;
  std::vector<double> potential;
  for (const int threads : { 1, 2, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        SolvationFlow flow(IonPair(5.0), IonParameters(0.5));
        flow.Run();
        if (first.empty())
        {
          first = flow.GetSurface().Distance;
          potential = flow.GetSolution().GetPotential();
        }
        EXPECT_EQ(flow.GetSurface().Distance, first);
        EXPECT_EQ(flow.GetSolution().GetPotential(), potential);
      });
  }
}

TEST(SolvationFlow, ProbeKeepsTheFieldFromDrawingTheSurfaceIn)
{
  // Between two balls, water of radius 1.4 does not enter where the field alone would draw it.
  std::array<double, 2> volume{};
  for (const double probe : { 0.0, 1.4 })
  {
    SolvationParameters p = IonParameters(0.4);
    p.Flow.ProbeRadius = probe;
    SolvationFlow flow(IonPair(4.4), p);
    flow.Run();
    volume[probe > 0.0 ? 1 : 0] = flow.GetUpdates().back().Volume;
    EXPECT_GT(flow.GetUpdates().back().OnObstacle, 0.9) << probe;
  }
  EXPECT_GT(volume[1], 1.02 * volume[0]);
}

TEST(SolvationFlow, LackOfConvergenceIsReported)
{
  SolvationParameters p = IonParameters(0.5);
  p.Policy.MaximumUpdates = 2;
  SolvationFlow flow(IonPair(5.0), p);
  flow.Run();
  EXPECT_FALSE(flow.HasConverged());
  EXPECT_EQ(flow.GetUpdates().size(), 2u);
  EXPECT_GT(flow.GetUpdates().back().Area, 0.0);
}

TEST(SolvationFlow, ReportsBadInput)
{
  const auto said = [](SolvationAtoms atoms, const SolvationParameters& p)
  {
    try
    {
      SolvationFlow flow(std::move(atoms), p);
      flow.Run();
    }
    catch (const std::exception& error)
    {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  SolvationAtoms stray = Ion(2.0);
  stray.Charges.push_back({ { 9.0, 0.0, 0.0 }, 1.0, 0.0 });
  EXPECT_NE(
    said(stray, IonParameters(0.5)).find("The charge of atom 1 lies outside"), std::string::npos);
  EXPECT_NE(said({}, IonParameters(0.5)).find("no atoms"), std::string::npos);
  struct Case
  {
    const char* Name;
    double UpdatePolicy::*Number;
    double Value;
  };
  for (const Case& c : { Case{ "SurfaceRelaxation", &UpdatePolicy::SurfaceRelaxation, 0.0 },
         Case{ "FieldRelaxation", &UpdatePolicy::FieldRelaxation, 1.5 } })
  {
    SolvationParameters p = IonParameters(0.5);
    p.Policy.*c.Number = c.Value;
    EXPECT_NE(said(Ion(2.0), p).find(std::string(c.Name) + " is "), std::string::npos) << c.Name;
  }
  SolvationParameters p = IonParameters(0.5);
  p.EnergyTolerance = std::nan("");
  EXPECT_NE(said(Ion(2.0), p).find("EnergyTolerance is "), std::string::npos);
  p = IonParameters(0.5);
  p.Policy.UpdatePeriod = 0;
  EXPECT_NE(said(Ion(2.0), p).find("UpdatePeriod is "), std::string::npos);
  p = IonParameters(0.5);
  p.Solvent.SurfaceTension = -1.0;
  EXPECT_NE(said(Ion(2.0), p).find("SurfaceTension is "), std::string::npos);
  p = IonParameters(1e-3);
  EXPECT_NE(said(Ion(2.0), p).find("of memory, but only"), std::string::npos);
}

namespace
{

/// The shares of cases whose error is covered, and the median of estimate / error where the error
/// is above a thousandth of the energy, as in the guide's table of estimates.
struct Coverage
{
  void Add(double error, double estimate, double energy)
  {
    ++this->Cases;
    this->Covered += estimate >= std::abs(error) ? 1 : 0;
    if (std::abs(error) > 1e-3 * std::abs(energy))
    {
      this->Ratios.push_back(estimate / std::abs(error));
    }
  }
  double Median()
  {
    std::sort(this->Ratios.begin(), this->Ratios.end());
    return this->Ratios.empty() ? 0.0 : this->Ratios[this->Ratios.size() / 2];
  }
  void Print(const char* name)
  {
    const auto above =
      std::count_if(this->Ratios.begin(), this->Ratios.end(), [](double r) { return r > 10.0; });
    std::printf("%s: %d cases, %.0f %% covered, %zu errors above 0.1 %%, median ratio %.1f, above "
                "10 in %.0f %%\n",
      name, this->Cases, 100.0 * this->Covered / this->Cases, this->Ratios.size(), this->Median(),
      this->Ratios.empty()
        ? 0.0
        : 100.0 * static_cast<double>(above) / static_cast<double>(this->Ratios.size()));
  }

  int Cases = 0, Covered = 0;
  std::vector<double> Ratios;
};

}

// Ions, two charges in a ball, and pairs of ions, whose surfaces end on their balls, so that polar
// energy, area and volume are known.
TEST(SolvationErrors, CoverTheTruth)
{
  std::mt19937 random(5);
  const auto between = [&random](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  Coverage polar, total;
  const double kilocalorie = units::ThermalKilocalorie(298.15);
  for (int i = 0; i < 36; ++i)
  {
    const double spacing = between(0.3, 0.6);
    const Point3 center{ between(-0.5, 0.5), between(-0.5, 0.5), between(-0.5, 0.5) };
    SolvationParameters p = IonParameters(spacing);
    p.Potential.SoluteDielectric = i % 2 == 0 ? 1.0 : 2.0;
    p.Potential.Padding = 6.0;
    SolvationAtoms atoms;
    double exact = 0.0, area = 0.0, volume = 0.0;
    const auto put = [&](const Point3& at, double radius)
    {
      atoms.Balls.push_back({ at, radius });
      atoms.Dispersion.push_back({ at, 1.9, 0.0 });
      area += 4.0 * Pi * radius * radius;
      volume += 4.0 / 3.0 * Pi * std::pow(radius, 3);
    };
    if (i % 3 < 2)
    {
      KirkwoodSphere sphere;
      sphere.Center = center;
      sphere.Solute = p.Potential.SoluteDielectric;
      sphere.Radius = between(i % 3 == 0 ? 1.2 : 2.5, 4.0);
      sphere.Charges = { { center, 1.0, 0.0 } };
      if (i % 3 == 1)
      {
        const double depth = between(0.3, 0.6) * sphere.Radius;
        sphere.Charges = { { center + Point3{ depth, 0.0, 0.0 }, 1.0, 0.0 },
          { center - Point3{ 0.0, 0.7 * depth, 0.5 * depth }, between(-1.0, 1.0), 0.0 } };
      }
      put(center, sphere.Radius);
      atoms.Charges = sphere.Charges;
      exact = sphere.Energy();
    }
    else
    {
      const double low = between(1.6, 2.5), high = between(1.6, 2.5);
      const double half = 0.5 * (low + high + between(2.0, 3.0));
      const double charge = i % 4 == 0 ? 1.0 : -1.0;
      put(center - Point3{ half, 0.0, 0.0 }, low);
      put(center + Point3{ half, 0.0, 0.0 }, high);
      atoms.Charges = { { atoms.Balls[0].Center, 1.0, low },
        { atoms.Balls[1].Center, charge, high } };
      exact = TwoSpheres(
        { -half, low, 1.0, 0.0 }, { half, high, charge, 0.0 }, p.Potential.SoluteDielectric, 80.0)
                .Energy();
    }
    SolvationFlow flow(atoms, p);
    flow.Run();
    const SolvationUpdate& last = flow.GetUpdates().back();
    const SolvationErrors errors = flow.EstimateErrors();
    const double inPolar = exact * kilocalorie;
    const double inTotal = inPolar + p.Solvent.SurfaceTension * area + p.Solvent.Pressure * volume;
    std::printf("%d: spacing %.2f polar %.3f error %.4f stated %.4f, total %.3f error %.4f stated "
                "%.4f\n",
      i, spacing, inPolar, last.PolarEnergy - inPolar, errors.Polar, inTotal,
      last.Total() - inTotal, errors.Total);
    polar.Add(last.PolarEnergy - inPolar, errors.Polar, inPolar);
    total.Add(last.Total() - inTotal, errors.Total, inTotal);
  }
  polar.Print("PolarEnergyError");
  total.Print("TotalEnergyError");
  EXPECT_GE(polar.Covered, 0.9 * polar.Cases);
  EXPECT_GE(total.Covered, 0.9 * total.Cases);
  EXPECT_LE(polar.Median(), 5.0);
  EXPECT_LE(total.Median(), 5.0);
}
