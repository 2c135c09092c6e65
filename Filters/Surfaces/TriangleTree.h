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

/// Squared distance of `x` from the segment from `a` to `b`, which may be one point.
VTKISTHMUSFILTERSSURFACES_EXPORT double SquaredDistanceToSegment(
  const Point3& x, const Point3& a, const Point3& b);

/// Squared distance of `x` from a triangle: to its plane over the inside, else to its border.
VTKISTHMUSFILTERSSURFACES_EXPORT double SquaredDistanceToTriangle(
  const Point3& x, const std::array<Point3, 3>& corners);

/**
 * Cylinders in a tree over the triangles, halved three times a level at the median of their centres
 * along the longest side. A cylinder's axis is the mean normal of its triangles: where the surface
 * is smooth, it is a flat disc, and far from the surface few discs are as near as the nearest
 * triangle. (Boxes along the axes reach off the surface; inside a sphere a hundred times as many
 * had to be opened.) Eight children, and eight triangles of a leaf, are measured at once by the
 * machine's vectors, as trees for ray tracing do (H. Dammertz et al., Shallow bounding volume
 * hierarchies for fast SIMD ray tracing of incoherent rays, 2008).
 *
 * Owns a copy of the corners. Building: O(n log n); memory: about 80 bytes a triangle. Queries may
 * run in parallel; their bits are the same for any guess, but may differ in the last one from
 * machine to machine.
 */
class VTKISTHMUSFILTERSSURFACES_EXPORT TriangleTree
{
public:
  /// @pre Less than 2^34 triangles.
  explicit TriangleTree(const SurfaceView& mesh);

  /// The answer to a query: `Guess` serves the query of a point nearby, -1 from an empty tree.
  struct Nearest
  {
    double Squared;
    std::int64_t Guess;
  };

  /**
   * Squared distance of `x` from the surface: the least of all triangles', each by its plane over
   * the inside and else by its border; infinite for an empty surface. `guess` (that of an answer
   * for a point nearby, or -1) only saves time: most of it.
   */
  Nearest Find(const Point3& x, std::int64_t guess) const;

private:
  class Search;

  TriangleTreeNodes Tree;
};

}

#endif
