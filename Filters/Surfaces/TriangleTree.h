/**
 * @file TriangleTree.h
 * @brief Exact distance of points from a triangle surface, by a tree of cylinders.
 */
#ifndef isthmus_TriangleTree_h
#define isthmus_TriangleTree_h

#include "Core/Geometry.h"
#include "Surfaces/TriangleTreeNodes.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <array>
#include <cstdint>

namespace isthmus
{

/// Squared distance of x from the segment from a to b, which may be equal.
VTKISTHMUSFILTERSSURFACES_EXPORT double SquaredDistanceToSegment(
  const Point3& x, const Point3& a, const Point3& b);

/// Squared distance of x from a triangle: to its plane if the projection is inside, otherwise to
/// its border.
double SquaredDistanceToTriangle(const Point3& x, const std::array<Point3, 3>& corners);

/**
 * A tree of cylinders over the triangles, which are halved three times at each level, at the median
 * of their centers along the longest side. A cylinder's axis is the mean normal of its triangles.
 * Eight children, or eight triangles of a leaf, are measured at the same time by vector
 * instructions, as in trees for ray tracing (H. Dammertz et al., Shallow bounding volume
 * hierarchies for fast SIMD ray tracing of incoherent rays, 2008).
 *
 * Owns a copy of the corners. Building: O(n log n); memory: about 80 bytes for each triangle.
 * Queries may run in parallel. Results are bitwise the same for any guess, but may differ in the
 * last bit from machine to machine.
 */
class VTKISTHMUSFILTERSSURFACES_EXPORT TriangleTree
{
public:
  /// @pre Less than 2^34 triangles.
  explicit TriangleTree(const SurfaceView& mesh);

  /// The result of a query. Guess is for a query of a nearby point; it is -1 for an empty tree.
  struct Nearest
  {
    double Squared;
    std::int64_t Guess;
  };

  /**
   * Squared distance of x from the surface: the smallest over all triangles, each to its plane if
   * the projection is inside, otherwise to its border; infinite for an empty surface. `guess` (that
   * of the result for a nearby point, or -1) has no effect on the result but saves most of the
   * time.
   */
  Nearest Find(const Point3& x, std::int64_t guess) const;

private:
  class Search;

  TriangleTreeNodes Tree;
};

}

#endif
