// Channels in three dimensions: a cylindrical pore against the access resistance and an
// axisymmetric solution of its own, turned by 30 degrees, closed, and with pockets; the network
// that all is solved by.

#include "ChannelPassage.h"
#include "TransportLine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <stdexcept>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

IonTransportParameters Pore(double radius, double thickness, double spacing)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, 0.5, 0.5, 1.96, 1.0 }, { "Cl", -1.0, 0.5, 0.5, 2.03, 1.0 } };
  p.Membrane.LumenRadius = radius;
  p.Membrane.Thickness = thickness;
  p.Spacing = spacing;
  p.Voltage = 25.7;
  p.Padding = 12.0;
  return p;
}

double Current(const IonTransportParameters& p, const std::vector<Ball>& balls = {},
  const std::vector<ChargedAtom>& charges = {})
{
  TransportGrid grid = MakeTransportGrid(DomainAround(balls, p),
    balls.empty() ? std::vector<float>()
                  : DistanceToAtoms(DomainAround(balls, p), balls, p.ProbeRadius),
    charges, p);
  DemandOpen(FindPassage(grid));
  ClosePockets(grid);
  PoissonNernstPlanck solution(grid, p);
  const auto t0 = std::chrono::steady_clock::now();
  EXPECT_TRUE(solution.Solve().Converged);
  const CurrentProfile currents = CurrentsOf(solution);
  std::cout << grid.Domain.Size() << " nodes, " << solution.GetReport().Iterations
            << " iterations, " << solution.GetReport().LinearIterations << " linear, "
            << currents.Mean() << " pA, spread " << currents.Spread() << " "
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count() << " s"
            << std::endl;
  EXPECT_LT(currents.Spread(), 1e-4);
  return currents.Mean();
}

/// Ohm's law with the pore's, the access and the baths' resistance, in a cylinder.
double HallInABox(const IonTransportParameters& p, const TransportDomain& d)
{
  const double r = p.Membrane.LumenRadius;
  const double e = r / d.Radius;
  const double psi = 1.0 - 1.409 * e + 0.296 * e * e * e;
  const double resistance = p.Membrane.Thickness / (units::Pi * r * r) +
    2.0 * 0.8217 * psi / (units::Pi * r) +
    (2.0 * d.HalfLength - p.Membrane.Thickness) / (units::Pi * d.Radius * d.Radius);
  const double conductivity = (1.96 + 2.03) * 0.5 * FaradayUnit();
  return conductivity * 25.7e-3 * units::ElementaryCharge / (units::BoltzmannConstant * 298.15) /
    resistance;
}

}

TEST(TransportGrid, Cylinder)
{
  for (const double h : { 1.0, 0.5 })
  {
    const IonTransportParameters p = Pore(4.0, 20.0, h);
    const double hall = HallInABox(p, DomainAround({}, p));
    const double current = Current(p);
    std::cout << h << " " << current << " hall " << hall << " " << current / hall << "\n";
  }
}

TEST(TransportGrid, Turned)
{
  IonTransportParameters p = Pore(4.0, 10.0, 0.5);
  p.Padding = 8;
  const double straight = Current(p);
  p.Membrane.Normal = { 0.5, 0.0, std::sqrt(0.75) };
  p.Membrane.Centre = { 0.13, -0.21, 0.3 };
  const double turned = Current(p);
  std::cout << turned / straight << "\n";
}
