/**
 * @file SurfacePaths.h
 * @brief Shortest paths along the edges of a surface from one of its points.
 */
#ifndef isthmus_SurfacePaths_h
#define isthmus_SurfacePaths_h

#include "SurfaceAdjacency.h"

#include <unordered_map>

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

  bool Has(SimplexId p) const { return this->Known.count(p) != 0; }

  /// @pre Has(p).
  double Length(SimplexId p) const { return this->Known.at(p).Length; }

  /// The last half edge of the path to p, None for the first point. @pre Has(p).
  HalfEdgeId Last(SimplexId p) const { return this->Known.at(p).Last; }

private:
  struct Path
  {
    double Length;
    HalfEdgeId Last;
  };

  std::unordered_map<SimplexId, Path> Known; ///< of the points settled
  std::vector<SimplexId> Settled;
};

}

#endif
