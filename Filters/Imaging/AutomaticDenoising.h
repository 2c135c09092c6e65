/**
 * @file AutomaticDenoising.h
 * @brief Denoising with parameters that are chosen automatically, by risk or by a rule, and
 * residual smoothing.
 *
 * **By risk (DenoisingRisk.h): the diffusion with the least estimated error on a sample of the
 * volume is applied to the whole. A linear diffusion is applied exactly, as a function of the
 * Laplacian (ChebyshevFilter.h), and one with edge stopping by time steps. The constant background
 * of a masked map (VolumeSample.h) keeps its value.
 *
 * **Residual smoothing** returns what a denoising filter removed from long waves, where it is
 * signal and not noise:
 *
 *     result + G (input - result),   G a Gaussian (by heat flow, Neumann boundaries)
 *
 * The residual of a good denoiser contains only noise; what a low-pass filter finds in it is mostly
 * structure (J. W. Tukey, "Exploratory data analysis", 1977, called adding it back twicing; S.
 * Osher et al., Multiscale Model. Simul. 4 (2005) 460, for diffusions). Waves much longer than G
 * are restored to those of the input, waves much shorter remain those of the result, and in between
 * both are averaged, which has a smaller error than the worse of the two. The mean becomes the
 * input's.
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

struct AutomaticParameters : DenoisingSearch
{
  double KnownNoise = 0.0; ///< standard deviation of white noise; 0: estimated
  /// Estimate for volumes that are too small to measure a spectrum in; 0: there is no noise.
  double SimpleEstimate = 0.0;
  /// The report of the run with edge stopping.
  DiffusionParameters::IntegratorType Integrator = DiffusionParameters().Integrator;
  int Steps = DiffusionParameters().Steps;
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const AutomaticParameters& parameters);

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
 * Denoises `values` in place. `noise` (may be null) is a volume of noise like that in `values`; its
 * level and spectrum are then used.
 *
 * Memory: 5 volumes beside `values` for linear choices (3 on several ranks), for edge stopping
 * those of Diffuse and one more; in addition the sample, up to 100 MiB.
 * @throws Cancelled if `progress` returns false; otherwise the exceptions of Diffuse.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT AutomaticResult DenoiseByRisk(const DiffusionGrid<T>& grid,
  const AutomaticParameters& parameters, T* values, const T* noise,
  const ProgressCallback& progress = {});

/// A gradient, in data units per length, that noise alone rarely reaches; 1 for an image without
/// noise. `voxel` is the grid spacing.
VTKISTHMUSFILTERSIMAGING_EXPORT double NoiseGradient(const NoiseEstimate& noise, double voxel);

/**
 * Chooses parameters by a rule, for equations that the search by risk does not cover (geometric
 * flow, several orders together, local variance, fidelity, a source).
 *
 * Sets Sigma, PreSmoothing, Time and ResidualSmoothing for parameters.Order, its diffusivity, and a
 * strength from 0 (light) to 1 (strong); `voxel` is the grid spacing. Sigma is a third of the
 * standard deviation of the signal (that of all values minus the part due to noise). PreSmoothing
 * and the smoothing length grow with the ratio of noise to signal; the residual is smoothed a
 * little more than the image. Without noise, Time is 0.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT void ChooseDenoisingParameters(
  const NoiseEstimate& noise, double strength, double voxel, DiffusionParameters& parameters);

/**
 * Adds the smoothed residual to `values`. `deviation` (a length above 0) is the standard deviation
 * of G; `residual` holds the input and is overwritten. Memory: one volume in addition to these two.
 * Cost: about 5 (deviation / spacing)^2 evaluations of the heat equation. Throws as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void AddSmoothedResidual(const DiffusionGrid<T>& grid,
  double deviation, T* residual, T* values, const ProgressCallback& progress = {});

}

#endif
