// Poisson-Nernst-Planck where there are analytical solutions: constant field, double layer, liquid
// junction; properties of every solution; and refused input.

#include "TransportLine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>
#include <stdexcept>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

IonTransportParameters MakeSalt(double below, double above)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, below, above, 1.96, 1.0 }, { "Cl", -1.0, below, above, 2.03, 1.0 } };
  return p;
}

double Thermal(const IonTransportParameters& p)
{
  return 1e3 * units::BoltzmannConstant * p.Temperature / units::ElementaryCharge; // mV
}

double LineCurrent(const TransportGrid& line, const PoissonNernstPlanck& solution)
{
  return ComputeCurrents(solution).Mean() / (line.Domain.Spacing * line.Domain.Spacing);
}

}

TEST(PoissonNernstPlanck, ConstantFieldIsGoldmanHodgkinKatz)
{
  // At 1e-7 mol/l the ions do not change the field: D. E. Goldman, J. Gen. Physiol. 27 (1943) 37.
  constexpr double length = 50.0;
  const TransportGrid line = TransportLine(26, length);
  IonTransportParameters p = MakeSalt(1e-7, 5e-8);
  p.MembraneThickness = length;
  p.Species.push_back({ "Ca", 2.0, 1e-8, 3e-8, 0.79, 1.0 });
  p.Species[1].Below += 2e-8;
  p.Species[1].Above += 6e-8;
  for (const double voltage : { -200.0, -100.0, -25.0, 0.0, 50.0, 200.0 })
  {
    p.Voltage = voltage;
    PoissonNernstPlanck solution(line, p);
    EXPECT_TRUE(solution.Solve().Converged);
    const CurrentProfile currents = ComputeCurrents(solution);
    for (std::size_t k = 0; k < p.Species.size(); ++k)
    {
      const TransportSpecies& s = p.Species[k];
      const double x = s.Valence * voltage / Thermal(p);
      const double factor = x == 0.0 ? 1.0 : x / (1.0 - std::exp(-x));
      const double expected = s.Valence * s.Diffusion * FaradayUnit() / length * factor *
        (s.Below - s.Above * std::exp(-x)) * line.Domain.Spacing * line.Domain.Spacing;
      EXPECT_NEAR(currents.Mean(k) / expected, 1.0, 1e-6) << s.Name << " at " << voltage;
    }
    EXPECT_LT(currents.Spread(), 1e-6);
  }
}

TEST(PoissonNernstPlanck, DoubleLayerIsGouysAndChapmansToSecondOrder)
{
  // A wall with a charge at the closed end of a long line; phi from tanh(phi / 4), exactly.
  constexpr double length = 160.0;
  constexpr double molar = 0.1;
  constexpr double surface = -0.004; // e per square angstrom
  double before = 0.0;
  for (const std::int64_t nodes : { 101, 201, 401, 801 })
  {
    TransportGrid line = TransportLine(nodes, length);
    const double h = line.Domain.Spacing;
    line.Baths.back() = 0;
    line.Water.back() = 0.5F;
    line.Charge.back() = surface * h * h;
    IonTransportParameters p = MakeSalt(molar, molar);
    p.Voltage = 0.0;
    p.Tolerance = 1e-8;
    PoissonNernstPlanck solution(line, p);
    EXPECT_TRUE(solution.Solve().Converged);
    const double coulomb = units::CoulombLength(p.Temperature) / 80.0;
    const double kappa = std::sqrt(8.0 * Pi * coulomb * molar * units::IonsPerCubicAngstrom);
    const double wall = 2.0 * std::asinh(2.0 * Pi * coulomb * surface / kappa);
    double error = 0.0;
    for (std::int64_t i = 0; i < nodes; ++i)
    {
      const double from = length - h * static_cast<double>(i);
      const double exact = 4.0 * std::atanh(std::tanh(0.25 * wall) * std::exp(-kappa * from));
      error =
        std::max(error, std::abs(solution.GetPotential()[static_cast<std::size_t>(i)] - exact));
    }
    std::cout << nodes << " nodes: " << error << " kT/e of " << wall << "\n";
    if (before > 0.0)
    {
      EXPECT_GT(std::log2(before / error), 1.9) << nodes;
    }
    before = error;
  }
  EXPECT_LT(before, 1e-3);
}

TEST(PoissonNernstPlanck, LongLiquidJunctionIsHendersons)
{
  // NaCl, 0.5 against 0.05 mol/l: (D+ - D-) / (D+ + D-) ln 10 (P. Henderson, Z. phys. Chem. 59
  // (1907) 118), where the junction is many Debye lengths long.
  constexpr double length = 800.0;
  const TransportGrid line = TransportLine(401, length);
  IonTransportParameters p = MakeSalt(0.5, 0.05);
  p.Species[0] = { "Na", 1.0, 0.5, 0.05, 1.33, 1.0 };
  p.MembraneThickness = length;
  p.Tolerance = 1e-7;
  const double henderson = (1.33 - 2.03) / (1.33 + 2.03) * std::log(10.0); // of Above less Below
  PoissonNernstPlanck solution(line, p);
  double voltage[2] = { 0.0, 20.0 };
  double current[2];
  for (int i = 0; i < 2; ++i)
  {
    solution.SetVoltage(voltage[i]);
    EXPECT_TRUE(solution.Solve().Converged);
    current[i] = ComputeCurrents(solution).Mean();
  }
  for (int step = 0; step < 4; ++step) // secants
  {
    const double next =
      voltage[1] - current[1] * (voltage[1] - voltage[0]) / (current[1] - current[0]);
    voltage[0] = voltage[1];
    current[0] = current[1];
    voltage[1] = next;
    solution.SetVoltage(next);
    EXPECT_TRUE(solution.Solve().Converged);
    current[1] = ComputeCurrents(solution).Mean();
  }
  const double junction = -voltage[1] / Thermal(p);
  std::cout << "junction " << junction << ", Henderson " << henderson << " kT/e\n";
  EXPECT_NEAR(junction / henderson, 1.0, 0.01);
}

TEST(PoissonNernstPlanck, ConcentrationsArePositiveAndCurrentsConserved)
{
  // Fixed charges of both signs at random, up to 8 mol/l of them; voltages and salts at random.
  std::mt19937 random(17);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  for (int trial = 0; trial < 20; ++trial)
  {
    TransportGrid line = TransportLine(81, 80.0);
    for (std::size_t i = 10; i < 70; ++i)
    {
      line.Charge[i] = 8.0 * part(random) * units::IonsPerCubicAngstrom;
    }
    IonTransportParameters p = MakeSalt(0.1 + 0.09 * part(random), 0.5 + 0.45 * part(random));
    p.Voltage = 200.0 * part(random);
    PoissonNernstPlanck solution(line, p);
    EXPECT_TRUE(solution.Solve().Converged) << trial;
    for (std::int64_t node = 0; node < line.Domain.Size(); ++node)
    {
      ASSERT_GT(solution.Concentration(SpeciesId(0), node), 0.0);
      ASSERT_GT(solution.Concentration(SpeciesId(1), node), 0.0);
      ASSERT_TRUE(std::isfinite(solution.GetPotential()[static_cast<std::size_t>(node)]));
    }
    EXPECT_LT(ComputeCurrents(solution).Spread(), 1e-4) << trial;
  }
}

TEST(PoissonNernstPlanck, SymmetricChannelsHaveSymmetricCurrents)
{
  TransportGrid line = TransportLine(61, 60.0);
  for (std::size_t i = 20; i <= 40; ++i)
  {
    line.Charge[i] = -0.5 * units::IonsPerCubicAngstrom;
  }
  IonTransportParameters p = MakeSalt(0.1, 0.1);
  p.Tolerance = 1e-6;
  PoissonNernstPlanck solution(line, p);
  for (const double voltage : { 25.0, 100.0 })
  {
    solution.SetVoltage(voltage);
    solution.Solve();
    const double forth = LineCurrent(line, solution);
    solution.SetVoltage(-voltage);
    solution.Solve();
    EXPECT_GT(forth, 0.0);
    EXPECT_NEAR(LineCurrent(line, solution) / forth, -1.0, 1e-4) << voltage;
  }
  solution.SetVoltage(0.0);
  solution.Solve();
  EXPECT_NEAR(LineCurrent(line, solution), 0.0, 1e-9);
}

TEST(PoissonNernstPlanck, LackOfConvergenceIsMarked)
{
  TransportGrid line = TransportLine(61, 60.0);
  line.Charge[30] = -0.01;
  IonTransportParameters p = MakeSalt(0.1, 0.1);
  p.MaximumIterations = 1;
  PoissonNernstPlanck solution(line, p);
  EXPECT_FALSE(solution.Solve().Converged);
  ASSERT_EQ(solution.GetReport().Changes.size(), 1u);
  EXPECT_GT(solution.GetReport().Changes[0], p.Tolerance);
  EXPECT_GT(ComputeCurrents(solution).Mean(), 0.0);
}

TEST(PoissonNernstPlanck, RefusesUnsolvableProblems)
{
  const TransportGrid line = TransportLine(11, 10.0);
  const auto refused = [&](auto&& change)
  {
    IonTransportParameters p = MakeSalt(0.1, 0.1);
    change(p);
    try
    {
      PoissonNernstPlanck solution(line, p);
    }
    catch (const std::invalid_argument& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const double nan = std::nan("");
  const auto has = [](const std::string& sentence, const char* word)
  { return sentence.find(word) != std::string::npos; };
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_TRUE(has(refused([](auto& p) { p.Species.clear(); }), "no ions"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[0].Valence = 0.0; }), "valence"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[0].Below = 0.2; }), "bath below"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[0].Above = 0.2; }), "bath above"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[0].Above = -0.2; }), "concentration above"));
  // Rounding is allowed, relative to the charge of all ions however few they are.
  for (const double molar : { 1e-6, 4.0 })
  {
    const auto calcium = [molar](double more)
    {
      return [=](auto& p)
      {
        p.Species[0] = { "Ca", 2.0, molar * (1.0 + more), molar, 0.79, 1.0 };
        p.Species[1] = { "Cl", -1.0, 2.0 * molar, 2.0 * molar, 2.03, 1.0 };
      };
    };
    EXPECT_EQ(refused(calcium(1e-10)), "") << molar;
    EXPECT_TRUE(has(refused(calcium(1e-8)), "bath below")) << molar;
  }
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[1].Diffusion = 0.0; }), "diffusion"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Species[1].ChannelFraction = 0.0; }), "fraction"));
  EXPECT_TRUE(has(refused([](auto& p) { p.MembraneNormal = { 0.0, 0.0, 0.0 }; }), "normal"));
  EXPECT_TRUE(has(refused([&](auto& p) { p.MembraneCenter[1] = nan; }), "MembraneCenter"));
  EXPECT_TRUE(has(refused([](auto& p) { p.MembraneThickness = 0.0; }), "MembraneThickness"));
  EXPECT_TRUE(has(refused([](auto& p) { p.LumenRadius = -1.0; }), "LumenRadius"));
  EXPECT_TRUE(has(refused([&](auto& p) { p.Voltage = nan; }), "Voltage"));
  EXPECT_TRUE(has(refused([](auto& p) { p.SolventDielectric = 0.0; }), "SolventDielectric"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Spacing = 0.0; }), "Spacing"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Padding = 0.5; }), "Padding"));
  EXPECT_TRUE(has(refused([](auto& p) { p.Temperature = -1.0; }), "Temperature"));
}
