/**
 * @file LoopFeature.h
 * @brief A choking loop as it is shown: curves on the surface and a membrane that they bound.
 */
#ifndef isthmus_LoopFeature_h
#define isthmus_LoopFeature_h

#include "ChokingLoops.h"
#include "LoopDrawing.h"

namespace isthmus
{

/// True when loops belong to the choke point of a feature, see MakeLoopFeature().
VTKISTHMUS_EXPORT bool Belongs(
  const ChokingLoops& loops, std::size_t feature, const LoopFeature& geometry);

/**
 * Loops and membrane of a feature; with `rounds` above 0 the loops are shortened that often, and a
 * strip of triangles between the old and the new loop keeps the membrane's boundary theirs.
 *
 * A trusted feature's loops belong to its choke point: the longest is at least 0.98 ShortestGirth()
 * long, and the point lies within 0.3 of its radius of their convex hull. Of MembraneOf() and,
 * where those loops do not belong or are long, TightMembraneOf() the shorter ones that belong are
 * taken. Where neither does, since nothing on M holds them there, the loops are held where the
 * choking ball touches M, geodesic between these points, corners cut off. Where they turn sharply
 * even so (above 54 degrees), or a loop of another class that bounds there is no longer
 * (EncirclingMembranesOf()), that one is taken; where all are hairpins, a tight loop of the class
 * elsewhere, which then does not surround the choke point.
 *
 * @throws Cancelled.
 */
VTKISTHMUS_EXPORT LoopFeature MakeLoopFeature(
  ChokingLoops& loops, std::size_t feature, int rounds, const ProgressCallback& progress = {});

}

#endif
