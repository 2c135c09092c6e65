/**
 * @file PocketMouths.h
 * @brief The triangles through which pockets open, grouped.
 */
#ifndef isthmus_PocketMouths_h
#define isthmus_PocketMouths_h

#include "CellAccess.h"
#include "PocketParameters.h"

namespace isthmus
{

/**
 * Adds to each pocket the triangles wider than `inner` that lead out of it (`labels`: the pocket of
 * each tetrahedron, -1: none); those that share an edge are one mouth. O(n log n).
 */
VTKISTHMUS_EXPORT void AddMouths(const RegularFiltration& f, const CellAccess& access,
  const std::vector<SimplexId>& labels, double inner, std::vector<Pocket>& pockets);

}

#endif
