#include "Contouring/DualCells.h"

#include <numeric>

namespace isthmus
{

DualCells::DualCells(const HermiteGrid& grid)
  : Grid(grid)
  , Stride{ 1, grid.Shape.Dimensions[0], grid.Shape.Dimensions[0] * grid.Shape.Dimensions[1] }
{
  this->FindActive();
  constexpr int mostRounds = 8; // each turns faces of other cells than the one before
  for (int round = 0; round < mostRounds; ++round)
  {
    this->PieceOfEdge.clear();
    for (const std::int64_t cell : this->Cells)
    {
      this->PieceOfEdge.push_back(this->PiecesOf(cell));
    }
    if (!this->TurnDoubleFaces())
    {
      break;
    }
  }
}

DualCells::Index DualCells::IndexOf(std::int64_t node) const
{
  return { node % this->Stride[1], node % this->Stride[2] / this->Stride[1],
    node / this->Stride[2] };
}

std::int64_t DualCells::NodeOf(const Index& i) const
{
  return i[0] + i[1] * this->Stride[1] + i[2] * this->Stride[2];
}

std::int64_t DualCells::NodeOfEdge(std::int64_t cell, DualEdge edge) const
{
  const std::size_t axis = edge.Value / 4;
  return cell + static_cast<std::int64_t>(edge.Value & 1) * this->Stride[(axis + 1) % 3] +
    static_cast<std::int64_t>(edge.Value >> 1 & 1) * this->Stride[(axis + 2) % 3];
}

std::size_t DualCells::Find(std::int64_t cell) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->Cells.begin(), this->Cells.end(), cell) - this->Cells.begin());
}

void DualCells::FindActive()
{
  const auto& n = this->Grid.Shape.Dimensions;
  for (std::int64_t k = 0; k + 1 < n[2]; ++k)
  {
    for (std::int64_t j = 0; j + 1 < n[1]; ++j)
    {
      for (std::int64_t i = 0; i + 1 < n[0]; ++i)
      {
        const std::int64_t cell = this->NodeOf({ i, j, k });
        int inside = 0;
        for (std::size_t corner = 0; corner < 8; ++corner)
        {
          inside += this->IsInside(cell + static_cast<std::int64_t>(corner & 1) +
                      static_cast<std::int64_t>(corner >> 1 & 1) * this->Stride[1] +
                      static_cast<std::int64_t>(corner >> 2) * this->Stride[2])
            ? 1
            : 0;
        }
        if (inside > 0 && inside < 8)
        {
          this->Cells.push_back(cell);
        }
      }
    }
  }
}

DualCells::Face DualCells::FaceOf(std::int64_t cell, std::size_t axis, std::size_t side) const
{
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  // Around the face: below, right, above, left.
  const std::array<std::size_t, 4> edges{ 4 * u + 2 * side, 4 * v + side + 2, 4 * u + 1 + 2 * side,
    4 * v + side };
  Face face{ {}, 0 };
  std::array<std::size_t, 4> crossed;
  for (const std::size_t edge : edges)
  {
    if (this->IsCrossed(this->NodeOfEdge(cell, DualEdge(edge)), edge / 4))
    {
      crossed[static_cast<std::size_t>(face.Crossed++)] = edge;
    }
  }
  if (face.Crossed == 2)
  {
    face.Pairs = { crossed[0], crossed[1], 0, 0 };
  }
  if (face.Crossed == 4)
  {
    const std::int64_t corner = cell + static_cast<std::int64_t>(side) * this->Stride[axis];
    const bool turned = this->Turned.count({ corner, axis }) > 0;
    // The corner between left and below: is it cut off alone?
    face.Pairs = this->IsInside(corner) != turned
      ? std::array<std::size_t, 4>{ edges[3], edges[0], edges[1], edges[2] }
      : std::array<std::size_t, 4>{ edges[0], edges[1], edges[2], edges[3] };
  }
  return face;
}

std::array<signed char, CellEdges> DualCells::PiecesOf(std::int64_t cell) const
{
  std::array<std::size_t, CellEdges> parent;
  std::iota(parent.begin(), parent.end(), std::size_t{ 0 });
  const auto root = [&parent](std::size_t e)
  {
    while (parent[e] != e)
    {
      e = parent[e];
    }
    return e;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const std::size_t side : { 0u, 1u })
    {
      const Face face = this->FaceOf(cell, axis, side);
      for (int pair = 0; pair < face.Crossed / 2; ++pair)
      {
        const auto at = static_cast<std::size_t>(2 * pair);
        parent[root(face.Pairs[at])] = root(face.Pairs[at + 1]);
      }
    }
  }
  std::array<signed char, CellEdges> pieces, names;
  pieces.fill(NoPiece);
  names.fill(NoPiece);
  signed char next = 0;
  for (std::size_t e = 0; e < CellEdges; ++e)
  {
    if (this->IsCrossed(this->NodeOfEdge(cell, DualEdge(e)), e / 4))
    {
      signed char& name = names[root(e)];
      name = name == NoPiece ? next++ : name;
      pieces[e] = name;
    }
  }
  return pieces;
}

/// Faces over which two cells are joined twice are turned; were there any?
bool DualCells::TurnDoubleFaces()
{
  bool any = false;
  for (std::size_t c = 0; c < this->Cells.size(); ++c)
  {
    const std::int64_t cell = this->Cells[c];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const Face face = this->FaceOf(cell, axis, 0);
      if (face.Crossed != 4 || this->IndexOf(cell)[axis] == 0 ||
        this->Turned.count({ cell, axis }) > 0)
      {
        continue;
      }
      const auto& mine = this->PieceOfEdge[c];
      const auto& theirs = this->PieceOfEdge[this->Find(cell - this->Stride[axis])];
      const Face other = this->FaceOf(cell - this->Stride[axis], axis, 1);
      if (mine[face.Pairs[0]] == mine[face.Pairs[2]] &&
        theirs[other.Pairs[0]] == theirs[other.Pairs[2]])
      {
        this->Turned.insert({ cell, axis });
        any = true;
      }
    }
  }
  return any;
}

}
