/**
 * @file SolvationParameters.h
 * @brief What a solvation surface is asked for, and what it tells of its way to rest.
 */
#ifndef isthmus_SolvationParameters_h
#define isthmus_SolvationParameters_h

#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "Solvation/SurfacePeriod.h"

namespace isthmus
{

/// A charged ball: what the surface goes around, what is attracted, what makes the field.
struct SolvationAtoms
{
  std::vector<Ball> Balls;                ///< angstrom
  std::vector<DispersionAtom> Dispersion; ///< one for each ball
  std::vector<ChargedAtom> Charges;       ///< in the frame of the balls; each within one of them
};

struct SolvationParameters
{
  SurfaceFlowParameters Flow;           ///< EvolutionTime, Steady and CoarseToFine are not used
  SolventParameters Solvent;            ///< tension, pressure, dispersion
  PoissonBoltzmannParameters Potential; ///< Boundary and Start are not used
  UpdatePolicy Policy;                  ///< its Tolerance is the total energy's
};

/// After each solution. Energies in kcal/mol.
struct SolvationUpdate
{
  double Time = 0.0;   ///< of the flow, square angstrom
  double Area = 0.0;   ///< square angstrom
  double Volume = 0.0; ///< cubic angstrom
  double SurfaceEnergy = 0.0;
  double VolumeEnergy = 0.0;
  double DispersionEnergy = 0.0;
  double PolarEnergy = 0.0;
  double OnObstacle = 0.0; ///< the part of the surface that rests on its obstacle, 0 to 1

  double Nonpolar() const
  {
    return this->SurfaceEnergy + this->VolumeEnergy + this->DispersionEnergy;
  }
  double Total() const { return this->Nonpolar() + this->PolarEnergy; }
};

}

#endif
