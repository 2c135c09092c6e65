#include "Imaging/AutomaticDenoising.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{

double NoiseGradient(const NoiseEstimate& noise, double voxel)
{
  return noise.Noise > 0.0 ? 1.5 * noise.Noise / voxel : 1.0;
}

void ChooseDenoisingParameters(
  const NoiseEstimate& noise, double strength, double voxel, DiffusionParameters& parameters)
{
  const double variance = noise.Deviation * noise.Deviation - noise.Noise * noise.Noise;
  const double signal = std::sqrt(std::max(variance, 1e-3 * noise.Deviation * noise.Deviation));
  if (!(noise.Noise > 0.0) || !(signal > 0.0))
  {
    parameters.Time = 0.0; // nothing to remove
    return;
  }
  // Fitted to the optima found by search on a phantom at signal-to-noise ratios 1, 0.3 and 0.1
  // (ratios of variances, so 1, 1.8 and 3.2 here); README has the table.
  const double ratio = noise.Noise / signal;
  parameters.Sigma = 0.32 * signal / voxel;
  parameters.PreSmoothing = voxel * std::clamp(0.9 * std::pow(ratio, 0.25), 0.5, 3.0);
  // Lower orders spread wider for the same detail kept, higher ones less.
  constexpr double ofOrder[] = { 1.6, 1.0, 0.85, 0.75 };
  const double length =
    voxel * 1.26 * std::pow(std::min(ratio, 10.0), 0.35) * std::exp2(strength - 0.5);
  parameters.ResidualSmoothing = 1.45 * length;
  parameters.Time = std::pow(ofOrder[parameters.Order] * length, 2 * parameters.Order + 2) /
    parameters.Diffusivity[static_cast<std::size_t>(parameters.Order)];
}

namespace
{

/// Replaces a[n] by body(a[n], b[n]), in parallel.
template <typename T, typename Body>
void Combine(std::int64_t size, T* a, const T* b, Body&& body)
{
  ParallelFor(0, size, 1 << 16,
    [=](std::int64_t first, std::int64_t last)
    { std::transform(a + first, a + last, b + first, a + first, body); });
}

}

template <typename T>
void AddSmoothedResidual(const DiffusionGrid<T>& grid, double deviation, T* residual, T* values,
  const ProgressCallback& progress)
{
  Combine(grid.Size(), residual, values, [](T input, T value) { return input - value; });
  DiffusionParameters heat;
  heat.Order = 0;
  heat.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  heat.Time = deviation * deviation / 2.0;
  // Explicit steps of 0.6 of the limit leave next to nothing of the shortest waves, which are
  // noise; super steps would halve them at best.
  heat.Integrator = DiffusionParameters::IntegratorType::ForwardEuler;
  heat.Steps =
    static_cast<int>(std::ceil(heat.Time / (0.6 * ExplicitStepLimit(heat, grid.Spacing))));
  Diffuse<T>(grid, heat, residual, nullptr, nullptr, progress);
  Combine(grid.Size(), values, residual, [](T value, T back) { return value + back; });
}

template void AddSmoothedResidual(
  const DiffusionGrid<float>&, double, float*, float*, const ProgressCallback&);
template void AddSmoothedResidual(
  const DiffusionGrid<double>&, double, double*, double*, const ProgressCallback&);

}
