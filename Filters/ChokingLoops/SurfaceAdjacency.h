/**
 * @file SurfaceAdjacency.h
 * @brief Half edges of a closed triangle surface: who is beside, round a point, along an edge.
 */
#ifndef isthmus_SurfaceAdjacency_h
#define isthmus_SurfaceAdjacency_h

#include "Core/SurfaceView.h"
#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// A side of a triangle seen from it: 3 t + k runs from corner k of triangle t.
using HalfEdgeId = Handle<struct SurfaceHalfEdge, SimplexId>;
/// Not an edge of the complex of the surface's points: SurfaceInComplex leads from one to the
/// other.
using SurfaceEdgeId = Handle<struct SurfaceEdge, SimplexId>;
using SurfaceTriangleId = Handle<struct SurfaceTriangle, SimplexId>;

/// A set of edges of a surface over Z/2.
using SurfaceChain = std::vector<SurfaceEdgeId>;

/**
 * Half edge 3 t + k runs from corner k of triangle t to corner k + 1 (mod 3); t lies to its left.
 *
 * The surface must be closed, manifold and oriented (FindDefects() (SurfaceCheck.h)).
 */
class SurfaceAdjacency
{
public:
  /// O(n log n), 28 bytes a half edge. @pre The owner of `mesh` outlives this object.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit SurfaceAdjacency(const SurfaceView& mesh);
  explicit SurfaceAdjacency(TriangleMesh&& mesh) = delete;

  const SurfaceView& Mesh() const { return this->Surface; }
  HandleRange<HalfEdgeId> HalfEdges() const { return this->Opposites.Keys(); }
  HandleRange<SurfaceEdgeId> Edges() const { return this->Halves.Keys(); }
  std::size_t EdgeCount() const { return this->Halves.size(); }

  static SurfaceTriangleId Triangle(HalfEdgeId h) { return SurfaceTriangleId(h.Value / 3); }
  static HalfEdgeId Next(HalfEdgeId h)
  {
    return HalfEdgeId(h.Value % 3 == 2 ? h.Value - 2 : h.Value + 1);
  }
  static HalfEdgeId Previous(HalfEdgeId h)
  {
    return HalfEdgeId(h.Value % 3 == 0 ? h.Value + 2 : h.Value - 1);
  }

  static HandleRange<HalfEdgeId> HalfEdgesOf(SurfaceTriangleId t)
  {
    return { 3 * t.Index(), 3 * t.Index() + 3 };
  }

  HalfEdgeId Opposite(HalfEdgeId h) const { return this->Opposites[h]; }
  /// The edge that h and its opposite share, numbered from 0.
  SurfaceEdgeId Edge(HalfEdgeId h) const { return this->EdgeIds[h]; }
  /// One of the two half edges of an edge.
  HalfEdgeId HalfEdgeOf(SurfaceEdgeId edge) const { return this->Halves[edge]; }
  SimplexId From(HalfEdgeId h) const;
  SimplexId To(HalfEdgeId h) const { return this->From(Next(h)); }
  /// Some half edge that leaves point p; None when no triangle uses it.
  HalfEdgeId Leaving(SimplexId p) const { return this->Outgoing[static_cast<std::size_t>(p)]; }
  /// The next half edge that leaves From(h), counter-clockwise seen from outside.
  HalfEdgeId Turn(HalfEdgeId h) const { return this->Opposite(Previous(h)); }

  double Length(HalfEdgeId h) const
  {
    return Distance(this->Surface.Points[static_cast<std::size_t>(this->From(h))],
      this->Surface.Points[static_cast<std::size_t>(this->To(h))]);
  }

  /// The half edge from a to b, or None. Time: the valence of a.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HalfEdgeId Find(SimplexId a, SimplexId b) const;

private:
  SurfaceView Surface;
  HandleVector<HalfEdgeId, HalfEdgeId> Opposites;
  HandleVector<HalfEdgeId, SurfaceEdgeId> EdgeIds;
  HandleVector<SurfaceEdgeId, HalfEdgeId> Halves;
  std::vector<HalfEdgeId> Outgoing; ///< by point
};

inline SimplexId SurfaceAdjacency::From(HalfEdgeId h) const
{
  return static_cast<SimplexId>(this->Surface.Triangles[h.Index() / 3][h.Index() % 3]);
}

}

#endif
