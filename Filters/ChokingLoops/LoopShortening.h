/**
 * @file LoopShortening.h
 * @brief A closed curve on a triangle surface becomes a geodesic loop of its homotopy class.
 */
#ifndef isthmus_LoopShortening_h
#define isthmus_LoopShortening_h

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// A closed curve on a triangle surface becomes a geodesic loop of its homotopy class.
//
// Source: S.-Q. Xin, Y. He, C.-W. Fu, "Efficiently computing exact geodesic loops within finite
// steps", IEEE TVCG 18 (2012) 879, the thesis' reference [198]: the shortest closed path in the
// strip of triangles that the curve crosses, by unfolding and a funnel; where the path bends at a
// point with an angle below pi on its other side, the strip is led round that side.

/// A closed curve that runs straight through triangles.
struct SurfaceCurve
{
  std::vector<SurfaceCurvePoint> Crossings;
  /// Crossings at points of the surface that the curve is held at (LoopShortening.h).
  std::vector<std::size_t> Pins;
  double SharpestBend = 0.0; ///< largest turn there, in radians (LoopShortening.h)
  double Length = 0.0;
  bool Converged = false; ///< a geodesic: straight, or bent with at least pi on either side
  /// The loop is contractible within its strip: it is returned unchanged.
  bool Contractible = false;
};

/// The length of the closed curve through these points.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double LengthOf(
  const SurfaceAdjacency& surface, const std::vector<SurfaceCurvePoint>& crossings);

struct LoopShorteningParameters
{
  int MaximumRounds = 200; ///< each finds the shortest path in the strip and leads it on
  double Tolerance = 1e-6; ///< relative accuracy of the length within a strip
};

/**
 * Shortens the closed curve through the points `loop`, consecutive ones joined by an edge.
 *
 * Never longer than the curve given. Cost of a round: the number of edges crossed. Throws
 * std::invalid_argument for a loop with consecutive points that no edge joins, and Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceCurve ShortenLoop(const SurfaceAdjacency& surface,
  const std::vector<SimplexId>& loop, const LoopShorteningParameters& parameters = {},
  const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// A closed curve that is geodesic between fixed points.

/**
 * As ShortenLoop(), but the curve keeps passing `pins`, points of `loop`, which need not be
 * straight there: each piece between two of them becomes a geodesic of its homotopy class.
 *
 * @pre at least one pin is a point of the loop. @throws what ShortenLoop() throws.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceCurve ShortenPinned(const SurfaceAdjacency& surface,
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins,
  const LoopShorteningParameters& parameters = {}, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Cuts the corners of a curve that is held at points of a surface.

/**
 * At each pin (SurfaceCurve::Pins) where the curve turns by more than `sharpest` radians, the piece
 * from `reach` before it to `reach` behind it (less beside another pin, and a crossing at least)
 * is replaced by the shortest path between its ends on the side of the pin where the angle is
 * smaller: two corners in place of one, which are cut half as far off again where they are too
 * sharp, five times at most. SurfaceCurve::SharpestBend is then the largest turn at what is left
 * of them. With `reach` 0 it is only measured.
 *
 * Time: proportional to what is cut.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceCurve CutCorners(
  const SurfaceAdjacency& surface, SurfaceCurve curve, double sharpest, double reach);

}

#endif
