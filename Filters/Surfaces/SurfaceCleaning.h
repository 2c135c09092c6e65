/**
 * @file SurfaceCleaning.h
 * @brief Prepares surfaces for algorithms: merges coinciding points, removes triangles without area
 * (without moving anything else), and explains why a surface is open.
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
 * lose an edge by this are dropped; they had no area. O(n), by hashing; 30 bytes for each point in
 * addition to the result. `original`, if given, is set to the id in `surface` of each point.
 * @throws std::invalid_argument if a corner is not a valid point.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT TriangleMesh MergePoints(
  const SurfaceView& surface, std::vector<std::int64_t>* original = nullptr);

/// A surface for algorithms that need unique points.
struct CleanedSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input
  std::string Message;                      ///< cracks that were closed; empty: there were none
};

/**
 * `surface` as it is where FindDefects finds nothing; else with coinciding points merged
 * (MergePoints), cracks closed (JoinCracks of SurfaceCorrection.h) and triangles without area
 * removed. Holes and other defects stay. If a corner is not a valid point, or a point is not
 * finite, the surface is not changed at all. O(n).
 */
VTKISTHMUSFILTERSSURFACES_EXPORT CleanedSurface CleanSurface(TriangleMesh surface);

/// The corners of the triangles of `surface` after the same merging; its points are not changed.
/// `places`, if given, is set to the representative of each point, which is the point itself if no
/// triangle uses it.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> MergedCorners(
  const SurfaceView& surface, std::vector<vtkIdType>* places = nullptr);

/**
 * For a surface that FindDefects found to be open: if it is open only at the faces of its bounding
 * box, like a contour whose level leaves the map, a message with the reason and the remedy, to
 * append to SurfaceDefects::Message(). Else empty.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::string DescribeOpenBoundary(
  const SurfaceView& surface, const SurfaceDefects& defects);

/**
 * `surface` without triangles that have no area, the same as a set of points.
 *
 * Those with the same corner twice are dropped. If the corners a, b, c of a triangle lie on a line,
 * with b between the others, its neighbour (c, a, d) across the side ac is split at b, so that (c,
 * b, d) and (b, a, d) replace both. At a border, the triangle is dropped. The triangle is kept, and
 * reported by FindDefects, if there is already an edge bd, or ac has more than two triangles.
 *
 * @pre corners exist and are finite, and no two points are at one place (MergePoints).
 * O(n log n) for each layer of flat triangles on top of each other; up to 16 layers are processed.
 */
TriangleMesh RemoveFlatTriangles(TriangleMesh surface);

}

#endif
