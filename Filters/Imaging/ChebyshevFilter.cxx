#include "Imaging/ChebyshevFilter.h"

#include "Core/Geometry.h"
#include "Imaging/DiffusionEvaluation.h"
#include "Imaging/StageSweep.h"
#include "Imaging/SuperTimeStepping.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace isthmus
{

std::vector<double> ChebyshevInterpolation(
  const std::function<double(double)>& f, std::size_t intervals)
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

namespace
{

double SumOfModuli(const std::vector<double>& terms, std::size_t first)
{
  return std::accumulate(terms.begin() + static_cast<std::ptrdiff_t>(first), terms.end(), 0.0,
    [](double sum, double term) { return sum + std::abs(term); });
}

}

std::vector<double> ChebyshevSeries(const std::function<double(double)>& f, double tolerance)
{
  std::size_t intervals = 32;
  std::vector<double> series = ChebyshevInterpolation(f, intervals);
  while (SumOfModuli(series, intervals / 2) > tolerance / 2)
  {
    intervals *= 2;
    RequireEvaluations(static_cast<double>(intervals) / 2); // the least number that is needed
    series = ChebyshevInterpolation(f, intervals);
  }
  double left = 0.0;
  while (series.size() > 2 && left + std::abs(series.back()) <= tolerance)
  {
    left += std::abs(series.back());
    series.pop_back();
  }
  return series;
}

namespace
{

template <typename T>
DiffusionOperator<T> Laplacian(const DiffusionGrid<T>& grid)
{
  DiffusionOperator<T> laplacian;
  laplacian.Dimensions = grid.Dimensions;
  laplacian.Spacing = grid.Spacing;
  return laplacian;
}

/// T_1 from T_0; without values before it, an explicit step.
template <typename T>
RowUpdate<T> FirstTerm(double bound)
{
  RowUpdate<T> update;
  update.RateFactor = static_cast<T>(2.0 / bound);
  return update;
}

/// T_(n+1) from T_n and T_(n-1).
template <typename T>
RowUpdate<T> NextTerm(double bound)
{
  RowUpdate<T> update;
  update.CurrentFactor = 2;
  update.PreviousFactor = -1;
  update.RateFactor = static_cast<T>(4.0 / bound);
  return update;
}

}

template <typename T>
double LaplacianBound(const std::array<double, 3>& spacing)
{
  DiffusionOperator<T> laplacian;
  laplacian.Spacing = spacing;
  return laplacian.SpectralBound() *
    (1.0 + 8.0 * static_cast<double>(std::numeric_limits<T>::epsilon()));
}

template <typename T>
void AddChebyshevSeries(const DiffusionGrid<T>& grid,
  const std::vector<std::vector<double>>& series, const T* values, const std::vector<T*>& changes,
  const ProgressCallback& progress)
{
  const DiffusionOperator<T> laplacian = Laplacian(grid);
  const double bound = LaplacianBound<T>(grid.Spacing);
  std::size_t terms = 2;
  std::vector<StageSum<T>> sums;
  for (std::size_t k = 0; k < changes.size(); ++k)
  {
    terms = std::max(terms, series[k].size());
    sums.push_back({ changes[k], std::vector<T>(series[k].begin() + 1, series[k].end()) });
  }
  std::vector<RowUpdate<T>> updates(terms - 1, NextTerm<T>(bound));
  updates.front() = FirstTerm<T>(bound);
  constexpr double volumes = 4.0; // that the other way takes
  const double volumeBytes = static_cast<double>(grid.Size()) * sizeof(T);
  if (!grid.ExchangeHalo && SweepBytes(grid, updates.size()) < volumes * volumeBytes)
  {
    SweepStages(grid, updates, values, sums, progress);
    return;
  }
  std::for_each(
    changes.begin(), changes.end(), [&grid](T* change) { std::fill_n(change, grid.Size(), T(0)); });
  StageSequence<T> recurrence;
  recurrence.Updates = updates;
  recurrence.Sums = sums;
  recurrence.Current = values;
  recurrence.First = values;
  const StageVolumes<T> between(grid, laplacian);
  recurrence.Volumes = between.Pointers();
  EvaluateStages(grid, laplacian, recurrence, progress);
}

template <typename T>
void FillChebyshevBasis(const DiffusionGrid<T>& grid, const std::vector<T*>& basis)
{
  const DiffusionOperator<T> laplacian = Laplacian(grid);
  const double bound = LaplacianBound<T>(grid.Spacing);
  for (std::size_t n = 1; n < basis.size(); ++n)
  {
    DiffusionPass<T> pass;
    pass.Updates.push_back(n == 1 ? FirstTerm<T>(bound) : NextTerm<T>(bound));
    pass.Current = basis[n - 1];
    pass.Previous = n == 1 ? nullptr : basis[n - 2];
    pass.First = n == 1 ? nullptr : basis[0];
    pass.Out = basis[n];
    Evaluate(laplacian, pass);
  }
}

#define ISTHMUS_CHEBYSHEV_FILTER(T)                                                                \
  template double LaplacianBound<T>(const std::array<double, 3>&);                                 \
  template void AddChebyshevSeries(const DiffusionGrid<T>&,                                        \
    const std::vector<std::vector<double>>&, const T*, const std::vector<T*>&,                     \
    const ProgressCallback&);                                                                      \
  template void FillChebyshevBasis(const DiffusionGrid<T>&, const std::vector<T*>&);

ISTHMUS_CHEBYSHEV_FILTER(float)
ISTHMUS_CHEBYSHEV_FILTER(double)

}
