/**
 * @file DiffusionReference.h
 * @brief A plain implementation of the diffusion flows, node by node, in double.
 */
#ifndef isthmus_DiffusionReference_h
#define isthmus_DiffusionReference_h

#include "Imaging/HighOrderDiffusion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace isthmus::testing
{

/// Node values whose indices are clamped to the grid: a mirror at half a voxel beyond the ends.
class ReferenceVolume
{
public:
  ReferenceVolume(DiffusionGrid<double> grid, std::vector<double> values)
    : Grid(std::move(grid))
    , Values(std::move(values))
  {
  }

  double operator()(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto& n = this->Grid.Dimensions;
    i = std::clamp<std::int64_t>(i, 0, n[0] - 1);
    j = std::clamp<std::int64_t>(j, 0, n[1] - 1);
    k = std::clamp<std::int64_t>(k, 0, n[2] - 1);
    return this->Values[static_cast<std::size_t>(i + n[0] * (j + n[1] * k))];
  }

  /// A volume of body(i, j, k).
  template <typename Body>
  ReferenceVolume Map(Body&& body) const
  {
    std::vector<double> result;
    const auto& n = this->Grid.Dimensions;
    for (std::int64_t k = 0; k < n[2]; ++k)
    {
      for (std::int64_t j = 0; j < n[1]; ++j)
      {
        for (std::int64_t i = 0; i < n[0]; ++i)
        {
          result.push_back(body(i, j, k));
        }
      }
    }
    return { this->Grid, result };
  }

  ReferenceVolume Laplacian() const
  {
    const ReferenceVolume& u = *this;
    const auto& h = this->Grid.Spacing;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        return (u(i - 1, j, k) - 2 * u(i, j, k) + u(i + 1, j, k)) / (h[0] * h[0]) +
          (u(i, j - 1, k) - 2 * u(i, j, k) + u(i, j + 1, k)) / (h[1] * h[1]) +
          (u(i, j, k - 1) - 2 * u(i, j, k) + u(i, j, k + 1)) / (h[2] * h[2]);
      });
  }

  /// A component of the gradient, one-sided at the ends.
  ReferenceVolume Slope(std::size_t axis) const
  {
    const ReferenceVolume& u = *this;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        const std::int64_t at[3] = { i, j, k };
        const bool end = at[axis] == 0 || at[axis] == this->Grid.Dimensions[axis] - 1;
        const auto x = std::int64_t(axis == 0), y = std::int64_t(axis == 1),
                   z = std::int64_t(axis == 2);
        return (u(i + x, j + y, k + z) - u(i - x, j - y, k - z)) /
          ((end ? 1 : 2) * this->Grid.Spacing[axis]);
      });
  }

  ReferenceVolume Squared() const
  {
    const ReferenceVolume& u = *this;
    return this->Map([&](auto i, auto j, auto k) { return u(i, j, k) * u(i, j, k); });
  }

  ReferenceVolume operator+(const ReferenceVolume& other) const
  {
    return this->Map([&](auto i, auto j, auto k) { return (*this)(i, j, k) + other(i, j, k); });
  }

  ReferenceVolume GradientSquared() const
  {
    return this->Slope(0).Squared() + this->Slope(1).Squared() + this->Slope(2).Squared();
  }

  /// div(f grad u), with face(a, b) the coefficient between nodes where `at` has a and b.
  template <typename Face>
  ReferenceVolume Divergence(const ReferenceVolume& at, Face&& face) const
  {
    const ReferenceVolume& u = *this;
    const auto& h = this->Grid.Spacing;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        double sum = 0.0;
        for (int axis = 0; axis < 3; ++axis)
        {
          for (int side = -1; side <= 1; side += 2)
          {
            const auto a = i + (axis == 0) * side, b = j + (axis == 1) * side,
                       c = k + (axis == 2) * side;
            const double width = h[static_cast<std::size_t>(axis)];
            sum += face(at(i, j, k), at(a, b, c)) * (u(a, b, c) - u(i, j, k)) / (width * width);
          }
        }
        return sum;
      });
  }

  /// Mean over a window of nodes, moved inwards where it would leave the grid.
  ReferenceVolume WindowMean(int window) const
  {
    const ReferenceVolume& u = *this;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        std::int64_t begin[3] = { i, j, k };
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          begin[axis] = std::clamp<std::int64_t>(
            begin[axis] - window / 2, 0, this->Grid.Dimensions[axis] - window);
        }
        double sum = 0.0;
        for (int n = 0; n < window * window * window; ++n)
        {
          sum += u(
            begin[0] + n % window, begin[1] + n / window % window, begin[2] + n / window / window);
        }
        return sum / std::pow(window, 3);
      });
  }

  DiffusionGrid<double> Grid;
  std::vector<double> Values;
};

/// Coefficient c of the hyperdiffusion (4.34; Sigma given, or 4.35).
inline ReferenceVolume ReferenceCoefficient(
  const ReferenceVolume& u, const DiffusionParameters& parameters)
{
  using Type = DiffusionParameters::EdgeStoppingType;
  const int window = parameters.Window;
  const ReferenceVolume slope = u.GradientSquared();
  ReferenceVolume meanSquare = u.Squared().WindowMean(window);
  ReferenceVolume squaredMean = u.WindowMean(window).Squared();
  if (parameters.Order > 0)
  {
    meanSquare = slope.WindowMean(window);
    squaredMean = u.Slope(0).WindowMean(window).Squared() +
      u.Slope(1).WindowMean(window).Squared() + u.Slope(2).WindowMean(window).Squared();
  }
  return u.Map(
    [&](auto i, auto j, auto k)
    {
      double variance = parameters.Sigma * parameters.Sigma;
      if (parameters.EdgeStopping == Type::None)
      {
        return 1.0;
      }
      if (parameters.EdgeStopping == Type::LocalVariance)
      {
        variance = meanSquare(i, j, k) - squaredMean(i, j, k);
      }
      return std::exp(-slope(i, j, k) / (2 * variance));
    });
}

/// Rate of change of u without fidelity and source.
inline ReferenceVolume ReferenceRate(
  const ReferenceVolume& u, const DiffusionParameters& parameters)
{
  ReferenceVolume power = u;
  ReferenceVolume rate = u.Map([](auto, auto, auto) { return 0.0; });
  const bool geometric = parameters.Flow == DiffusionParameters::FlowType::GeometricFlow;
  const ReferenceVolume c = ReferenceCoefficient(u, parameters);
  for (int p = 0; p <= parameters.Order; ++p)
  {
    if (p == parameters.Order || parameters.LowerOrders)
    {
      const double d = parameters.Diffusivity[static_cast<std::size_t>(p)] * (p % 2 == 0 ? 1 : -1);
      const ReferenceVolume slope = power.GradientSquared();
      const double variance = parameters.Sigma * parameters.Sigma;
      auto gram = [&](double a, double b)
      { return std::sqrt((1 + a / variance) / (1 + (a + b) / 2 / variance)); };
      auto mean = [](double a, double b) { return (a + b) / 2; };
      const ReferenceVolume term =
        geometric ? power.Divergence(slope, gram) : power.Divergence(c, mean);
      rate = rate.Map([&](auto i, auto j, auto k) { return rate(i, j, k) + d * term(i, j, k); });
    }
    power = power.Laplacian();
  }
  return rate;
}

}

#endif
