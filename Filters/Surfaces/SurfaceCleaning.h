/**
 * @file SurfaceCleaning.h
 * @brief Surfaces as algorithms need them: coinciding points merged, triangles without area removed
 * (nothing else moves), and why a surface is open.
 */
#ifndef isthmus_SurfaceCleaning_h
#define isthmus_SurfaceCleaning_h

#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceDefects.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <string>
#include <vector>

namespace isthmus
{

/**
 * `surface` with one point for each place that a triangle uses, in the order of first use by point
 * id; files with texture coordinates or normals at corners (OBJ, STL) have several. Triangles that
 * lose an edge thereby are left out: they had no area. O(n), by hashing; 30 bytes a point beside
 * the result. `original`, if given, gets the id in `surface` of each point.
 * @throws std::invalid_argument for a corner that is no point.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh MergePoints(
  const SurfaceView& surface, std::vector<std::int64_t>* original = nullptr);

/// A surface as algorithms want it that need each place once.
struct CleanedSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in what came in
  std::string Message;                      ///< cracks that were closed; empty: there were none
};

/**
 * `surface` as it is where FindDefects finds nothing; else with coinciding points merged
 * (MergePoints), cracks closed (JoinCracks of SurfaceMending.h) and triangles without area removed.
 * Holes and other defects stay. Where a corner is no point, or a point is not finite, the surface
 * is not changed at all. O(n).
 */
VTKISTHMUSFILTERSSURFACES_EXPORT CleanedSurface CleanSurface(TriangleMesh surface);

/// The corners of the triangles of `surface` after the same merging; its points stay where they
/// are. `places`, if given, gets for each point the one that stands for its place; itself for a
/// point that no triangle uses.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> MergedCorners(
  const SurfaceView& surface, std::vector<vtkIdType>* places = nullptr);

/**
 * Where a surface that FindDefects found to be open is so only at the faces of its own box, as a
 * contour is where the level leaves the map: a message that says so, and the remedy, to append to
 * SurfaceDefects::Sentence(). Else empty.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::string DescribeOpenBoundary(
  const SurfaceView& surface, const SurfaceDefects& defects);

/**
 * `surface` without triangles that have no area, as a set of points the same.
 *
 * Those with a corner twice are left out. Of one whose corners a, b, c lie on a line, b between the
 * others, the neighbour (c, a, d) across the side ac is split at b: (c, b, d) and (b, a, d) stand
 * for both; at a border it is left out. It stays, to be reported by FindDefects, where an edge bd
 * is there already or ac has more than two triangles.
 *
 * @pre corners exist and are finite, and no two points are at one place (MergePoints).
 * O(n log n) for each layer of flat triangles upon each other, of which 16 are tried.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh RemoveFlatTriangles(TriangleMesh surface);

}

#endif
