/**
 * @file DiffusionEvaluation.h
 * @brief Evaluates a DiffusionOperator on a whole grid, in one pass over memory.
 *
 * The pass walks through tiles of rows, plane after plane; intermediate results (W at every order,
 * c, and all stages except the last) are kept in ring buffers of a few planes that stay in cache,
 * so that each volume is transferred from memory only once for all stages of the pass.
 */
#ifndef isthmus_DiffusionEvaluation_h
#define isthmus_DiffusionEvaluation_h

#include "Core/Progress.h"
#include "Imaging/DiffusionOperator.h"

namespace isthmus
{

/// Number of stages of this operator that should be done in one pass for best performance.
template <typename T>
int StagesPerPass(const DiffusionOperator<T>& diffusion);

/**
 * Does the stages of a pass on all nodes, in parallel. The result is bitwise the same on any number
 * of threads and for any number of stages in a pass, because every node is computed by the same row
 * kernels.
 *
 * Memory: for each thread half a MiB of scratch, two MiB with several stages, or a few planes if
 * rows are very long. `progress` is called about every tenth of a second; if it returns false,
 * Cancelled is thrown.
 */
template <typename T>
void Evaluate(const DiffusionOperator<T>& diffusion, const DiffusionPass<T>& pass,
  const ProgressCallback& progress = {});

}

#endif
