/**
 * @file AutomaticDenoising.h
 * @brief From a noise level and one wish, more or less, to a diffusion's parameters.
 */
#ifndef isthmus_AutomaticDenoising_h
#define isthmus_AutomaticDenoising_h

#include "HighOrderDiffusion.h"
#include "NoiseEstimate.h"

namespace isthmus
{

/// A gradient that noise alone rarely reaches; 1 for an image without noise.
VTKISTHMUS_EXPORT double NoiseSigma(const NoiseEstimate& noise);

/// Sets Sigma, PreSmoothing and Time (lengths in voxels) for `strength` from 0 to 1.
VTKISTHMUS_EXPORT void ChooseDenoising(
  const NoiseEstimate& noise, double strength, DiffusionParameters& parameters);

}

#endif
