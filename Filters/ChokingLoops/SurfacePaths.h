/**
 * @file SurfacePaths.h
 * @brief Shortest paths along the edges of a surface from one of its points.
 */
#ifndef isthmus_SurfacePaths_h
#define isthmus_SurfacePaths_h

#include "IdMap.h"
#include "SurfaceAdjacency.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// The tree of shortest paths (E. W. Dijkstra, Numer. Math. 1 (1959) 269). O(n log n) in the
/// number of points met.
class SurfacePaths
{
public:
  /// Paths of at most `reach`; the search ends at `to`, if given.
  VTKISTHMUS_EXPORT SurfacePaths(
    const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to = -1);

  /// Points by the length of their paths, `from` first.
  const std::vector<SimplexId>& Points() const { return this->Settled; }

  /// Where a point stands in Points(); -1: there is no path to it.
  std::ptrdiff_t PlaceOf(SimplexId p) const { return this->Places[p]; }
  double LengthAt(std::size_t place) const { return this->Lengths[place]; }
  HalfEdgeId LastAt(std::size_t place) const { return this->Lasts[place]; }

  bool Has(SimplexId p) const { return this->Places[p] >= 0; }

  /// @pre Has(p).
  double Length(SimplexId p) const { return this->Lengths[Index(p)]; }

  /// The last half edge of the path to p, None for the first point. @pre Has(p).
  HalfEdgeId Last(SimplexId p) const { return this->Lasts[Index(p)]; }

private:
  std::size_t Index(SimplexId p) const { return static_cast<std::size_t>(this->Places[p]); }

  IdMap<SimplexId, std::int32_t> Places{ -1 }; ///< of the points settled
  std::vector<SimplexId> Settled;
  std::vector<double> Lengths;
  std::vector<HalfEdgeId> Lasts;
};

}

#endif
