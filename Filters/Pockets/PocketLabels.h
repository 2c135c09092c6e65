/**
 * @file PocketLabels.h
 * @brief Which pocket each tetrahedron belongs to.
 */
#ifndef isthmus_PocketLabels_h
#define isthmus_PocketLabels_h

#include "Pockets/CellAccess.h"
#include "Pockets/PocketParameters.h"

namespace isthmus
{

/// A pocket, from 0 in the order of their first tetrahedra.
using PocketNumber = Handle<struct PocketKind, std::int32_t>;
using PocketByCell = HandleVector<TetrahedronId, PocketNumber>;

/// The pocket of each tetrahedron.
/// Tetrahedra with room for the inner ball that the outer one does not reach, joined through
/// triangles that let the inner one pass. O(n).
PocketByCell PocketCores(
  const CellFiltration& complex, const CellAccess& access, const PocketOptions& options);

/**
 * Gives the crevices to the pockets: empty tetrahedra too narrow for the inner ball that the probe
 * reaches from a pocket belong to the one with the widest way. So the room of a void is all of it.
 * O(n log n).
 */
PocketByCell WithCrevices(const CellFiltration& complex, const FacesByCell& faces,
  const CellAccess& access, double outer, const PocketByCell& cores);

}

#endif
