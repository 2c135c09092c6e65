/**
 * @file ChainPieces.h
 * @brief Sets of triangles of a complex: their boundary, and what of them hangs together.
 */
#ifndef isthmus_ChainPieces_h
#define isthmus_ChainPieces_h

#include "ChokingLoops/SurfaceInComplex.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <set>

namespace isthmus
{

/// Adds an element over Z/2.
template <typename Id>
void Toggle(std::set<Id>& chain, Id e)
{
  if (!chain.erase(e))
  {
    chain.insert(e);
  }
}

/// Boundary of a set of triangles, over Z/2, ascending.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeChain BoundaryOf(
  const CellFiltration& f, const TriangleChain& triangles);

/// Of `triangles`, those that hang together with `seed` across edges that are not on M.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleChain PieceAround(const CellFiltration& f,
  const SurfaceInComplex& surface, const std::set<TriangleId>& triangles, TriangleId seed);

}

#endif
