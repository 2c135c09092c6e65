/**
 * @file ParallelReduce.h
 * @brief Sums over index ranges in parallel, with the same bits on any number of threads.
 */
#ifndef isthmus_ParallelReduce_h
#define isthmus_ParallelReduce_h

#include "Core/ParallelFor.h"

#include <algorithm>
#include <vector>

namespace isthmus
{

/**
 * Sum of what `work(partial, first, last)` adds to copies of `zero` for blocks of `block` indices
 * of [0, count). `Partial` has operator+=.
 *
 * Blocks are fixed and added in their order, so the result does not depend on the threads; sums of
 * sums also keep rounding small: about (block + count / block) roundings instead of count.
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
