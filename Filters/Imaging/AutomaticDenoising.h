/**
 * @file AutomaticDenoising.h
 * @brief Denoising with automatic parameters: chosen by risk, or by a rule, and residual smoothing.
 *
 * **By risk** (DenoisingRisk.h): the diffusion whose estimated error on a sample of the volume is
 * least is applied to the whole. A linear one is applied exactly, as a function of the Laplacian
 * (ChebyshevFilter.h); one with edge stopping by time steps. Constant background of a masked map
 * (VolumeSample.h) keeps its value.
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
#include "Imaging/DenoisingRisk.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/HighOrderDiffusion.h"
#include "Imaging/NoiseEstimate.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <string>
#include <vector>

namespace isthmus
{

struct AutomaticParameters
{
  DenoisingSearch Search;
  double KnownNoise = 0.0; ///< standard deviation of white noise; 0: estimated
  /// Estimate for volumes that are too small to measure a spectrum in; 0: there is no noise.
  double SimpleEstimate = 0.0;
  /// Of the run with edge stopping.
  DiffusionParameters::IntegratorType Integrator =
    DiffusionParameters::IntegratorType::SuperTimeStepping;
  int Steps = 0;
};

struct AutomaticResult
{
  /// Nothing changed.
  AutomaticResult()
  {
    this->Parameters.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
    this->Parameters.Order = 0;
    this->Parameters.Time = 0.0;
  }

  DiffusionParameters Parameters; ///< those used; Time 0: nothing was changed
  DiffusionReport Report;
  double NoiseLevel = 0.0;
  bool White = true;      ///< the noise was taken to be white
  bool Background = true; ///< False: coloured noise without background to measure it in
  double Gain = 0.0;      ///< estimated, dB
  double GainError = 0.0; ///< standard error of it, dB
  std::vector<double> RiskTime, RiskValue; ///< RiskValue in squared data units (Goal volumes)

  /// "Order 2, linear, time 0.05; estimated gain 11.2 dB".
  std::string Sentence() const;
};

/**
 * Denoises `values` in place. `noise` (may be null) is a volume of noise like that in the values,
 * whose level and spectrum are then used.
 *
 * Memory: 5 volumes beside `values` for linear choices (3 on several ranks), for edge stopping
 * those of Diffuse and one more; and the sample, up to 100 MiB.
 * @throws Cancelled when progress says so; otherwise as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT AutomaticResult DenoiseByRisk(const DiffusionGrid<T>& grid,
  const AutomaticParameters& parameters, T* values, const T* noise,
  const ProgressCallback& progress = {});

/// A gradient that noise alone rarely reaches, data unit per length, where `voxel` is the
/// length between nodes; 1 for an image without noise.
VTKISTHMUSFILTERSIMAGING_EXPORT double NoiseGradient(const NoiseEstimate& noise, double voxel);

/**
 * The rule for equations that the search by risk does not cover (geometric flow, several orders
 * together, local variance, fidelity, a source).
 *
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
