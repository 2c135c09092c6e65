#include "Imaging/PDETransform.h"

#include "Core/Geometry.h"
#include "Imaging/SuperTimeStepping.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <type_traits>

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

namespace
{

/// The coefficients of the polynomial of degree `intervals` through f at 1 - 2s = cos(pi j /
/// intervals).
std::vector<double> Interpolate(const std::function<double(double)>& f, std::size_t intervals)
{
  std::vector<double> around(2 * intervals); // f once around the circle
  for (std::size_t j = 0; j <= intervals; ++j)
  {
    const double sine = std::sin(Pi * static_cast<double>(j) / static_cast<double>(2 * intervals));
    const double value = f(sine * sine);
    around[j] = value;
    around[(2 * intervals - j) % (2 * intervals)] = value;
  }
  std::vector<std::complex<double>> spectrum;
  Eigen::FFT<double>().fwd(spectrum, around);
  std::vector<double> coefficients(intervals + 1);
  for (std::size_t n = 0; n <= intervals; ++n)
  {
    const bool end = n == 0 || n == intervals;
    coefficients[n] = spectrum[n].real() / static_cast<double>(end ? 2 * intervals : intervals);
  }
  return coefficients;
}

double SumOfModuli(const std::vector<double>& terms, std::size_t first)
{
  return std::accumulate(terms.begin() + static_cast<std::ptrdiff_t>(first), terms.end(), 0.0,
    [](double sum, double term) { return sum + std::abs(term); });
}

/**
 * Coefficients a_n with f(s) = sum a_n T_n(1 - 2s) on [0, 1], as many as `tolerance` needs.
 *
 * Interpolates at cosines, twice as many until the second half of the coefficients is rounding, by
 * a fast Fourier transform; then leaves out the last ones while the sum of their moduli, which
 * bounds the error since |T_n| <= 1, stays below the tolerance.
 * @pre f is smooth, |f| <= 1 (steep near 0 it may be: s is exact there), and tolerance is 1e-14 or
 * more.
 * @throws std::invalid_argument for a series longer than MaximumEvaluations.
 */
std::vector<double> ChebyshevSeries(const std::function<double(double)>& f, double tolerance)
{
  std::size_t intervals = 32;
  std::vector<double> series = Interpolate(f, intervals);
  while (SumOfModuli(series, intervals / 2) > tolerance / 2)
  {
    intervals *= 2;
    RequireEvaluations(static_cast<double>(intervals) / 2); // at least so many are needed
    series = Interpolate(f, intervals);
  }
  double left = 0.0;
  while (series.size() > 2 && left + std::abs(series.back()) <= tolerance)
  {
    left += std::abs(series.back());
    series.pop_back();
  }
  return series;
}

/// -L's bound with room for the rounding of T, beyond which polynomials would grow without end.
template <typename T>
double SafeBound(const DiffusionOperator<T>& laplacian)
{
  return laplacian.SpectralBound() *
    (1.0 + 8.0 * static_cast<double>(std::numeric_limits<T>::epsilon()));
}

/// Coefficients of all low-passes from the input to X_(k+2), k the first index.
template <typename T>
std::vector<std::vector<double>> SeriesOfModes(
  const PDETransformParameters& parameters, double bound)
{
  const double tolerance = std::is_same_v<T, float> ? 1e-7 : 1e-13;
  std::vector<DiffusionParameters> lowPasses;
  std::vector<std::vector<double>> all;
  for (int k = 0; k < parameters.Modes; ++k)
  {
    lowPasses.push_back(LowPass(parameters, k));
    // Checked before the series is computed, which is about five times as long as this.
    const double wavelength = parameters.FirstWavelength * std::pow(parameters.Ratio, k);
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
      tolerance));
  }
  return all;
}

/// modes[k] = sum over n of series[k][n] (T_n u - u).
template <typename T>
void AddPolynomials(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& laplacian,
  const std::vector<std::vector<double>>& series, const T* values, const std::vector<T*>& modes,
  const ProgressCallback& progress)
{
  std::size_t terms = 0;
  StageSequence<T> recurrence;
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    terms = std::max(terms, series[k].size());
    std::fill_n(modes[k], grid.Size(), T(0));
    recurrence.Sums.push_back({ modes[k], std::vector<T>(series[k].begin() + 1, series[k].end()) });
  }
  const double factor = 4.0 / SafeBound(laplacian);
  RowUpdate<T> update;
  update.OfRate = static_cast<T>(factor / 2.0); // T_1; without values before it, an explicit step
  recurrence.Updates.push_back(update);
  update.OfCurrent = 2;
  update.OfPrevious = -1;
  update.OfRate = static_cast<T>(factor);
  recurrence.Updates.resize(terms - 1, update);
  recurrence.Current = values;
  recurrence.First = values;
  const StageVolumes<T> volumes(grid, laplacian);
  recurrence.Volumes = volumes.Pointers();
  EvaluateStages(grid, laplacian, recurrence, progress);
}

}

template <typename T>
void TransformByPDE(const DiffusionGrid<T>& grid, const PDETransformParameters& parameters,
  T* values, const std::vector<T*>& modes, const ProgressCallback& progress)
{
  Check(parameters);
  DiffusionOperator<T> laplacian;
  laplacian.Dimensions = grid.Dimensions;
  laplacian.Spacing = grid.Spacing;
  AddPolynomials(
    grid, laplacian, SeriesOfModes<T>(parameters, SafeBound(laplacian)), values, modes, progress);
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
