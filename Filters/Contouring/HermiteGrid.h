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

/// The cube of `size` cells each way at `index`, grown by `reach` of its sides, within the grid
/// grown by `reach` cells.
Bounds3 CellBox(const GridShape& shape, const std::array<std::int64_t, 3>& index, std::int64_t size,
  double reach);

/// Lowest node of the cell that `x` lies in, -1 outside the grid.
std::int64_t CellAt(const GridShape& grid, const Point3& x);

//--------------------------------------------------------------------------------------------------
// The edges and corners of a triangle surface over which its normal jumps.

struct SharpEdges
{
  std::vector<std::array<Point3, 2>> Segments;
  /// Where one, three or more segments end, or two that turn by more than the angle.
  std::vector<Point3> Corners;
};

/// Where a surface crosses the lines of a grid, with its normals there ("Hermite data").
struct HermiteGrid
{
  GridShape Shape;
  std::vector<unsigned char> Inside;   ///< of each node: 1 inside, else 0
  std::vector<GridCrossing> Crossings; ///< ordered by node and axis; normals outward
  SharpEdges Sharp;                    ///< where known: points of their cells go there
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

//--------------------------------------------------------------------------------------------------
// The sharp edges and corners in each cell of a grid.

class SharpFeatureGrid
{
public:
  /// What is outside the grid is left out. O(n log n) for n pieces of edge, 60 bytes each.
  SharpFeatureGrid(const SharpEdges& sharp, const GridShape& grid);

  using Filter = std::function<bool(const Point3&)>;

  /// The corner in `cell` (id of its lowest node) nearest to `x`, of those that `isMine`.
  std::optional<Point3> NearestCorner(
    std::int64_t cell, const Point3& x, const Filter& isMine) const;
  /// Which of a cell's edges count: the tenth of a piece beside each face is left to neighbours, so
  /// that no two cells take the same point.
  enum class Part
  {
    Middle,
    Whole
  };
  /// The nearest point of the edges in `cell`, of those pieces whose middle `isMine`.
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
