// Surface and field in turn: ions beside Born's formula, pairs, policies of updating, the pull.

#include "SolvationFlow.h"
#include "SurfacePull.h"

#include "ElectrostaticUnits.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

using namespace isthmus;

namespace
{

constexpr Vector3 Off{ 0.11, -0.07, 0.05 }; // off the nodes

SolvationParameters IonParameters(double spacing)
{
  SolvationParameters p;
  p.Flow.Spacing = spacing;
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
    const Vector3 at{ Off[0] + 0.5 * side * distance, Off[1], Off[2] };
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
    EXPECT_TRUE(flow.Rests());
    EXPECT_LE(flow.GetUpdates().size(), 10u);
    EXPECT_GT(last.OnObstacle, 0.99);
    EXPECT_NEAR(last.PolarEnergy / Born(radius), 1.0, 1e-3);
  }
}

TEST(SurfacePull, OfAnIonIsKnown)
{
  // E just outside is C / (eps_s r^2), and the energy's derivative by r, over the area, the pull.
  SolvationFlow flow(Ion(2.0), IonParameters(0.25));
  flow.Run();
  const std::vector<double> pull =
    PullAtCrossings(flow.GetSolution(), flow.GetLevel(), flow.GetTemperature());
  const double expected = -Born(2.0) / 2.0 / (4.0 * Pi * 4.0);
  for (const double value : pull)
  {
    ASSERT_NEAR(value / expected, 1.0, 0.05);
  }
  EXPECT_GT(pull.size(), 1000u);
}

TEST(SolvationFlow, PoliciesOfUpdatingEndAlike)
{
  std::vector<double> energies;
  struct Policy
  {
    int Period;
    double Relaxation;
  };
  for (const Policy policy : { Policy{ 50, 1.0 }, Policy{ 10, 1.0 }, Policy{ 10, 0.5 } })
  {
    SolvationParameters p = IonParameters(0.4);
    p.UpdatePeriod = policy.Period;
    p.FieldRelaxation = policy.Relaxation;
    SolvationFlow flow(IonPair(5.0), p);
    flow.Run();
    energies.push_back(flow.GetUpdates().back().PolarEnergy);
    std::cout << "pair, period " << policy.Period << ", alpha' " << policy.Relaxation << ": "
              << energies.back() << " after " << flow.GetUpdates().size() << " updates\n";
    EXPECT_TRUE(flow.Rests());
    EXPECT_LE(flow.GetUpdates().size(), 10u);
  }
  EXPECT_NEAR(energies[1] / energies[0], 1.0, 5e-3);
  EXPECT_NEAR(energies[2] / energies[0], 1.0, 5e-3);
}

TEST(SolvationFlow, ThreadsLeaveNoTrace)
{
  std::vector<float> first;
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        SolvationFlow flow(IonPair(5.0), IonParameters(0.5));
        flow.Run();
        if (first.empty())
        {
          first = flow.GetSurface().Distance;
        }
        EXPECT_EQ(flow.GetSurface().Distance, first);
      });
  }
}

TEST(SolvationFlow, ProbeKeepsTheFieldFromDrawingTheSurfaceIn)
{
  // Between two balls, water of radius 1.4 does not get where the bare field would draw it.
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

TEST(SolvationFlow, WhatDoesNotRestIsToldAndKept)
{
  SolvationParameters p = IonParameters(0.5);
  p.MaximumUpdates = 2;
  SolvationFlow flow(IonPair(5.0), p);
  flow.Run();
  EXPECT_FALSE(flow.Rests());
  EXPECT_EQ(flow.GetUpdates().size(), 2u);
  EXPECT_GT(flow.GetUpdates().back().Area, 0.0);
}

TEST(SolvationFlow, BadInputIsToldInASentence)
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
    double SolvationParameters::*Number;
    double Value;
  };
  for (const Case& c : { Case{ "SurfaceRelaxation", &SolvationParameters::SurfaceRelaxation, 0.0 },
         Case{ "FieldRelaxation", &SolvationParameters::FieldRelaxation, 1.5 },
         Case{ "Tolerance", &SolvationParameters::Tolerance, std::nan("") } })
  {
    SolvationParameters p = IonParameters(0.5);
    p.*c.Number = c.Value;
    EXPECT_NE(said(Ion(2.0), p).find(std::string(c.Name) + " is "), std::string::npos) << c.Name;
  }
  SolvationParameters p = IonParameters(0.5);
  p.UpdatePeriod = 0;
  EXPECT_NE(said(Ion(2.0), p).find("UpdatePeriod is "), std::string::npos);
  p = IonParameters(0.5);
  p.Solvent.SurfaceTension = -1.0;
  EXPECT_NE(said(Ion(2.0), p).find("SurfaceTension is "), std::string::npos);
  p = IonParameters(1e-3);
  EXPECT_NE(said(Ion(2.0), p).find("of memory, of which"), std::string::npos);
}
