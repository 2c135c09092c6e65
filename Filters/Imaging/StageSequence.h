/**
 * @file StageSequence.h
 * @brief Many stages of one recurrence, several in each pass over memory.
 */
#ifndef isthmus_StageSequence_h
#define isthmus_StageSequence_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/DiffusionOperator.h"

#include <array>
#include <memory>
#include <vector>

namespace isthmus
{

/// Each stage goes from the two before it (and the first values) to the next; see DiffusionPass.
template <typename T>
struct StageSequence
{
  std::vector<RowUpdate<T>> Updates; ///< one for each stage
  const T* Before = nullptr;         ///< If null, the first stage is an explicit step.
  const T* Current = nullptr;
  const T* First = nullptr;
  const T* FirstRate = nullptr; ///< may be null, see DiffusionPass
  /// Where stages are written; Before and Current may be among them. The third and fourth are used
  /// where StagesAtOnce is more than 1.
  std::array<T*, 4> Volumes{};
  std::vector<StageSum<T>> Sums; ///< Each may be for the first stages only.
};

/// How many stages one pass does: on several ranks one, since each needs its own halo.
template <typename T>
int StagesAtOnce(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

/// Does all stages (one at least) and returns the volume that holds the last one's result; bit for
/// bit the same however many stages a pass does. @throws Cancelled when progress says so.
template <typename T>
T* EvaluateStages(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion,
  const StageSequence<T>& sequence, const ProgressCallback& progress);

/// As many volumes as EvaluateStages needs, 2 or 4.
template <typename T>
class StageVolumes
{
public:
  StageVolumes(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

  std::array<T*, 4> Pointers() const;

private:
  std::array<std::unique_ptr<T[]>, 4> Owned;
};

/// A volume's memory, left uninitialised: whoever writes it first touches it first.
template <typename T>
std::unique_ptr<T[]> NewVolume(std::int64_t size);

}

#endif
