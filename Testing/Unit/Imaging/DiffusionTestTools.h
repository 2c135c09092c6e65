/**
 * @file DiffusionTestTools.h
 * @brief Grids, noise and norms for the tests of the diffusion filters.
 */
#ifndef isthmus_DiffusionTestTools_h
#define isthmus_DiffusionTestTools_h

#include "Imaging/HighOrderDiffusion.h"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace isthmus::testing
{

template <typename T>
DiffusionGrid<T> Grid(std::int64_t nx, std::int64_t ny, std::int64_t nz)
{
  DiffusionGrid<T> grid;
  grid.Dimensions = { nx, ny, nz };
  return grid;
}

/// Normal noise; the same on every machine.
template <typename T>
std::vector<T> Noise(const DiffusionGrid<T>& grid, double deviation = 1.0, unsigned seed = 1)
{
  std::mt19937 bits(seed);
  std::vector<T> values(static_cast<std::size_t>(grid.Size()));
  for (T& value : values)
  {
    // Sum of twelve uniform numbers: sufficiently close to normal, and defined by the standard.
    double sum = -6.0;
    for (int n = 0; n < 12; ++n)
    {
      sum += static_cast<double>(bits()) / 4294967296.0;
    }
    value = static_cast<T>(deviation * sum);
  }
  return values;
}

template <typename T>
double Mean(const std::vector<T>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Root mean square of a - b.
template <typename A, typename B>
double Distance(const std::vector<A>& a, const std::vector<B>& b)
{
  double sum = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n)
  {
    const double difference = static_cast<double>(a[n]) - static_cast<double>(b[n]);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

template <typename T>
double Deviation(const std::vector<T>& values)
{
  return Distance(values, std::vector<double>(values.size(), Mean(values)));
}

template <typename T>
std::vector<T> Diffused(const DiffusionGrid<T>& grid, const DiffusionParameters& parameters,
  std::vector<T> values, DiffusionReport* report = nullptr)
{
  const std::vector<T> input = parameters.Fidelity > 0.0 ? values : std::vector<T>();
  const DiffusionReport told =
    Diffuse<T>(grid, parameters, values.data(), input.empty() ? nullptr : input.data(), nullptr);
  if (report)
  {
    *report = told;
  }
  return values;
}

}

#endif
