/**
 * @file ChebyshevFilter.h
 * @brief Functions of the discrete Laplacian, applied to a volume by a Chebyshev series.
 *
 * With L the 7-point Laplacian of the grid and b a bound of -L, a function f on [0, 1] gives
 *
 *     f(-L/b) u = u + sum_n a_n (T_n u - u),   T_(n+1) u = 2 T_n u - T_(n-1) u + 4/b L T_n u,
 *
 * for f with f(0) = 1 (H. Tal-Ezer, SIAM J. Numer. Anal. 26 (1989) 1). The part dropped is below
 * 1e-7 (float) or 1e-13 (double) of the input in the root mean square, since |T_n| <= 1 on the
 * spectrum.
 */
#ifndef isthmus_ChebyshevFilter_h
#define isthmus_ChebyshevFilter_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"

#include <array>
#include <functional>
#include <vector>

namespace isthmus
{

/// An upper bound of -L, with a margin for the rounding of T, since the recurrence would grow
/// beyond the bound.
template <typename T>
double LaplacianBound(const std::array<double, 3>& spacing);

/// Truncation error allowed for the series: 1e-7 for float, 1e-13 for double.
template <typename T>
constexpr double SeriesTolerance();

template <>
constexpr double SeriesTolerance<float>()
{
  return 1e-7;
}

template <>
constexpr double SeriesTolerance<double>()
{
  return 1e-13;
}

/**
 * Coefficients a_n with f(s) = sum a_n T_n(1 - 2s) on [0, 1], as many as `tolerance` requires.
 *
 * The last coefficients are dropped while the sum of their moduli, which bounds the error, stays
 * below the tolerance.
 * @pre f is smooth, |f| <= 1 (it may be steep near 0, where s is exact), tolerance >= 1e-14.
 * @throws std::invalid_argument for a series longer than MaximumEvaluations.
 */
std::vector<double> ChebyshevSeries(const std::function<double(double)>& f, double tolerance);

/// The coefficients of the polynomial of degree `intervals` through f at 1 - 2s = cos(pi j /
/// intervals).
std::vector<double> ChebyshevInterpolation(
  const std::function<double(double)>& f, std::size_t intervals);

/// changes[k] = sum over n > 0 of series[k][n] (T_n u - u), u the values, in one recurrence.
template <typename T>
void AddChebyshevSeries(const DiffusionGrid<T>& grid,
  const std::vector<std::vector<double>>& series, const T* values, const std::vector<T*>& changes,
  const ProgressCallback& progress);

/// Fills basis[n] with T_n u for n from 1; basis[0] holds u.
/// @pre one rank.
template <typename T>
void FillChebyshevBasis(const DiffusionGrid<T>& grid, const std::vector<T*>& basis);

}

#endif
