#include "Tetrahedra/StuffingAngles.h"

#include "Tetrahedra/MeshQuality.h"

namespace isthmus
{
namespace
{

bool IsMoved(const StuffingWarp& warp, const LatticePoint& p)
{
  return warp.Side(p) == 0;
}

class Straightener
{
public:
  Straightener(const StuffingLattice& lattice, StuffingWarp& warp)
    : Lattice(lattice)
    , Warp(warp)
    , Background(lattice)
  {
  }

  /// Goes through all tetrahedra near the surface once; were some points let go?
  bool Pass(const ProgressCallback& progress)
  {
    const std::int64_t before = this->Warp.Stayed();
    const std::int64_t layers = this->Lattice.Cells()[2];
    for (std::int64_t k = 0; k < layers; ++k)
    {
      Report(progress, static_cast<double>(k) / static_cast<double>(layers));
      this->Background.ForEachOctant(k, [&](const Octant& octant) { this->Visit(octant); });
    }
    return this->Warp.Stayed() > before;
  }

private:
  void Visit(const Octant& octant)
  {
    const LatticePoint& c = octant.First;
    if (octant.Level > 0 || !this->Lattice.IsNear(this->Lattice.Cell(c[0], c[1], c[2])))
    {
      return;
    }
    this->Tetrahedra.clear();
    this->Background.Append(octant, this->Tetrahedra);
    for (const LatticeTetrahedron& t : this->Tetrahedra)
    {
      while (this->IsBad(t))
      {
        this->LetGo(t);
      }
    }
  }

  bool IsBad(const LatticeTetrahedron& t)
  {
    const auto moved = std::count_if(
      t.begin(), t.end(), [this](const LatticePoint& p) { return IsMoved(this->Warp, p); });
    if (moved == 0 || moved == 4)
    {
      return moved == 4;
    }
    this->Pieces.clear();
    CutTetrahedron(this->Warp, t, 1, this->Pieces);
    CutTetrahedron(this->Warp, t, -1, this->Pieces);
    for (const StuffingPiece& piece : this->Pieces)
    {
      const CellAngles angles =
        MeasureTetrahedron(PositionOf(this->Warp, piece[0]), PositionOf(this->Warp, piece[1]),
          PositionOf(this->Warp, piece[2]), PositionOf(this->Warp, piece[3]));
      if (angles.Smallest < StuffingSmallestAngle || angles.Largest > StuffingLargestAngle)
      {
        return true;
      }
    }
    return false;
  }

  void LetGo(const LatticeTetrahedron& t)
  {
    const LatticePoint* farthest = nullptr;
    for (const LatticePoint& p : t)
    {
      if (IsMoved(this->Warp, p) &&
        (!farthest || this->Warp.MoveLength(p) > this->Warp.MoveLength(*farthest)))
      {
        farthest = &p;
      }
    }
    this->Warp.Keep(*farthest);
  }

  const StuffingLattice& Lattice;
  StuffingWarp& Warp;
  const StuffingBackground Background;
  std::vector<LatticeTetrahedron> Tetrahedra;
  std::vector<StuffingPiece> Pieces;
};

}

void KeepAngles(
  const StuffingLattice& lattice, StuffingWarp& warp, const ProgressCallback& progress)
{
  Straightener straightener(lattice, warp);
  double from = 0.0;
  bool again = true;
  while (again)
  {
    // Each pass has half of what is left of the bar.
    again = straightener.Pass(Between(progress, from, 0.5 * (1.0 + from)));
    from = 0.5 * (1.0 + from);
  }
}

}
