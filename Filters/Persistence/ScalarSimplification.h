/**
 * @file ScalarSimplification.h
 * @brief A volume without its short-lived components and voids.
 */
#ifndef isthmus_ScalarSimplification_h
#define isthmus_ScalarSimplification_h

#include "Core/Progress.h"
#include "Persistence/ScalarFeatures.h"

namespace isthmus
{

/**
 * Writes the values to `result` (same type and size as `volume`) without the minima and maxima of
 * features beyond the first features.Kept (J. Tierny, V. Pascucci, IEEE TVCG 18, 2012: unwanted
 * extrema are flooded up to the saddle where they meet one that is kept).
 *
 * First each node is raised to the lowest pass over which a remaining minimum can be reached (6
 * neighbours), then lowered to the highest pass to a remaining void or to the exterior (26
 * neighbours). No value changes by more than the longest removed persistence, and no new values are
 * created: every result is a value of the volume. As in TTK, loops (dimension 1) are not cancelled.
 *
 * Serial, O(n log n); 12 bytes for each node.
 */
void SimplifyScalar(const VolumeView& volume, const FeatureList& features, bool superlevel,
  void* result, const ProgressCallback& progress = {});

}

#endif
