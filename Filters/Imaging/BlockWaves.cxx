#include "Imaging/BlockWaves.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

/// Orthonormal cosine transform along one axis, by its matrix.
void TransformAxis(std::vector<double>& values, const Index3& size, std::size_t axis)
{
  const std::int64_t n = size[axis];
  if (n == 1)
  {
    return;
  }
  std::vector<double> matrix(static_cast<std::size_t>(n * n));
  for (std::int64_t k = 0; k < n; ++k)
  {
    const double norm = std::sqrt((k == 0 ? 1.0 : 2.0) / static_cast<double>(n));
    for (std::int64_t i = 0; i < n; ++i)
    {
      matrix[static_cast<std::size_t>(k * n + i)] =
        norm * std::cos(Pi * static_cast<double>(k * (2 * i + 1)) / static_cast<double>(2 * n));
    }
  }
  const std::int64_t step = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
  const std::int64_t total = size[0] * size[1] * size[2];
  std::vector<double> line(static_cast<std::size_t>(n));
  for (std::int64_t at = 0; at < total; ++at)
  {
    if (at / step % n != 0)
    {
      continue;
    }
    for (std::int64_t i = 0; i < n; ++i)
    {
      line[static_cast<std::size_t>(i)] = values[static_cast<std::size_t>(at + i * step)];
    }
    for (std::int64_t k = 0; k < n; ++k)
    {
      values[static_cast<std::size_t>(at + k * step)] = std::inner_product(
        line.begin(), line.end(), matrix.begin() + static_cast<std::ptrdiff_t>(k * n), 0.0);
    }
  }
}

}

std::vector<double> AxisModes(std::int64_t n, double spacing, double bound)
{
  std::vector<double> modes(static_cast<std::size_t>(n));
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    const double sine = std::sin(Pi * static_cast<double>(k) / (2.0 * static_cast<double>(n)));
    modes[k] = 4.0 * sine * sine / (spacing * spacing * bound);
  }
  return modes;
}

double SpectralBound(const std::array<double, 3>& spacing)
{
  double bound = 0.0;
  for (const double h : spacing)
  {
    bound += 4.0 / (h * h);
  }
  return bound;
}

std::size_t FrequencyBin(double s)
{
  return std::min(waveBins - 1, static_cast<std::size_t>(std::sqrt(s) * double(waveBins)));
}

BlockWaves TransformBlocks(const NoiseBlocks& blocks, const std::array<double, 3>& spacing)
{
  BlockWaves waves;
  waves.Size = blocks.Size;
  const Index3 size = blocks.Size;
  const double bound = SpectralBound(spacing);
  std::array<std::vector<double>, 3> modes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    modes[a] = AxisModes(size[a], spacing[a], bound);
  }
  const std::int64_t nodes = size[0] * size[1] * size[2];
  waves.Bin.resize(static_cast<std::size_t>(nodes), -1);
  for (std::int64_t n = 1; n < nodes; ++n)
  {
    waves.Bin[static_cast<std::size_t>(n)] =
      static_cast<int>(FrequencyBin(modes[0][static_cast<std::size_t>(n % size[0])] +
        modes[1][static_cast<std::size_t>(n / size[0] % size[1])] +
        modes[2][static_cast<std::size_t>(n / (size[0] * size[1]))]));
  }
  waves.Squares.resize(blocks.Values.size());
  ParallelFor(0, static_cast<std::int64_t>(blocks.Values.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t block = first; block < last; ++block)
      {
        const auto& values = blocks.Values[static_cast<std::size_t>(block)];
        std::vector<double> amplitudes(values.begin(), values.end());
        for (std::size_t a = 0; a < 3; ++a)
        {
          TransformAxis(amplitudes, size, a);
        }
        auto& squares = waves.Squares[static_cast<std::size_t>(block)];
        squares.resize(amplitudes.size());
        std::transform(amplitudes.begin(), amplitudes.end(), squares.begin(),
          [](double amplitude) { return static_cast<float>(amplitude * amplitude); });
      }
    });
  return waves;
}

double SpreadAtQuantile(double degrees, double z)
{
  const double a = 2.0 / (9.0 * degrees);
  return std::pow(std::max(0.05, 1.0 - a + z * std::sqrt(a)), 3);
}

double Quantile(std::vector<double> values, double share)
{
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}
