/**
 * @file ParallelFor.h
 * @brief Parallel loops over index ranges, through vtkSMPTools, and sums that are bitwise the same
 * on any number of threads.
 *
 * Debian's ParaView starts with vtkSMPTools' Sequential backend, so a plain vtkSMPTools::For runs
 * on one core there. ParallelFor runs its body under STDThread when the backend in use is
 * Sequential and the user has not chosen one (environment variable VTK_SMP_BACKEND_IN_USE unset);
 * otherwise the backend in use is left as it is. It never calls vtkSMPTools::SetBackend.
 */
#ifndef isthmus_ParallelFor_h
#define isthmus_ParallelFor_h

#include "Core/Progress.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/// Work on the half-open index range [first, last).
using RangeBody = std::function<void(std::int64_t first, std::int64_t last)>;

/**
 * Calls `body` on disjoint pieces that together cover [begin, end), in parallel and in no
 * particular order.
 *
 * A piece has about `grain` indices (at least 1), so choose it large enough to amortise one call.
 * The result is independent of the thread count as long as `body` writes only data of its own
 * indices. The first exception that a piece throws is rethrown on the calling thread; pieces not
 * yet started are then skipped.
 *
 * Everything runs on the calling thread where an address space limit (`ulimit -v`) leaves no room
 * for the stacks of the others.
 *
 * With `progress`, the range is processed in rounds of about a tenth of a second. After each round,
 * `progress` is called on the calling thread with the fraction done, and Cancelled is thrown if it
 * returns false.
 */
VTKISTHMUSFILTERSCORE_EXPORT void ParallelFor(std::int64_t begin, std::int64_t end,
  std::int64_t grain, const RangeBody& body, const ProgressCallback& progress = {});

/// Number of threads that ParallelFor currently uses.
VTKISTHMUSFILTERSCORE_EXPORT int ParallelThreads();

/**
 * Splits [0, count) into blocks of `block` indices, calls work(partial, first, last) on a copy of
 * `zero` for each, and returns the sum of these partial results. `Partial` has operator+=.
 *
 * Blocks are fixed and added in their order, so the result does not depend on the threads. Sums of
 * sums also keep rounding errors small: about (block + count / block) roundings instead of count.
 */
template <typename Partial, typename Work>
Partial ParallelReduce(std::int64_t count, std::int64_t block, const Partial& zero, Work&& work,
  const ProgressCallback& progress = {})
{
  const std::int64_t blocks = (count + block - 1) / block;
  std::vector<Partial> partials(static_cast<std::size_t>(blocks), zero);
  ParallelFor(
    0, blocks, 1,
    [&](std::int64_t firstBlock, std::int64_t lastBlock)
    {
      for (std::int64_t b = firstBlock; b < lastBlock; ++b)
      {
        work(partials[static_cast<std::size_t>(b)], b * block, std::min(count, (b + 1) * block));
      }
    },
    progress);
  Partial total = zero;
  for (const Partial& partial : partials)
  {
    total += partial;
  }
  return total;
}

}

#endif
