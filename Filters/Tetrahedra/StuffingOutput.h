/**
 * @file StuffingOutput.h
 * @brief Gathers the tetrahedra of isosurface stuffing into a mesh of shared points.
 */
#ifndef isthmus_StuffingOutput_h
#define isthmus_StuffingOutput_h

#include "Core/TetrahedralMesh.h"
#include "Tetrahedra/StuffingStencils.h"

#include <unordered_map>

namespace isthmus
{

class StuffingOutput
{
public:
  StuffingOutput(const StuffingWarp& warp, MeshedSide side)
    : Warp(warp)
    , Wanted(side)
  {
  }

  /// What the surface leaves of `t` on the sides wanted.
  void AddCut(const LatticeTetrahedron& t);
  /// A tetrahedron that the surface does not come near, on the side given (1 or -1).
  void AddWhole(const LatticeTetrahedron& t, int side);

  bool Wants(int side) const
  {
    return this->Wanted == MeshedSide::Both || (side > 0) == (this->Wanted == MeshedSide::Inside);
  }
  const std::vector<bool>& OnSurface() const { return this->Surface; }
  TetrahedralMesh& Mesh() { return this->Result; }

private:
  void Insert(const StuffingPiece& piece, int side);
  std::int64_t PointId(const StuffingCorner& corner);

  const StuffingWarp& Warp;
  MeshedSide Wanted;
  TetrahedralMesh Result;
  std::vector<bool> Surface; ///< of each point: is it on the level set?
  std::unordered_map<std::uint64_t, std::int64_t> Ids;
  std::vector<StuffingPiece> Pieces;
};

}

#endif
