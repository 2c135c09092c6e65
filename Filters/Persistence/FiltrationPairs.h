/**
 * @file FiltrationPairs.h
 * @brief Persistent homology over Z/2 of a tetrahedral complex: voids and loops, born and filled.
 */
#ifndef isthmus_FiltrationPairs_h
#define isthmus_FiltrationPairs_h

#include "ColumnStore.h"

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
  VTKISTHMUS_EXPORT explicit FiltrationPairs(
    const CellFiltration& f, const ProgressCallback& progress = {});

  /// The tetrahedron that fills the void closed by `triangle`; -1: it closes none, or
  /// nothing but the exterior fills it.
  SimplexId VoidFilled(SimplexId triangle) const;

  /// The triangle that fills the loop closed by `edge`; -1: none.
  SimplexId LoopFilled(SimplexId edge) const;

  /// The edge that closes the loop filled by `triangle`; -1: it fills none.
  SimplexId LoopClosed(SimplexId triangle) const;

  /// The triangles whose boundary is the reduced boundary of a negative triangle: a cycle whose
  /// latest edge is LoopClosed(triangle).
  VTKISTHMUS_EXPORT Chain Filling(SimplexId triangle) const;

  /// True for an edge that the cycle under reduction may not keep.
  using Unwanted = std::function<bool(SimplexId edge)>;

  /**
   * Pushes cycle `z` downhill: while it has an unwanted edge whose loop was filled by a triangle
   * ranked below `limit`, that loop's boundary is added, latest edge first. Returns the new cycle;
   * the triangles passed are added (mod 2) to `swept`, so that z + result = boundary of swept.
   */
  VTKISTHMUS_EXPORT Chain Push(
    const Chain& z, SimplexId limit, const Unwanted& unwanted, Chain& swept) const;

  /**
   * What bounds a cycle of edges (they may repeat and then cancel): ranks of triangles, latest
   * first, whose reduced boundaries add up to it. An edge whose loop nothing fills stands as its
   * own rank plus the number of triangles.
   */
  VTKISTHMUS_EXPORT std::vector<std::int64_t> Bounding(const Chain& z) const;

private:
  void PairLoops(const ProgressCallback& progress);
  std::vector<SimplexId> Pivots() const;
  bool Reduce(SimplexId rank, const std::vector<SimplexId>& filler, SimplexId& pivot,
    const std::function<void()>& tick);
  std::array<SimplexId, 3> BoundaryOf(SimplexId rank) const;
  template <typename Heap>
  void AddColumn(SimplexId rank, SimplexId pivot, Heap& heap) const;

  const CellFiltration& F;
  /// Per triangle: the edge that closes the loop which it fills; -1: it fills none; below that,
  /// -2 - the tetrahedron that fills the void which it closes. No triangle does both.
  std::vector<SimplexId> Partner;
  std::vector<SimplexId> LoopFilledBy;
  ColumnStore Columns;
};

inline SimplexId FiltrationPairs::VoidFilled(SimplexId triangle) const
{
  return std::max(-1, -2 - this->Partner[static_cast<std::size_t>(triangle)]);
}

inline SimplexId FiltrationPairs::LoopFilled(SimplexId edge) const
{
  return this->LoopFilledBy[static_cast<std::size_t>(edge)];
}

inline SimplexId FiltrationPairs::LoopClosed(SimplexId triangle) const
{
  return std::max(-1, this->Partner[static_cast<std::size_t>(triangle)]);
}

}

#endif
