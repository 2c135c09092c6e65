/**
 * @file SurfaceIntake.h
 * @brief One rule for surfaces that come in: points that coincide are one, and what is open is
 * named.
 */
#ifndef isthmus_SurfaceIntake_h
#define isthmus_SurfaceIntake_h

#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceCheck.h"
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
struct TakenSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in what came in
};

/**
 * `surface` as it is where FindDefects finds nothing; else with coinciding points merged
 * (MergePoints) and without triangles that have no area (FlatTriangles.h). Holes and whatever else
 * there is stay. Where a corner is no point, or one is not finite, it stays as it is altogether,
 * for what repairs or refuses it. O(n).
 */
VTKISTHMUSFILTERSSURFACES_EXPORT TakenSurface TakeSurface(TriangleMesh surface);

/// The corners of the triangles of `surface` after the same merging; its points stay where they
/// are. `places`, if given, gets for each point the one that stands for its place; itself for a
/// point that no triangle uses.
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<Triangle> MergedCorners(
  const SurfaceView& surface, std::vector<vtkIdType>* places = nullptr);

/**
 * Where a surface that FindDefects found to be open is so only at the faces of its own box, as a
 * contour is where the level leaves the map: a sentence that says so, and the way out, to append to
 * SurfaceDefects::Sentence(). Else empty.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::string WhyOpen(
  const SurfaceView& surface, const SurfaceDefects& defects);

}

#endif
