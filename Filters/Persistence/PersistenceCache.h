/**
 * @file PersistenceCache.h
 * @brief The pairs of an image's scalars, computed once for the same values.
 */
#ifndef isthmus_PersistenceCache_h
#define isthmus_PersistenceCache_h

#include "Core/Cached.h"
#include "Core/Progress.h"
#include "Persistence/CubicalDiagram.h"
#include "Persistence/VolumeView.h"

#include <array>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/// The values as stored in memory. Throws std::invalid_argument for arrays that are not contiguous
/// plain numbers.
VolumeView MakeVolumeView(vtkDataArray* scalars, vtkImageData* image);

/// Statistics and pairs of the last scalars. They do not depend on thresholds, so that threshold
/// changes are instant; changed values, another sign or other levels recompute them.
class PersistenceCache
{
public:
  /// Clears the cache if the scalars differ from the cached ones. O(n).
  const VolumeStatistics& Statistics(vtkDataArray* scalars, const VolumeView& volume);

  /// Pairs of the same values. Cost where they are not cached: CubicalPersistence.h.
  /// @pre Statistics() was called with this volume. @throws Cancelled, and std::runtime_error with
  /// what to do if the memory does not suffice.
  const CubicalDiagram& Pairs(const VolumeView& volume, const CubicalParameters& parameters,
    const ProgressCallback& progress);

private:
  Cached<std::pair<ObjectState, std::array<std::int64_t, 3>>, VolumeStatistics> OfVolume;
  Cached<std::pair<bool, std::vector<double>>, CubicalDiagram> Diagram; ///< of that volume
};

}

#endif
