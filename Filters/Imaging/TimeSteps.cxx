#include "Imaging/TimeSteps.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace isthmus
{
namespace
{

[[noreturn]] void RefuseSteps(double time, double limit, int count, const char* integrator)
{
  std::ostringstream text;
  text << "With Steps = " << count << " a step is " << time / count << " long, but " << integrator
       << " is stable only up to " << limit << " for these orders, diffusivities and spacing: take "
       << std::ceil(time / limit) << " steps or more, or Steps = 0 for automatic ones.";
  throw std::invalid_argument(text.str());
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

void DemandEvaluations(double evaluations)
{
  if (!(evaluations <= MaximumEvaluations))
  {
    std::ostringstream text;
    text << "This takes " << evaluations << " evaluations of the equation, or more; the most is "
         << MaximumEvaluations
         << ". Lower the end time or the diffusivities, take SuperTimeStepping, or a coarser grid.";
    throw std::invalid_argument(text.str());
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
  DemandEvaluations(steps);
  return std::vector<TimeStep>(static_cast<std::size_t>(steps), { time / steps, 1 });
}

std::vector<TimeStep> SuperSteps(double time, double limit, int count)
{
  const double longest = limit * Reach(MaximumStages);
  std::vector<TimeStep> steps;
  // Each step has three stages at least; the longest, MaximumStages.
  DemandEvaluations(count > 0 ? 3.0 * count : time / longest * MaximumStages);
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
    update.OfRate = static_cast<T>(B(1) * w * length);
    return update;
  }
  const double mu = (2.0 * j - 1.0) / j * B(j) / B(j - 1);
  const double nu = -(j - 1.0) / j * B(j) / B(j - 2);
  update.OfCurrent = static_cast<T>(mu);
  update.OfPrevious = static_cast<T>(nu);
  update.OfRate = static_cast<T>(mu * w * length);
  update.OfFirstRate = static_cast<T>(-(1.0 - B(j - 1)) * mu * w * length);
  return update;
}

template <typename T>
RowUpdate<T> FirstOrderLegendreStage(int j, int stages, double length)
{
  const double w = 1.0 / FirstOrderReach(stages), mu = (2.0 * j - 1.0) / j;
  RowUpdate<T> update;
  update.OfCurrent = static_cast<T>(mu);
  update.OfPrevious = static_cast<T>(1.0 - mu);
  update.OfRate = static_cast<T>(mu * w * length);
  return update;
}

template RowUpdate<float> LegendreStage(int, int, double);
template RowUpdate<double> LegendreStage(int, int, double);
template RowUpdate<float> FirstOrderLegendreStage(int, int, double);
template RowUpdate<double> FirstOrderLegendreStage(int, int, double);

}
