/**
 * @file TriangleTreeNodes.h
 * @brief The nodes of a TriangleTree: triangles sorted into leaves, bounded by cylinders.
 */
#ifndef isthmus_TriangleTreeNodes_h
#define isthmus_TriangleTreeNodes_h

#include "Core/Geometry.h"
#include "Core/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Eight children for each node and eight triangles for each leaf, stored lane by lane, so that a
/// query measures them at the same time. Cylinders are only used to exclude distant triangles, with
/// rounding on the safe side, so floats are sufficient: (x - Origin) / Scale, at most about 1.
struct TriangleTreeNodes
{
  static constexpr std::size_t Width = 8;
  using Lanes = std::array<double, Width>;
  using FloatLanes = std::array<float, Width>;

  /// Eight cylinders; those that are missing are infinitely far.
  struct Node
  {
    alignas(64) std::array<FloatLanes, 3> Center;
    std::array<FloatLanes, 3> Axis; ///< unit
    FloatLanes HalfHeight;
    FloatLanes Radius;
    std::array<std::int32_t, Width> Child; ///< a node, or ~n for leaf n
  };

  /// Eight triangles; if there are fewer, the last one is repeated.
  struct Leaf
  {
    alignas(64) std::array<std::array<Lanes, 3>, 3> Corner; ///< by corner and axis
  };

  Point3 Origin{ 0.0, 0.0, 0.0 };
  double Scale = 1.0;
  std::vector<Node> Nodes; ///< the root first; none where one leaf holds all
  std::vector<Leaf> Leaves;
};

/// O(n log n) for n triangles, fewer than 2^34; empty if there are none.
TriangleTreeNodes MakeTriangleNodes(const SurfaceView& mesh);

}

#endif
