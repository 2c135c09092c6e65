/**
 * @file SurfaceDefects.h
 * @brief Finds defects of a triangle surface: places where it is not closed, manifold or oriented.
 */
#ifndef isthmus_SurfaceDefects_h
#define isthmus_SurfaceDefects_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/**
 * The defects of a surface, each with the ids of the triangles (or points) concerned.
 *
 * Except for InvalidPoints and DegenerateTriangles, they are purely combinatorial; crossings of
 * triangles are not included.
 */
struct SurfaceDefects
{
  std::vector<std::int64_t> InvalidPoints;        ///< NaN or infinite coordinates
  std::vector<std::int64_t> InvalidTriangles;     ///< a point id twice or out of range
  std::vector<std::int64_t> DegenerateTriangles;  ///< area 0
  std::vector<std::int64_t> DuplicateTriangles;   ///< the same three points as an earlier one
  std::vector<std::int64_t> BoundaryTriangles;    ///< an edge with no other triangle
  std::vector<std::int64_t> NonManifoldTriangles; ///< an edge with more than two triangles
  std::vector<std::int64_t> FlippedTriangles;     ///< an edge run through twice the same way
  std::vector<std::int64_t> NonManifoldPoints;    ///< triangles around it form more than one fan

  bool None() const;

  /// Empty if there are no defects; otherwise one message with counts and the first few ids of each
  /// kind.
  VTKISTHMUSFILTERSSURFACES_EXPORT std::string Message() const;
};

/// "3, 17, 20 and 4 more"
VTKISTHMUSFILTERSSURFACES_EXPORT std::string FirstIds(const std::vector<std::int64_t>& ids);

/// Defects of `mesh`. O(n) for points of bounded valence, in parallel; about 35 bytes for each
/// triangle.
VTKISTHMUSFILTERSSURFACES_EXPORT SurfaceDefects FindDefects(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// @throws std::invalid_argument, with the point, for one whose edges are all below what
/// the resolution of the largest coordinates: new triangles there would be flat, and such parts
/// would disappear silently; with one point at 1e18, all of an ordinary surface. Corners must be
/// points. O(n).
VTKISTHMUSFILTERSSURFACES_EXPORT void RequireResolved(const SurfaceView& mesh);

}

#endif
