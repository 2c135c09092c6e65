#include "Imaging/PDETransform.h"

#include "Core/Geometry.h"
#include "Core/RangeChecks.h"
#include "Imaging/ChebyshevFilter.h"
#include "Imaging/SuperTimeStepping.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
void Check(const PDETransformParameters& parameters)
{
  RequireRange("NumberOfModes", parameters.NumberOfModes, 1, 16);
  RequireRange("FirstOrder", parameters.FirstOrder, 0, 3);
  RequireRange("LastOrder", parameters.LastOrder, 0, parameters.FirstOrder,
    "Orders do not rise: FirstOrder is the highest.");
  RequireAbove("FirstWavelength", parameters.FirstWavelength, 0.0, Unlimited);
  RequireAbove("WavelengthRatio", parameters.WavelengthRatio, 1.0, 16.0);
}

DiffusionParameters LowPass(const PDETransformParameters& parameters, int k)
{
  DiffusionParameters diffusion;
  diffusion.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  diffusion.Order = std::max(parameters.LastOrder, parameters.FirstOrder - k);
  const double wavelength = parameters.FirstWavelength * std::pow(parameters.WavelengthRatio, k);
  const double wave = 2.0 * Pi / wavelength;
  diffusion.Time = std::log(2.0) / std::pow(wave, 2 * diffusion.Order + 2);
  return diffusion;
}

namespace
{

/// Coefficients of all low-passes from the input to X_(k+2), k the first index.
template <typename T>
std::vector<std::vector<double>> SeriesOfModes(
  const PDETransformParameters& parameters, double bound)
{
  std::vector<DiffusionParameters> lowPasses;
  std::vector<std::vector<double>> all;
  for (int k = 0; k < parameters.NumberOfModes; ++k)
  {
    lowPasses.push_back(LowPass(parameters, k));
    // Checked before the series is computed, which is about five times as long as this.
    const double wavelength = parameters.FirstWavelength * std::pow(parameters.WavelengthRatio, k);
    RequireEvaluations(std::sqrt(bound) * wavelength / (2.0 * Pi));
    all.push_back(ChebyshevSeries(
      [&](double share)
      {
        double exponent = 0.0;
        for (const DiffusionParameters& lowPass : lowPasses)
        {
          exponent += lowPass.Time * std::pow(share * bound, lowPass.Order + 1);
        }
        return std::exp(-exponent);
      },
      SeriesTolerance<T>()));
  }
  return all;
}

}

template <typename T>
void TransformByPDE(const DiffusionGrid<T>& grid, const PDETransformParameters& parameters,
  T* values, const std::vector<T*>& modes, const ProgressCallback& progress)
{
  Check(parameters);
  AddChebyshevSeries(
    grid, SeriesOfModes<T>(parameters, LaplacianBound<T>(grid.Spacing)), values, modes, progress);
  // modes[k] is X_(k+2) - X_1.
  ParallelFor(0, grid.Size(), 1 << 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t n = first; n < last; ++n)
      {
        T before = 0;
        for (T* mode : modes)
        {
          const T after = mode[n];
          mode[n] = before - after;
          before = after;
        }
        values[n] += before;
      }
    });
}

template void TransformByPDE(const DiffusionGrid<float>&, const PDETransformParameters&, float*,
  const std::vector<float*>&, const ProgressCallback&);
template void TransformByPDE(const DiffusionGrid<double>&, const PDETransformParameters&, double*,
  const std::vector<double*>&, const ProgressCallback&);

}
