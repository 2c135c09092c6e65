/**
 * @file SurfaceInComplex.h
 * @brief From edges of a surface to edges of the complex of its points, and back.
 */
#ifndef isthmus_SurfaceInComplex_h
#define isthmus_SurfaceInComplex_h

#include "ChokingLoops/SurfaceAdjacency.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// The surface's points are points of the complex, with the same ids; its edges and triangles need
/// not be simplices of it.
class SurfaceInComplex
{
public:
  /// O(n). Keeps references to both.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceInComplex(const SurfaceAdjacency& surface,
    const CellFiltration& f, const ProgressCallback& progress = {});

  /// The surface's edge that an edge of the complex is, or None.
  SurfaceEdgeId SurfaceEdge(EdgeId edge) const { return this->OnSurface[edge]; }

  /**
   * Edges of the complex that replace an edge of the surface: itself, or the Delaunay edges between
   * the Voronoi cells that it passes. Each of these enters before half the edge's length, and the
   * path can be deformed into the edge within the balls of that radius.
   */
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeChain Image(SurfaceEdgeId surfaceEdge) const;

  /// Shortest path of surface edges between two points of the surface, at most `reach` long; empty
  /// when there is none.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<SurfaceEdgeId> ShortestPath(
    SimplexId from, SimplexId to, double reach) const;

private:
  const SurfaceAdjacency& Surface;
  const CellFiltration& F;
  HandleVector<EdgeId, SurfaceEdgeId> OnSurface;
  HandleVector<SurfaceEdgeId, EdgeId> InComplex;
  std::vector<SimplexId> FirstSmaller; ///< edges whose larger point is p, in SmallerEdges
  std::vector<EdgeId> SmallerEdges;
};

}

#endif
