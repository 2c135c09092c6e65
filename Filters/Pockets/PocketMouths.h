/**
 * @file PocketMouths.h
 * @brief The triangles through which pockets open, grouped.
 */
#ifndef isthmus_PocketMouths_h
#define isthmus_PocketMouths_h

#include "Pockets/PocketLabels.h"
#include "Pockets/PocketParameters.h"
#include "vtkIsthmusFiltersPocketsModule.h"

namespace isthmus
{

/**
 * Adds to each pocket the triangles wider than `inner` that lead out of it (`labels`: the pocket of
 * each tetrahedron); those that share an edge are one mouth. O(n log n).
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT void AddMouths(const RegularFiltration& f, const CellAccess& access,
  const PocketByCell& labels, double inner, std::vector<Pocket>& pockets);

}

#endif
