// Channels in three dimensions: a cylindrical pore against the access resistance and an
// axisymmetric solution of its own, turned by 30 degrees, closed, with pockets.

#include "AxisymmetricPore.h"
#include "Solvation/ChannelPassage.h"
#include "Solvation/ChannelSolution.h"
#include "TransportLine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <random>
#include <stdexcept>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

IonTransportParameters Pore(double radius, double thickness, double spacing)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, 0.5, 0.5, 1.96, 1.0 }, { "Cl", -1.0, 0.5, 0.5, 2.03, 1.0 } };
  p.LumenRadius = radius;
  p.MembraneThickness = thickness;
  p.Spacing = spacing;
  p.Voltage = 25.7;
  return p;
}

CurrentProfile SolveCurrents(const TransportGrid& grid, const IonTransportParameters& p)
{
  PoissonNernstPlanck solution(grid, p);
  EXPECT_TRUE(solution.Solve().Converged);
  for (std::int64_t node = 0; node < grid.Domain.Size(); ++node)
  {
    for (std::size_t k = 0; k < p.Species.size(); ++k)
    {
      EXPECT_GE(solution.Concentration(SpeciesId(k), node), 0.0);
    }
  }
  const CurrentProfile currents = ComputeCurrents(solution);
  EXPECT_LT(currents.Spread(), 1e-4);
  return currents;
}

double Current(const IonTransportParameters& p, const std::vector<ChargedAtom>& charges = {})
{
  TransportGrid grid = MakeTransportGrid(DomainAround({}, p), {}, charges, p);
  RequireOpen(FindPassage(grid));
  CloseIsolatedPockets(grid);
  return SolveCurrents(grid, p).Mean();
}

/// Ohm's law with the resistances of the pore, of the access to it (J. E. Hall, J. Gen. Physiol. 66
/// (1975) 531, in a cylinder of finite width) and of the baths.
double OhmicCurrent(const IonTransportParameters& p)
{
  const TransportDomain d = DomainAround({}, p);
  const double r = p.LumenRadius;
  const double e = r / d.Radius;
  const double psi = 1.0 - 1.409 * e + 0.296 * e * e * e;
  const double resistance = p.MembraneThickness / (Pi * r * r) + 2.0 * 0.8217 * psi / (Pi * r) +
    (2.0 * d.HalfLength - p.MembraneThickness) / (Pi * d.Radius * d.Radius);
  double conductivity = 0.0;
  for (const TransportSpecies& s : p.Species)
  {
    conductivity += s.Diffusion * s.Below * FaradayUnit();
  }
  return conductivity * 1e-3 * p.Voltage * units::ElementaryCharge /
    (units::BoltzmannConstant * p.Temperature) / resistance;
}

/// A ring of charges around the axis, in the middle of the membrane, turned as the membrane is.
std::vector<ChargedAtom> Ring(const MembraneSlab& m, double radius, double charge)
{
  const Point3& n = m.MembraneNormal; // in the plane of x and z
  std::vector<ChargedAtom> ring;
  constexpr int count = 12;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    const double u = radius * std::cos(angle);
    const double v = radius * std::sin(angle);
    ring.push_back(
      { { m.MembraneCenter[0] + u * n[2], m.MembraneCenter[1] + v, m.MembraneCenter[2] - u * n[0] },
        charge / count, 0.0 });
  }
  return ring;
}

}

TEST(TransportGrid, PoreHasItsAccessResistance)
{
  IonTransportParameters p = Pore(4.0, 20.0, 1.0);
  p.Padding = 12.0;
  const double current = Current(p);
  std::cout << current << " pA, by resistances " << OhmicCurrent(p) << "\n";
  EXPECT_NEAR(current / OhmicCurrent(p), 1.0, 0.05);
}

TEST(TransportGrid, ChargedPoreMatchesTwoDimensions)
{
  IonTransportParameters p = Pore(4.0, 10.0, 0.5);
  p.Padding = 5.0;
  p.Species[0].Below = p.Species[1].Below = 0.3;
  p.Species[0].Above = p.Species[1].Above = 0.1;
  p.Voltage = 50.0;
  constexpr double charge = -0.8;
  TransportGrid grid = MakeTransportGrid(DomainAround({}, p), {}, Ring(p, 7.0, charge), p);
  const CurrentProfile currents = SolveCurrents(grid, p);
  // Its own error is of the first order (chloride 3.66, 3.79, 3.86, 3.89 pA at 0.5 to 0.0625
  // angstrom), so two of them are extrapolated to spacing 0.
  const AxisymmetricPore coarse(grid.Domain, p, 7.0, charge, 0.5);
  const AxisymmetricPore fine(grid.Domain, p, 7.0, charge, 0.25);
  for (std::size_t k = 0; k < 2; ++k)
  {
    const double reference = 2.0 * fine.Current(k) - coarse.Current(k);
    std::cout << p.Species[k].Name << ": " << currents.Mean(k) << " pA, in two dimensions "
              << reference << "\n";
    EXPECT_NEAR(currents.Mean(k) / reference, 1.0, 0.02);
  }
}

TEST(ChannelSolution, ErrorOfTheCurrentCoversTheTruth)
{
  // Pores with a ring of charges, compared with two dimensions extrapolated to spacing 0.
  std::mt19937 random(5);
  const auto between = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  constexpr int count = 12;
  int covered = 0;
  std::vector<double> ratios;
  for (int i = 0; i < count; ++i)
  {
    IonTransportParameters p =
      Pore(0.5 * std::round(between(5.0, 10.0)), std::round(between(8.0, 14.0)), between(0.4, 1.0));
    p.Padding = 5.0;
    p.Species[0].Below = p.Species[1].Below = between(0.1, 0.5);
    p.Species[0].Above = p.Species[1].Above = between(0.1, 0.5);
    p.Voltage = between(30.0, 100.0);
    const double charge = between(-0.8, 0.2);
    const double ring = p.LumenRadius + 3.0;
    ChannelProblem problem;
    problem.Transport = p;
    problem.Charges = Ring(p, ring, charge);
    const ChannelSolution channel(problem);
    const double current = ComputeCurrents(channel.Get()).Mean();
    const double estimate = EstimateCurrentError(problem, channel);
    double reference = 0.0;
    const TransportDomain domain = DomainAround({}, p);
    for (const double h : { 0.25, 0.125 })
    {
      const AxisymmetricPore pore(domain, p, ring, charge, h);
      reference += (h < 0.2 ? 2.0 : -1.0) * (pore.Current(0) + pore.Current(1));
    }
    const double error = std::abs(current - reference);
    covered += estimate >= error ? 1 : 0;
    ratios.push_back(estimate / error);
    std::printf("R %.2f h %.2f: %.3f pA, in two dimensions %.3f, error %.3f, estimate %.3f\n",
      p.LumenRadius, p.Spacing, current, reference, error, estimate);
  }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_GE(covered, count * 9 / 10);
  EXPECT_LE(ratios[count / 2], 5.0);
}

TEST(TransportGrid, TurnedByThirtyDegreesTheCurrentIsTheSame)
{
  IonTransportParameters p = Pore(4.0, 10.0, 0.5);
  p.Padding = 5.0;
  const double straight = Current(p, Ring(p, 7.0, -0.8));
  p.MembraneNormal = { 0.5, 0.0, std::sqrt(0.75) };
  p.MembraneCenter = { 0.13, -0.21, 0.3 };
  const double turned = Current(p, Ring(p, 7.0, -0.8));
  std::cout << straight << " pA, turned " << turned << "\n";
  EXPECT_NEAR(turned / straight, 1.0, 1e-4);
}

TEST(TransportGrid, PositivePartMatchesASquare)
{
  for (const double distance : { -0.9, -0.4, -0.1, 0.0, 0.2, 0.7 })
  {
    for (const double g1 : { 0.0, 1e-9, -0.3, 0.8 })
    {
      for (const double g2 : { 0.0, 0.5, -0.6 })
      {
        constexpr int n = 400;
        int positive = 0;
        for (int i = 0; i < n * n; ++i)
        {
          const double u = (i % n + 0.5) / n - 0.5;
          const double v = (static_cast<double>(i / n) + 0.5) / n - 0.5;
          positive += distance + g1 * u + g2 * v > 0.0 ? 1 : 0;
        }
        if (distance != 0.0 || g1 != 0.0 || g2 != 0.0)
        {
          EXPECT_NEAR(PositiveFraction(distance, g1, g2), positive / double(n * n), 0.01)
            << distance << " " << g1 << " " << g2;
        }
      }
    }
  }
}

TEST(ChannelPassage, ReportsWhereAChannelCloses)
{
  // A ball of 3 angstrom stops a pore of 4, off the axis by 2.2: the passage on its other side is
  // widest halfway between ball and wall, 1.6 from each.
  IonTransportParameters p = Pore(4.0, 10.0, 0.5);
  p.Padding = 4.0;
  p.ProbeRadius = 0.0;
  const auto passage = [&p](double x, double radius)
  {
    const std::vector<Ball> ball{ { { x, 0.0, 1.5 }, radius } };
    const TransportDomain domain = DomainAround(ball, p);
    return FindPassage(
      MakeTransportGrid(domain, DistanceToAtoms(domain, ball, p.ProbeRadius), {}, p));
  };
  const ChannelPassage past = passage(2.0, 3.0);
  RequireOpen(past);
  EXPECT_NEAR(past.Radius, 1.5, 0.3);
  EXPECT_NEAR(past.Bottleneck[0], -2.5, 0.6);
  EXPECT_NEAR(past.Along, 1.5,
    2.6); // nodes at a distance of 2.5 are as near to the wall as the narrowest one
  const ChannelPassage closed = passage(0.0, 4.6);
  EXPECT_NEAR(closed.Radius, -0.3, 0.2);
  try
  {
    RequireOpen(closed);
    FAIL() << "it is closed";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("blocked at ("), std::string::npos) << error.what();
  }
}

TEST(ChannelPassage, ClosesPocketsWithoutABath)
{
  TransportGrid line = TransportLine(41, 40.0);
  EXPECT_THROW(
    {
      TransportGrid cut = line;
      cut.Aperture[2][20] = 0.0F;
      CloseIsolatedPockets(cut);
    },
    std::runtime_error);
  // A second line beside it, which is a dead end.
  TransportGrid two = line;
  two.Domain.Dimensions[0] = 2;
  const auto beside = [](auto& values, const auto& of, auto first)
  {
    values.clear();
    for (const auto& value : of)
    {
      values.push_back(value);
      values.push_back(first);
    }
  };
  beside(two.Distance, line.Distance, 1.0F);
  beside(two.Along, line.Along, 0.0F);
  beside(two.Water, line.Water, 1.0F);
  beside(two.Baths, line.Baths, static_cast<unsigned char>(0));
  beside(two.Charge, line.Charge, 0.0);
  for (std::size_t a = 0; a < 3; ++a)
  {
    beside(two.Permittivity[a], line.Permittivity[a], a == 2 ? 80.0F : 0.0F);
    beside(two.Aperture[a], line.Aperture[a], a == 2 ? 1.0F : 0.0F);
  }
  two.Aperture[2][81] = 0.0F; // the last one has no successor
  CloseIsolatedPockets(two);
  EXPECT_EQ(two.Water[21], 0.0F);
  EXPECT_EQ(two.Aperture[2][21], 0.0F);
  EXPECT_EQ(two.Water[20], 1.0F);
  EXPECT_EQ(two.Aperture[2][20], 1.0F);
}

TEST(TransportSpecies, ThoseWithoutANameHaveTheirNumber)
{
  std::vector<TransportSpecies> species(4);
  NameSpecies("Na, Cl", species);
  EXPECT_EQ(species[0].Name, "Na");
  EXPECT_EQ(species[1].Name, "Cl");
  EXPECT_EQ(species[2].Name, "Ion3");
  EXPECT_EQ(species[3].Name, "Ion4");
}
