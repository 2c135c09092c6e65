#include "Solvation/IonTransportParameters.h"

#include "Core/PrintableText.h"
#include "Core/RangeChecks.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <cmath>
#include <set>
#include <stdexcept>

namespace isthmus
{
namespace
{

void CheckSpecies(const TransportSpecies& s)
{
  const std::string of = " of " + s.Name;
  const double most = 10.0;
  const double molar = units::LargestConcentration;
  RequireRange(
    ("The valence" + of).c_str(), s.Valence, -most, most, "It is the charge of the ion in e.");
  if (s.Valence == 0.0)
  {
    throw std::invalid_argument(
      "The valence" + of + " is 0, but neutral species carry no current: remove this one.");
  }
  const char* unit = "It is in mol/l.";
  RequireRange(("The concentration below" + of).c_str(), s.Below, 0.0, molar, unit);
  RequireRange(("The concentration above" + of).c_str(), s.Above, 0.0, molar, unit);
  RequireAbove(("The diffusion coefficient" + of).c_str(), s.Diffusion, 0.0, 1e3,
    "It is in 1e-9 m^2/s, e.g. 1.96 for potassium.");
  RequireAbove(("The channel fraction" + of).c_str(), s.ChannelFraction, 0.0, most,
    "It is the fraction of the diffusion coefficient that applies in the channel.");
}

void CheckNeutral(
  const std::vector<TransportSpecies>& all, double TransportSpecies::*bath, const char* where)
{
  constexpr double rounding = 1e-9;
  double charge = 0.0;
  double ions = 0.0;
  for (const TransportSpecies& s : all)
  {
    charge += s.Valence * s.*bath;
    ions += std::abs(s.Valence) * s.*bath;
  }
  if (std::abs(charge) > rounding * ions)
  {
    throw std::invalid_argument(std::string("The bath ") + where + " has " + FormatNumber(charge) +
      " mol/l of charge, but a bath is neutral: make the sum of valence times concentration 0 "
      "there.");
  }
}

}

void Check(const IonTransportParameters& p)
{
  if (p.Species.empty())
  {
    throw std::invalid_argument("There are no ions: add at least one species, e.g. K and Cl.");
  }
  for (const TransportSpecies& s : p.Species)
  {
    CheckSpecies(s);
  }
  CheckNeutral(p.Species, &TransportSpecies::Below, "below");
  CheckNeutral(p.Species, &TransportSpecies::Above, "above");
  const double length = std::hypot(p.MembraneNormal[0], p.MembraneNormal[1], p.MembraneNormal[2]);
  if (!(length >= SmallestLength && length <= LargestLength))
  {
    throw std::invalid_argument(
      "The normal of the membrane has no direction: set a vector along the axis of the channel.");
  }
  for (const double x : p.MembraneCenter)
  {
    RequireRange("MembraneCenter", x, -1e6, 1e6, "It is a position in angstrom.");
  }
  RequireAbove("MembraneThickness", p.MembraneThickness, 0.0, 1e3,
    "It is in angstrom; a bilayer has 24 to 40.");
  RequireRange("LumenRadius", p.LumenRadius, 0.0, 1e3, "It is in angstrom.");
  RequireRange("Voltage", p.Voltage, -1000.0, 1000.0, "It is in mV.");
  RequireRange("ProbeRadius", p.ProbeRadius, 0.0, 10.0, "It is in angstrom.");
  RequireAbove("Spacing", p.Spacing, 0.0, 10.0, "It is in angstrom.");
  RequireRange(
    "Padding", p.Padding, 2.0 * p.Spacing, 1e3, "It is in angstrom, two spacings or more.");
  RequireRange("SoluteDielectric", p.SoluteDielectric, 1.0, 1000.0);
  RequireRange("SolventDielectric", p.SolventDielectric, 1.0, 1000.0);
  RequireRange("Temperature", p.Temperature, units::LowestTemperature, units::HighestTemperature,
    "It is in kelvin.");
  RequireRange("Tolerance", p.Tolerance, 1e-10, 1.0, "It is a change of the potential in kT/e.");
  RequireRange("MaximumIterations", p.MaximumIterations, 1.0, 1e6);
}

void NameSpecies(const std::string& names, std::vector<TransportSpecies>& species)
{
  const char* const between = " ,;\t\n";
  const std::string text = Printable(names);
  std::size_t at = 0;
  std::size_t number = 0;
  std::set<std::string> taken;
  for (TransportSpecies& s : species)
  {
    at = text.find_first_not_of(between, at);
    const std::size_t end = text.find_first_of(between, at);
    s.Name = at == std::string::npos ? "Ion" + std::to_string(++number) : text.substr(at, end - at);
    number += at == std::string::npos ? 0 : 1;
    at = at == std::string::npos ? at : end;
    if (!taken.insert(s.Name).second)
    {
      throw std::invalid_argument(
        "Two species are called " + s.Name + ": give each a name of its own in SpeciesNames.");
    }
  }
}

}
