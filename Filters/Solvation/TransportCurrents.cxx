#include "Solvation/TransportCurrents.h"

#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

/// Ions per nanosecond in a flux of 1 angstrom mol/l 1e-9 m^2/s.
constexpr double IonsPerFlux = 100.0 * units::IonsPerCubicAngstrom; // 1e-9 m^2/s = 100 A^2/ns

}

double PicoamperePerIon()
{
  return 1e21 * units::ElementaryCharge;
}

double CurrentProfile::Mean(std::size_t species) const
{
  const std::vector<double>& all = this->Currents[species];
  return all.empty()
    ? 0.0
    : std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

double CurrentProfile::Mean() const
{
  double total = 0.0;
  for (std::size_t k = 0; k < this->Currents.size(); ++k)
  {
    total += this->Mean(k);
  }
  return total;
}

double CurrentProfile::Spread() const
{
  double sizes = 0.0;
  for (std::size_t k = 0; k < this->Currents.size(); ++k)
  {
    sizes += std::abs(this->Mean(k));
  }
  const double mean = this->Mean();
  double largest = 0.0;
  for (std::size_t section = 0; section < this->Along.size(); ++section)
  {
    double whole = 0.0;
    for (const std::vector<double>& of : this->Currents)
    {
      whole += of[section];
    }
    largest = std::max(largest, std::abs(whole - mean));
  }
  return sizes > 0.0 ? largest / sizes : 0.0;
}

CurrentProfile ComputeCurrents(const PoissonNernstPlanck& solution)
{
  const TransportGrid& grid = solution.GetGrid();
  const TransportDomain& d = grid.Domain;
  const std::array<std::int64_t, 3> steps = d.Steps();
  const std::vector<TransportSpecies>& species = solution.GetParameters().Species;
  CurrentProfile profile;
  const auto sections = static_cast<std::int64_t>(std::llround(2.0 * d.HalfLength / d.Spacing));
  for (std::int64_t i = 0; i < sections; ++i)
  {
    profile.Along.push_back(-d.HalfLength + d.Spacing * (static_cast<double>(i) + 0.5));
  }
  profile.Currents.assign(
    species.size(), std::vector<double>(static_cast<std::size_t>(sections), 0.0));
  // The first section behind a place along the axis.
  const auto behind = [&](std::int64_t node)
  {
    const auto along = static_cast<double>(grid.Along[static_cast<std::size_t>(node)]);
    const double at = std::ceil((along + d.HalfLength) / d.Spacing - 0.5);
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(at), 0, sections);
  };
  for (std::size_t k = 0; k < species.size(); ++k)
  {
    const double unit = species[k].Valence * IonsPerFlux * PicoamperePerIon();
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::int64_t node = 0; node < d.Size(); ++node)
      {
        const std::int64_t here =
          grid.Aperture[a][static_cast<std::size_t>(node)] > 0.0F ? behind(node) : 0;
        const std::int64_t there =
          grid.Aperture[a][static_cast<std::size_t>(node)] > 0.0F ? behind(node + steps[a]) : 0;
        const double current =
          here == there ? 0.0 : unit * solution.EdgeFlux(SpeciesId(k), a, node);
        for (std::int64_t i = std::min(here, there); i < std::max(here, there); ++i)
        {
          profile.Currents[k][static_cast<std::size_t>(i)] += here < there ? current : -current;
        }
      }
    }
  }
  return profile;
}

Point3 FluxAt(const PoissonNernstPlanck& solution, SpeciesId species, std::int64_t node)
{
  const TransportDomain& d = solution.GetGrid().Domain;
  const std::array<std::int64_t, 3> steps = d.Steps();
  const std::array<std::int64_t, 3> at = d.Indices(node);
  Point3 flux{ 0.0, 0.0, 0.0 };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double behind = at[a] + 1 < d.Dimensions[a] ? solution.EdgeFlux(species, a, node) : 0.0;
    const double before = at[a] > 0 ? solution.EdgeFlux(species, a, node - steps[a]) : 0.0;
    flux[a] = 0.5 * IonsPerFlux * (behind + before) / (d.Spacing * d.Spacing);
  }
  return d.Turned(flux);
}

}
