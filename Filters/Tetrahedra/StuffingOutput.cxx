#include "Tetrahedra/StuffingOutput.h"

namespace isthmus
{

std::int64_t StuffingOutput::PointId(const StuffingCorner& corner)
{
  // Points and middles of edges, in quarters of a cell, all differ: 21 bits for each number.
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    key |= static_cast<std::uint64_t>(corner.From[axis] + corner.To[axis]) << (21 * axis);
  }
  const auto [known, isNew] =
    this->Ids.emplace(key, static_cast<std::int64_t>(this->Result.Points.size()));
  if (isNew)
  {
    this->Result.Points.push_back(PositionOf(this->Warp, corner));
    this->Surface.push_back(corner.IsCrossing() || this->Warp.Side(corner.From) == 0);
  }
  return known->second;
}

void StuffingOutput::Insert(const StuffingPiece& piece, int side)
{
  Tetrahedron t;
  for (std::size_t c = 0; c < 4; ++c)
  {
    t[c] = this->PointId(piece[c]);
  }
  const auto at = [&](std::size_t c)
  { return this->Result.Points[static_cast<std::size_t>(t[c])]; };
  if (Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) < 0.0)
  {
    std::swap(t[2], t[3]);
  }
  this->Result.Tetrahedra.push_back(t);
  this->Result.Regions.push_back(side > 0 ? 1 : 0);
}

void StuffingOutput::AddWhole(const LatticeTetrahedron& t, int side)
{
  this->Insert({ { { t[0], t[0] }, { t[1], t[1] }, { t[2], t[2] }, { t[3], t[3] } } }, side);
}

void StuffingOutput::AddCut(const LatticeTetrahedron& t)
{
  for (const int side : { 1, -1 })
  {
    if (this->Wants(side))
    {
      this->Pieces.clear();
      CutTetrahedron(this->Warp, t, side, this->Pieces);
      for (const StuffingPiece& piece : this->Pieces)
      {
        this->Insert(piece, side);
      }
    }
  }
}

}
