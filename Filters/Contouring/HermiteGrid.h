/**
 * @file HermiteGrid.h
 * @brief Crossings of a surface with the lines of a grid, its normals there and its sharp edges.
 */
#ifndef isthmus_HermiteGrid_h
#define isthmus_HermiteGrid_h

#include "Core/Geometry.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/SurfaceCrossings.h"

#include <functional>
#include <optional>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// The box of a cell of a grid or octree, and the cell at a place.

/// The cube of `size` cells along each axis at `index`, enlarged by `reach` times its side, within
/// the grid enlarged by `reach` cells.
Bounds3 CellBox(const GridShape& shape, const std::array<std::int64_t, 3>& index, std::int64_t size,
  double reach);

/// Lowest node of the cell in which x lies, or -1 outside the grid.
std::int64_t CellAt(const GridShape& grid, const Point3& x);

//--------------------------------------------------------------------------------------------------
// The edges and corners of a triangle surface over which its normal jumps.

struct SharpEdges
{
  std::vector<std::array<Point3, 2>> Segments;
  /// Points at which one, three or more segments end, or two that turn by more than the angle.
  std::vector<Point3> Corners;
};

/// The crossings of a surface with the lines of a grid, with its normals there ("Hermite data").
struct HermiteGrid
{
  GridShape Shape;
  std::vector<unsigned char> Inside;   ///< of each node: 1 inside, else 0
  std::vector<GridCrossing> Crossings; ///< ordered by node and axis; normals outward
  SharpEdges Sharp;                    ///< where known: points of their cells are moved there
};

/**
 * Edges for which the cosine of the angle between the normals of the two triangles is below
 * `cosine`, and edges of more than two triangles. Points with the same position are merged;
 * triangles without area have no normal and are ignored. Ordered by the ids of the points. O(n log
 * n), 100 bytes for each triangle.
 */
SharpEdges FindSharpEdges(const SurfaceView& surface, double cosine);

/**
 * Cosine of the angle between two planes above which a cell of dual contouring treats them as one,
 * if both have the same number of crossings. The matrix n1 n1^T + n2 n2^T has the eigenvalues 1 + c
 * and 1 - c, and the smaller one is ignored if it is below `threshold` times the larger.
 */
inline double SharpCosine(double threshold)
{
  return (1.0 - threshold) / (1.0 + threshold);
}

//--------------------------------------------------------------------------------------------------
// The sharp edges and corners in each cell of a grid.

class SharpFeatureGrid
{
public:
  /// Parts outside the grid are dropped. O(n log n) for n pieces of edge, 60 bytes each.
  SharpFeatureGrid(const SharpEdges& sharp, const GridShape& grid);

  using Filter = std::function<bool(const Point3&)>;

  /// The corner in `cell` (id of its lowest node) that is nearest to `x`, among those accepted by
  /// `isMine`.
  std::optional<Point3> NearestCorner(
    std::int64_t cell, const Point3& x, const Filter& isMine) const;
  /// The part of the edges in a cell that is used: the tenth of a piece next to each face is left
  /// to neighbours, so that no two cells use the same point.
  enum class Part
  {
    Middle,
    Whole
  };
  /// The nearest point of the edges in `cell`, among the pieces whose midpoint is accepted by
  /// `isMine`.
  std::optional<Point3> NearestOnEdge(
    std::int64_t cell, const Point3& x, Part part, const Filter& isMine) const;

private:
  struct Piece
  {
    std::int64_t Cell;
    std::array<Point3, 2> Ends;
    std::array<bool, 2> IsAtFace; ///< of each end
  };
  struct Corner
  {
    std::int64_t Cell;
    Point3 Place;
  };

  void AddPieces(const std::array<Point3, 2>& segment, const GridShape& grid);

  std::vector<Piece> Pieces;
  std::vector<Corner> Corners;
};

}

#endif
