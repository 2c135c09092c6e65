/**
 * @file SolvationFlow.h
 * @brief The equilibrium surface of a molecule under tension, pressure, dispersion and its own
 * field.
 *
 * The coupled Laplace-Beltrami and Poisson-Boltzmann equations (thesis 2.3; Z. Chen, N. A. Baker,
 * G. W. Wei, J. Comput. Phys. 229 (2010) 8231) in sharp form: the surface flows (SurfaceFlow.h) by
 *
 *   phi_t = |grad phi| div(grad phi / |grad phi|) - (V / gamma) |grad phi|,
 *   -V = p - rho_0 U + pull of the field (CoupledFlow.h),
 *
 * for a period of steps with the pull fixed; then the Poisson-Boltzmann equation is solved with the
 * surface where it is (PoissonBoltzmann.h: dielectrics jump, nothing is smeared), the pull is
 * computed again, and so on until the whole energy
 *
 *   G = gamma Area + p Volume + rho_0 int_solvent U + G_polar
 *
 * changes by less than EnergyTolerance twice in a row. With Potential.DielectricModel
 * SmoothDielectric (one permittivity for each edge, InterfaceExtrapolation.h) the iteration is that
 * of the thesis, and the energy of the last surface is computed again with the jump, which adds one
 * row to the updates.
 *
 * **Obstacle.** The surface stays outside of the solvent-excluded volume of the atoms (ProbeRadius;
 * SolventExcludedSurface.h): there is no solvent where the probe does not fit. With ProbeRadius 0,
 * it stays outside of the atoms.
 */
#ifndef isthmus_SolvationFlow_h
#define isthmus_SolvationFlow_h

#include "Core/Progress.h"
#include "Electrostatics/PoissonBoltzmann.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "Solvation/CoupledFlow.h"
#include "Solvation/SolvationParameters.h"

#include <memory>

namespace isthmus
{

/// The atoms: balls that the surface encloses, their dispersion parameters and charges.
struct SolvationAtoms
{
  std::vector<Ball> Balls;                ///< angstrom
  std::vector<DispersionAtom> Dispersion; ///< one for each ball
  std::vector<ChargedAtom> Charges;       ///< in the frame of the balls; each within one of them
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
  double OnObstacle = 0.0; ///< the fraction of the surface on its obstacle

  double Nonpolar() const
  {
    return this->SurfaceEnergy + this->VolumeEnergy + this->DispersionEnergy;
  }
  double Total() const { return this->Nonpolar() + this->PolarEnergy; }
};

/// kcal/mol.
struct SolvationErrors
{
  double Polar = 0.0, Total = 0.0;
};

/// Cost: a Poisson-Boltzmann solution for each of 3 to 20 updates, the first with its border
/// values, later ones recomputed only where the surface has moved (SolveAgain()); between them
/// UpdatePeriod steps of O(band nodes). Memory: that of the solution (120 bytes for each node,
/// including the potential and the crossings of the last surface) and of the flow. The result is
/// bitwise the same on any number of threads.
class SolvationFlow
{
public:
  /// @throws std::invalid_argument for lists of different lengths, parameters out of range, charges
  /// outside of all balls, and std::runtime_error for grids that do not fit into memory.
  SolvationFlow(SolvationAtoms atoms, const SolvationParameters& parameters);
  ~SolvationFlow();
  SolvationFlow(const SolvationFlow&) = delete;
  void operator=(const SolvationFlow&) = delete;

  /// Runs until convergence or MaximumUpdates.
  /// @throws the exceptions of SolvePoissonBoltzmann, and Cancelled.
  void Run(const ProgressCallback& progress = {});

  /**
   * Estimates of the discretisation errors of the energies of the last update: that of the polar
   * energy from coarser grids for the last surface (EstimateEnergyError()); that of the total
   * energy also from a whole flow with 1.5 times the spacing, or a tenth of the energy if that is
   * too coarse for the atoms. Cost: a third of Run(). @throws Cancelled.
   */
  SolvationErrors EstimateErrors(const ProgressCallback& progress = {}) const;

  /// Whether the energy has converged; if not, the last surface is kept.
  bool HasConverged() const { return this->Converged; }
  double GetTemperature() const { return this->Equation.Temperature; } ///< kelvin
  const SurfaceFlowResult& GetSurface() const { return this->Surface; }
  const LevelFunction& GetLevel() const { return this->Level; }
  const GridPotential& GetSolution() const { return *this->Solution; }
  const std::vector<SolvationUpdate>& GetUpdates() const { return this->Updates; }

private:
  FlowField StartingField(const ProgressCallback& progress) const;
  void Solve(const FlowField& field, const ProgressCallback& progress);
  double Dispersion(const SolventParameters& solvent) const;
  void Record(const FlowField& field);
  void Pull(FlowField& field);
  bool IsStill() const;

  const SolvationAtoms Atoms;
  const SolvationParameters Parameters;
  const IonAtmosphere Ions;
  PoissonBoltzmannParameters Equation;
  std::vector<ChargedAtom> Placed; ///< charges in the frame of the grid
  std::vector<float> Steady;       ///< the constant part of the pull, in spacings
  std::vector<float> LastDistance; ///< of the surface before
  double Time = 0.0;
  bool Converged = false;
  LevelFunction Level;
  SurfaceFlowResult Surface;
  std::unique_ptr<GridPotential> Solution;
  std::vector<SolvationUpdate> Updates;
};

}

#endif
