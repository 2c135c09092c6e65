#include "PDETransform.h"

#include "Pi.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus
{
namespace
{

void Require(bool holds, const char* sentence)
{
  if (!holds)
  {
    throw std::invalid_argument(sentence);
  }
}

}

void Check(const PDETransformParameters& parameters)
{
  Require(parameters.Modes >= 1 && parameters.Modes <= 16, "NumberOfModes must be from 1 to 16.");
  Require(parameters.LastOrder >= 0 && parameters.LastOrder <= parameters.FirstOrder &&
      parameters.FirstOrder <= 3,
    "Orders must fall: 3 >= FirstOrder >= LastOrder >= 0.");
  Require(parameters.FirstWavelength > 0.0 && std::isfinite(parameters.FirstWavelength),
    "FirstWavelength must be finite and positive.");
  Require(parameters.Ratio > 1.0 && parameters.Ratio <= 16.0,
    "WavelengthRatio must be above 1 and at most 16.");
}

DiffusionParameters LowPass(const PDETransformParameters& parameters, int k)
{
  DiffusionParameters diffusion;
  diffusion.EdgeStopping = DiffusionParameters::EdgeStoppingType::None;
  diffusion.Order = std::max(parameters.LastOrder, parameters.FirstOrder - k);
  const double wavelength = parameters.FirstWavelength * std::pow(parameters.Ratio, k);
  const double wave = 2.0 * Pi / wavelength;
  diffusion.Time = std::log(2.0) / std::pow(wave, 2 * diffusion.Order + 2);
  return diffusion;
}

template <typename T>
void TransformByPDE(const DiffusionGrid<T>& grid, const PDETransformParameters& parameters,
  T* values, const std::function<void(int k, const T* before, const T* after)>& takeMode,
  const ProgressCallback& progress)
{
  Check(parameters);
  std::vector<T> before(static_cast<std::size_t>(grid.Size()));
  for (int k = 0; k < parameters.Modes; ++k)
  {
    std::copy_n(values, grid.Size(), before.begin());
    Diffuse<T>(grid, LowPass(parameters, k), values, nullptr, nullptr,
      Between(progress, double(k) / parameters.Modes, double(k + 1) / parameters.Modes));
    takeMode(k, before.data(), values);
  }
}

template void TransformByPDE(const DiffusionGrid<float>&, const PDETransformParameters&, float*,
  const std::function<void(int, const float*, const float*)>&, const ProgressCallback&);
template void TransformByPDE(const DiffusionGrid<double>&, const PDETransformParameters&, double*,
  const std::function<void(int, const double*, const double*)>&, const ProgressCallback&);

}
