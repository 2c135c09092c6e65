/**
 * @file DiffusionEvaluation.h
 * @brief Evaluates a DiffusionOperator on a whole grid, in one pass over memory.
 *
 * The pass walks through tiles of rows, plane after plane; what lies between u and the result (W at
 * every order, c, and the stages but the last) lives in rings of a few planes that stay in cache,
 * so that each volume crosses memory once for all stages of the pass.
 */
#ifndef isthmus_DiffusionEvaluation_h
#define isthmus_DiffusionEvaluation_h

#include "Core/Progress.h"
#include "Imaging/DiffusionOperator.h"

namespace isthmus
{

/// How many stages of this operator are worth doing in one pass.
template <typename T>
int StagesPerPass(const DiffusionOperator<T>& diffusion);

/**
 * Does the stages of a pass on all nodes, in parallel, bit for bit the same on any number of
 * threads and however many stages a pass has: every node is worked out by the same row kernels.
 *
 * Memory: per thread half a MiB of scratch, two with several stages, or a few planes of very long
 * rows. `progress` is asked about every tenth of a second; false throws Cancelled.
 */
template <typename T>
void Evaluate(const DiffusionOperator<T>& diffusion, const DiffusionPass<T>& pass,
  const ProgressCallback& progress = {});

}

#endif
