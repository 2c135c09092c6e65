// A straight line of nodes between two baths: where the Poisson-Nernst-Planck equations have
// analytical solutions.
#ifndef TransportLine_h
#define TransportLine_h

#include "Electrostatics/ElectrostaticUnits.h"
#include "Solvation/PoissonNernstPlanck.h"
#include "Solvation/TransportCurrents.h"

namespace isthmus::testing
{

/// `nodes` of them over `length` angstrom, with water of `permittivity` all along; the first is in
/// the bath below, the last above.
inline TransportGrid TransportLine(std::int64_t nodes, double length, double permittivity = 80.0)
{
  TransportGrid grid;
  TransportDomain& d = grid.Domain;
  d.Dimensions = { 1, 1, nodes };
  d.Spacing = length / static_cast<double>(nodes - 1);
  d.HalfLength = 0.5 * length;
  d.Origin = { 0.0, 0.0, -0.5 * length };
  d.Radius = d.Spacing;
  const auto n = static_cast<std::size_t>(nodes);
  for (std::size_t a = 0; a < 3; ++a)
  {
    grid.Permittivity[a].assign(n, a == 2 ? static_cast<float>(permittivity) : 0.0F);
    grid.Aperture[a].assign(n, a == 2 ? 1.0F : 0.0F);
    grid.Permittivity[a][n - 1] = grid.Aperture[a][n - 1] = 0.0F;
  }
  grid.Distance.assign(n, 1.0F);
  grid.Water.assign(n, 1.0F);
  grid.Baths.assign(n, 0);
  grid.Baths.front() = static_cast<unsigned char>(Bath::Below);
  grid.Baths.back() = static_cast<unsigned char>(Bath::Above);
  grid.Charge.assign(n, 0.0);
  for (std::int64_t i = 0; i < nodes; ++i)
  {
    grid.Along.push_back(static_cast<float>(d.Place(i)[2]));
  }
  return grid;
}

/// pA for an angstrom of length, a square angstrom of section, 1 mol/l and 1e-9 m^2/s.
inline double FaradayUnit()
{
  return 100.0 * units::IonsPerCubicAngstrom * PicoamperePerIon();
}

}

#endif
