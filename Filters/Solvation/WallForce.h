/**
 * @file WallForce.h
 * @brief The force of field and ions on the wall of a channel.
 *
 * The thesis' V_2 (4.28) less pressure and dispersion, with the jump in place of its smeared
 * permittivity. A wall that moves towards the atoms by dn gains (pull dn dA),
 *
 *   pull = kT / (8 pi C) [ (1 / eps_m - 1 / eps_s) (eps d_n phi)^2 + (eps_s - eps_m) |grad_t phi|^2
 * ]
 *        + kT N sum_k (c_k - c0_k),
 *
 * phi in kT/e, c_k at the wall and c0_k of the baths (between them linear along the membrane's
 * thickness), mol/l, N ions in a cubic angstrom at 1 mol/l. The last term is the ions' osmotic
 * pressure: what 4.28 has where its generalised potential mu_k is 0, that is where each place is in
 * equilibrium with itself. 4.28 adds sum rho_k mu_k, which out of equilibrium depends on where phi
 * is said to be 0; this has no effect on walls, and it is omitted.
 *
 * The field is that of a quadratic on both sides of the wall (InterfaceJumpConditions.h), fitted to
 * nodes in the water for the most part, to the potential of PoissonNernstPlanck.h. Positive: the
 * water gains.
 */
#ifndef isthmus_WallForce_h
#define isthmus_WallForce_h

#include "Electrostatics/InterfaceGeometry.h"
#include "Solvation/PoissonNernstPlanck.h"
#include "vtkIsthmusFiltersSolvationModule.h"

namespace isthmus
{

/// Values at crossings of the wall with the grid's edges.
struct WallValues
{
  std::vector<InterfaceCrossing> Crossings; ///< by nodes of the box
  std::vector<double> Pull;                 ///< kcal/mol/angstrom^3
};

/**
 * `level` are distances in angstrom on the nodes of `box`, which is the domain's grid with `margin`
 * nodes more on each side. Crossings at the domain's border, and those that no field can be fitted
 * to, are dropped. O(crossings), parallel.
 */
VTKISTHMUSFILTERSSOLVATION_EXPORT WallValues ForceAtWall(const PoissonNernstPlanck& solution,
  const LevelFunction& level, const SolverBox& box, std::int64_t margin);

}

#endif
