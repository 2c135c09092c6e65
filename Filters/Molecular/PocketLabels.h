/**
 * @file PocketLabels.h
 * @brief Which pocket each tetrahedron belongs to.
 */
#ifndef isthmus_PocketLabels_h
#define isthmus_PocketLabels_h

#include "CellAccess.h"
#include "PocketParameters.h"

namespace isthmus
{

/// The pocket of each tetrahedron, from 0 in the order of their first tetrahedra; -1: none.
/// Tetrahedra with room for the inner ball that the outer one does not reach, joined through
/// triangles that let the inner one pass. O(n).
std::vector<SimplexId> PocketCores(
  const CellFiltration& complex, const CellAccess& access, const PocketOptions& options);

/**
 * Gives the crevices to the pockets: empty tetrahedra too narrow for the inner ball that the probe
 * reaches from a pocket belong to the one with the widest way. So the room of a void is all of it.
 * O(n log n).
 */
std::vector<SimplexId> WithCrevices(const CellFiltration& complex,
  const std::vector<std::array<SimplexId, 4>>& faces, const CellAccess& access, double outer,
  const std::vector<SimplexId>& cores);

}

#endif
