/**
 * @file StuffingStencils.h
 * @brief What the surface leaves of a tetrahedron of the lattice on each of its sides.
 */
#ifndef isthmus_StuffingStencils_h
#define isthmus_StuffingStencils_h

#include "Tetrahedra/StuffingWarp.h"

#include <vector>

namespace isthmus
{

/// A lattice point (both the same), or the crossing of the surface with the edge between two.
struct StuffingCorner
{
  LatticePoint From;
  LatticePoint To;

  bool IsCrossing() const { return this->From != this->To; }
};

using StuffingPiece = std::array<StuffingCorner, 4>;

/**
 * Appends the tetrahedra of `t` on `side` (1 or -1) to `out`; their orientation is not fixed.
 *
 * Each side of a cut tetrahedron is a tetrahedron, a pyramid or a prism. Quadrilaterals in faces of
 * the lattice are cut by a diagonal that the face alone decides, so that both its tetrahedra agree:
 * to the crossing on the long edge where a long and a short edge are crossed; else from the end of
 * the long edge that lies to an even number of positive sides of the third corner (the paper's
 * parity rule). The quadrilateral on the surface then has one diagonal left, the same for both
 * sides.
 */
void CutTetrahedron(
  const StuffingWarp& warp, const LatticeTetrahedron& t, int side, std::vector<StuffingPiece>& out);

Point3 PositionOf(const StuffingWarp& warp, const StuffingCorner& corner);

}

#endif
