/**
 * @file BoundaryForces.h
 * @brief What field and ions do to the atoms through the surface that these carry.
 *
 * The energy is stationary in the potential, so that its derivative by the surface's place is that
 * at a fixed field (the sharp form of W. Im, D. Beglov and B. Roux, Comput. Phys. Commun. 111
 * (1998) 59, whose surface is smeared). A point that moves outwards by dn changes it by (pull dn
 * dA), with
 *
 *   pull = kT / (8 pi C) [ (1 / eps_m - 1 / eps_s) (eps_s d_n phi)^2
 *                          + (eps_s - eps_m) |grad_t phi|^2 ]
 *
 * phi in kT/e just outside: the field draws the solvent towards the charges. The ions' border moves
 * along, and their osmotic pressure above the bulk's, sum c (exp(-z phi) - 1), or sum c z^2 phi^2 /
 * 2 of the linear equation, is the pull there. Which atom carries what: SurfaceMotion.h.
 */
#ifndef isthmus_BoundaryForces_h
#define isthmus_BoundaryForces_h

#include "Electrostatics/PotentialOnBox.h"
#include "Electrostatics/SurfaceMotion.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/// The pull at each crossing of the solution's surface with the grid, kcal/mol/angstrom^3; 0 where
/// no field could be fitted. O(crossings), parallel.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<double> PullAtCrossings(
  const PotentialOnBox& solution, double kelvin);

/// On each atom, kT/angstrom, along the grid's axes.
struct BoundaryForces
{
  std::vector<Point3> Dielectric, Ionic;
};

/**
 * Of a solved problem. The integral over the surface is the sum over crossings of the grid's edges
 * along each axis, |n_axis| times the area between edges for each; ions at a distance from the
 * surface are summed over the nodes at their border. O(crossings times atoms near + nodes); the
 * same bits on any number of threads.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT BoundaryForces ForcesOnBoundary(
  const PotentialOnBox& solution, const SurfaceMotion& motion);

}

#endif
