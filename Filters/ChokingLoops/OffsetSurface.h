/**
 * @file OffsetSurface.h
 * @brief The points at a given distance from a surface, as a level set of a function on a grid.
 */
#ifndef isthmus_OffsetSurface_h
#define isthmus_OffsetSurface_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Persistence/SurfaceDistance.h"

namespace isthmus
{

/**
 * Distances on a grid large enough for the offset: the level set at Distance is the offset of
 * `surface` on the requested side. If only one side is requested, distances on the other are
 * negative.
 *
 * Values within two grid spacings h of that level are exact, so a contour lies within about h^2 /
 * (8 Distance) of a smooth offset. Other values are only guaranteed to lie on the correct side of
 * the level.
 *
 * @throws std::invalid_argument with a message: Check(), a point is not finite, there are no
 * triangles, one side is requested and the surface is not closed, or both are and Distance is less
 * than h; Cancelled.
 *
 * Time: about 50 ns for each of Resolution^3 nodes, and a few microseconds for each node near the
 * level. Memory: 32 bytes per node.
 */
DistanceGrid OffsetDistances(const SurfaceView& surface, const OffsetSurfaceParameters& parameters,
  const ProgressCallback& progress = {});

}

#endif
