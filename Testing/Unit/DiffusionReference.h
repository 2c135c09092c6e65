/**
 * @file DiffusionReference.h
 * @brief The equations of the diffusion flows written down plainly, node by node, in double.
 */
#ifndef isthmus_DiffusionReference_h
#define isthmus_DiffusionReference_h

#include "HighOrderDiffusion.h"

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

  ReferenceVolume GradientSquared() const
  {
    const ReferenceVolume& u = *this;
    const auto& h = this->Grid.Spacing;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        const double x = (u(i + 1, j, k) - u(i - 1, j, k)) / (2 * h[0]);
        const double y = (u(i, j + 1, k) - u(i, j - 1, k)) / (2 * h[1]);
        const double z = (u(i, j, k + 1) - u(i, j, k - 1)) / (2 * h[2]);
        return x * x + y * y + z * z;
      });
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

  /// Mean over a window of nodes.
  ReferenceVolume WindowMean(int window) const
  {
    const ReferenceVolume& u = *this;
    return this->Map(
      [&](auto i, auto j, auto k)
      {
        const int r = window / 2;
        double sum = 0.0;
        for (int c = -r; c <= r; ++c)
        {
          for (int b = -r; b <= r; ++b)
          {
            for (int a = -r; a <= r; ++a)
            {
              sum += u(i + a, j + b, k + c);
            }
          }
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
  const ReferenceVolume slope = u.GradientSquared();
  const ReferenceVolume square = parameters.Order == 0
    ? u.Map([&](auto i, auto j, auto k) { return u(i, j, k) * u(i, j, k); })
    : slope;
  const ReferenceVolume meanSquare = square.WindowMean(parameters.Window);
  const ReferenceVolume mean = u.WindowMean(parameters.Window);
  const ReferenceVolume slopeOfMean = mean.GradientSquared();
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
        variance = meanSquare(i, j, k) -
          (parameters.Order == 0 ? mean(i, j, k) * mean(i, j, k) : slopeOfMean(i, j, k));
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
