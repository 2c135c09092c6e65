/**
 * @file HausdorffDistance.h
 * @brief Hausdorff distance of two surfaces, and the boundary surface of a tetrahedral mesh, whose
 * distance from the surface it was made for shows how far the mesher moved it.
 */
#ifndef isthmus_HausdorffDistance_h
#define isthmus_HausdorffDistance_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/// The faces between tetrahedra of positive region and everything else, facing out of them.
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh BoundarySurface(const TetrahedralMesh& mesh);

/**
 * Largest distance of points, middles of edges and middles of triangles of either surface from the
 * other one: the Hausdorff distance but for what lies between these places. Infinite when one of
 * them is empty. @pre corners exist and are finite. O(n log n), in parallel.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT double HausdorffDistance(
  const SurfaceView& a, const SurfaceView& b);

/// Triangles of `a` with such a place farther from `b` than `distance`, ascending; all of them when
/// `b` is empty.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<std::int64_t> TrianglesFartherThan(
  const SurfaceView& a, const SurfaceView& b, double distance);

/// Such a distance from `a` to `b` only: how far `a` reaches from `b`.
VTKISTHMUSFILTERSSURFACES_EXPORT double OneSidedDistance(
  const SurfaceView& a, const SurfaceView& b);

}

#endif
