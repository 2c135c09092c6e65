/**
 * @file FiltrationPairs.h
 * @brief Persistent homology over Z/2 of a tetrahedral complex: voids and loops, born and filled.
 */
#ifndef isthmus_FiltrationPairs_h
#define isthmus_FiltrationPairs_h

#include "Persistence/ColumnStore.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <functional>

namespace isthmus
{

/**
 * Every triangle either closes a void (positive) or fills a loop (negative).
 *
 * A void that triangle t closes is filled by tetrahedron VoidFilled[t]; a loop that edge e closes
 * is filled by triangle LoopFilled[e].
 */
class FiltrationPairs
{
public:
  /**
   * Pairs all simplices of `f`, which must outlive this object.
   *
   * Voids by union-find over tetrahedra in descending order (the elder rule, seen from the
   * complement), near linear. Loops by reduction of the negative triangles' columns; all but a few
   * percent of an alpha complex's columns need none, the worst case is cubic. Time and memory are
   * near linear for samples of surfaces. `progress` can stop it.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT explicit FiltrationPairs(
    const CellFiltration& f, const ProgressCallback& progress = {});

  /// The tetrahedron that fills the void closed by `triangle`; None: it closes none, or
  /// nothing but the exterior fills it.
  TetrahedronId VoidFilled(TriangleId triangle) const;

  /// The triangle that fills the loop closed by `edge`, or None.
  TriangleId LoopFilled(EdgeId edge) const;

  /// The edge that closes the loop filled by `triangle`; None: it fills none.
  EdgeId LoopClosed(TriangleId triangle) const;

  /// The triangles whose boundary is the reduced boundary of a negative triangle: a cycle whose
  /// latest edge is LoopClosed(triangle).
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT TriangleChain Filling(TriangleId triangle) const;

  /// True for an edge that the cycle under reduction may not keep.
  using Unwanted = std::function<bool(EdgeId edge)>;

  /**
   * Pushes cycle `z` downhill: while it has an unwanted edge whose loop was filled by a triangle
   * ranked below `limit`, that loop's boundary is added, latest edge first. Returns the new cycle;
   * the triangles passed are added (mod 2) to `swept`, so that z + result = boundary of swept.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT EdgeChain Push(
    const EdgeChain& z, TriangleRank limit, const Unwanted& unwanted, TriangleChain& swept) const;

  /**
   * What bounds a cycle of edges (they may repeat and then cancel): ranks of triangles, latest
   * first, whose reduced boundaries add up to it. An edge whose loop nothing fills stands as its
   * own rank plus the number of triangles.
   */
  VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<std::int64_t> Bounding(const EdgeChain& z) const;

private:
  void PairLoops(const ProgressCallback& progress);
  HandleVector<TriangleRank, EdgeRank> Pivots() const;
  struct Reduction;
  bool Reduce(TriangleRank rank, const HandleVector<EdgeRank, TriangleRank>& filler,
    EdgeRank& pivot, Reduction& work, const std::function<void()>& tick);
  std::array<EdgeRank, 3> BoundaryOf(TriangleRank rank) const;
  template <typename Heap>
  void AddColumn(TriangleRank rank, EdgeRank pivot, Heap& heap) const;

  const CellFiltration& F;
  /// Per triangle: the edge that closes the loop which it fills; -1: it fills none; below that,
  /// -2 - the tetrahedron that fills the void which it closes. No triangle does both.
  HandleVector<TriangleId, SimplexId> Partner;
  HandleVector<EdgeId, TriangleId> LoopFilledBy;
  ColumnStore Columns;
};

inline TetrahedronId FiltrationPairs::VoidFilled(TriangleId triangle) const
{
  return TetrahedronId(std::max(-1, -2 - this->Partner[triangle]));
}

inline TriangleId FiltrationPairs::LoopFilled(EdgeId edge) const
{
  return this->LoopFilledBy[edge];
}

inline EdgeId FiltrationPairs::LoopClosed(TriangleId triangle) const
{
  return EdgeId(std::max(-1, this->Partner[triangle]));
}

}

#endif
