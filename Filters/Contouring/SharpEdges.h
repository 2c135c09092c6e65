/**
 * @file SharpEdges.h
 * @brief The edges and corners of a triangle surface over which its normal jumps.
 */
#ifndef isthmus_SharpEdges_h
#define isthmus_SharpEdges_h

#include "Core/TriangleMesh.h"

namespace isthmus
{

struct SharpEdges
{
  std::vector<std::array<Point3, 2>> Segments;
  /// Where one, three or more segments end, or two that turn by more than the angle.
  std::vector<Point3> Corners;
};

/**
 * Edges whose two triangles' normals enclose an angle with a cosine below `cosine`, and those of
 * more than two triangles. Points in one place are one; triangles without area have no normal and
 * do not count. Ordered by the ids of their points. O(n log n), 100 bytes a triangle.
 */
SharpEdges FindSharpEdges(const SurfaceView& surface, double cosine);

/**
 * Cosine of the angle between two planes, as often met, above which a cell of dual contouring takes
 * them for one: n1 n1^T + n2 n2^T has the eigenvalues 1 + c and 1 - c, and the smaller one does not
 * count where it is below `threshold` times the larger.
 */
inline double SharpCosine(double threshold)
{
  return (1.0 - threshold) / (1.0 + threshold);
}

}

#endif
