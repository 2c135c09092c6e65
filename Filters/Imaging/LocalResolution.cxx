#include "Imaging/LocalResolution.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>

namespace isthmus
{
namespace
{

using NodeIndex = std::array<std::int64_t, 3>;
using Complex = std::complex<float>;

constexpr std::int64_t windowSide = 24;
constexpr double mostWindows = 2000.0;

/// Windows of one size on a lattice that covers the grid.
class WindowedCorrelation
{
public:
  WindowedCorrelation(const NodeIndex& dimensions, const std::array<double, 3>& spacing)
    : Dimensions(dimensions)
    , Spacing(spacing)
  {
    double nodes = 1.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Side[a] = std::min(windowSide, dimensions[a]);
      nodes *= static_cast<double>(dimensions[a] - this->Side[a] + 1);
      this->Length = std::max(this->Length, spacing[a] * static_cast<double>(this->Side[a]));
      this->Finest = std::min(this->Finest, this->Side[a] > 1 ? spacing[a] : this->Finest);
    }
    const double stride = std::max(6.0, std::cbrt(nodes / mostWindows));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t room = dimensions[a] - this->Side[a];
      this->Count[a] = 1 + static_cast<std::int64_t>(std::ceil(double(room) / stride));
      for (std::int64_t n = 0; n < this->Count[a]; ++n)
      {
        this->Begin[a].push_back(this->Count[a] > 1 ? room * n / (this->Count[a] - 1) : 0);
      }
      for (std::int64_t i = 0; i < this->Side[a]; ++i)
      {
        const double phase = Pi * (double(i) + 0.5) / double(this->Side[a]);
        this->Taper[a].push_back(
          this->Side[a] > 1 ? static_cast<float>(std::sin(phase) * std::sin(phase)) : 1.0f);
      }
    }
    this->FindShells();
  }

  std::int64_t Windows() const { return this->Count[0] * this->Count[1] * this->Count[2]; }

  /// The frequency at which the halves cease to correlate in a window.
  double Frequency(
    std::int64_t window, const std::vector<float>& one, const std::vector<float>& other) const
  {
    std::vector<double> cross(this->Shells, 0.0), first(this->Shells, 0.0),
      second(this->Shells, 0.0);
    const std::vector<Complex> a = this->Transform(window, one);
    const std::vector<Complex> b = this->Transform(window, other);
    for (std::size_t n = 1; n < a.size(); ++n)
    {
      const std::size_t shell = this->ShellNumbers[n];
      if (shell < this->Shells)
      {
        cross[shell] += static_cast<double>((a[n] * std::conj(b[n])).real());
        first[shell] += static_cast<double>(std::norm(a[n]));
        second[shell] += static_cast<double>(std::norm(b[n]));
      }
    }
    constexpr double threshold = 0.5;
    double before = 1.0;
    for (std::size_t shell = 1; shell < this->Shells; ++shell)
    {
      const double power = std::sqrt(first[shell] * second[shell]);
      const double correlation = power > 0.0 ? cross[shell] / power : 0.0;
      if (correlation < threshold)
      {
        const double part = (before - threshold) / std::max(1e-12, before - correlation);
        return std::max(1.0, double(shell) - 1.0 + part) / this->Length;
      }
      before = correlation;
    }
    return 0.5 / this->Finest;
  }

  /// Position of a node on the lattice of the windows' centers along an axis.
  double LatticePosition(std::int64_t node, std::size_t axis) const
  {
    if (this->Count[axis] == 1)
    {
      return 0.0;
    }
    const double room = double(this->Dimensions[axis] - this->Side[axis]);
    const double place =
      (double(node) - 0.5 * double(this->Side[axis] - 1)) / room * double(this->Count[axis] - 1);
    return std::clamp(place, 0.0, double(this->Count[axis] - 1));
  }

  const NodeIndex& Lattice() const { return this->Count; }

private:
  /// The shell of each wave: its frequency in units of one over the window's length.
  void FindShells()
  {
    const std::int64_t size = this->Side[0] * this->Side[1] * this->Side[2];
    this->Shells = static_cast<std::size_t>(std::floor(0.5 * this->Length / this->Finest)) + 1;
    for (std::int64_t n = 0; n < size; ++n)
    {
      const NodeIndex at{ n % this->Side[0], n / this->Side[0] % this->Side[1],
        n / (this->Side[0] * this->Side[1]) };
      double square = 0.0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const std::int64_t wave = std::min(at[a], this->Side[a] - at[a]);
        const double f = double(wave) / (this->Spacing[a] * double(this->Side[a]));
        square += f * f;
      }
      this->ShellNumbers.push_back(
        static_cast<std::size_t>(std::lround(std::sqrt(square) * this->Length)));
    }
  }

  /// Scaled by a power of two: squares have single precision.
  static void ScaleToOne(std::vector<Complex>& block)
  {
    float largest = 0.0f;
    for (const Complex& value : block)
    {
      largest = std::max(largest, std::abs(value.real()));
    }
    int exponent = 0;
    std::frexp(largest, &exponent);
    for (Complex& value : block)
    {
      value = std::ldexp(value.real(), -exponent);
    }
  }

  std::vector<Complex> Transform(std::int64_t window, const std::vector<float>& values) const
  {
    const NodeIndex at{ window % this->Count[0], window / this->Count[0] % this->Count[1],
      window / (this->Count[0] * this->Count[1]) };
    std::vector<Complex> block;
    block.reserve(this->ShellNumbers.size());
    double mean = 0.0;
    for (int pass = 0; pass < 2; ++pass)
    {
      double sum = 0.0;
      for (std::int64_t k = 0; k < this->Side[2]; ++k)
      {
        for (std::int64_t j = 0; j < this->Side[1]; ++j)
        {
          for (std::int64_t i = 0; i < this->Side[0]; ++i)
          {
            const std::int64_t node = i + this->Begin[0][std::size_t(at[0])] +
              this->Dimensions[0] *
                (j + this->Begin[1][std::size_t(at[1])] +
                  this->Dimensions[1] * (k + this->Begin[2][std::size_t(at[2])]));
            const float value = values[static_cast<std::size_t>(node)];
            sum += double(value);
            if (pass == 1)
            {
              block.emplace_back((value - static_cast<float>(mean)) *
                  this->Taper[0][std::size_t(i)] * this->Taper[1][std::size_t(j)] *
                  this->Taper[2][std::size_t(k)],
                0.0f);
            }
          }
        }
      }
      mean = sum / static_cast<double>(this->ShellNumbers.size());
    }
    ScaleToOne(block);
    const NodeIndex step{ 1, this->Side[0], this->Side[0] * this->Side[1] };
    Eigen::FFT<float> transform;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::int64_t n = this->Side[a];
      if (n == 1)
      {
        continue;
      }
      std::vector<Complex> line(static_cast<std::size_t>(n)), waves;
      for (std::int64_t start = 0; start < std::int64_t(block.size()); ++start)
      {
        if (start / step[a] % n != 0)
        {
          continue;
        }
        for (std::int64_t i = 0; i < n; ++i)
        {
          line[std::size_t(i)] = block[std::size_t(start + i * step[a])];
        }
        transform.fwd(waves, line);
        for (std::int64_t i = 0; i < n; ++i)
        {
          block[std::size_t(start + i * step[a])] = waves[std::size_t(i)];
        }
      }
    }
    return block;
  }

  NodeIndex Dimensions, Side{ 1, 1, 1 }, Count{ 1, 1, 1 };
  std::array<double, 3> Spacing;
  double Length = 0.0, Finest = 1e300;
  std::array<std::vector<std::int64_t>, 3> Begin;
  std::array<std::vector<float>, 3> Taper;
  std::vector<std::size_t> ShellNumbers;
  std::size_t Shells = 0;
};

}

void FindLocalResolution(const NodeIndex& dimensions, const std::array<double, 3>& spacing,
  const std::vector<float>& one, const std::vector<float>& other, float* resolution,
  const ProgressCallback& progress)
{
  const WindowedCorrelation windows(dimensions, spacing);
  std::vector<double> frequencies(static_cast<std::size_t>(windows.Windows()));
  ParallelFor(
    0, windows.Windows(), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t window = first; window < last; ++window)
      {
        frequencies[static_cast<std::size_t>(window)] = windows.Frequency(window, one, other);
      }
    },
    progress);
  const NodeIndex lattice = windows.Lattice();
  ParallelFor(0, dimensions[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * dimensions[0] * dimensions[1];
           node < last * dimensions[0] * dimensions[1]; ++node)
      {
        const NodeIndex at{ node % dimensions[0], node / dimensions[0] % dimensions[1],
          node / (dimensions[0] * dimensions[1]) };
        double sum = 0.0;
        for (int corner = 0; corner < 8; ++corner)
        {
          double weight = 1.0;
          std::int64_t index = 0, stride = 1;
          for (std::size_t a = 0; a < 3; ++a)
          {
            const double place = windows.LatticePosition(at[a], a);
            const auto low =
              std::min(static_cast<std::int64_t>(place), std::max<std::int64_t>(0, lattice[a] - 2));
            const double part = place - double(low);
            const bool high = (corner >> a & 1) != 0;
            weight *= high ? part : 1.0 - part;
            index += std::min(low + (high ? 1 : 0), lattice[a] - 1) * stride;
            stride *= lattice[a];
          }
          sum += weight * frequencies[static_cast<std::size_t>(index)];
        }
        resolution[node] = static_cast<float>(1.0 / sum);
      }
    });
}

}
