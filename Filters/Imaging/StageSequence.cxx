#include "Imaging/StageSequence.h"

#include "Core/LargePages.h"
#include "Imaging/DiffusionEvaluation.h"

#include <algorithm>
#include <initializer_list>

namespace isthmus
{
namespace
{

/// The first of the volumes that is none of these.
template <typename T>
T* Free(const std::array<T*, 4>& volumes, std::initializer_list<const T*> taken)
{
  return *std::find_if(volumes.begin(), volumes.end(),
    [&](const T* volume) { return std::find(taken.begin(), taken.end(), volume) == taken.end(); });
}

/// What a pass of `stages` stages adds to the sums that still have terms.
template <typename T>
std::vector<StageSum<T>> PartOf(
  const std::vector<StageSum<T>>& sums, std::size_t done, std::size_t stages)
{
  std::vector<StageSum<T>> parts;
  for (const StageSum<T>& sum : sums)
  {
    if (sum.OfStage.size() > done)
    {
      const auto first = sum.OfStage.begin() + static_cast<std::ptrdiff_t>(done);
      const std::size_t terms = std::min(stages, sum.OfStage.size() - done);
      parts.push_back({ sum.Volume, { first, first + static_cast<std::ptrdiff_t>(terms) } });
    }
  }
  return parts;
}

}

template <typename T>
int StagesAtOnce(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion)
{
  return grid.ExchangeHalo ? 1 : StagesOfAPass(diffusion);
}

template <typename T>
T* EvaluateStages(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion,
  const StageSequence<T>& sequence, const ProgressCallback& progress)
{
  const std::size_t count = sequence.Updates.size();
  const auto most = static_cast<std::size_t>(StagesAtOnce(grid, diffusion));
  const auto& volumes = sequence.Volumes;
  DiffusionPass<T> pass;
  pass.Previous = sequence.Before;
  pass.Current = sequence.Current;
  pass.First = sequence.First;
  pass.FirstRate = sequence.FirstRate;
  for (std::size_t done = 0; done < count; done += pass.Updates.size())
  {
    const std::size_t stages = std::min(most, count - done);
    const auto first = sequence.Updates.begin() + static_cast<std::ptrdiff_t>(done);
    pass.Updates.assign(first, first + static_cast<std::ptrdiff_t>(stages));
    pass.Sums = PartOf(sequence.Sums, done, stages);
    // One stage alone may write where the values before the last lie: it reads them at their place.
    const auto before = std::find(volumes.begin(), volumes.end(), pass.Previous);
    const bool inPlace = stages == 1 && pass.Previous && before != volumes.end();
    pass.Out = inPlace ? *before : Free<T>(volumes, { pass.Previous, pass.Current });
    pass.OutBefore = stages > 1 && done + stages < count
      ? Free<T>(volumes, { pass.Previous, pass.Current, pass.Out })
      : nullptr;
    const auto share = [count](std::size_t n) { return double(n) / static_cast<double>(count); };
    const ProgressCallback part = Between(progress, share(done), share(done + stages));
    // On several ranks all must stop at the same place, so not inside a stage.
    Evaluate(diffusion, pass, grid.ExchangeHalo ? nullptr : part);
    Report(part, 1.0);
    grid.Exchange(pass.Out);
    pass.Previous = stages == 1 ? pass.Current : pass.OutBefore;
    pass.Current = pass.Out;
  }
  return pass.Out;
}

template <typename T>
StageVolumes<T>::StageVolumes(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion)
{
  const std::size_t count = StagesAtOnce(grid, diffusion) > 1 ? 4 : 2;
  std::generate_n(this->Owned.begin(), count, [&grid]() { return NewVolume<T>(grid.Size()); });
}

template <typename T>
std::array<T*, 4> StageVolumes<T>::Pointers() const
{
  std::array<T*, 4> pointers{};
  std::transform(this->Owned.begin(), this->Owned.end(), pointers.begin(),
    [](const std::unique_ptr<T[]>& volume) { return volume.get(); });
  return pointers;
}

template <typename T>
std::unique_ptr<T[]> NewVolume(std::int64_t size)
{
  std::unique_ptr<T[]> volume(new T[static_cast<std::size_t>(size)]);
  AdviseLargePages(volume.get(), static_cast<std::size_t>(size) * sizeof(T));
  return volume;
}

#define ISTHMUS_STAGE_SEQUENCE(T)                                                                  \
  template int StagesAtOnce(const DiffusionGrid<T>&, const DiffusionOperator<T>&);                 \
  template T* EvaluateStages(const DiffusionGrid<T>&, const DiffusionOperator<T>&,                 \
    const StageSequence<T>&, const ProgressCallback&);                                             \
  template class StageVolumes<T>;                                                                  \
  template std::unique_ptr<T[]> NewVolume(std::int64_t);

ISTHMUS_STAGE_SEQUENCE(float)
ISTHMUS_STAGE_SEQUENCE(double)

}
