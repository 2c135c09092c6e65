/**
 * @file DiffusionEvaluation.h
 * @brief Evaluates a DiffusionOperator on a whole grid, in one pass over memory.
 *
 * The pass walks through tiles of rows, plane after plane; what lies between u and the rate (W at
 * every order, c) lives in rings of a few planes that stay in cache, so that each volume crosses
 * memory once.
 */
#ifndef isthmus_DiffusionEvaluation_h
#define isthmus_DiffusionEvaluation_h

#include "DiffusionOperator.h"
#include "Progress.h"

namespace isthmus
{

/**
 * Evaluates one stage on all nodes, in parallel, bit for bit the same on any number of threads.
 *
 * Memory: per thread about half a MiB of scratch, or a few planes of very long rows.
 * `progress` is asked about every tenth of a second; false throws Cancelled.
 */
template <typename T>
void Evaluate(const DiffusionOperator<T>& diffusion, const DiffusionStage<T>& stage,
  const ProgressCallback& progress = {});

}

#endif
