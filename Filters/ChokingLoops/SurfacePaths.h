/**
 * @file SurfacePaths.h
 * @brief Paths on a closed triangle surface: half edges, shortest paths along edges, and across
 * triangles by the funnel algorithm.
 */
#ifndef isthmus_SurfacePaths_h
#define isthmus_SurfacePaths_h

#include "Core/TriangleMesh.h"
#include "Persistence/CellFiltration.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Half edges of a closed triangle surface: neighbours across, around a point, along an edge.

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
 * The surface must be closed, manifold and oriented (FindDefects() (SurfaceDefects.h)).
 */
class SurfaceAdjacency
{
public:
  /// O(n log n), 28 bytes per half edge. @pre The owner of `mesh` outlives this object.
  explicit SurfaceAdjacency(const SurfaceView& mesh);
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

  static HandleRange<HalfEdgeId> GetHalfEdges(SurfaceTriangleId t)
  {
    return { 3 * t.Index(), 3 * t.Index() + 3 };
  }

  HalfEdgeId Opposite(HalfEdgeId h) const { return this->Opposites[h]; }
  /// The edge that h and its opposite share, numbered from 0.
  SurfaceEdgeId Edge(HalfEdgeId h) const { return this->EdgeIds[h]; }
  /// One of the two half edges of an edge.
  HalfEdgeId GetHalfEdge(SurfaceEdgeId edge) const { return this->Halves[edge]; }
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

/**
 * A hash map from ids to values, for some of very many ids: points of a surface, tetrahedra of a
 * complex. Values that were never set are `unset`. Constant time; 36 to 72 bytes per value of four
 * bytes.
 *
 * CGAL's Unique_hash_map, which allocates no node for each value. In breadth-first walks over 200
 * to 50,000 of 160,000 points, std::unordered_map takes 1.3 to 3.4 times as long,
 * boost::unordered_map (1.74) 1.2 to 3.6 times (CPU time, alternating in one process, least of four
 * runs).
 */
template <typename Id, typename Value>
class IdMap
{
public:
  explicit IdMap(Value unset)
    : Table(unset)
  {
  }
  // A copy of CGAL's table has another default.
  IdMap(const IdMap&) = delete;
  IdMap& operator=(const IdMap&) = delete;

  const Value& operator[](Id id) const { return this->Table[Number(id)]; }
  Value& operator[](Id id) { return this->Table[Number(id)]; }

private:
  struct Same
  {
    std::size_t operator()(std::size_t number) const { return number; }
  };

  /// None, the only id below 0, comes last.
  static std::size_t Number(Id id)
  {
    if constexpr (std::is_integral_v<Id>)
    {
      return static_cast<std::uint32_t>(id);
    }
    else
    {
      return static_cast<std::uint32_t>(id.Value);
    }
  }

  CGAL::Unique_hash_map<std::size_t, Value, Same> Table;
};

// ------------------------------------------------------------------------------------------
// Shortest paths along the edges of a surface from one of its points.

/**
 * The tree of shortest paths (E. W. Dijkstra, Numer. Math. 1 (1959) 269). O(n log n) in the number
 * of points met.
 *
 * With `to` it ends there and searches in that direction first, by the remaining straight-line
 * distance (P. E. Hart, N. J. Nilsson, B. Raphael, IEEE Trans. Syst. Sci. Cybern. 4 (1968) 100):
 * the path to that point is the shortest, and only those other points are visited through which a
 * shorter one could lead.
 */
class SurfacePaths
{
public:
  /// Paths of at most `reach`. @pre `surface` outlives this object.
  SurfacePaths(const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to = -1);

  /// Extends the search to paths of at most `reach`, as if started with it.
  void Grow(double reach);

  /// Points by the length of their paths (with `to`, as they were met), `from` first.
  const std::vector<SimplexId>& Points() const { return this->Settled; }

  /// The index of a point in Points(); -1: there is no path to it.
  std::ptrdiff_t GetPlace(SimplexId p) const { return this->Places[p]; }
  double LengthAt(std::size_t place) const { return this->Lengths[place]; }
  HalfEdgeId LastAt(std::size_t place) const { return this->Lasts[place]; }

  /// The place of the first point whose path is longer than `length`. @pre Without `to`.
  std::size_t FirstBeyond(double length) const
  {
    return static_cast<std::size_t>(
      std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length) - this->Lengths.begin());
  }

  /// The shortest length among edges between these points and others; no edge between two of them
  /// is longer.
  double LongestEdge() const { return this->Longest; }

  bool Has(SimplexId p) const { return this->Places[p] >= 0; }

  /// @pre Has(p).
  double Length(SimplexId p) const { return this->Lengths[Index(p)]; }

  /// The last half edge of the path to p, None for the first point. @pre Has(p).
  HalfEdgeId Last(SimplexId p) const { return this->Lasts[Index(p)]; }

private:
  struct Entry
  {
    double Least; ///< of a path through this point: Length, and the remaining distance to `to`
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

// ------------------------------------------------------------------------------------------
// The triangles that a closed curve on a surface passes, as edges crossed, and unfolded.

/// A point of a curve on a surface: on half edge HalfEdge, at a fraction of it from From to To.
struct SurfaceCurvePoint
{
  HalfEdgeId HalfEdge;
  double Fraction;
};

/// Where a point of a curve lies.
Point3 ComputePosition(const SurfaceAdjacency& surface, const SurfaceCurvePoint& p);

/// The edges that a closed curve crosses, each as half edge of the triangle that the curve enters
/// there: seen along the curve, From is on the left and To on the right.
using EdgeStrip = std::vector<SurfaceCurvePoint>;

/// Removes crossings that immediately return over the same edge.
void RemoveBacktracking(const SurfaceAdjacency& surface, EdgeStrip& strip);

/// The same for an open strip.
EdgeStrip WithoutBacktracking(const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// The strip just left of a closed loop of points, consecutive ones joined by an edge: at each
/// point, the edges between the ways in and out. Throws std::invalid_argument where no edge joins
/// two of them.
EdgeStrip LeftStrip(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop);

/// The same for an open path of points, from the first to the last: neither end is passed.
EdgeStrip StripLeftOfPath(const SurfaceAdjacency& surface, const std::vector<SimplexId>& path);

/// Removes crossings that immediately return over the same edge, and those of edges on which the
/// ends `from` and `to` of an open path lie.
void RemoveBacktracking(
  const SurfaceAdjacency& surface, EdgeStrip& strip, SimplexId from, SimplexId to);

using Point2 = std::array<double, 2>;

/// Twice the signed area of (o, a, b).
inline double Cross2(const Point2& o, const Point2& a, const Point2& b)
{
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// The point to the left of (a, b) at these distances from a and b.
inline Point2 UnfoldCorner(const Point2& a, const Point2& b, double toA, double toB)
{
  const double c = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double x = (toA * toA - toB * toB + c * c) / (2.0 * c);
  const double y = std::sqrt(std::max(0.0, toA * toA - x * x));
  const Point2 u{ (b[0] - a[0]) / c, (b[1] - a[1]) / c };
  return { a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0] };
}

/// A strip laid into the plane from one edge round to its copy: both ends of every edge.
struct UnfoldedStrip
{
  std::vector<Point2> From;
  std::vector<Point2> To;
};

/// Triangles keep their lengths, neighbours their common edge. One edge more than the strip has.
UnfoldedStrip Unfold(const SurfaceAdjacency& surface, const EdgeStrip& strip, std::size_t start);

/// The strip of an open path between two points, its ends as edges without length: two edges more
/// than the strip has. @pre the strip is not empty and has no edge that ends at `from` or `to`.
UnfoldedStrip UnfoldPath(const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// A strip laid into the plane from its first edge to its last.
UnfoldedStrip UnfoldOpen(const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// At a fraction of edge i of an unfolded strip.
inline Point2 PointOn(const UnfoldedStrip& plane, std::size_t i, double fraction)
{
  const Point2& from = plane.From[i];
  const Point2& to = plane.To[i];
  return { from[0] + fraction * (to[0] - from[0]), from[1] + fraction * (to[1] - from[1]) };
}

// ------------------------------------------------------------------------------------------
// The funnel algorithm: the shortest path through a sequence of edges in the plane.
//
// Source: D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence of rectilinear
// barriers", Networks 14 (1984) 393: the funnel between the borders of a sleeve of triangles.

/**
 * The shortest path from `p` on the first edge to `q` on the last one that crosses all edges
 * between: where it crosses each of these, as fractions from From to To; 0 or 1 where it bends
 * round an end. Entry 0 belongs to the first edge and is 0. O(number of edges) for most strips.
 */
std::vector<double> FunnelCrossings(const UnfoldedStrip& plane, const Point2& p, const Point2& q);

/// The same into `fraction`, whose memory is used again.
void FunnelCrossings(
  const UnfoldedStrip& plane, const Point2& p, const Point2& q, std::vector<double>& fraction);

// ------------------------------------------------------------------------------------------
// A strip of triangles rerouted around the other side of a point.

/// Angle at From(h) of the triangle left of h.
double CornerAngle(const SurfaceAdjacency& surface, HalfEdgeId h);

/**
 * The edges at point p on the other side of a curve that enters over half edge `enter`, passes
 * edges that all end at p, and leaves through triangle `last`: with p on its right it turns
 * clockwise there, and the rerouted path counter-clockwise. Fractions lie at p.
 */
EdgeStrip StripOnOtherSide(
  const SurfaceAdjacency& surface, HalfEdgeId enter, SurfaceTriangleId last, SimplexId p);

/// Angle at p between the incoming and the outgoing path, on the side of the edges `other`.
double AngleOnOtherSide(const SurfaceAdjacency& surface, const EdgeStrip& other, SimplexId p,
  const Point3& before, const Point3& after);

/// True for a curve that passes through the end p of its edge.
bool Touches(const SurfaceAdjacency& surface, const SurfaceCurvePoint& c, SimplexId p);

/// The end of the edge of `c` at which the curve passes through a vertex, or -1.
SimplexId TouchedBy(const SurfaceAdjacency& surface, const SurfaceCurvePoint& c);

}

#endif
