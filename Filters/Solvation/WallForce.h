/**
 * @file WallForce.h
 * @brief The force of the field and the ions on the wall of a channel.
 *
 * V_2 of the thesis (4.28) without pressure and dispersion, and with the jump instead of its
 * smeared permittivity. When a wall moves towards the atoms by dn, the energy decreases by (pull dn
 * dA),
 *
 *   pull = kT / (8 pi C) [ (1 / eps_m - 1 / eps_s) (eps d_n phi)^2 + (eps_s - eps_m) |grad_t phi|^2
 * ]
 *        + kT N sum_k (c_k - c0_k),
 *
 * phi in kT/e, c_k at the wall and c0_k of the baths (between them linear along the membrane's
 * thickness), mol/l, N ions in a cubic angstrom at 1 mol/l. The last term is the osmotic pressure
 * of the ions, which equals that of 4.28 if the generalised potential mu_k is 0, i.e. in local
 * equilibrium. 4.28 adds sum rho_k mu_k, which out of equilibrium depends on the reference of phi;
 * a change of the reference has no effect on walls, so this term is omitted.
 *
 * The field is that of a quadratic on both sides of the wall (InterfaceJumpConditions.h), fitted to
 * the potential of PoissonNernstPlanck.h, mostly at nodes in the water. Positive values move the
 * wall towards the atoms.
 */
#ifndef isthmus_WallForce_h
#define isthmus_WallForce_h

#include "Electrostatics/InterfaceGeometry.h"
#include "Solvation/PoissonNernstPlanck.h"

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
 * nodes more on each side. Crossings at the border of the domain, and those where no field can be
 * fitted, are dropped. O(crossings), parallel.
 */
WallValues ForceAtWall(const PoissonNernstPlanck& solution, const LevelFunction& level,
  const SolverBox& box, std::int64_t margin);

}

#endif
