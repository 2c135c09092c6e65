/**
 * @file SurfaceCheck.h
 * @brief Is a triangle surface closed, manifold and oriented, and if not, where not?
 */
#ifndef isthmus_SurfaceCheck_h
#define isthmus_SurfaceCheck_h

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
VTKISTHMUS_EXPORT SurfaceDefects FindDefects(const TriangleMesh& mesh);

/**
 * Connected components (triangles that share an edge), numbered from 0 by their first triangle:
 * one number for each triangle. The mesh must be free of invalid triangles.
 */
VTKISTHMUS_EXPORT std::vector<int> Components(const TriangleMesh& mesh);

/// Volume enclosed by a closed surface, (1/6) sum of v0.(v1 x v2) (thesis, eq. 4.41 corrected):
/// positive when its triangles are counter-clockwise seen from outside.
VTKISTHMUS_EXPORT double SignedVolume(const TriangleMesh& mesh);

/// Euler characteristic V - E + F of a closed surface, over the points that triangles use.
VTKISTHMUS_EXPORT std::int64_t EulerCharacteristic(const TriangleMesh& mesh);

/// "3, 17, 20 and 4 more"
VTKISTHMUS_EXPORT std::string FirstIds(const std::vector<std::int64_t>& ids);

}

#endif
