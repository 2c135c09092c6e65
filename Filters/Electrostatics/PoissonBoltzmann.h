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
 * least `Padding` of solvent, and the caller has to crop the solution.
 *
 * **Border values** (SelfConsistent) start as the Debye-Hueckel sum of the charges. The equation is
 * solved on a grid of twice the spacing (or the same spacing, if twice is more than 1.1 angstrom),
 * and the solution on a box between surface and border is continued outwards by Green's third
 * identity. This is done twice, and then the equation is solved on the final grid. The sum alone
 * does not account for the dielectric cavity. Cost: border nodes and patches both number about
 * (nodes)^(2/3); the sums use a tree if there are thousands.
 */
#ifndef isthmus_PoissonBoltzmann_h
#define isthmus_PoissonBoltzmann_h

#include "Electrostatics/GridPotential.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/**
 * The nodes of the volume, and enough nodes around it for `padding` between surface and border.
 * Throws std::invalid_argument if the level set is empty or leaves the volume.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT SolverBox BoxAround(
  const LevelFunction& level, double padding);

/// Every `stride`-th node of `box`, and enough nodes at the upper end to reach its border.
SolverBox CoarserBox(const SolverBox& box, std::int64_t stride);

/**
 * Solves on `box`. Atoms are in the frame of the volume and inside the level. The solution refers
 * to the arguments as long as it exists.
 *
 * Throws std::invalid_argument for bad input, std::runtime_error if an iteration does not converge,
 * and Cancelled. Time: linear in nodes and crossings, and in atoms x crossings below 5000 atoms (a
 * tree is used for more); memory: 80 to 104 bytes for each node. Bitwise the same on any number of
 * threads.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::unique_ptr<GridPotential> SolvePoissonBoltzmann(
  const LevelFunction& level, const SolverBox& box, const std::vector<ChargedAtom>& atoms,
  const PoissonBoltzmannParameters& parameters, const IonAtmosphere& ions,
  const ProgressCallback& progress = {});

/**
 * An estimate of the error of the solvation energy of `solution`, kT: what follows from the
 * resolution of the grid, not from the equation or from the surface given.
 *
 * The equation is solved on two grids of twice the spacing, whose nodes lie differently to the
 * surface, with the border values of `solution`. Errors of the scheme are of second order, but
 * their sign depends on where the surface lies between the nodes, so that the difference, which
 * would be three times the error of a regular second order, is taken nearly whole: it covers the
 * error in more than nine of ten cases (guide, How far to trust it). Errors that all grids share
 * are in proportion to the energy, or to that of the charges' own field beyond the surface if this
 * is larger, as where the dielectrics are alike and the energy vanishes. A tenth of these if no
 * coarser grid can be solved, because it does not resolve the surface, and the grid of the solution
 * hardly does. With the condition Zero, what the potential at the border would add is included.
 *
 * Cost: a quarter of a solution. Exceptions: Cancelled.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT double EstimateEnergyError(
  const LevelFunction& level, const GridPotential& solution, const ProgressCallback& progress = {});

/// What is added to it where the surface is the edge of a mask, whose place is unknown between two
/// nodes: the energy of a sphere with the same ratio of area to volume changes by this much if its
/// radius changes by a quarter of the spacing, kT. O(nodes).
double EstimateMaskError(const LevelFunction& level, const GridPotential& solution);

/// Solves for a surface that has moved since `last`; everything else, including the border values,
/// is the same. The iteration starts from the potential of `last` and ends when the residual is as
/// small as it was there; charges are summed again only where the surface has moved. The solution
/// does not refer to `last`, which needs little memory after its Release(). Exceptions, time and
/// threads are as above.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::unique_ptr<GridPotential> SolveAgain(
  const LevelFunction& level, const GridPotential& last, const ProgressCallback& progress = {});

}

#endif
