/**
 * @file DenoiseMap.h
 * @brief Denoises a volume by the diffusion with the least estimated error.
 *
 * The diffusion is chosen on a sample of the volume (DenoisingRisk.h, VolumeSample.h) and applied
 * to the whole: a linear one as a function of the Laplacian (ChebyshevFilter.h), one with edge
 * stopping by time steps (HighOrderDiffusion.h). The constant background of a masked map keeps its
 * value.
 */
#ifndef isthmus_DenoiseMap_h
#define isthmus_DenoiseMap_h

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

struct DenoiseMapParameters : DenoisingSearch
{
  double KnownNoise =
    0.0; ///< standard deviation of white noise; 0: level and spectrum are estimated
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const DenoiseMapParameters& parameters);

struct DenoiseMapResult
{
  /// Nothing changed.
  DenoiseMapResult()
  {
    this->Diffusion.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
    this->Diffusion.Time = 0.0;
  }

  DiffusionParameters Diffusion; ///< what was applied; Time 0: nothing was changed
  DiffusionReport Report;
  NoiseEstimate Estimate;  ///< of white noise, and the deviation of the values
  double NoiseLevel = 0.0; ///< standard deviation of the noise that the choice was made for
  bool White = true;       ///< the noise was assumed to be white
  bool Background = true;  ///< false: coloured noise without background to measure it in
  double Gain = 0.0;       ///< estimated, dB
  double GainError = 0.0;  ///< standard error of Gain, dB
  std::vector<double> RiskTime, RiskValue; ///< RiskValue in squared data units (Goal volumes)

  bool IsLinear() const
  {
    return this->Diffusion.EdgeStopping == DiffusionParameters::EdgeStoppingType::None;
  }

  /// "Order 2, linear, time 0.05; estimated gain 11.2 dB".
  std::string Sentence() const;
};

/**
 * Denoises `values` in place. `noise` (may be null) is a volume of noise like that in `values`,
 * which then gives level and spectrum. A mask or labels (NoiseEstimate::FewValues) are not changed.
 *
 * Memory: one volume beside `values` for linear choices and the rows of SweepBytes (3 volumes on
 * several ranks), for edge stopping those of Diffuse and one more; in addition the sample, up to
 * 100 MiB whatever the size of the volume.
 * @throws Cancelled if `progress` returns false; otherwise the exceptions of Diffuse.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT DenoiseMapResult DenoiseMap(const DiffusionGrid<T>& grid,
  const DenoiseMapParameters& parameters, T* values, const T* noise,
  const ProgressCallback& progress = {});

}

#endif
