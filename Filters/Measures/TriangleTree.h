/**
 * @file TriangleTree.h
 * @brief Exact distance of points from a triangle surface, by a tree of cylinders.
 */
#ifndef isthmus_TriangleTree_h
#define isthmus_TriangleTree_h

#include "SurfaceView.h"
#include "TriangleMesh.h"
#include "vtkIsthmusModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Squared distance of `x` from a triangle: to its plane over the inside, else to its border.
VTKISTHMUS_EXPORT double SquaredDistanceToTriangle(
  const Point3& x, const std::array<Point3, 3>& corners);

/**
 * Cylinders in a binary tree over the triangles, halved at the median of their centres along the
 * longest side. A cylinder's axis is the mean normal of its triangles: where the surface is smooth,
 * it is a flat disc, and far from the surface few discs are as near as the nearest triangle. (Boxes
 * along the axes reach off the surface; inside a sphere a hundred times as many had to be opened.)
 * Owns a copy of the corners. Building: O(n log n); memory: about 150 bytes a triangle. Queries may
 * run in parallel.
 */
class VTKISTHMUS_EXPORT TriangleTree
{
public:
  explicit TriangleTree(const SurfaceView& mesh);

  /// The answer to a query: `Triangle` is a number of the tree's own, -1 for a tree without any.
  struct Nearest
  {
    double Squared;
    std::int64_t Triangle;
  };

  /**
   * Squared distance of `x` from the surface: the least of all triangles', each by its plane over
   * the inside and else by its border; infinite for an empty surface. `guess` (a Triangle of an
   * answer for a point nearby, or -1) only saves time: most of it.
   */
  Nearest Find(const Point3& x, std::int64_t guess) const;

private:
  struct Cylinder
  {
    Point3 Centre, Axis; ///< unit axis
    double HalfHeight, Radius;
    std::int64_t First; ///< triangle of a leaf, else the left child
    std::int64_t Count; ///< triangles of a leaf, else 0
  };

  class Builder;

  static double SquaredDistance(const Cylinder& cylinder, const Point3& x);

  std::vector<std::array<Point3, 3>> Corners; ///< leaf by leaf
  std::vector<Cylinder> Cylinders;            ///< the root first, children in pairs
};

}

#endif
