/**
 * @file StageSweep.h
 * @brief All stages of a long recurrence with the Laplacian in one pass over a volume, which needs
 * rings of rows instead of volumes for what lies between them.
 *
 * Stage n is done in plane z - n and row y - n while the first values of plane z and row y are
 * read: all that it reads is then there, of each stage only the last three planes, and of these
 * only a strip of rows, are needed again, and no node is computed twice. Strips follow each other
 * along y, each behind the one before it, whose last two rows of each stage and plane it reads.
 */
#ifndef isthmus_StageSweep_h
#define isthmus_StageSweep_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/DiffusionOperator.h"

#include <vector>

namespace isthmus
{

/// Bytes that SweepStages allocates: about those of two planes (along x and z) for each stage.
template <typename T>
double SweepBytes(const DiffusionGrid<T>& grid, std::size_t stages);

/**
 * Does the stages of a recurrence u -> L u on one rank, beginning with an explicit step from
 * `first`, and sets the volume of each sum to its factors times (stage s - first); what the volume
 * held before is not read. Bitwise the same as EvaluateStages, on any number of threads, since
 * every row is computed by the same kernels.
 *
 * @throws Cancelled if `progress`, which is called about ten times a second, returns false.
 */
template <typename T>
void SweepStages(const DiffusionGrid<T>& grid, const std::vector<RowUpdate<T>>& updates,
  const T* first, const std::vector<StageSum<T>>& sums, const ProgressCallback& progress);

}

#endif
