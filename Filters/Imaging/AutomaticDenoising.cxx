#include "AutomaticDenoising.h"

namespace isthmus
{

double NoiseSigma(const NoiseEstimate& noise)
{
  return noise.Noise > 0.0 ? noise.Noise : 1.0;
}

void ChooseDenoising(const NoiseEstimate& noise, double strength, DiffusionParameters& parameters)
{
  parameters.Sigma = NoiseSigma(noise);
  parameters.PreSmoothing = 1.0;
  parameters.Time = strength * 10.0;
}

}
