/**
 * @file StuffingAngles.h
 * @brief Sees to it that no tetrahedron of isosurface stuffing breaks the bounds on angles.
 */
#ifndef isthmus_StuffingAngles_h
#define isthmus_StuffingAngles_h

#include "Tetrahedra/StuffingBackground.h"
#include "Tetrahedra/StuffingStencils.h"

namespace isthmus
{

/**
 * Measures every tetrahedron near the surface, on both sides. Where one would have an angle out of
 * bounds, or all four corners on the surface (the surface turns within a cell), the corner that is
 * moved farthest stays where it was, until none is left. This ends, since tetrahedra none of
 * whose corners are moved are well within the bounds.
 */
void KeepAngles(
  const StuffingLattice& lattice, StuffingWarp& warp, const ProgressCallback& progress);

}

#endif
