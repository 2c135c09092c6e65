/**
 * @file SurfaceDefects.h
 * @brief What can be wrong with a triangle surface, and a sentence that says so.
 */
#ifndef isthmus_SurfaceDefects_h
#define isthmus_SurfaceDefects_h

#include "vtkIsthmusFiltersSurfacesModule.h"

#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/**
 * What is wrong with a surface, each as the ids of the triangles (or points) concerned.
 *
 * Purely combinatorial but for InvalidPoints and DegenerateTriangles: crossings of triangles are
 * another matter, for the room of meshing.
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
  VTKISTHMUSFILTERSSURFACES_EXPORT std::string Sentence() const;
};

/// "3, 17, 20 and 4 more"
VTKISTHMUSFILTERSSURFACES_EXPORT std::string FirstIds(const std::vector<std::int64_t>& ids);

}

#endif
