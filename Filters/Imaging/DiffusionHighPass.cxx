#include "Imaging/DiffusionHighPass.h"

#include "Core/NumberText.h"

#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t grain = 1 << 16;

/// Solves u' = a (v - u), v' = b (u - v) over `time`.
template <typename T>
void Couple(std::int64_t size, const HighPassParameters& parameters, double time, T* u, T* v)
{
  const double a = parameters.Coupling[0], b = parameters.Coupling[1];
  if (a + b == 0.0)
  {
    return;
  }
  // The difference decays at the rate a + b; b u + a v is kept.
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

/// So many that neither coupling nor the slower diffusion does much within one.
int AutomaticSteps(const HighPassParameters& parameters)
{
  const double coupling = parameters.Coupling[0] + parameters.Coupling[1];
  const bool coupled = coupling > 0.0;
  const double wanted = coupled ? std::ceil(4.0 * coupling * parameters.Time) : 1.0;
  return static_cast<int>(std::clamp(wanted, coupled ? 8.0 : 1.0, 1000.0));
}

/// At least so many of both diffusions, by the bound of the plain Laplacian in three dimensions.
double EvaluationsOf(
  const std::array<double, 3>& spacing, const HighPassParameters& parameters, int steps)
{
  double perTime = 0.0;
  for (const double h : spacing)
  {
    perTime += 2.0 / (h * h);
  }
  double sum = 0.0;
  for (const double d : parameters.Diffusivity)
  {
    // A super step of s stages reaches about s^2 / 4 explicit ones, and s is at most MaximumStages.
    const double explicitSteps = d * perTime * parameters.Time / steps;
    const double stages = std::max(3.0, 2.0 * std::sqrt(explicitSteps));
    sum += d > 0.0 ? steps * (stages < MaximumStages ? stages : 4.0 * explicitSteps / MaximumStages)
                   : 0.0;
  }
  return std::max(sum, static_cast<double>(steps));
}

void RequireAll(const std::array<double, 2>& values, const char* what)
{
  for (const double value : values)
  {
    if (!(value >= 0.0) || !std::isfinite(value))
    {
      throw std::invalid_argument(std::string(what) + " is " + FormatNumber(value) +
        ", but must be finite and not negative.");
    }
  }
}

}

void Check(const HighPassParameters& parameters)
{
  RequireAll(parameters.Diffusivity, "A diffusivity");
  RequireAll(parameters.Coupling, "A coupling");
  RequireAll({ parameters.Time, parameters.Sigma }, "Time or Sigma");
  if (parameters.Steps < 0)
  {
    throw std::invalid_argument("Steps is " + std::to_string(parameters.Steps) +
      ", but must be positive, or 0 for automatic steps.");
  }
}

template <typename T>
void EvolveHighPass(const DiffusionGrid<T>& grid, const HighPassParameters& parameters, T* u, T* v,
  const ProgressCallback& progress)
{
  Check(parameters);
  const int steps = parameters.Steps > 0 ? parameters.Steps : AutomaticSteps(parameters);
  RequireEvaluations(EvaluationsOf(grid.Spacing, parameters, steps));
  const double length = parameters.Time / steps;
  DiffusionParameters diffusion;
  diffusion.Order = 0;
  diffusion.EdgeStopping = parameters.Sigma > 0.0 ? DiffusionParameters::EdgeStoppingType::Gaussian
                                                  : DiffusionParameters::EdgeStoppingType::None;
  diffusion.Sigma = parameters.Sigma;
  diffusion.Time = length;
  const std::array<T*, 2> fields{ u, v };
  for (int step = 0; step < steps; ++step)
  {
    Couple(grid.Size(), parameters, length / 2, u, v);
    for (std::size_t field = 0; field < 2; ++field)
    {
      diffusion.Diffusivity[0] = parameters.Diffusivity[field];
      const double begin = (step + 0.5 * static_cast<double>(field)) / steps;
      if (diffusion.Diffusivity[0] > 0.0)
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
