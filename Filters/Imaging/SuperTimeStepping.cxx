#include "Imaging/SuperTimeStepping.h"

#include "Core/LargePages.h"
#include "Core/NumberText.h"
#include "Imaging/DiffusionEvaluation.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>

namespace isthmus
{
namespace
{

[[noreturn]] void RefuseSteps(double time, double limit, int count, const char* integrator)
{
  throw std::invalid_argument(
    JoinText("With Steps = ", count, " a step is ", time / count, " long, but ", integrator,
      " is stable only up to ", limit, " for these orders, diffusivities and spacing: take ",
      std::ceil(time / limit), " steps or more, or Steps = 0 for automatic ones."));
}

/// Length that `stages` stages reach, in explicit steps.
double Reach(int stages)
{
  const double s = stages;
  return (s * s + s - 2.0) / 4.0;
}

/// The same of the first-order method.
double FirstOrderReach(int stages)
{
  const double s = stages;
  return (s * s + s) / 2.0;
}

/// The next odd number, at least `fewest`: even ones damp the fastest mode less.
int OddStages(double needed, int fewest)
{
  const auto stages = static_cast<int>(std::ceil(needed * (1.0 - 1e-12)));
  return std::max(fewest, stages + (stages % 2 == 0));
}

double B(int j)
{
  return j < 2 ? 1.0 / 3.0 : (j * j + j - 2.0) / (2.0 * j * (j + 1.0));
}

}

void RequireEvaluations(double evaluations)
{
  if (!(evaluations <= MaximumEvaluations))
  {
    throw std::invalid_argument(JoinText("This takes ", evaluations,
      " evaluations of the equation, or more; the most is ", MaximumEvaluations,
      ". Lower the end time or the diffusivities, or use SuperTimeStepping or a coarser grid."));
  }
}

int SuperStages(double length, double limit)
{
  return OddStages((std::sqrt(9.0 + 16.0 * length / limit) - 1.0) / 2.0, 3);
}

int FirstOrderStages(double length, double limit)
{
  return OddStages((std::sqrt(1.0 + 8.0 * length / limit) - 1.0) / 2.0, 1);
}

std::vector<TimeStep> EulerSteps(double time, double limit, int count)
{
  if (count > 0 && time / count > limit * (1.0 + 1e-9))
  {
    RefuseSteps(time, limit, count, "ForwardEuler");
  }
  constexpr double safety = 0.9;
  const double steps = count > 0 ? count : std::max(1.0, std::ceil(time / (safety * limit)));
  RequireEvaluations(steps);
  return std::vector<TimeStep>(static_cast<std::size_t>(steps), { time / steps, 1 });
}

std::vector<TimeStep> SuperSteps(double time, double limit, int count)
{
  const double longest = limit * Reach(MaximumStages);
  std::vector<TimeStep> steps;
  // Each step has three stages at least; the longest, MaximumStages.
  RequireEvaluations(count > 0 ? 3.0 * count : time / longest * MaximumStages);
  if (count > 0)
  {
    if (time / count > longest * (1.0 + 1e-9))
    {
      RefuseSteps(time, longest, count, "SuperTimeStepping");
    }
    steps.assign(static_cast<std::size_t>(count), { time / count, 0 });
  }
  else
  {
    // A super step only halves modes that decay much faster than its length, so fast modes need
    // short steps at the beginning. So do the edges, which appear while the noise decays.
    constexpr double growth = 2.0;
    const double parts = std::max(12.0, 0.19 * std::sqrt(time / limit));
    const double last = std::min(longest, std::max(limit * Reach(5), time / parts));
    double length = limit;
    double sum = 0.0;
    while (sum < time)
    {
      steps.push_back({ length, 0 });
      sum += length;
      length = std::min(last, length * growth);
    }
    for (TimeStep& step : steps)
    {
      step.Length *= time / sum; // shorter: as many stages still reach it
    }
  }
  for (TimeStep& step : steps)
  {
    step.Stages = SuperStages(step.Length, limit);
  }
  return steps;
}

template <typename T>
RowUpdate<T> LegendreStage(int j, int stages, double length)
{
  const double w = 1.0 / Reach(stages);
  RowUpdate<T> update;
  if (j == 1)
  {
    update.RateFactor = static_cast<T>(B(1) * w * length);
    return update;
  }
  const double mu = (2.0 * j - 1.0) / j * B(j) / B(j - 1);
  const double nu = -(j - 1.0) / j * B(j) / B(j - 2);
  update.CurrentFactor = static_cast<T>(mu);
  update.PreviousFactor = static_cast<T>(nu);
  update.RateFactor = static_cast<T>(mu * w * length);
  update.FirstRateFactor = static_cast<T>(-(1.0 - B(j - 1)) * mu * w * length);
  return update;
}

template <typename T>
RowUpdate<T> FirstOrderLegendreStage(int j, int stages, double length)
{
  const double w = 1.0 / FirstOrderReach(stages), mu = (2.0 * j - 1.0) / j;
  RowUpdate<T> update;
  update.CurrentFactor = static_cast<T>(mu);
  update.PreviousFactor = static_cast<T>(1.0 - mu);
  update.RateFactor = static_cast<T>(mu * w * length);
  return update;
}

template RowUpdate<float> LegendreStage(int, int, double);
template RowUpdate<double> LegendreStage(int, int, double);
template RowUpdate<float> FirstOrderLegendreStage(int, int, double);
template RowUpdate<double> FirstOrderLegendreStage(int, int, double);

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
std::vector<StageSum<T>> PassSums(
  const std::vector<StageSum<T>>& sums, std::size_t done, std::size_t stages)
{
  std::vector<StageSum<T>> parts;
  for (const StageSum<T>& sum : sums)
  {
    if (sum.StageFactors.size() > done)
    {
      const auto first = sum.StageFactors.begin() + static_cast<std::ptrdiff_t>(done);
      const std::size_t terms = std::min(stages, sum.StageFactors.size() - done);
      parts.push_back({ sum.Volume, { first, first + static_cast<std::ptrdiff_t>(terms) } });
    }
  }
  return parts;
}

}

template <typename T>
int StagesPerPass(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion)
{
  return grid.ExchangeHalo ? 1 : StagesPerPass(diffusion);
}

template <typename T>
T* EvaluateStages(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion,
  const StageSequence<T>& sequence, const ProgressCallback& progress)
{
  const std::size_t count = sequence.Updates.size();
  const auto most = static_cast<std::size_t>(StagesPerPass(grid, diffusion));
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
    pass.Sums = PassSums(sequence.Sums, done, stages);
    // A single stage may overwrite the values before the last, since it reads each only at the node
    // that it writes.
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
  const std::size_t count = StagesPerPass(grid, diffusion) > 1 ? 4 : 2;
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
  template int StagesPerPass(const DiffusionGrid<T>&, const DiffusionOperator<T>&);                \
  template T* EvaluateStages(const DiffusionGrid<T>&, const DiffusionOperator<T>&,                 \
    const StageSequence<T>&, const ProgressCallback&);                                             \
  template class StageVolumes<T>;                                                                  \
  template std::unique_ptr<T[]> NewVolume(std::int64_t);

ISTHMUS_STAGE_SEQUENCE(float)
ISTHMUS_STAGE_SEQUENCE(double)

}
