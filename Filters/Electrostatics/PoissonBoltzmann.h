/**
 * @file PoissonBoltzmann.h
 * @brief The electrostatic potential of charges in a solute in salt water, second order at its
 * surface.
 *
 * Linear or nonlinear Poisson-Boltzmann equation with two dielectric constants that jump at a level
 * set; formulation in GridPotential.h, the surface in InterfaceJumpConditions.h, the solver in
 * InterfaceSolver.h. Units: angstrom, e, kT/e, mol/l.
 *
 * The volume that holds the level set may end close to it: the equation is solved on a box with at
 * least `Padding` of solvent, and the answer is for the caller to crop.
 *
 * **Border** (SelfConsistent): charges' Debye-Hueckel sum first; the equation is solved on a grid
 * of twice the spacing (the same one, where that is beyond 1.1 angstrom); what that solution is on
 * a box between surface and border is continued outwards by Green's third identity; the same once
 * more; then the grid proper. With the sum alone the potential of a dipole in a cavity is off by
 * 0.15 kT/e at 12 angstrom. Cost: for border nodes and patches both by sums of (nodes)^(2/3), by a
 * tree where there are thousands.
 */
#ifndef isthmus_PoissonBoltzmann_h
#define isthmus_PoissonBoltzmann_h

#include "Electrostatics/GridPotential.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// Throws std::invalid_argument, with the property, for parameters out of their range.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT void CheckParameters(
  const PoissonBoltzmannParameters& parameters);

/**
 * The nodes of the volume and as many around as give `padding` between surface and border.
 * Throws std::invalid_argument where the level set is empty or leaves the volume.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT SolverBox BoxAround(
  const LevelFunction& level, double padding);

/// Every `stride`-th node of `box`, and as many more at the upper end as reach its border.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT SolverBox CoarserBox(
  const SolverBox& box, std::int64_t stride);

/**
 * Solves on `box`. Atoms are in the frame of the volume and inside the level; it refers to what it
 * is passed as long as the answer lives.
 *
 * Throws std::invalid_argument for bad input, std::runtime_error where an iteration does not
 * converge, Cancelled. Time: linear in nodes and crossings, and in atoms x crossings below 5000
 * atoms (by a tree above); memory 80 to 104 bytes a node.
 * Bitwise the same on any number of threads.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::unique_ptr<GridPotential> SolvePoissonBoltzmann(
  const LevelFunction& level, const SolverBox& box, const std::vector<ChargedAtom>& atoms,
  const PoissonBoltzmannParameters& parameters, const IonAtmosphere& ions,
  const ProgressCallback& progress = {});

/// Solves for a surface that has moved since `last`, everything else being as it is there, its
/// border values included: from its potential, until the residual is as small as it became there,
/// with the charges summed again only where the surface did move. `last` is not referred to; after
/// its Release() it is small. Throws, time and threads: as above.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::unique_ptr<GridPotential> SolveAgain(
  const LevelFunction& level, const GridPotential& last, const ProgressCallback& progress = {});

}

#endif
