#include "Imaging/AutomaticDenoising.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{

double NoiseSigma(const NoiseEstimate& noise, double voxel)
{
  return noise.Noise > 0.0 ? 1.5 * noise.Noise / voxel : 1.0;
}

void ChooseDenoising(
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

}
