/**
 * @file CellFiltration.h
 * @brief A tetrahedral complex that grows with a distance: simplices, incidences, values, order.
 */
#ifndef isthmus_CellFiltration_h
#define isthmus_CellFiltration_h

#include "Point3.h"
#include "Progress.h"
#include "vtkIsthmusModule.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Index of a simplex of one dimension. 32 bits: a complex has at most 2^29 tetrahedra, whose faces
/// are numbered, which is about 80 million points; CellFiltration::Connect() refuses more with a
/// sentence.
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

  /// A triangle as a face of a tetrahedron t, of two the one with the smaller id: 4 t + the corner
  /// that it is opposite to. Ascending. Points and sides follow from it: they are a third of all
  /// memory when they are kept.
  std::vector<SimplexId> TriangleFaces;
  std::vector<std::array<SimplexId, 3>> TriangleEdges; ///< edge k is opposite to point k
  std::vector<std::array<SimplexId, 2>> Edges;         ///< points, ascending, sorted
  std::vector<SimplexId> FirstEdge; ///< edges whose smaller point is p: [FirstEdge[p], [p+1])

  std::vector<double> TetrahedronValue;
  std::vector<double> TriangleValue;
  std::vector<double> EdgeValue;

  std::vector<SimplexId> TriangleRank; ///< position in the order of entry, per dimension
  std::vector<SimplexId> EdgeRank;
  std::vector<SimplexId> TrianglesInOrder; ///< inverse of TriangleRank
  std::vector<SimplexId> EdgesInOrder;

  /// Ranks a simplex below all others, whatever its value: those of a surface kept as subcomplex.
  std::vector<char> EdgeFirst;
  std::vector<char> TriangleFirst;

  /// Derives triangles and edges from tetrahedra and their neighbours. O(n), some 150 bytes a
  /// tetrahedron in all. Throws std::runtime_error beyond 2^29 tetrahedra.
  VTKISTHMUS_EXPORT void Connect(const ProgressCallback& progress = {});

  /// Sorts triangles and edges by value, ties by index (SimplexOrder.h). O(n).
  VTKISTHMUS_EXPORT void Order(const ProgressCallback& progress = {});

  /// The edge between two points, or -1.
  VTKISTHMUS_EXPORT SimplexId FindEdge(SimplexId a, SimplexId b) const;

  std::size_t TriangleCount() const { return this->TriangleFaces.size(); }

  /// Points of triangle i, ascending.
  std::array<SimplexId, 3> TrianglePoints(std::size_t i) const;

  /// The tetrahedra beside triangle i, the smaller id first; -1, the exterior, comes second.
  std::array<SimplexId, 2> TriangleSides(std::size_t i) const
  {
    const auto face = static_cast<std::uint32_t>(this->TriangleFaces[i]);
    return { static_cast<SimplexId>(face / 4), this->Neighbours[face / 4][face % 4] };
  }

  /// True if tetrahedron `a` enters after `b`.
  bool EntersLater(SimplexId a, SimplexId b) const
  {
    const double atA = this->TetrahedronValue[static_cast<std::size_t>(a)];
    const double atB = this->TetrahedronValue[static_cast<std::size_t>(b)];
    return atA != atB ? atA > atB : a > b;
  }

  /// The corner of tetrahedron `cell` that is not on `triangle`, one of its faces.
  SimplexId Opposite(SimplexId cell, const std::array<SimplexId, 3>& triangle) const
  {
    const auto& corners = this->Tetrahedra[static_cast<std::size_t>(cell)];
    return *std::find_if(corners.begin(), corners.end(),
      [&triangle](SimplexId p)
      { return p != triangle[0] && p != triangle[1] && p != triangle[2]; });
  }
};

inline std::array<SimplexId, 3> CellFiltration::TrianglePoints(std::size_t i) const
{
  const auto face = static_cast<std::uint32_t>(this->TriangleFaces[i]);
  const auto& corners = this->Tetrahedra[face / 4];
  const SimplexId a = corners[(face + 1) % 4];
  const SimplexId b = corners[(face + 2) % 4];
  const SimplexId c = corners[(face + 3) % 4];
  const SimplexId low = std::min(a, b);
  const SimplexId high = std::max(a, b);
  return { std::min(low, c), std::max(low, std::min(high, c)), std::max(high, c) };
}

}

#endif
