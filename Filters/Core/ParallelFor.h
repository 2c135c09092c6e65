/**
 * @file ParallelFor.h
 * @brief The one door to threads: loops over index ranges through vtkSMPTools.
 *
 * Debian's ParaView starts with vtkSMPTools' Sequential backend, so a plain vtkSMPTools::For runs
 * on one core there. ParallelFor runs its body under STDThread when the backend in use is
 * Sequential and the user has not chosen one (environment variable VTK_SMP_BACKEND_IN_USE unset);
 * otherwise the backend in use is left as it is. It never calls vtkSMPTools::SetBackend.
 */
#ifndef isthmus_ParallelFor_h
#define isthmus_ParallelFor_h

#include "Core/Progress.h"
#include "vtkIsthmusFiltersCoreModule.h" // for the export macro

#include <cstdint>
#include <functional>

namespace isthmus
{

/// Work on the half-open index range [first, last).
using RangeBody = std::function<void(std::int64_t first, std::int64_t last)>;

/**
 * Calls `body` on disjoint pieces that together cover [begin, end), in parallel, in no order.
 *
 * A piece has about `grain` indices (at least 1), so choose it large enough to pay for one call.
 * The result is independent of the thread count as long as `body` writes only what belongs to its
 * own indices. The first exception a piece throws is thrown again on the calling thread; pieces
 * not yet begun are then left out.
 *
 * With `progress`, the range is worked off in rounds of about a tenth of a second; after each, it
 * is called on the calling thread with the fraction done, and a false answer throws Cancelled.
 */
VTKISTHMUSFILTERSCORE_EXPORT void ParallelFor(std::int64_t begin, std::int64_t end,
  std::int64_t grain, const RangeBody& body, const ProgressCallback& progress = {});

/// Number of threads that ParallelFor uses now.
VTKISTHMUSFILTERSCORE_EXPORT int ParallelThreads();

}

#endif
