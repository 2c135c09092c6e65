/**
 * @file AutomaticDenoising.h
 * @brief Denoising with automatic parameters: chosen from the noise level, and residual smoothing.
 *
 * **Residual smoothing** returns what a denoising filter removed from long waves, where it is
 * signal and not noise:
 *
 *     result + G (input - result),   G a Gaussian (by heat flow, Neumann boundaries)
 *
 * The residual of a good denoiser is noise alone; what a low-pass finds in it is mostly structure
 * (J. W. Tukey, "Exploratory data analysis", 1977, called adding it back twicing; S. Osher et al.,
 * Multiscale Model. Simul. 4 (2005) 460, for diffusions). Waves much longer than G become those of
 * the input again, waves much shorter stay those of the result, and between them both are averaged,
 * which has less error than the worse of the two. The mean becomes the input's.
 */
#ifndef isthmus_AutomaticDenoising_h
#define isthmus_AutomaticDenoising_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/HighOrderDiffusion.h"
#include "Imaging/NoiseEstimate.h"
#include "vtkIsthmusFiltersImagingModule.h"

namespace isthmus
{

/// A gradient that noise alone rarely reaches, data unit per length, where `voxel` is the
/// length between nodes; 1 for an image without noise.
VTKISTHMUSFILTERSIMAGING_EXPORT double NoiseGradient(const NoiseEstimate& noise, double voxel);

/**
 * Sets Sigma, PreSmoothing, Time and ResidualSmoothing for parameters.Order, its diffusivity, and a
 * `strength` from 0 (light) to 1 (strong); `voxel` is the length between nodes. Sigma is a third of
 * the signal's standard deviation (that of all values without the noise's share), PreSmoothing and
 * the length to smooth over grow with the ratio of noise to signal; the residual is smoothed a
 * little more than the image. Without noise, Time is 0.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT void ChooseDenoisingParameters(
  const NoiseEstimate& noise, double strength, double voxel, DiffusionParameters& parameters);

/**
 * Adds the smoothed residual to `values`. `deviation` (length, above 0) is G's; `residual` holds
 * the input, which is overwritten. Memory: a volume beside these two. Cost: about 5 (deviation /
 * spacing)^2 evaluations of the heat equation. Throws as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void AddSmoothedResidual(const DiffusionGrid<T>& grid,
  double deviation, T* residual, T* values, const ProgressCallback& progress = {});

}

#endif
