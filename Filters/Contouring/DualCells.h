/**
 * @file DualCells.h
 * @brief The pieces of surface in each cell of a grid: one vertex of dual contouring each.
 *
 * Edges of a cell that the surface crosses belong together when a piece of surface connects them
 * across the faces. A face crossed four times is ambiguous; its inside corners are kept apart,
 * unless that would join two cells twice over the face, where its outside corners are: so every
 * edge of the contour belongs to two polygons (S. Schaefer, T. Ju, J. Warren, IEEE TVCG 13 (2007)
 * 610, doi:10.1109/TVCG.2007.1012; R. Wenger, Isosurfaces, 2013).
 */
#ifndef isthmus_DualCells_h
#define isthmus_DualCells_h

#include "Contouring/DualContouringParameters.h"
#include "Core/Handles.h"

#include <set>

namespace isthmus
{

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

}

#endif
