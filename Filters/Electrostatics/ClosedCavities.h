/**
 * @file ClosedCavities.h
 * @brief The cavities inside the surface that are cut off from the solvent: their crossings, and
 * the correction that makes the net flux through the wall of each one 0.
 *
 * The potential of a cavity that is cut off from the solvent depends on one sum: no more flows in
 * through its wall than its ions take up. The equations of its nodes say so together, with the
 * fluxes F+ of the outside function across the wall's edges; a fit keeps these to its truncation
 * times eps_s only. The inside function's fluxes F- across the same edges,
 *
 *     F+ = eps_s (v_in - u_out),   F- = eps_m (u_in - v_out)   (v: continued across the surface),
 *
 * differ from them edge by edge, but by the divergence theorem not in their sum over a closed wall:
 * eps d_n phi goes through the surface, and either function's flux through it is that through the
 * edges. F- is truncated eps_s / eps_m times less, and is what the equations inside count with, so
 * nothing is lost between the two. Each row gets its share of the difference,
 *
 *     row_p += (edges of p through the wall / all of them) sum over the wall (F+ - F-),
 *
 * which leaves to the fits how the flux is spread. For ghost-fluid values F+ = F-.
 */
#ifndef isthmus_ClosedCavities_h
#define isthmus_ClosedCavities_h

#include "Electrostatics/InterfaceExtrapolation.h"
#include "Electrostatics/InterfaceGeometry.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

namespace isthmus
{

/**
 * The crossings of each closed cavity: no path over nodes outside, along edges and diagonals of the
 * grid's faces, leads from there to the border of the box (which is outside). Parts that touch only
 * across diagonals are joined by a neck thinner than the spacing, as finer grids show. Both orders
 * are those of the crossings. O(nodes), by runs of nodes along x: about 40 bytes a run, at most.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<std::vector<std::int64_t>> WallsOfClosedCavities(
  const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings);

/// Of one cavity: a sum over nodes, Value . u - RightSide, that its rows get shares of.
struct CavityFlux
{
  std::vector<std::int64_t> Column; ///< nodes, in increasing order
  std::vector<double> Value;
  double RightSide = 0.0;
  std::vector<std::int64_t> Row; ///< of the irregular rows
  std::vector<double> Share;     ///< of each, before the row is scaled; 1 together
};

/**
 * For each closed cavity of `problem.Cavities`, in their order; `nodes` are those of the irregular
 * rows. Row and sum are times h^2, as InterfaceMatrixRows.h has it. O(crossings of closed
 * cavities).
 */
std::vector<CavityFlux> CavityFluxes(const InterfaceProblem& problem,
  const std::vector<InterfaceExtrapolation>& values, const std::vector<std::int64_t>& nodes);

}

#endif
