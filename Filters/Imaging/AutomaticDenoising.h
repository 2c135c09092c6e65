/**
 * @file AutomaticDenoising.h
 * @brief From a noise level and one wish, more or less, to a diffusion's parameters.
 */
#ifndef isthmus_AutomaticDenoising_h
#define isthmus_AutomaticDenoising_h

#include "Imaging/HighOrderDiffusion.h"
#include "Imaging/NoiseEstimate.h"
#include "vtkIsthmusFiltersImagingModule.h"

namespace isthmus
{

/// A gradient that noise alone rarely reaches, data unit per length, where `voxel` is the
/// length between nodes; 1 for an image without noise.
VTKISTHMUSFILTERSIMAGING_EXPORT double NoiseSigma(const NoiseEstimate& noise, double voxel);

/**
 * Sets Sigma, PreSmoothing, Time and ResidualSmoothing for parameters.Order, its diffusivity, and a
 * `strength` from 0 (light) to 1 (strong); `voxel` is the length between nodes. Sigma is a third of
 * the signal's standard deviation (that of all values without the noise's share), PreSmoothing and
 * the length to smooth over grow with the ratio of noise to signal; the residual is smoothed a
 * little more than the image. Without noise, Time is 0.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT void ChooseDenoising(
  const NoiseEstimate& noise, double strength, double voxel, DiffusionParameters& parameters);

}

#endif
