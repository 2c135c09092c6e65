/**
 * @file SurfaceBoolean.h
 * @brief Union and difference of two closed surfaces.
 */
#ifndef isthmus_SurfaceBoolean_h
#define isthmus_SurfaceBoolean_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersRemeshingModule.h"

namespace isthmus
{

/// A surface whose triangles have tags for their origin.
struct TaggedSurface
{
  TriangleMesh Mesh;
  std::vector<int> Tags; ///< one for each triangle; parts of a triangle have its tag
};

enum class BooleanOperation
{
  Union,
  Difference ///< the first without the second
};

/**
 * The surface of the union or difference of the volumes enclosed by `a` and `b`, by CGAL's
 * corefinement (exact predicates and constructions along the curve where they cross). Points and
 * triangles away from that curve are bitwise unchanged, but not in the same order.
 *
 * @pre both are closed, manifold, without self-intersections, and bound a volume: their outer
 * shells face outward, cavities inward (OutwardSurface()).
 * @throws std::runtime_error with a message where the result is not manifold or CGAL fails.
 * O((n + m) log(n + m)).
 */
VTKISTHMUSFILTERSREMESHING_EXPORT TaggedSurface CombineSurfaces(
  const TaggedSurface& a, const TaggedSurface& b, BooleanOperation operation, double finest);

/// `mesh` with each component turned so that all of them together bound a volume.
/// @pre closed, manifold, without self-intersections. @throws std::runtime_error.
VTKISTHMUSFILTERSREMESHING_EXPORT TriangleMesh OutwardSurface(const SurfaceView& mesh);

/// The triangles of least area (and then least angles between them) that fill a closed polygon, as
/// indices into it; empty if CGAL finds none. O(n^2), at worst O(n^3).
VTKISTHMUSFILTERSREMESHING_EXPORT std::vector<Triangle> PolygonFilling(
  const std::vector<Point3>& polygon);

}

#endif
