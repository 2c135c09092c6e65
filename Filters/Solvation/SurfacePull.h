/**
 * @file SurfacePull.h
 * @brief The pull of an electric field at a surface between two dielectrics.
 *
 * In its sharp form (the derivative of the electrostatic energy by the surface's place; thesis 4.18
 * with the jump in place of its smeared permittivity), with n outward, phi in kT/e just outside and
 * C = e^2 / (4 pi eps0 kT):
 *
 *   pull = kT / (8 pi C) [ (1 / eps_m - 1 / eps_s) (eps_s d_n phi)^2 + (eps_s - eps_m) |grad_t
 * phi|^2 ]
 *
 * an energy for each volume, never negative: the field draws the solvent towards the charges, and
 * only an obstacle ends that. Ions' osmotic pressure is left out: it is smaller by kappa^2 times a
 * squared length of the surface.
 */
#ifndef isthmus_SurfacePull_h
#define isthmus_SurfacePull_h

#include "FlowGrid.h"
#include "LevelFunction.h"
#include "PotentialOnBox.h"
#include "vtkIsthmusModule.h"

#include <vector>

namespace isthmus
{

/// The pull at each crossing of the solution's surface with the grid, kcal/mol/angstrom^3; 0 where
/// no field could be fitted. O(crossings), parallel.
VTKISTHMUS_EXPORT std::vector<double> PullAtCrossings(
  const PotentialOnBox& solution, const LevelFunction& level, double kelvin);

/**
 * Values of the crossings at the nodes of a flow's grid: nodes of an edge that is crossed have the
 * mean of their crossings, those farther out that of their neighbours which have one, layer by
 * layer, so that values are carried off the surface to both sides. The level's volume is the grid
 * without its margin. O(nodes), serial; 5 bytes a node.
 */
VTKISTHMUS_EXPORT std::vector<float> CarriedOff(
  const PotentialOnBox& solution, const std::vector<double>& values, const FlowGrid& grid);

}

#endif
