/**
 * @file SolidStuffing.h
 * @brief Isosurface stuffing of what a triangle soup encloses, by its winding number.
 */
#ifndef isthmus_SolidStuffing_h
#define isthmus_SolidStuffing_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Tetrahedra/MeshedSide.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"

namespace isthmus
{

struct SolidStuffingParameters
{
  double CellSize = 0.0; ///< a length; 0: a hundredth of the diagonal
  MeshedSide Side = MeshedSide::Inside;
  double BoxMargin = 0.5;         ///< Outside, Both: in diagonals of the surface's box
  std::uint64_t MaximumBytes = 0; ///< of the lattice; 0: no limit
};

/**
 * Tetrahedra of the points that `soup` winds around by more than one half, whatever way it is
 * turned: region 1 inside, 0 outside. Distances to the soup place the new surface between the
 * points of the lattice, so that it is the old one where that is closed, and spans the holes.
 *
 * Cost: some microseconds for each of the two points of a cell, in parallel.
 * @pre corners exist and are finite.
 * @throws std::invalid_argument when nothing is enclosed; otherwise as IsosurfaceStuffing.
 */
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT TetrahedralMesh StuffSolid(const SurfaceView& soup,
  const SolidStuffingParameters& parameters, const ProgressCallback& progress = {});

}

#endif
