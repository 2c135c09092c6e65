/**
 * @file PinnedShortening.h
 * @brief A closed curve on a triangle surface, drawn tight between points that it must pass.
 */
#ifndef isthmus_PinnedShortening_h
#define isthmus_PinnedShortening_h

#include "ChokingLoops/LoopShortening.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * As ShortenLoop(), but the curve keeps passing `pins`, points of `loop`, which need not be
 * straight there: each piece between two of them becomes a geodesic of its homotopy class.
 *
 * @pre at least one pin is a point of the loop. @throws what ShortenLoop() throws.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SurfaceCurve ShortenPinned(const SurfaceAdjacency& surface,
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins,
  const LoopShorteningParameters& parameters = {}, const ProgressCallback& progress = {});

}

#endif
