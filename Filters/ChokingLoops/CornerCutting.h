/**
 * @file CornerCutting.h
 * @brief Takes the corners off a curve that is held at points of a surface.
 */
#ifndef isthmus_CornerCutting_h
#define isthmus_CornerCutting_h

#include "ChokingLoops/LoopShortening.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * At each pin (SurfaceCurve::Pins) where the curve turns by more than `sharpest` radians, the piece
 * from `reach` before it to `reach` behind it (less beside another pin, and a crossing at least)
 * gives way to the shortest path between its ends on the side of the pin where the angle is
 * smaller: two corners in place of one, which are cut half as far off in turn where they are too
 * sharp, five times at most. SurfaceCurve::SharpestBend is then the largest turn at what is left
 * of them. With `reach` 0 it is only measured.
 *
 * Time: proportional to what is cut.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceCurve CutCorners(
  const SurfaceAdjacency& surface, SurfaceCurve curve, double sharpest, double reach);

}

#endif
