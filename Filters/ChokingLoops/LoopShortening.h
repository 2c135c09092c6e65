/**
 * @file LoopShortening.h
 * @brief A closed curve on a triangle surface becomes a geodesic loop of its homotopy class.
 */
#ifndef isthmus_LoopShortening_h
#define isthmus_LoopShortening_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "ChokingLoops/SurfacePaths.h"
#include "Core/Progress.h"

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// A closed curve on a triangle surface becomes a geodesic loop of its homotopy class.
//
// Source: S.-Q. Xin, Y. He, C.-W. Fu, "Efficiently computing exact geodesic loops within finite
// steps", IEEE TVCG 18 (2012) 879, the thesis' reference [198]: the shortest closed path in the
// strip of triangles that the curve crosses, by unfolding and a funnel; where the path bends at a
// point and the angle on the other side is below pi, the strip is rerouted around that side.

/// A closed curve that runs straight through triangles.
struct SurfaceCurve
{
  std::vector<SurfaceCurvePoint> Crossings;
  /// Crossings at the points of the surface where the curve is fixed.
  std::vector<std::size_t> Pins;
  double SharpestBend = 0.0; ///< largest turning angle at them, in radians
  double Length = 0.0;
  bool Converged = false; ///< a geodesic: straight, or with an angle of at least pi on either side
  /// The loop is contractible within its strip: it is returned unchanged.
  bool Contractible = false;
};

/// The length of the closed curve through these points.
double CurveLength(
  const SurfaceAdjacency& surface, const std::vector<SurfaceCurvePoint>& crossings);

/**
 * Shortens the closed curve through the points `loop`; an edge joins consecutive points.
 *
 * The result is never longer than the input. Time of a round: proportional to the number of edges
 * crossed. Throws std::invalid_argument if no edge joins two consecutive points, and Cancelled.
 */
SurfaceCurve ShortenLoop(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const LoopShorteningParameters& parameters = {}, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// A closed curve that is geodesic between fixed points.

/**
 * Like ShortenLoop(), but the curve stays fixed at `pins`, which are points of `loop`, and may bend
 * there: each piece between two pins becomes a geodesic of its homotopy class. A loop that
 * contracts to its only pin is returned unchanged, as Contractible.
 *
 * @pre at least one pin is a point of the loop. @throws the exceptions of ShortenLoop().
 */
SurfaceCurve ShortenPinned(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const std::vector<SimplexId>& pins, const LoopShorteningParameters& parameters = {},
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Cuts the corners of a curve that is fixed at points of a surface.

/**
 * At each pin (SurfaceCurve::Pins) where the curve turns by more than `sharpest` radians, the piece
 * from `reach` before it to `reach` behind it (less next to another pin, but at least one crossing)
 * is replaced by the shortest path between its ends on the side of the pin where the angle is
 * smaller. This replaces one corner by two; corners that are still too sharp are cut again at half
 * the distance, at most five times. SurfaceCurve::SharpestBend is the largest turning angle that
 * remains. With `reach` 0 it is only measured.
 *
 * Time: proportional to the number of crossings removed.
 */
SurfaceCurve CutCorners(
  const SurfaceAdjacency& surface, SurfaceCurve curve, double sharpest, double reach);

}

#endif
