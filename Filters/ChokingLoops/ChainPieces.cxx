#include "ChokingLoops/ChainPieces.h"

#include <map>

namespace isthmus
{
EdgeChain BoundaryOf(const CellFiltration& f, const TriangleChain& triangles)
{
  std::set<EdgeId> edges;
  for (const TriangleId t : triangles)
  {
    for (const EdgeId e : f.TriangleEdges[t])
    {
      Toggle(edges, e);
    }
  }
  return { edges.begin(), edges.end() };
}

TriangleChain PieceAround(const CellFiltration& f, const SurfaceInComplex& surface,
  const std::set<TriangleId>& triangles, TriangleId seed)
{
  std::map<EdgeId, TriangleChain> beside;
  for (const TriangleId t : triangles)
  {
    for (const EdgeId e : f.TriangleEdges[t])
    {
      beside[e].push_back(t);
    }
  }
  std::set<TriangleId> found{ seed };
  TriangleChain piece{ seed };
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    for (const EdgeId e : f.TriangleEdges[piece[i]])
    {
      if (surface.SurfaceEdge(e).Exists())
      {
        continue;
      }
      for (const TriangleId other : beside[e])
      {
        if (found.insert(other).second)
        {
          piece.push_back(other);
        }
      }
    }
  }
  return piece;
}

}
