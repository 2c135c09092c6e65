/**
 * @file VoidPairs.h
 * @brief Persistence of voids: which tetrahedron fills what a triangle closes.
 */
#ifndef isthmus_VoidPairs_h
#define isthmus_VoidPairs_h

#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/**
 * For each triangle: the tetrahedron that fills the void it closes, or None where it closes none.
 *
 * Tetrahedra are joined across triangles from the last to the first; the younger of two basins, the
 * one whose latest tetrahedron enters earlier, ends there (the elder rule, seen from the
 * complement; C. J. A. Delfinado, H. Edelsbrunner, 1995). Everything goes by rank, so that what
 * enters together lies together. Near linear; 8 bytes a tetrahedron and 8 a triangle beside the
 * result.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TriangleId, TetrahedronId> VoidPairs(
  const CellFiltration& f, const ProgressCallback& progress = {});

}

#endif
