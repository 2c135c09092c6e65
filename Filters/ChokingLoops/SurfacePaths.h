/**
 * @file SurfacePaths.h
 * @brief Shortest paths along the edges of a surface from one of its points.
 */
#ifndef isthmus_SurfacePaths_h
#define isthmus_SurfacePaths_h

#include "ChokingLoops/IdMap.h"
#include "ChokingLoops/SurfaceAdjacency.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <vector>

namespace isthmus
{

/**
 * The tree of shortest paths (E. W. Dijkstra, Numer. Math. 1 (1959) 269). O(n log n) in the number
 * of points met.
 *
 * With `to` it ends there and looks that way first, by the straight line that is left (P. E. Hart,
 * N. J. Nilsson, B. Raphael, IEEE Trans. Syst. Sci. Cybern. 4 (1968) 100): the path to that point
 * is the shortest, and of the others only those are met over which a shorter one could lead.
 */
class SurfacePaths
{
public:
  /// Paths of at most `reach`. @pre `surface` outlives this object.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfacePaths(
    const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to = -1);

  /// Goes on to paths of at most `reach`, as if it had been asked for at first.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Grow(double reach);

  /// Points by the length of their paths (with `to`, as they were met), `from` first.
  const std::vector<SimplexId>& Points() const { return this->Settled; }

  /// Where a point stands in Points(); -1: there is no path to it.
  std::ptrdiff_t PlaceOf(SimplexId p) const { return this->Places[p]; }
  double LengthAt(std::size_t place) const { return this->Lengths[place]; }
  HalfEdgeId LastAt(std::size_t place) const { return this->Lasts[place]; }

  /// The place of the first point whose path is longer than `length`. @pre Without `to`.
  std::size_t FirstBeyond(double length) const
  {
    return static_cast<std::size_t>(
      std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length) - this->Lengths.begin());
  }

  /// Of the edges between these points and others; no edge between two of them is longer.
  double LongestEdge() const { return this->Longest; }

  bool Has(SimplexId p) const { return this->Places[p] >= 0; }

  /// @pre Has(p).
  double Length(SimplexId p) const { return this->Lengths[Index(p)]; }

  /// The last half edge of the path to p, None for the first point. @pre Has(p).
  HalfEdgeId Last(SimplexId p) const { return this->Lasts[Index(p)]; }

private:
  struct Entry
  {
    double Least; ///< of a path that leads this way: Length, and what is left to `to`
    SimplexId Point;
    HalfEdgeId Last;
    double Length;

    bool operator>(const Entry& other) const
    {
      return std::tie(this->Least, this->Point, this->Last) >
        std::tie(other.Least, other.Point, other.Last);
    }
  };

  std::size_t Index(SimplexId p) const { return static_cast<std::size_t>(this->Places[p]); }
  void Settle(const Entry& entry);
  double Left(SimplexId p) const;

  const SurfaceAdjacency& Surface;
  SimplexId Goal;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
  IdMap<SimplexId, std::int32_t> Places{ -1 }; ///< of the points settled
  double Longest = 0.0;                        ///< edge
  std::vector<SimplexId> Settled;
  std::vector<double> Lengths;
  std::vector<HalfEdgeId> Lasts;
};

}

#endif
