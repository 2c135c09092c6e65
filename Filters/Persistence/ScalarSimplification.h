/**
 * @file ScalarSimplification.h
 * @brief A volume without its short-lived components and voids.
 */
#ifndef isthmus_ScalarSimplification_h
#define isthmus_ScalarSimplification_h

#include "Core/Progress.h"
#include "Persistence/ScalarFeatures.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/**
 * Writes to `result` (same type and size as `volume`) the values without the minima and maxima of
 * features beyond the first `features.Kept` (J. Tierny, V. Pascucci, IEEE TVCG 18, 2012: extrema
 * that are not wanted are flooded up to the saddle where they meet one that is).
 *
 * First each node is raised to the lowest pass over which a minimum that stays is reached (6
 * neighbours), then lowered to the highest pass to a void that stays, or to the outside (26
 * neighbours). No value changes by more than the longest persistence taken out, and no value is
 * made up: every result is a value of the volume. Loops (dimension 1) are not cancelled, as in TTK.
 *
 * Serial, O(n log n): about 0.3 us a node, 12 bytes a node.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void SimplifyScalar(const VolumeView& volume,
  const FeatureList& features, bool superlevel, void* result,
  const ProgressCallback& progress = {});

}

#endif
