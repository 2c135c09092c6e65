/**
 * @file HausdorffDistance.h
 * @brief Hausdorff distance between two surfaces, and the boundary surface of a tetrahedral mesh;
 * its distance from the input surface shows how far the mesher moved the surface.
 */
#ifndef isthmus_HausdorffDistance_h
#define isthmus_HausdorffDistance_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/// The faces between tetrahedra with a positive region and everything else, facing outwards.
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh BoundarySurface(const TetrahedralMesh& mesh);

/**
 * Largest distance of the points, midpoints of edges and centers of triangles of either surface
 * from the other one. This approximates the Hausdorff distance, since places in between are not
 * sampled. Infinite when one of them is empty. @pre corners exist and are finite. O(n log n), in
 * parallel.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT double HausdorffDistance(
  const SurfaceView& a, const SurfaceView& b);

/// Triangles of `a` with such a place farther from `b` than `distance`, in ascending order; all of
/// them if `b` is empty.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<std::int64_t> TrianglesFartherThan(
  const SurfaceView& a, const SurfaceView& b, double distance);

/// The one-sided distance: the largest distance of such places of `a` from `b`.
VTKISTHMUSFILTERSSURFACES_EXPORT double OneSidedDistance(
  const SurfaceView& a, const SurfaceView& b);

}

#endif
