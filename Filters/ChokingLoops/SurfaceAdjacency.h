/**
 * @file SurfaceAdjacency.h
 * @brief Half edges of a closed triangle surface: who is beside, round a point, along an edge.
 */
#ifndef isthmus_SurfaceAdjacency_h
#define isthmus_SurfaceAdjacency_h

#include "CellFiltration.h"
#include "SurfaceView.h"

namespace isthmus
{

/**
 * Half edge 3 t + k runs from corner k of triangle t to corner k + 1 (mod 3); t lies to its left.
 *
 * The surface must be closed, manifold and oriented (FindDefects() (SurfaceCheck.h)).
 */
class SurfaceAdjacency
{
public:
  /// O(n log n), 28 bytes a half edge. @pre The owner of `mesh` outlives this object.
  VTKISTHMUS_EXPORT explicit SurfaceAdjacency(const SurfaceView& mesh);
  explicit SurfaceAdjacency(TriangleMesh&& mesh) = delete;

  const SurfaceView& Mesh() const { return this->Surface; }
  SimplexId HalfEdges() const { return static_cast<SimplexId>(this->Opposites.size()); }
  SimplexId Edges() const { return this->EdgeCount; }

  static SimplexId Triangle(SimplexId h) { return h / 3; }
  static SimplexId Next(SimplexId h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static SimplexId Previous(SimplexId h) { return h % 3 == 0 ? h + 2 : h - 1; }

  SimplexId Opposite(SimplexId h) const { return this->Opposites[static_cast<std::size_t>(h)]; }
  /// The edge that h and its opposite share, numbered from 0.
  SimplexId Edge(SimplexId h) const { return this->EdgeIds[static_cast<std::size_t>(h)]; }
  /// One of the two half edges of an edge.
  SimplexId HalfEdgeOf(SimplexId edge) const
  {
    return this->Halves[static_cast<std::size_t>(edge)];
  }
  SimplexId From(SimplexId h) const;
  SimplexId To(SimplexId h) const { return this->From(Next(h)); }
  /// Some half edge that leaves point p; -1 when no triangle uses it.
  SimplexId Leaving(SimplexId p) const { return this->Outgoing[static_cast<std::size_t>(p)]; }
  /// The next half edge that leaves From(h), counter-clockwise seen from outside.
  SimplexId Turn(SimplexId h) const { return this->Opposite(Previous(h)); }

  double Length(SimplexId h) const;

  /// The half edge from a to b, or -1. Time: the valence of a.
  VTKISTHMUS_EXPORT SimplexId Find(SimplexId a, SimplexId b) const;

private:
  SurfaceView Surface;
  std::vector<SimplexId> Opposites;
  std::vector<SimplexId> EdgeIds;
  std::vector<SimplexId> Halves;
  std::vector<SimplexId> Outgoing;
  SimplexId EdgeCount = 0;
};

inline SimplexId SurfaceAdjacency::From(SimplexId h) const
{
  return static_cast<SimplexId>(
    this->Surface.Triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)]);
}

}

#endif
