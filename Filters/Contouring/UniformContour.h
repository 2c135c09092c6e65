/**
 * @file UniformContour.h
 * @brief Dual contouring of all cells of a grid: pieces of surface, their vertices, and
 * quadrilaterals.
 *
 * Each step is a class in this file: DualCells groups the crossed edges of each cell into pieces of
 * surface, VertexPlacement places a vertex for each piece, and UniformContour connects them.
 */
#ifndef isthmus_UniformContour_h
#define isthmus_UniformContour_h

#include "Contouring/DualContouringParameters.h"
#include "Contouring/HermiteGrid.h"
#include "Contouring/QuadricError.h"
#include "Core/Geometry.h"
#include "Core/Handles.h"
#include "Core/Progress.h"
#include "Surfaces/SurfaceCrossings.h"

#include <functional>
#include <set>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// The pieces of surface in each cell of a grid: one vertex of dual contouring each.
//
// Crossed edges of a cell belong together if a piece of surface connects them across the faces. A
// face crossed four times is ambiguous. Its inside corners are separated, unless that would connect
// two cells twice over the face; then its outside corners are separated. Thus every edge of the
// contour belongs to two polygons (S. Schaefer, T. Ju, J. Warren, IEEE TVCG 13 (2007) 610,
// doi:10.1109/TVCG.2007.1012; R. Wenger, Isosurfaces, 2013).

/// Edge 4 a + p + 2 q of a cell runs along axis a and is shifted by p steps along axis a+1 and q
/// steps along a+2.
constexpr std::size_t CellEdges = 12;
using DualEdge = Handle<struct DualEdgeKind, std::size_t>;

class DualCells
{
public:
  using Index = std::array<std::int64_t, 3>;
  static constexpr signed char NoPiece = -1;

  explicit DualCells(const HermiteGrid& grid);

  /// Cells that the surface crosses, by the id of their lowest node, ascending.
  const std::vector<std::int64_t>& Active() const { return this->Cells; }
  /// For each of them, the piece to which each edge belongs, counted from 0.
  const std::vector<std::array<signed char, CellEdges>>& Pieces() const
  {
    return this->PieceOfEdge;
  }

  /// Index of a cell in Active().
  /// @pre it is in the list.
  std::size_t Find(std::int64_t cell) const;

  Index GetIndex(std::int64_t node) const;
  std::int64_t GetNode(const Index& index) const;
  /// Lowest node of an edge of a cell.
  std::int64_t NodeOfEdge(std::int64_t cell, DualEdge edge) const;
  bool IsInside(std::int64_t node) const
  {
    return this->Grid.Inside[static_cast<std::size_t>(node)] != 0;
  }
  bool IsCrossed(std::int64_t node, std::size_t axis) const
  {
    return this->IsInside(node) != this->IsInside(node + this->Stride[axis]);
  }

private:
  /// The edges of a face in pairs that belong together, and the number of crossed edges.
  struct Face
  {
    std::array<std::size_t, 4> Pairs;
    int Crossed;
  };

  void FindActive();
  Face GetFace(std::int64_t cell, std::size_t axis, std::size_t side) const;
  std::array<signed char, CellEdges> GetPieces(std::int64_t cell) const;
  bool FlipDoubleFaces();

  const HermiteGrid& Grid;
  std::array<std::int64_t, 3> Stride;
  std::vector<std::int64_t> Cells;
  std::vector<std::array<signed char, CellEdges>> PieceOfEdge;
  std::set<std::pair<std::int64_t, std::size_t>> Turned; ///< faces: lowest node and axis
};

//--------------------------------------------------------------------------------------------------
// Position of a point of dual contouring in its cell, or in an empty cell next to it.
//
// A vertex is placed where the planes of its crossings meet best. If that is outside its cell, in a
// cell without crossings, the vertex may stay there: an edge that extends through a face of a cell
// without crossing a line of the grid has its point there, and no other cell has one. If no edges
// are known, it may move to any adjacent cell in which all its planes, more than would generally
// meet, pass within 0.02 spacings of one point of an edge or corner. Otherwise it is kept in its
// cell. If sharp edges or corners of the surface are known, the vertex is placed on the one in that
// cell that best fits its planes; this is exact even if the planes, of curved faces, are not. It
// moves to an adjacent cell only if they pass within 0.05 spacings of that edge.

struct PlacedVertex
{
  Point3 At;
  bool IsSharp; ///< on a sharp edge or corner that was known
};

class VertexPlacement
{
public:
  /// The object keeps references to the arguments.
  VertexPlacement(
    const HermiteGrid& grid, const DualCells& cells, const DualContouringParameters& parameters);

  /// The vertex for piece `i` of the `count` pieces in an active cell. The planes are the tangent
  /// planes or those that meet better (QuadricError.h). O(log n)
  PlacedVertex Place(
    std::int64_t cell, const QuadricError* pieces, std::size_t count, std::size_t i) const;
  /// The same, but always in the cell, regardless of other cells.
  Point3 Inside(std::int64_t cell, const QuadricError& planes) const;

private:
  bool IsEmpty(std::int64_t cell) const;
  /// Whether the planes pass within `spacings` of `x`, as a root mean square.
  bool AllPassNear(const QuadricError& planes, const Point3& x, double spacings) const;
  /// Whether there are more planes than needed to define an edge or corner, and all of them pass
  /// near `x`.
  bool MeetOnEdge(const QuadricError& planes, const Point3& x) const;

  const HermiteGrid& Grid;
  const DualCells& Cells;
  const DualContouringParameters& Parameters;
  const SharpFeatureGrid Features;
};

//--------------------------------------------------------------------------------------------------
// Dual contouring on every cell of a grid: the input for merging cells, or the result.

/// A contour with one point for each piece of surface in a cell, and one quadrilateral for each
/// crossed edge.
struct UniformContour
{
  using Index = std::array<std::int64_t, 3>;

  /// An edge of the grid that the surface crosses and that has cells on all sides.
  struct Edge
  {
    std::array<std::int64_t, 4> Around; ///< its points, counter-clockwise seen from outside
    Point3 Crossing;                    ///< a thousandth of the edge away from its ends at least
    Point3 Normal;
  };

  GridShape Shape;
  std::vector<Index> Cells;         ///< of each point: its cell's lowest node
  std::vector<QuadricError> Errors; ///< of each point: the tangent planes of its crossings
  std::vector<Point3> Points;       ///< where these are least in the cell
  std::vector<char> IsSharp;        ///< of each point: on a known sharp edge or corner
  std::vector<Edge> Edges;
};

/**
 * O(cells + crossings log crossings), points in parallel that are bitwise the same on any number of
 * threads; 400 bytes for each point.
 * @throws std::runtime_error if inside and crossings contradict each other, and Cancelled.
 */
UniformContour MakeUniformContour(const HermiteGrid& grid,
  const DualContouringParameters& parameters, const ProgressCallback& progress);

}

#endif
