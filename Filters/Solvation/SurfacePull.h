/**
 * @file SurfacePull.h
 * @brief The pull of an electric field at a surface between two dielectrics, off the surface.
 *
 * The pull (BoundaryForces.h: the derivative of the electrostatic energy by the surface's place;
 * thesis 4.18 with the jump in place of its smeared permittivity) is an energy for each volume,
 * never negative: the field draws the solvent towards the charges, and only an obstacle ends that.
 * Ions' osmotic pressure is left out: it is smaller by kappa^2 times a squared length of the
 * surface.
 */
#ifndef isthmus_SurfacePull_h
#define isthmus_SurfacePull_h

#include "Electrostatics/BoundaryForces.h"
#include "MolecularSurfaces/FlowField.h"
#include "vtkIsthmusFiltersSolvationModule.h"

#include <vector>

namespace isthmus
{

/**
 * Values of the crossings at the nodes of a flow's grid: nodes of an edge that is crossed have the
 * mean of their crossings, those farther out that of their neighbours which have one, layer by
 * layer, so that values are carried off the surface to both sides. The level's volume is the grid
 * without its margin. O(nodes), serial; 5 bytes a node.
 */
VTKISTHMUSFILTERSSOLVATION_EXPORT std::vector<float> CarriedOff(const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const std::vector<double>& values,
  const FlowGrid& grid);

}

#endif
