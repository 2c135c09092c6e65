/**
 * @file UniformContour.h
 * @brief Dual contouring of all cells of a grid: surface pieces, their vertices, quadrilaterals.
 *
 * The steps are those of the classes here: DualCells groups the crossed edges of each cell into
 * pieces of surface, VertexPlacement puts a vertex for each piece, UniformContour connects them.
 */
#ifndef isthmus_UniformContour_h
#define isthmus_UniformContour_h

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
// Parameters of dual contouring.

struct DualContouringParameters
{
  /// Directions in which the normals of a cell vary less than this part of how they vary most are
  /// left to the mean of its crossings: 0 (all noise is a feature) to 1 (none is). 0.07: an edge of
  /// 30 degrees, tan^2 of half the angle (HermiteGrid.h).
  double FeatureThreshold = 0.07;
  /// Spacings by which a vertex may leave its cell, 0 to 1, whatever is there (at 0: only into
  /// empty cells and to known edges, UniformContour.h); polygons cross more easily above 0.
  double Reach = 0.0;
  bool Triangles = true; ///< quadrilaterals cut in two, else as they are
  /// How far the surface may be from that of the whole grid, a length: above 0, cells are put
  /// together (octree) where that allows it. 0: none are.
  double Tolerance = 0.0;
  /// No two triangles cross: quadrilaterals around which they do are cut into triangles that each
  /// stay in a cell. Triangles only.
  bool FreeOfCrossings = false;
  /// Moves points of the grid's frame to where they are wanted; empty: they stay. Point by point.
  std::function<void(std::vector<Point3>& points)> ToWorld;
};

//--------------------------------------------------------------------------------------------------
// The pieces of surface in each cell of a grid: one vertex of dual contouring each.
//
// Edges of a cell that the surface crosses belong together when a piece of surface connects them
// across the faces. A face crossed four times is ambiguous; its inside corners are kept apart,
// unless that would join two cells twice over the face, where its outside corners are: so every
// edge of the contour belongs to two polygons (S. Schaefer, T. Ju, J. Warren, IEEE TVCG 13 (2007)
// 610, doi:10.1109/TVCG.2007.1012; R. Wenger, Isosurfaces, 2013).

/// Edge 4 a + p + 2 q of a cell runs along axis a, p steps up along axis a+1 and q along a+2.
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
  /// For each of them, the piece that each edge belongs to, from 0.
  const std::vector<std::array<signed char, CellEdges>>& Pieces() const
  {
    return this->PieceOfEdge;
  }

  /// Place of a cell in Active(). @pre it is there.
  std::size_t Find(std::int64_t cell) const;

  Index IndexOf(std::int64_t node) const;
  std::int64_t NodeOf(const Index& index) const;
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
  /// The edges of a face, two and two that belong together; how many of the four are crossed.
  struct Face
  {
    std::array<std::size_t, 4> Pairs;
    int Crossed;
  };

  void FindActive();
  Face FaceOf(std::int64_t cell, std::size_t axis, std::size_t side) const;
  std::array<signed char, CellEdges> PiecesOf(std::int64_t cell) const;
  bool TurnDoubleFaces();

  const HermiteGrid& Grid;
  std::array<std::int64_t, 3> Stride;
  std::vector<std::int64_t> Cells;
  std::vector<std::array<signed char, CellEdges>> PieceOfEdge;
  std::set<std::pair<std::int64_t, std::size_t>> Turned; ///< faces: lowest node and axis
};

//--------------------------------------------------------------------------------------------------
// Where in its cell, or in an empty one beside it, a point of dual contouring goes.
//
// It goes where the planes of its crossings meet best. Where that is outside its cell, in one that
// no crossing bounds, it may stay there: an edge that pokes through a face of a cell without
// crossing a line of the grid has its point there, and nobody else has one. It may go to any cell
// beside its own where no edges are known and all its planes, more than would meet by themselves,
// pass within 0.02 spacings of one point of an edge or corner. Otherwise it is kept in its cell.
// Where sharp edges or corners of the surface are known, it goes to the one in that cell that fits
// its planes best, which is exact where these, of faces that bend, are not; into the cell beside
// its own only where they pass within 0.05 spacings of that edge.

struct PlacedVertex
{
  Point3 At;
  bool IsSharp; ///< on a sharp edge or corner that was known
};

class VertexPlacement
{
public:
  /// The arguments are kept by reference.
  VertexPlacement(
    const HermiteGrid& grid, const DualCells& cells, const DualContouringParameters& parameters);

  /// For piece `i` of the `count` pieces in the active cell `cell` with these planes, which are the
  /// tangent ones or those that meet better (QuadricError.h). O(log n)
  PlacedVertex Place(
    std::int64_t cell, const QuadricError* pieces, std::size_t count, std::size_t i) const;
  /// The same, but in the cell, whatever is in the others.
  Point3 Inside(std::int64_t cell, const QuadricError& planes) const;

private:
  bool IsEmpty(std::int64_t cell) const;
  /// Do the planes pass within `spacings` of `x`, in the mean of squares?
  bool PassBy(const QuadricError& planes, const Point3& x, double spacings) const;
  /// Are there more planes than an edge or corner needs, and do all pass by `x`?
  bool MeetOnEdge(const QuadricError& planes, const Point3& x) const;

  const HermiteGrid& Grid;
  const DualCells& Cells;
  const DualContouringParameters& Parameters;
  const SharpFeatureGrid Features;
};

//--------------------------------------------------------------------------------------------------
// Dual contouring on every cell of a grid: what cells are put together from, or the result.

/// One point for each piece of surface in a cell, one quadrilateral for each crossed edge.
struct UniformContour
{
  using Index = std::array<std::int64_t, 3>;

  /// An edge of the grid that the surface crosses, with cells all around.
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
 * threads; 400 bytes a point.
 * @throws std::runtime_error where inside and crossings contradict each other, and Cancelled.
 */
UniformContour MakeUniformContour(const HermiteGrid& grid,
  const DualContouringParameters& parameters, const ProgressCallback& progress);

}

#endif
