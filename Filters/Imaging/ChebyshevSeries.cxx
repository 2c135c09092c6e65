#include "Imaging/ChebyshevSeries.h"

#include "Core/Geometry.h"
#include "Imaging/TimeSteps.h"

#include <unsupported/Eigen/FFT>

#include <cmath>
#include <complex>
#include <numeric>

namespace isthmus
{
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

}

std::vector<double> ChebyshevSeries(const std::function<double(double)>& f, double tolerance)
{
  std::size_t intervals = 32;
  std::vector<double> series = Interpolate(f, intervals);
  while (SumOfModuli(series, intervals / 2) > tolerance / 2)
  {
    intervals *= 2;
    DemandEvaluations(static_cast<double>(intervals) / 2); // at least so many are needed
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

}
