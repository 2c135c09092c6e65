/**
 * @file HermiteGrid.h
 * @brief The sharp edges and corners in each cell of a grid.
 */
#ifndef isthmus_HermiteGrid_h
#define isthmus_HermiteGrid_h

#include "Contouring/SharpEdges.h"
#include "Surfaces/SurfaceCrossings.h"

#include <functional>
#include <optional>

namespace isthmus
{

class ContourFeatures
{
public:
  /// What is outside the grid is left out. O(n log n) for n pieces of edge, 60 bytes each.
  ContourFeatures(const SharpEdges& sharp, const GridShape& grid);

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
