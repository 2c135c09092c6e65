/**
 * @file SurfaceCheck.h
 * @brief Is a triangle surface closed, manifold and oriented, and if not, where not?
 */
#ifndef isthmus_SurfaceCheck_h
#define isthmus_SurfaceCheck_h

#include "Progress.h"
#include "TriangleMesh.h"
#include "vtkIsthmusModule.h"

#include <string>

namespace isthmus
{

/**
 * What is wrong with a surface, each as the ids of the triangles (or points) concerned.
 *
 * Purely combinatorial but for InvalidPoints and DegenerateTriangles: crossings of triangles are
 * found by SelfIntersections() of SurfaceRepair.h.
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

  /// Empty when there are none; else one sentence with counts and the first few ids of each kind.
  VTKISTHMUS_EXPORT std::string Sentence() const;
};

/// Defects of `mesh`. O(n log n) in time, some 60 bytes a triangle.
VTKISTHMUS_EXPORT SurfaceDefects FindDefects(
  const TriangleMesh& mesh, const ProgressCallback& progress = {});

/// "3, 17, 20 and 4 more"
VTKISTHMUS_EXPORT std::string FirstIds(const std::vector<std::int64_t>& ids);

}

#endif
