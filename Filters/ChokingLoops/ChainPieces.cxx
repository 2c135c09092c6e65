#include "ChainPieces.h"

#include "Index.h"

#include <map>

namespace isthmus
{
Chain BoundaryOf(const CellFiltration& f, const Chain& triangles)
{
  std::set<SimplexId> edges;
  for (const SimplexId t : triangles)
  {
    for (const SimplexId e : f.TriangleEdges[At(t)])
    {
      Toggle(edges, e);
    }
  }
  return { edges.begin(), edges.end() };
}

Chain PieceAround(const CellFiltration& f, const SurfaceInComplex& surface,
  const std::set<SimplexId>& triangles, SimplexId seed)
{
  std::map<SimplexId, std::vector<SimplexId>> beside; // per edge
  for (const SimplexId t : triangles)
  {
    for (const SimplexId e : f.TriangleEdges[At(t)])
    {
      beside[e].push_back(t);
    }
  }
  std::set<SimplexId> found{ seed };
  Chain piece{ seed };
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    for (const SimplexId e : f.TriangleEdges[At(piece[i])])
    {
      if (surface.SurfaceEdge(e) >= 0)
      {
        continue;
      }
      for (const SimplexId other : beside[e])
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
