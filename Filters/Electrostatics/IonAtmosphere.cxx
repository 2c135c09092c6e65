#include "Electrostatics/IonAtmosphere.h"

#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr double Highest = 50.0; // kT/e

/// Sum of w(z) c exp(-z v) over ions.
template <class Weight>
double BoltzmannSum(const std::vector<IonSpecies>& ions, double v, const Weight& weight)
{
  double sum = 0.0;
  for (const IonSpecies& s : ions)
  {
    sum += weight(s.Valence) * s.Concentration * std::exp(-s.Valence * v);
  }
  return sum;
}

void RequireSpecies(const IonSpecies& s)
{
  if (!(s.Concentration >= 0.0 && s.Concentration <= units::LargestConcentration) ||
    !std::isfinite(s.Valence) || !std::isfinite(s.Radius))
  {
    throw std::invalid_argument("An ion has the valence " + FormatNumber(s.Valence) +
      ", the concentration " + FormatNumber(s.Concentration) + " mol/l and the radius " +
      FormatNumber(s.Radius) + ", but concentrations are from 0 to " +
      FormatNumber(units::LargestConcentration) + " mol/l and all three are finite numbers.");
  }
}

}

IonAtmosphere::IonAtmosphere(const std::vector<IonSpecies>& species, double kelvin)
  : Factor(4.0 * Pi * units::CoulombLength(kelvin))
{
  double net = 0.0;
  double total = 0.0;
  for (const IonSpecies& s : species)
  {
    RequireSpecies(s);
    if (s.Concentration > 0.0 && s.Valence != 0.0)
    {
      const double radius = std::max(s.Radius, -1.0);
      auto layer = std::find_if(this->Layers.begin(), this->Layers.end(),
        [&](const Layer& l) { return l.Radius == radius; });
      if (layer == this->Layers.end())
      {
        layer = this->Layers.insert(layer, { radius, {} });
      }
      layer->Ions.push_back({ s.Valence, s.Concentration * units::IonsPerCubicAngstrom, radius });
      net += s.Valence * s.Concentration;
      total += std::abs(s.Valence) * s.Concentration;
    }
  }
  if (std::abs(net) > 1e-6 * total)
  {
    throw std::invalid_argument("The ions of the salt carry " + FormatNumber(net) +
      " mol/l of charge in all, but a solution is neutral: change a concentration.");
  }
}

double IonAtmosphere::Charge(std::size_t layer, double u) const
{
  const double v = std::clamp(u, -Highest, Highest);
  const double sum =
    BoltzmannSum(this->Layers[layer].Ions, v, [](double valence) { return -valence; });
  return this->Factor * sum + (u - v) * (u == v ? 0.0 : this->Derivative(layer, u));
}

double IonAtmosphere::Derivative(std::size_t layer, double u) const
{
  return this->Factor *
    BoltzmannSum(this->Layers[layer].Ions, std::clamp(u, -Highest, Highest),
      [](double valence) { return valence * valence; });
}

double IonAtmosphere::Energy(std::size_t layer, double u) const
{
  double sum = -this->Pressure(layer, u);
  sum -= 0.5 * u *
    BoltzmannSum(this->Layers[layer].Ions, std::clamp(u, -Highest, Highest),
      [](double valence) { return valence; });
  return sum;
}

double IonAtmosphere::Pressure(std::size_t layer, double u) const
{
  const auto all = [](double) { return 1.0; };
  const auto& ions = this->Layers[layer].Ions;
  return BoltzmannSum(ions, std::clamp(u, -Highest, Highest), all) - BoltzmannSum(ions, 0.0, all);
}

double IonAtmosphere::LinearPressure(std::size_t layer, double u) const
{
  return 0.5 * this->Derivative(layer, 0.0) / this->Factor * u * u;
}

double IonAtmosphere::Charge(double u) const
{
  return this->Sum([&](std::size_t l) { return this->Charge(l, u); });
}

double IonAtmosphere::Derivative(double u) const
{
  return this->Sum([&](std::size_t l) { return this->Derivative(l, u); });
}

double IonAtmosphere::Energy(double u) const
{
  return this->Sum([&](std::size_t l) { return this->Energy(l, u); });
}

}
