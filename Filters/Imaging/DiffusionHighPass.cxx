#include "Imaging/DiffusionHighPass.h"

#include "Core/RangeChecks.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr std::int64_t grain = 1 << 16;

/// Solves u' = a (v - u), v' = b (u - v) over `time`.
template <typename T>
void Couple(std::int64_t size, const HighPassParameters& parameters, double time, T* u, T* v)
{
  const double a = parameters.CouplingU, b = parameters.CouplingV;
  if (a + b == 0.0)
  {
    return;
  }
  // The difference decays at the rate a + b; b u + a v is constant.
  const double gone = -std::expm1(-(a + b) * time);
  const T ofU = static_cast<T>(a / (a + b) * gone), ofV = static_cast<T>(b / (a + b) * gone);
  ParallelFor(0, size, grain,
    [=](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        const T difference = v[n] - u[n];
        u[n] += ofU * difference;
        v[n] -= ofV * difference;
      }
    });
}

/// A number of steps in each of which coupling and the slower diffusion change little.
int AutomaticSteps(const HighPassParameters& parameters)
{
  const double coupling = parameters.CouplingU + parameters.CouplingV;
  const bool coupled = coupling > 0.0;
  const double wanted = coupled ? std::ceil(4.0 * coupling * parameters.Time) : 1.0;
  return static_cast<int>(std::clamp(wanted, coupled ? 8.0 : 1.0, 1000.0));
}

/// A lower bound of the evaluations of both diffusions, by the bound of the Laplacian.
double MinimumEvaluations(
  const std::array<double, 3>& spacing, const HighPassParameters& parameters, int steps)
{
  double perTime = 0.0;
  for (const double h : spacing)
  {
    perTime += 2.0 / (h * h);
  }
  double sum = 0.0;
  for (const double d : { parameters.DiffusivityU, parameters.DiffusivityV })
  {
    // A super step of s stages reaches about s^2 / 4 explicit ones, and s is at most MaximumStages.
    const double explicitSteps = d * perTime * parameters.Time / steps;
    const double stages = std::max(3.0, 2.0 * std::sqrt(explicitSteps));
    sum += d > 0.0 ? steps * (stages < MaximumStages ? stages : 4.0 * explicitSteps / MaximumStages)
                   : 0.0;
  }
  return std::max(sum, static_cast<double>(steps));
}

}

void Check(const HighPassParameters& parameters)
{
  RequireRange("DiffusivityU", parameters.DiffusivityU, 0.0, Unlimited);
  RequireRange("DiffusivityV", parameters.DiffusivityV, 0.0, Unlimited);
  RequireRange("CouplingU", parameters.CouplingU, 0.0, Unlimited);
  RequireRange("CouplingV", parameters.CouplingV, 0.0, Unlimited);
  RequireRange("Time", parameters.Time, 0.0, Unlimited);
  RequireRange("Sigma", parameters.Sigma, 0.0, Unlimited);
  RequireRange("Steps", parameters.Steps, 0, Unlimited, "0 stands for automatic steps.");
}

template <typename T>
void EvolveHighPass(const DiffusionGrid<T>& grid, const HighPassParameters& parameters, T* u, T* v,
  const ProgressCallback& progress)
{
  Check(parameters);
  const int steps = parameters.Steps > 0 ? parameters.Steps : AutomaticSteps(parameters);
  RequireEvaluations(MinimumEvaluations(grid.Spacing, parameters, steps));
  const double length = parameters.Time / steps;
  DiffusionParameters diffusion;
  diffusion.Order = 0;
  diffusion.EdgeStopping = parameters.Sigma > 0.0 ? DiffusionParameters::EdgeStoppingType::Gaussian
                                                  : DiffusionParameters::EdgeStoppingType::None;
  diffusion.Sigma = parameters.Sigma;
  diffusion.Time = length;
  const std::array<T*, 2> fields{ u, v };
  const std::array<double, 2> diffusivities{ parameters.DiffusivityU, parameters.DiffusivityV };
  for (int step = 0; step < steps; ++step)
  {
    Couple(grid.Size(), parameters, length / 2, u, v);
    for (std::size_t field = 0; field < 2; ++field)
    {
      diffusion.Diffusivity[0] = diffusivities[field];
      const double begin = (step + 0.5 * static_cast<double>(field)) / steps;
      if (diffusion.Diffusivity[0] > 0.0 && length > 0.0)
      {
        Diffuse<T>(grid, diffusion, fields[field], nullptr, nullptr,
          Between(progress, begin, begin + 0.5 / steps));
      }
      Report(progress, begin + 0.5 / steps);
    }
    Couple(grid.Size(), parameters, length / 2, u, v);
  }
}

template void EvolveHighPass(
  const DiffusionGrid<float>&, const HighPassParameters&, float*, float*, const ProgressCallback&);
template void EvolveHighPass(const DiffusionGrid<double>&, const HighPassParameters&, double*,
  double*, const ProgressCallback&);

}
