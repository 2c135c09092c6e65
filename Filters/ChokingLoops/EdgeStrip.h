/**
 * @file EdgeStrip.h
 * @brief The triangles that a closed curve on a surface passes, as edges crossed, and unfolded.
 */
#ifndef isthmus_EdgeStrip_h
#define isthmus_EdgeStrip_h

#include "ChokingLoops/SurfaceAdjacency.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// A point of a curve on a surface: on half edge HalfEdge, at a fraction of it from From to To.
struct SurfaceCurvePoint
{
  HalfEdgeId HalfEdge;
  double Fraction;
};

/// Where a point of a curve lies.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 PositionOf(
  const SurfaceAdjacency& surface, const SurfaceCurvePoint& p);

/// The edges that a closed curve crosses, each as half edge of the triangle that the curve enters
/// there: seen along the curve, From is on the left and To on the right.
using EdgeStrip = std::vector<SurfaceCurvePoint>;

/// Takes out crossings that go back at once over the same edge.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void CancelReturns(
  const SurfaceAdjacency& surface, EdgeStrip& strip);

/// The same of an open strip.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeStrip WithoutReturns(
  const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// The strip just left of a closed loop of points, consecutive ones joined by an edge: at each
/// point, the edges between the ways in and out. Throws std::invalid_argument where no edge joins
/// two of them.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeStrip StripLeftOf(
  const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop);

/// The same for an open path of points, from the first to the last: neither end is passed.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeStrip StripLeftOfPath(
  const SurfaceAdjacency& surface, const std::vector<SimplexId>& path);

/// Takes out crossings that go back at once over the same edge, and those of edges that the ends
/// `from` and `to` of an open path lie on.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void CancelReturns(
  const SurfaceAdjacency& surface, EdgeStrip& strip, SimplexId from, SimplexId to);

using Point2 = std::array<double, 2>;

/// Twice the signed area of (o, a, b).
inline double Cross2(const Point2& o, const Point2& a, const Point2& b)
{
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// A strip laid into the plane from one edge round to its copy: both ends of every edge.
struct UnfoldedStrip
{
  std::vector<Point2> From;
  std::vector<Point2> To;
};

/// Triangles keep their lengths, neighbours their common edge. One edge more than the strip has.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT UnfoldedStrip Unfold(
  const SurfaceAdjacency& surface, const EdgeStrip& strip, std::size_t start);

/// The strip of an open path between two points, its ends as edges without length: two edges more
/// than the strip has. @pre the strip is not empty and has no edge that ends at `from` or `to`.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT UnfoldedStrip UnfoldPath(
  const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// A strip laid into the plane from its first edge to its last.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT UnfoldedStrip UnfoldOpen(
  const SurfaceAdjacency& surface, const EdgeStrip& strip);

/// At a fraction of edge i of an unfolded strip.
inline Point2 PointOn(const UnfoldedStrip& plane, std::size_t i, double fraction)
{
  const Point2& from = plane.From[i];
  const Point2& to = plane.To[i];
  return { from[0] + fraction * (to[0] - from[0]), from[1] + fraction * (to[1] - from[1]) };
}

}

#endif
