/**
 * @file ClosedCavities.h
 * @brief The cavities inside the surface that are cut off from the solvent: their crossings, and
 * the correction that makes the net flux through the wall of each one 0.
 *
 * The potential of a cavity that is cut off from the solvent depends on the flux through its wall.
 * With v the functions continued across the surface, the fluxes of the functions outside and inside
 * across the edges of the wall are
 *
 *     F+ = eps_s (v_in - u_out),   F- = eps_m (u_in - v_out).
 *
 * Their sums over a closed wall are equal, and F- is the more accurate one. Each row gets its share
 * of the difference,
 *
 *     row_p += (edges of p through the wall / all of them) sum over the wall (F+ - F-),
 *
 * so that the fits determine how the flux is distributed. With ghost-fluid values F+ equals F-.
 */
#ifndef isthmus_ClosedCavities_h
#define isthmus_ClosedCavities_h

#include "Electrostatics/InterfaceExtrapolation.h"
#include "Electrostatics/InterfaceGeometry.h"

namespace isthmus
{

/**
 * The crossings of each closed cavity. A cavity is closed if no path over nodes outside, along
 * edges and diagonals of the faces of the grid, leads from it to the border of the box (which is
 * outside). Parts that touch only across diagonals are joined by a neck thinner than the spacing,
 * as finer grids show. Both orders are those of the crossings. O(nodes), by runs of nodes along x,
 * with at most about 40 bytes for each run.
 */
std::vector<std::vector<std::int64_t>> FindCavityWalls(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings);

/// The sum over nodes of one cavity, Value . u - RightSide, of which its rows get shares.
struct CavityFlux
{
  std::vector<std::int64_t> Column; ///< nodes, in increasing order
  std::vector<double> Value;
  double RightSide = 0.0;
  std::vector<std::int64_t> Row; ///< of the irregular rows
  std::vector<double> Share;     ///< of each, before the row is scaled; 1 together
};

/**
 * The sums for the closed cavities of `problem.Cavities`, in their order; `nodes` are those of the
 * irregular rows. Rows and sums are multiplied by h^2, as in InterfaceMatrixRows.h. O(crossings of
 * closed cavities).
 */
std::vector<CavityFlux> CavityFluxes(const InterfaceProblem& problem,
  const std::vector<InterfaceExtrapolation>& values, const std::vector<std::int64_t>& nodes);

}

#endif
