/**
 * @file CellFiltration.h
 * @brief A tetrahedral complex that grows with a distance: simplices, incidences, values, order.
 */
#ifndef isthmus_CellFiltration_h
#define isthmus_CellFiltration_h

#include "Progress.h"
#include "TriangleMesh.h"
#include "vtkIsthmusModule.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Index of a simplex of one dimension. 32 bits: a complex has at most 2^31 triangles, which is
/// about 160 million points; CellFiltration::Connect() refuses more with a sentence.
using SimplexId = std::int32_t;

/// A set of simplices of one dimension over Z/2, as ids without repetition.
using Chain = std::vector<SimplexId>;

/**
 * A simplicial 3-complex and the value at which each of its simplices enters.
 *
 * Values are squared distances (square of the unit of the points), and no face has a greater value
 * than its cofaces. The complement of the complex counts as one more tetrahedron, -1, which
 * enters last: with it the complex is a sphere, and a void is what dies in a tetrahedron.
 *
 * Fill Points, Tetrahedra and Neighbours, call Connect(), fill the values, call Order().
 */
struct CellFiltration
{
  std::vector<Point3> Points;
  std::vector<std::array<SimplexId, 4>> Tetrahedra;
  /// Across the face opposite to corner k, or -1 for the exterior.
  std::vector<std::array<SimplexId, 4>> Neighbours;

  std::vector<std::array<SimplexId, 3>> Triangles;     ///< points, ascending
  std::vector<std::array<SimplexId, 2>> TriangleSides; ///< the tetrahedra beside; -1: exterior
  std::vector<std::array<SimplexId, 3>> TriangleEdges; ///< edge k is opposite to point k
  std::vector<std::array<SimplexId, 2>> Edges;         ///< points, ascending, sorted
  std::vector<SimplexId> FirstEdge; ///< edges whose smaller point is p: [FirstEdge[p], [p+1])

  std::vector<double> TetrahedronValue;
  std::vector<double> TriangleValue;
  std::vector<double> EdgeValue;

  std::vector<SimplexId> TetrahedronRank; ///< position in the order of entry, per dimension
  std::vector<SimplexId> TriangleRank;
  std::vector<SimplexId> EdgeRank;
  std::vector<SimplexId> TrianglesInOrder; ///< inverse of TriangleRank
  std::vector<SimplexId> EdgesInOrder;

  /// Ranks a simplex below all others, whatever its value: those of a surface kept as subcomplex.
  std::vector<char> EdgeFirst;
  std::vector<char> TriangleFirst;

  /// Derives triangles and edges from tetrahedra and their neighbours. O(n), some 250 bytes a
  /// tetrahedron in all. Throws std::runtime_error beyond 2^31 triangles.
  VTKISTHMUS_EXPORT void Connect(const ProgressCallback& progress = {});

  /// Sorts the simplices of each dimension by value, ties by index (SimplexOrder.h). O(n).
  VTKISTHMUS_EXPORT void Order(const ProgressCallback& progress = {});

  /// The edge between two points, or -1.
  VTKISTHMUS_EXPORT SimplexId FindEdge(SimplexId a, SimplexId b) const;

  /// The corner of tetrahedron `cell` that is not on `triangle`, one of its faces.
  SimplexId Opposite(SimplexId cell, const std::array<SimplexId, 3>& triangle) const
  {
    const auto& corners = this->Tetrahedra[static_cast<std::size_t>(cell)];
    return *std::find_if(corners.begin(), corners.end(),
      [&triangle](SimplexId p)
      { return p != triangle[0] && p != triangle[1] && p != triangle[2]; });
  }
};

}

#endif
