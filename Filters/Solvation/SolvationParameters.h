/**
 * @file SolvationParameters.h
 * @brief Parameters of surfaces that move with an electric field, with their defaults.
 */
#ifndef isthmus_SolvationParameters_h
#define isthmus_SolvationParameters_h

#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "MolecularSurfaces/MolecularSurfaceParameters.h"
#include "vtkIsthmusFiltersSolvationModule.h"

namespace isthmus
{

/// How surface and field alternate.
struct UpdatePolicy
{
  int UpdatePeriod = 50;          ///< steps of the flow between solutions
  bool AdaptiveUpdate = true;     ///< end a period as soon as the volume has converged
  double SurfaceRelaxation = 1.0; ///< alpha: the fraction of each period's motion that is used
  double FieldRelaxation = 1.0;   ///< alpha': the fraction of each new field's force
  int MaximumUpdates = 20;
};

/// @throws std::invalid_argument with property, value and range; so do the other functions of this
/// name.
VTKISTHMUSFILTERSSOLVATION_EXPORT void Check(const UpdatePolicy& policy);

/// Of SolvationFlow.h.
struct SolvationParameters
{
  SolvationParameters() { this->Flow.ProbeRadius = 1.4; }

  SurfaceFlowParameters Flow;           ///< EvolutionTime, Steady and CoarseToFine are not used
  SolventParameters Solvent;            ///< tension, pressure, dispersion
  PoissonBoltzmannParameters Potential; ///< Spacing, Boundary and Start are not used
  UpdatePolicy Policy;
  double EnergyTolerance = 1e-3; ///< relative change of the energy, twice in a row
};

VTKISTHMUSFILTERSSOLVATION_EXPORT void Check(const SolvationParameters& parameters);

/// Of MovingChannel.h.
struct MovingChannelParameters
{
  MovingChannelParameters()
  {
    this->Policy.UpdatePeriod = 20;
    this->Policy.MaximumUpdates = 10;
  }

  SolventParameters Solvent; ///< tension, pressure, dispersion
  UpdatePolicy Policy;
  double UpdateTolerance = 1e-3; ///< relative change of currents and hole's water, twice in a row
};

VTKISTHMUSFILTERSSOLVATION_EXPORT void Check(const MovingChannelParameters& parameters);

}

#endif
