/**
 * @file CellFiltration.h
 * @brief A tetrahedral complex that grows with a distance: simplices, incidences, values, order.
 */
#ifndef isthmus_CellFiltration_h
#define isthmus_CellFiltration_h

#include "Core/Geometry.h"
#include "Core/Handles.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// Ids of a filtration's edges, triangles and tetrahedra, and their places in its order.

/// The integer type of all ids; ids of points are plain integers of this type. With 32 bits, a
/// complex has at most 2^29 tetrahedra, because their faces are numbered; this corresponds to about
/// 80 million points. CellFiltration::Connect() rejects more with a message.
using SimplexId = std::int32_t;

using EdgeId = Handle<struct FiltrationEdge, SimplexId>;
using TriangleId = Handle<struct FiltrationTriangle, SimplexId>;
/// None stands for the exterior of the complex.
using TetrahedronId = Handle<struct FiltrationTetrahedron, SimplexId>;

/// Position in the order of entry among the simplices of the same dimension.
using EdgeRank = Handle<struct FiltrationEdgeRank, SimplexId>;
using TriangleRank = Handle<struct FiltrationTriangleRank, SimplexId>;
using TetrahedronRank = Handle<struct FiltrationTetrahedronRank, SimplexId>;

static_assert(sizeof(EdgeId) == sizeof(SimplexId) && sizeof(TriangleRank) == sizeof(SimplexId));

/// A set of edges, or of triangles, over Z/2: ids without repetition.
using EdgeChain = std::vector<EdgeId>;
using TriangleChain = std::vector<TriangleId>;

//--------------------------------------------------------------------------------------------------
// The order in which simplices enter, by a radix sort of their values.

/**
 * Sorts all simplices of one dimension by (first, value, id); `rank` becomes the inverse.
 *
 * `first` marks simplices that come before all others (one flag each, or none); no value is NaN.
 * O(n), parallel, the same on any number of threads; 8 bytes for each simplex while it runs.
 */
template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, double>& value,
  const HandleVector<Id, char>& first, HandleVector<Id, Rank>& rank,
  const ProgressCallback& progress = {});

/// The same by levels, counted from 0: sorts all simplices by (level, id). Two passes for up to
/// four million levels.
template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, std::uint32_t>& level,
  HandleVector<Id, Rank>& rank, const ProgressCallback& progress = {});

extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<EdgeRank, EdgeId> SimplexOrder(
  const HandleVector<EdgeId, double>& value, const HandleVector<EdgeId, char>& first,
  HandleVector<EdgeId, EdgeRank>& rank, const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TriangleRank, TriangleId>
SimplexOrder(const HandleVector<TriangleId, double>& value,
  const HandleVector<TriangleId, char>& first, HandleVector<TriangleId, TriangleRank>& rank,
  const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TetrahedronRank, TetrahedronId>
SimplexOrder(const HandleVector<TetrahedronId, double>& value,
  const HandleVector<TetrahedronId, char>& first,
  HandleVector<TetrahedronId, TetrahedronRank>& rank, const ProgressCallback& progress);

extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<EdgeRank, EdgeId> SimplexOrder(
  const HandleVector<EdgeId, std::uint32_t>& level, HandleVector<EdgeId, EdgeRank>& rank,
  const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TriangleRank, TriangleId>
SimplexOrder(const HandleVector<TriangleId, std::uint32_t>& level,
  HandleVector<TriangleId, TriangleRank>& rank, const ProgressCallback& progress);

/// Gives memory that was freed, and that the C library keeps for later, back to the system; glibc
/// only.
void ReleaseFreeMemory();

/**
 * A simplicial 3-complex and the value at which each of its simplices enters.
 *
 * Values are squared distances (square of the unit of the points), and no face has a greater value
 * than its cofaces. The complement of the complex counts as one more tetrahedron, None, which
 * enters last. With it the complex is a sphere, and voids are the features that die when a
 * tetrahedron enters.
 *
 * Fill Points, Tetrahedra and Neighbours, call Connect(), fill the values, call Order().
 */
struct CellFiltration
{
  static constexpr std::size_t CellsPerBlock = 8;

  std::vector<Point3> Points;
  HandleVector<TetrahedronId, std::array<SimplexId, 4>> Tetrahedra;
  /// The neighbour across the face opposite to corner k, or None for the exterior.
  HandleVector<TetrahedronId, std::array<TetrahedronId, 4>> Neighbours;

  /// A triangle as a face of a tetrahedron t (of two, the one with the smaller id): 4 t + the
  /// corner opposite to it. Ascending. Its points and edges are derived from this number, since
  /// storing them would take a third of all memory.
  HandleVector<TriangleId, SimplexId> TriangleFaces;
  /// The first triangle of every 8th tetrahedron, with the total number at the end; bisection over
  /// all triangles would wait for memory at each step.
  std::vector<SimplexId> TriangleBlocks;
  HandleVector<EdgeId, std::array<SimplexId, 2>> Edges; ///< points, ascending, sorted
  std::vector<EdgeId> FirstEdge; ///< edges whose smaller point is p: [FirstEdge[p], [p+1])
  /// For edge k of a triangle, opposite to point k, its place among the edges of its smaller point;
  /// FarPlace if it does not fit.
  HandleVector<TriangleId, std::array<unsigned char, 3>> EdgePlaces;
  static constexpr unsigned char FarPlace = 255;

  HandleVector<TetrahedronId, double> TetrahedronValue;
  HandleVector<TriangleId, double> TriangleValue;
  HandleVector<EdgeId, double> EdgeValue;

  HandleVector<TriangleId, TriangleRank> RankOfTriangle; ///< FiltrationPairs alone needs it
  HandleVector<EdgeId, EdgeRank> RankOfEdge;
  HandleVector<TriangleRank, TriangleId> TrianglesInOrder; ///< inverse of RankOfTriangle
  HandleVector<EdgeRank, EdgeId> EdgesInOrder;

  /// Ranks a simplex below all others, regardless of its value; used for a surface that is kept as
  /// a subcomplex.
  HandleVector<EdgeId, char> EdgeFirst;
  HandleVector<TriangleId, char> TriangleFirst;

  /// Simplices that samples do not distinguish from their surface (DelaunayFiltration.h). Their
  /// ranks, by which loops are paired, are below all others; voids are paired by values alone.
  HandleVector<EdgeId, char> EdgeIndistinct;
  HandleVector<TriangleId, char> TriangleIndistinct;
  HandleVector<TetrahedronId, char> TetrahedronIndistinct;

  /// Throws std::runtime_error beyond 2^29 tetrahedra.
  void RequireNumbers() const;

  /// Derives triangles and edges from tetrahedra and their neighbours. O(n), about 100 bytes for
  /// each tetrahedron in total. Calls RequireNumbers().
  void Connect(const ProgressCallback& progress = {});

  /// Sorts triangles and edges by SimplexOrder(), indistinct ones first. O(n).
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT void Order(const ProgressCallback& progress = {});

  /// The edge between two points, or None.
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT EdgeId FindEdge(SimplexId a, SimplexId b) const;

  /// The edges whose smaller point is `point`.
  HandleRange<EdgeId> EdgesAbove(SimplexId point) const
  {
    const auto p = static_cast<std::size_t>(point);
    return { this->FirstEdge[p].Value, this->FirstEdge[p + 1].Value };
  }

  /// The triangle opposite to a corner of a tetrahedron. By bisection among about 20 ids.
  TriangleId GetTriangle(TetrahedronId cell, std::size_t corner) const;

  std::size_t TriangleCount() const { return this->TriangleFaces.size(); }
  HandleRange<TriangleId> Triangles() const { return this->TriangleFaces.Keys(); }

  /// Ascending.
  std::array<SimplexId, 3> TrianglePoints(TriangleId triangle) const;

  /// Edge k is opposite to point k.
  std::array<EdgeId, 3> TriangleEdges(TriangleId triangle) const;

  /// The tetrahedra on both sides of a triangle, the smaller id first; None (the exterior) comes
  /// second.
  std::array<TetrahedronId, 2> TriangleSides(TriangleId triangle) const
  {
    const auto face = static_cast<std::uint32_t>(this->TriangleFaces[triangle]);
    const auto first = TetrahedronId::At(face / 4);
    return { first, this->Neighbours[first][face % 4] };
  }

  /// The tetrahedron on the other side of `triangle`; None for the exterior.
  TetrahedronId Across(TriangleId triangle, TetrahedronId cell) const
  {
    const auto sides = this->TriangleSides(triangle);
    return sides[0] == cell ? sides[1] : sides[0];
  }

  /// True if tetrahedron `a` enters after `b`.
  bool EntersLater(TetrahedronId a, TetrahedronId b) const
  {
    const double atA = this->TetrahedronValue[a];
    const double atB = this->TetrahedronValue[b];
    return atA != atB ? atA > atB : a > b;
  }

  /// The same for triangles. @pre They have values.
  bool EntersLater(TriangleId a, TriangleId b) const
  {
    const bool firstA = !this->TriangleFirst.empty() && this->TriangleFirst[a] != 0;
    const bool firstB = !this->TriangleFirst.empty() && this->TriangleFirst[b] != 0;
    if (firstA || firstB)
    {
      return firstA == firstB ? a > b : firstB;
    }
    const double atA = this->TriangleValue[a];
    const double atB = this->TriangleValue[b];
    return atA != atB ? atA > atB : a > b;
  }

  /// True if `a` has a higher rank than `b`. @pre They have values.
  bool RanksAbove(TriangleId a, TriangleId b) const
  {
    const bool differ = !this->TriangleIndistinct.empty() &&
      this->TriangleIndistinct[a] != this->TriangleIndistinct[b];
    return differ ? this->TriangleIndistinct[b] != 0 : this->EntersLater(a, b);
  }

  /// Frees what only the search for pairs and features needs: EdgeValue and TetrahedronValue.
  void DropEdgeAndCellValues()
  {
    HandleVector<EdgeId, double>().swap(this->EdgeValue);
    HandleVector<TetrahedronId, double>().swap(this->TetrahedronValue);
  }

  /// Frees RankOfTriangle.
  void DropTriangleRanks() { HandleVector<TriangleId, TriangleRank>().swap(this->RankOfTriangle); }

  /// The corner of tetrahedron `cell` that is not on `triangle`, one of its faces.
  SimplexId Opposite(TetrahedronId cell, const std::array<SimplexId, 3>& triangle) const
  {
    const auto& corners = this->Tetrahedra[cell];
    return *std::find_if(corners.begin(), corners.end(),
      [&triangle](SimplexId p)
      { return p != triangle[0] && p != triangle[1] && p != triangle[2]; });
  }
};

inline TriangleId CellFiltration::GetTriangle(TetrahedronId cell, std::size_t corner) const
{
  TetrahedronId first = cell;
  if (const TetrahedronId other = this->Neighbours[cell][corner]; other.Exists() && other < cell)
  {
    const auto& back = this->Neighbours[other];
    first = other;
    corner = static_cast<std::size_t>(std::find(back.begin(), back.end(), cell) - back.begin());
  }
  const std::size_t block = first.Index() / CellsPerBlock;
  const auto begin = this->TriangleFaces.begin();
  const auto face = static_cast<std::uint32_t>(4 * first.Index() + corner);
  const auto at =
    std::lower_bound(begin + this->TriangleBlocks[block], begin + this->TriangleBlocks[block + 1],
      face, [](SimplexId a, std::uint32_t b) { return static_cast<std::uint32_t>(a) < b; });
  return TriangleId(static_cast<SimplexId>(at - begin));
}

inline std::array<SimplexId, 3> CellFiltration::TrianglePoints(TriangleId triangle) const
{
  const auto face = static_cast<std::uint32_t>(this->TriangleFaces[triangle]);
  const auto& corners = this->Tetrahedra[TetrahedronId::At(face / 4)];
  const SimplexId a = corners[(face + 1) % 4];
  const SimplexId b = corners[(face + 2) % 4];
  const SimplexId c = corners[(face + 3) % 4];
  const SimplexId low = std::min(a, b);
  const SimplexId high = std::max(a, b);
  return { std::min(low, c), std::max(low, std::min(high, c)), std::max(high, c) };
}

inline std::array<EdgeId, 3> CellFiltration::TriangleEdges(TriangleId triangle) const
{
  const auto p = this->TrianglePoints(triangle);
  const auto& places = this->EdgePlaces[triangle];
  const auto edge = [this](SimplexId small, SimplexId large, unsigned char place)
  {
    return place == FarPlace
      ? this->FindEdge(small, large)
      : EdgeId(this->FirstEdge[static_cast<std::size_t>(small)].Value + place);
  };
  return { edge(p[1], p[2], places[0]), edge(p[0], p[2], places[1]), edge(p[0], p[1], places[2]) };
}

}

#endif
