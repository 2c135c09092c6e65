/**
 * @file StripBend.h
 * @brief A strip of triangles led round the other side of a point.
 */
#ifndef isthmus_StripBend_h
#define isthmus_StripBend_h

#include "ChokingLoops/EdgeStrip.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// Angle at From(h) of the triangle left of h.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double CornerAngle(
  const SurfaceAdjacency& surface, HalfEdgeId h);

/**
 * The edges at point p on its other side, for a curve that enters over half edge `enter`, passes
 * edges that all end at p, and leaves through triangle `last`: with p on its right it turns
 * clockwise there, and the other way is counter-clockwise. Fractions lie at p.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EdgeStrip OtherWayRound(
  const SurfaceAdjacency& surface, HalfEdgeId enter, SurfaceTriangleId last, SimplexId p);

/// Angle between the ways into and out of p on the side where the edges `other` lie.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double AngleBeyond(const SurfaceAdjacency& surface,
  const EdgeStrip& other, SimplexId p, const Point3& before, const Point3& after);

/// True for a curve that runs through the end p of its edge.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool Touches(
  const SurfaceAdjacency& surface, const SurfaceCurvePoint& c, SimplexId p);

/// The end of its edge that a curve runs through, or -1.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SimplexId TouchedBy(
  const SurfaceAdjacency& surface, const SurfaceCurvePoint& c);

}

#endif
