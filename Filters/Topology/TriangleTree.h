/**
 * @file TriangleTree.h
 * @brief Which triangle of a surface is nearest?
 */
#ifndef isthmus_TriangleTree_h
#define isthmus_TriangleTree_h

#include "TriangleMesh.h"
#include "vtkIsthmusModule.h"

#include <limits>

namespace isthmus
{

/// Boxes within boxes round the triangles of a mesh, split at the median along the longest side.
class TriangleTree
{
public:
  /// O(n log n), 18 bytes a triangle. Keeps a reference to the mesh.
  VTKISTHMUS_EXPORT explicit TriangleTree(const TriangleMesh& mesh);

  /// Square of the distance from `p` to the nearest triangle, or `bound` if that is smaller.
  /// O(log n) for most points. May be called from several threads.
  VTKISTHMUS_EXPORT double SquaredDistance(
    const Point3& p, double bound = std::numeric_limits<double>::infinity()) const;

private:
  /// Triangles First .. First + Count - 1 in Order, or two children: the next node and Second.
  struct Node
  {
    Bounds3 Box;
    std::uint32_t First = 0;
    std::uint32_t Count = 0;
    std::uint32_t Second = 0;
  };

  void Split(std::size_t first, std::size_t last, const std::vector<Point3>& centres);
  double ToTriangle(const Point3& p, std::uint32_t triangle) const;

  const TriangleMesh& Mesh;
  std::vector<std::uint32_t> Order;
  std::vector<Node> Nodes;
};

}

#endif
