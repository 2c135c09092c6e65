/**
 * @file ClosedCavities.h
 * @brief The cavities inside the surface that are cut off from the solvent, by their crossings.
 */
#ifndef isthmus_ClosedCavities_h
#define isthmus_ClosedCavities_h

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

}

#endif
