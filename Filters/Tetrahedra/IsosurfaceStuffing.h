/**
 * @file IsosurfaceStuffing.h
 * @brief Tetrahedra with bounded angles directly from a level set: isosurface stuffing.
 *
 * F. Labelle, J. R. Shewchuk, ACM Trans. Graph. 26 (2007) 57, doi:10.1145/1276377.1276448: a
 * body-centered cubic lattice, its points near the surface moved onto it, its tetrahedra cut where
 * the surface crosses them. The graded lattice is uniform around the surface and coarser elsewhere
 * (angles there are 45 to 135 degrees). The paper's bounds, 10.7 to 164.8 degrees, hold for every
 * tetrahedron of either side: each one near the surface is measured, and a point is not moved if
 * that would violate the bounds, which happens where the surface turns within a cell.
 *
 * Both sides are cut alike, share the points and triangles of the surface, and fill the box.
 */
#ifndef isthmus_IsosurfaceStuffing_h
#define isthmus_IsosurfaceStuffing_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Tetrahedra/StuffingLattice.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"

#include <functional>

namespace isthmus
{

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT void Check(const StuffingParameters& parameters);

struct IsosurfaceStuffingResult
{
  TetrahedralMesh Mesh;        ///< region 1 inside, 0 outside; OriginalPoints is -1 throughout
  std::vector<bool> OnSurface; ///< for each point, whether it is on the level set
  std::int64_t KeptPoints = 0; ///< points near the surface that are not moved, see above
};

/**
 * Fills the region where `field` is positive (inside), or not positive (outside), within a box
 * around `bounds` with tetrahedra. The field must be finite everywhere, must not be positive
 * outside `bounds`, and may be called from several threads at the same time.
 *
 * The surface is that of the linear interpolation along lattice edges: second order in CellSize.
 *
 * @throws std::invalid_argument on parameters that can't be met (e.g. a CellSize of 0) or a lattice
 * of more than 2^18 cells along an axis; std::runtime_error where Memory does not hold the lattice;
 * Cancelled.
 *
 * Cost: two values for each cell of the box; 21 bytes for each cell, and about 70 bytes for each
 * tetrahedron. Sampling and warping are parallel; the result is bitwise the same on any number of
 * threads.
 */
VTKISTHMUSFILTERSTETRAHEDRA_EXPORT IsosurfaceStuffingResult IsosurfaceStuffing(
  const std::function<double(const Point3&)>& field, const Bounds3& bounds,
  const StuffingParameters& parameters, const ProgressCallback& progress = {});

}

#endif
