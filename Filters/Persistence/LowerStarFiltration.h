/**
 * @file LowerStarFiltration.h
 * @brief A tetrahedral mesh that grows with a function at its points (thesis, 6.3.1).
 */
#ifndef isthmus_LowerStarFiltration_h
#define isthmus_LowerStarFiltration_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/**
 * Every simplex enters with its last point; simplices of `surface` enter first, at 0.
 *
 * `values` are distances at the mesh's points, not negative (they are squared inside, as in every
 * CellFiltration). The points of the mesh keep their ids; `surface`, whose points are identified by
 * their exact coordinates, gets the points and ids of the mesh. Equal values enter in the order of
 * the ids.
 *
 * @throws std::invalid_argument when a face has more than two tetrahedra, a triangle of the surface
 * is not a face of the mesh, or a value is negative or not finite. O(n log n).
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT CellFiltration LowerStarFiltration(const TetrahedralMesh& mesh,
  const std::vector<double>& values, TriangleMesh& surface, const ProgressCallback& progress = {});

/**
 * The complex of a mesh with its `surface` marked as first, as above, but without values and order:
 * fill them and call Order().
 *
 * The mesh is given up: it is freed before the simplices are derived from it.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT CellFiltration ComplexAround(
  TetrahedralMesh&& mesh, TriangleMesh& surface, const ProgressCallback& progress = {});

}

#endif
