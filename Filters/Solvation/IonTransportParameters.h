/**
 * @file IonTransportParameters.h
 * @brief Parameters of steady ion transport, and the report of its iteration.
 */
#ifndef isthmus_IonTransportParameters_h
#define isthmus_IonTransportParameters_h

#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "vtkIsthmusFiltersSolvationModule.h"

#include <algorithm>
#include <string>
#include <vector>

namespace isthmus
{

/// One kind of ion, and its concentrations in the two baths.
struct TransportSpecies
{
  std::string Name;
  double Valence = 1.0;
  double Below = 0.1;           ///< mol/l in the bath behind the membrane, against its normal
  double Above = 0.1;           ///< mol/l in the bath that the normal points to
  double Diffusion = 1.96;      ///< 1e-9 m^2/s, in the baths
  double ChannelFraction = 1.0; ///< the fraction of it that applies within the membrane's slab
};

/// A flat membrane, closed except for a round hole around the channel.
struct MembraneSlab
{
  Point3 MembraneCenter{ 0.0, 0.0, 0.0 }; ///< on the channel's axis, angstrom
  Point3 MembraneNormal{ 0.0, 0.0, 1.0 }; ///< along that axis, from Below to Above; any length
  double MembraneThickness = 24.0;        ///< angstrom
  double LumenRadius = 5.0;               ///< of the hole around the axis

  /// A quantity that decreases linearly across the membrane, from 1 in the bath below to 0 in the
  /// bath above.
  double PartBelow(double along) const
  {
    return std::clamp(0.5 - along / this->MembraneThickness, 0.0, 1.0);
  }
};

struct IonTransportParameters : MembraneSlab
{
  /// By default potassium and chloride.
  std::vector<TransportSpecies> Species{ { "K", 1.0, 0.1, 0.1, 1.96, 1.0 },
    { "Cl", -1.0, 0.1, 0.1, 2.03, 1.0 } };
  double Voltage = 100.0; ///< mV: potential Below less that Above; drives cations along the normal
  double ProbeRadius = 1.0; ///< of the solvent-excluded surface, angstrom; 0: the atoms themselves
  double Spacing = 0.5;     ///< angstrom
  double Padding = 8.0;     ///< of the baths beyond the membrane and the atoms, angstrom
  double SoluteDielectric = 2.0; ///< of the atoms and the membrane
  double SolventDielectric = 80.0;
  double Temperature = 298.15; ///< kelvin
  double Tolerance = 1e-4;     ///< largest change of the potential in water, kT/e
  int MaximumIterations = 100; ///< of Gummel's
};

struct IonTransportReport
{
  bool Converged = false;
  int Iterations = 0;          ///< of Gummel's
  int LinearIterations = 0;    ///< of conjugate gradients, all systems together
  std::vector<double> Changes; ///< of the potential in water, kT/e, by iteration
  double Imbalance =
    0.0; ///< the fraction of a species' current that is not conserved; the largest one
};

/// @throws std::invalid_argument for values out of their range, a membrane
/// without a normal, species without a valence, and baths that carry a charge.
VTKISTHMUSFILTERSSOLVATION_EXPORT void Check(const IonTransportParameters& parameters);

/// Names each species from a list separated by blanks, commas or semicolons, or `Ion` and its
/// number.
/// @throws std::invalid_argument if two species have the same name.
VTKISTHMUSFILTERSSOLVATION_EXPORT void NameSpecies(
  const std::string& names, std::vector<TransportSpecies>& species);

}

#endif
