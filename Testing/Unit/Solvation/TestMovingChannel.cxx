// Channels with a wall moved by field and ions: the flow of a bare pore by a formula, the rest
// state of a charged pore compared with a radial solution, no force against the surface at rest,
// and what is reported.

#include "ChannelTube.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Solvation/MovingChannel.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// A pore through a membrane, and nothing else: no force on it but tension and pressure.
IonTransportParameters BarePore(double radius, double spacing)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, 0.1, 0.1, 1.96, 1.0 }, { "Cl", -1.0, 0.1, 0.1, 2.03, 1.0 } };
  p.LumenRadius = radius;
  p.MembraneThickness = 20.0;
  p.Spacing = spacing;
  p.Padding = 4.0;
  p.SoluteDielectric = 80.0;
  return p;
}

MovingChannelParameters Walls(double tension, double pressure, int period, int updates)
{
  MovingChannelParameters m;
  m.Solvent.SurfaceTension = tension;
  m.Solvent.Pressure = pressure;
  m.Policy.UpdatePeriod = period;
  m.Policy.MaximumUpdates = updates;
  return m;
}

/// Rings of charges around the axis, all along the membrane.
std::vector<ChargedAtom> ChargedWall(const MembraneSlab& m, double radius, double perAngstrom)
{
  constexpr int around = 24;
  constexpr double step = 0.5;
  std::vector<ChargedAtom> charges;
  for (double along = 0.5 * (step - m.MembraneThickness); along < 0.5 * m.MembraneThickness;
       along += step)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * i / around;
      charges.push_back({ { radius * std::cos(angle), radius * std::sin(angle), along },
        perAngstrom * step / around, 0.0 });
    }
  }
  return charges;
}

/// The pressure on the wall of an infinitely long pore, kT/angstrom^3: Poisson-Boltzmann's equation
/// in the radius alone (Runge and Kutta, from the axis), the charge of its ions known.
double WallPressure(const IonTransportParameters& p, double radius, double perAngstrom)
{
  const double coulomb = 4.0 * Pi * units::CoulombLength(p.Temperature);
  const double ions = units::IonsPerCubicAngstrom * p.Species[0].Below; // symmetric salt
  const auto atWall = [&](double axis)
  {
    constexpr int steps = 400;
    const double h = radius / steps;
    double phi = axis, slope = 0.0;
    const auto bend = [&](double r, double value, double d)
    {
      const double source = coulomb * ions / p.SolventDielectric * 2.0 * std::sinh(value);
      return r > 0.0 ? source - d / r : 0.5 * source;
    };
    for (int i = 0; i < steps; ++i)
    {
      const double r = h * i;
      const double a = bend(r, phi, slope);
      const double b = bend(r + 0.5 * h, phi + 0.5 * h * slope, slope + 0.5 * h * a);
      phi += h * (slope + 0.5 * h * a);
      slope += h * b;
    }
    return std::isfinite(slope) ? std::array<double, 2>{ phi, slope }
                                : std::array<double, 2>{ axis, axis * HUGE_VAL };
  };
  // Ions and wall cancel: 2 pi r eps phi' = 4 pi C x (charge of the wall along an angstrom).
  const double wanted = coulomb * perAngstrom / (2.0 * Pi * radius * p.SolventDielectric);
  double low = -15.0, high = 15.0;
  for (int i = 0; i < 80; ++i)
  {
    const double middle = 0.5 * (low + high);
    (atWall(middle)[1] < wanted ? low : high) = middle;
  }
  const auto [phi, slope] = atWall(low);
  const double displacement = p.SolventDielectric * slope;
  return (1.0 / p.SoluteDielectric - 1.0 / p.SolventDielectric) * displacement * displacement /
    (2.0 * coulomb) +
    2.0 * ions * (std::cosh(phi) - 1.0);
}

/// The radius of the circle of water in the middle of the membrane.
double RadiusInTheMiddle(const TransportGrid& grid)
{
  double area = 0.0;
  for (std::int64_t node = 0; node < grid.Domain.Size(); ++node)
  {
    const auto p = static_cast<std::size_t>(node);
    if (std::abs(static_cast<double>(grid.Along[p])) < 0.1 * grid.Domain.Spacing)
    {
      area += static_cast<double>(grid.Aperture[2][p]);
    }
  }
  return grid.Domain.Spacing * std::sqrt(area / Pi);
}

}

TEST(MovingChannel, ABarePoreClosesUnderTension)
{
  // dr/dT = -1/r + p/gamma, T in square angstrom: without pressure r^2 falls by 2 T.
  constexpr double radius = 3.2;
  double before = 0.0;
  for (const double spacing : { 1.0, 0.7 })
  {
    const IonTransportParameters p = BarePore(radius, spacing);
    MovingChannelParameters m = Walls(0.07, 0.0, 1, 2);
    m.Policy.AdaptiveUpdate = false;
    m.Policy.UpdatePeriod = static_cast<int>(std::lround(2.0 / (0.16 * spacing * spacing)));
    MovingChannel channel(DomainAround({}, p), {}, {}, {}, p, m);
    channel.Run();
    ASSERT_EQ(channel.GetUpdates().size(), 2u);
    const ChannelUpdate& last = channel.GetUpdates().back();
    EXPECT_LT(last.AreaChange, -10.0);
    EXPECT_NEAR(last.EnergyChange, 0.07 * last.AreaChange, 1e-9 * std::abs(last.AreaChange));
    EXPECT_LT(last.LumenVolume, channel.GetUpdates().front().LumenVolume);
    const double time = last.Time;
    const double exact = std::sqrt(radius * radius - 2.0 * time);
    const double reached = RadiusInTheMiddle(channel.GetSolution().GetGrid());
    const double error = std::abs(reached / exact - 1.0);
    std::cout << "spacing " << spacing << ": " << reached << " angstrom after " << time
              << ", exact " << exact << "\n";
    EXPECT_LT(error, 0.05 * spacing * spacing);
    EXPECT_TRUE(before == 0.0 || error < before);
    before = error;
  }
}

TEST(MovingChannel, PressureHoldsAPoreOpenThatIsWideEnough)
{
  // dr/dT is 0 at r = gamma / p: wider ones stay on their obstacle, narrower ones close.
  constexpr double radius = 3.0, tension = 0.07;
  const IonTransportParameters p = BarePore(radius, 1.0);
  const TransportDomain domain = DomainAround({}, p);
  MovingChannel wide(domain, {}, {}, {}, p, Walls(tension, 1.2 * tension / radius, 50, 10));
  wide.Run();
  EXPECT_TRUE(wide.HasConverged());
  EXPECT_NEAR(RadiusInTheMiddle(wide.GetSolution().GetGrid()) / radius, 1.0, 0.01);
  EXPECT_NEAR(wide.GetUpdates().back().Current() / wide.GetUpdates().front().Current(), 1.0, 0.02);
  MovingChannel narrow(domain, {}, {}, {}, p, Walls(tension, 0.8 * tension / radius, 50, 10));
  try
  {
    narrow.Run();
    FAIL() << "it closes";
  }
  catch (const std::runtime_error& error)
  {
    EXPECT_NE(std::string(error.what()).find("has closed the channel at ("), std::string::npos)
      << error.what();
  }
}

TEST(MovingChannel, WallOfALongChargedPoreIsPulledAsInOneDimension)
{
  constexpr double charge = -0.06; // e an angstrom
  constexpr double radius = 3.6;
  const std::array<double, 2> cases[] = { { 2.0, 0.8 }, { 2.0, 0.6 }, { 2.0, 0.5 }, { 40.0, 0.8 } };
  for (const auto& [dielectric, spacing] : cases)
  {
    IonTransportParameters p = BarePore(radius, spacing);
    p.SoluteDielectric = dielectric;
    p.Voltage = 0.0;
    p.MembraneThickness = 60.0;
    p.Padding = 3.6;
    const TransportDomain domain = DomainAround({}, p);
    MovingChannel channel(domain, {}, ChargedWall(p, 7.0, charge), {}, p, Walls(0.07, 0.0, 1, 1));
    channel.Run();
    const WallValues wall = channel.ForceAtWall();
    double sum = 0.0, count = 0.0;
    const double exact = WallPressure(p, radius, charge) * units::ThermalKilocalorie(p.Temperature);
    for (std::size_t i = 0; i < wall.Pull.size(); ++i)
    {
      const Point3 at = MovingChannel::Padded(domain).Place(wall.Crossings[i].Node);
      if (std::abs(at[2]) < 3.0 && std::hypot(at[0], at[1]) < 5.0)
      {
        sum += wall.Pull[i];
        count += 1.0;
        ASSERT_NEAR(wall.Pull[i] / exact, 1.0, 0.05);
      }
    }
    std::cout << "dielectric " << dielectric << ", spacing " << spacing << ": " << sum / count
              << " kcal/mol/A^3, in one dimension " << exact << "\n";
    EXPECT_NEAR(sum / count / exact, 1.0, 0.025);
  }
}

TEST(MovingChannel, AChargedPoreMovesAsPredicted)
{
  // In one dimension dr/dT = push / gamma - 1/r, the push that of the start. The ends are too far
  // away to have an effect in this time.
  constexpr double charge = -0.06, radius = 4.6;
  for (const double dielectric : { 2.0, 40.0 })
  {
    IonTransportParameters p = BarePore(radius, 0.8);
    p.MembraneThickness = 60.0;
    p.SoluteDielectric = dielectric;
    p.Voltage = 0.0;
    const double push = WallPressure(p, radius, charge) * units::ThermalKilocalorie(p.Temperature);
    const double tension = 3.0 * push * radius; // field and ions are a third as strong
    MovingChannel channel(
      DomainAround({}, p), {}, ChargedWall(p, 7.5, charge), {}, p, Walls(tension, 0.0, 40, 2));
    channel.Run();
    double r = radius;
    constexpr int steps = 400;
    for (int i = 0; i < steps; ++i)
    {
      r += (push / tension - 1.0 / r) * channel.GetUpdates()[1].Time / steps;
    }
    const double reached = RadiusInTheMiddle(channel.GetSolution().GetGrid());
    std::cout << "dielectric " << dielectric << ": from " << radius << " to " << reached
              << ", in one dimension " << r << "\n";
    EXPECT_NEAR((radius - reached) / (radius - r), 1.0, 0.1);
  }
}

TEST(MovingChannel, WithoutForcesItIsTheSteadySurface)
{
  // Atoms, but neither charges, nor a jump of the dielectric constant, nor voltage: tension alone,
  // on an obstacle given by a probe; what it changes is due to the flow, independent of the ions.
  IonTransportParameters p = TubeParameters(3.0);
  p.Voltage = 50.0;
  p.SoluteDielectric = p.SolventDielectric;
  Tube tube = MakeTube(p, 3.0, 0.0);
  const TransportDomain domain = DomainAround(tube.Balls, p);
  const std::vector<float> obstacle =
    DistanceToAtoms(MovingChannel::Padded(domain), tube.Balls, p.ProbeRadius);
  // Enough pressure to keep it on the obstacle: the result is ion transport with the obstacle's
  // surface.
  MovingChannel held(domain, obstacle, {}, {}, p, Walls(0.01, 0.05, 20, 10));
  held.Run();
  EXPECT_TRUE(held.HasConverged());
  TransportGrid grid =
    MakeTransportGrid(domain, DistanceToAtoms(domain, tube.Balls, p.ProbeRadius), {}, p);
  CloseIsolatedPockets(grid);
  PoissonNernstPlanck still(grid, p);
  still.Solve();
  const double current = ComputeCurrents(still).Mean();
  std::cout << held.GetUpdates().front().Current() << " pA, then "
            << held.GetUpdates().back().Current() << ", at rest " << current << "\n";
  EXPECT_NEAR(held.GetUpdates().front().Current() / current, 1.0, 0.01);
  EXPECT_NEAR(held.GetUpdates().back().Current() / current, 1.0, 0.02);
  // Without the contributions of ions and field, which are zero, the result is bitwise the same.
  IonTransportParameters dilute = p;
  for (TransportSpecies& s : dilute.Species)
  {
    s.Below = s.Above = 1e-6;
  }
  MovingChannel empty(domain, obstacle, {}, {}, dilute, Walls(0.01, 0.05, 20, 10));
  empty.Run();
  EXPECT_NEAR(empty.GetUpdates().back().LumenVolume, held.GetUpdates().back().LumenVolume, 1e-3);
}

TEST(MovingChannel, ConservesIonsOnAnyNumberOfThreads)
{
  IonTransportParameters p = TubeParameters(3.0);
  p.Species[0].Above = p.Species[1].Above = 0.3;
  const Tube tube = MakeTube(p, 3.0, -0.05);
  const TransportDomain domain = DomainAround(tube.Balls, p);
  std::vector<DispersionAtom> attracting;
  for (const Ball& ball : tube.Balls)
  {
    attracting.push_back({ ball.Center, ball.Radius, 0.1 });
  }
  MovingChannelParameters walls = Walls(0.07, 0.0464, 20, 10);
  walls.UpdateTolerance = 3e-3;
  std::vector<double> first;
  for (const int threads : { 1, 2, 4 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&]
      {
        MovingChannel channel(domain,
          DistanceToAtoms(MovingChannel::Padded(domain), tube.Balls, p.ProbeRadius), tube.Charges,
          attracting, p, walls);
        channel.Run();
        EXPECT_TRUE(channel.HasConverged());
        EXPECT_LE(channel.GetUpdates().size(), 10u);
        const PoissonNernstPlanck& solution = channel.GetSolution();
        EXPECT_LT(ComputeCurrents(solution).Spread(), 1e-4);
        for (std::int64_t node = 0; node < domain.Size(); ++node)
        {
          ASSERT_GE(solution.Concentration(SpeciesId(0), node), 0.0);
          ASSERT_GE(solution.Concentration(SpeciesId(1), node), 0.0);
        }
        std::cout << channel.GetUpdates().front().Current() << " pA at first, "
                  << channel.GetUpdates().back().Current() << " at rest after "
                  << channel.GetUpdates().size() << " updates\n";
        first = first.empty() ? solution.GetPotential() : first;
        EXPECT_EQ(solution.GetPotential(), first);
      });
  }
}

TEST(MovingChannel, WithoutConvergenceTheSteadiestUpdateIsKept)
{
  // Tension alone closes it at increasing speed: the first update after the start has the smallest
  // change.
  const IonTransportParameters p = BarePore(4.0, 1.0);
  MovingChannelParameters m = Walls(0.07, 0.0, 8, 4);
  m.Policy.AdaptiveUpdate = false;
  MovingChannel channel(DomainAround({}, p), {}, {}, {}, p, m);
  channel.Run();
  EXPECT_FALSE(channel.HasConverged());
  ASSERT_EQ(channel.GetUpdates().size(), 4u);
  EXPECT_GT(channel.LastChange(), m.UpdateTolerance);
  EXPECT_EQ(channel.GetShown(), 1u);
  EXPECT_NEAR(
    ComputeCurrents(channel.GetSolution()).Mean() / channel.GetUpdates()[1].Current(), 1.0, 1e-4);
}

TEST(MovingChannel, RefusesUnsolvableProblems)
{
  const IonTransportParameters p = BarePore(3.0, 1.0);
  const auto refused = [&](auto&& change)
  {
    MovingChannelParameters m = Walls(0.07, 0.0464, 10, 3);
    change(m);
    try
    {
      MovingChannel channel(DomainAround({}, p), {}, {}, {}, p, m);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto has = [](const std::string& sentence, const char* word)
  { return sentence.find(word) != std::string::npos; };
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_TRUE(has(refused([](auto& m) { m.Solvent.SurfaceTension = 0.0; }), "SurfaceTension"));
  EXPECT_TRUE(has(refused([](auto& m) { m.Solvent.Pressure = std::nan(""); }), "Pressure"));
  EXPECT_TRUE(has(refused([](auto& m) { m.Policy.UpdatePeriod = 0; }), "UpdatePeriod"));
  EXPECT_TRUE(has(refused([](auto& m) { m.Policy.FieldRelaxation = 2.0; }), "FieldRelaxation"));
}
