#include "Curvature/GaussianDerivative.h"

#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr int stencilWidth = 2 * DifferenceReach + 1;
using Stencil = std::array<double, stencilWidth>;

/// Weights of the central difference of an order of derivative (0 to 2) and of accuracy (2, 4, 6).
Stencil CentralDifference(int derivative, int accuracy, double spacing)
{
  static constexpr double first[3][3] = { { 1.0 / 2, 0.0, 0.0 }, { 2.0 / 3, -1.0 / 12, 0.0 },
    { 3.0 / 4, -3.0 / 20, 1.0 / 60 } };
  static constexpr double second[3][3] = { { 1.0, 0.0, 0.0 }, { 4.0 / 3, -1.0 / 12, 0.0 },
    { 3.0 / 2, -3.0 / 20, 1.0 / 90 } };
  Stencil weights{};
  weights[DifferenceReach] = derivative == 0 ? 1.0 : 0.0;
  for (std::size_t m = 1; m <= DifferenceReach && derivative > 0; ++m)
  {
    const auto row = static_cast<std::size_t>(accuracy / 2 - 1);
    const double weight =
      derivative == 1 ? first[row][m - 1] / spacing : second[row][m - 1] / (spacing * spacing);
    weights[DifferenceReach + m] = weight;
    weights[DifferenceReach - m] = derivative == 1 ? -weight : weight;
    weights[DifferenceReach] -= derivative == 1 ? 0.0 : 2.0 * weight;
  }
  return weights;
}

/// One side of a Gaussian of a standard deviation in nodes, from its center.
std::vector<double> HalfGaussian(double deviation)
{
  const auto reach = static_cast<std::size_t>(GaussianCutOff * deviation);
  std::vector<double> weights(reach + 1, 1.0);
  for (std::size_t m = 1; m <= reach; ++m)
  {
    const double x = static_cast<double>(m) / deviation;
    weights[m] = std::exp(-0.5 * x * x);
  }
  return weights;
}

/// Nodes of one axis and, for each of some stencils, their weights after smoothing.
struct AxisWeights
{
  std::int64_t First = 0;
  std::int64_t Count = 0;
  std::vector<double> Weights; ///< Count for each stencil

  const double* GetWeights(int stencil) const
  {
    return this->Weights.data() + static_cast<std::int64_t>(stencil) * this->Count;
  }
};

AxisWeights SmoothedStencils(const std::vector<double>& gaussian,
  const std::vector<Stencil>& stencils, std::int64_t node, std::int64_t size)
{
  const auto reach = static_cast<std::int64_t>(gaussian.size()) - 1;
  AxisWeights axis;
  axis.First = std::max<std::int64_t>(0, node - DifferenceReach - reach);
  axis.Count = std::min(size, node + DifferenceReach + reach + 1) - axis.First;
  axis.Weights.assign(stencils.size() * static_cast<std::size_t>(axis.Count), 0.0);
  for (std::int64_t m = 0; m < stencilWidth; ++m)
  {
    const std::int64_t center = node + m - DifferenceReach;
    const std::int64_t begin = std::max<std::int64_t>(0, center - reach);
    const std::int64_t end = std::min(size, center + reach + 1);
    double sum = 0.0;
    for (std::int64_t i = begin; i < end; ++i)
    {
      sum += gaussian[static_cast<std::size_t>(std::abs(i - center))];
    }
    for (std::size_t s = 0; s < stencils.size(); ++s)
    {
      const double weight = stencils[s][static_cast<std::size_t>(m)] / sum;
      double* out = axis.Weights.data() + static_cast<std::int64_t>(s) * axis.Count - axis.First;
      for (std::int64_t i = begin; i < end && weight != 0.0; ++i)
      {
        out[i] += weight * gaussian[static_cast<std::size_t>(std::abs(i - center))];
      }
    }
  }
  return axis;
}

/// Adds one plane's share of the derivatives whose first and second differences are those numbered
/// `first` and `second` of the stencils.
void AddPlane(const std::vector<double>& rows, const std::array<AxisWeights, 3>& axes,
  std::int64_t plane, int first, int second, NodeDerivatives& sums)
{
  const std::int64_t count = axes[0].Count;
  const auto dot = [&](int x, int y)
  {
    const double* weights = axes[0].GetWeights(x);
    const double* row = rows.data() + static_cast<std::int64_t>(y) * count;
    double sum = 0.0;
    for (std::int64_t i = 0; i < count; ++i)
    {
      sum += weights[i] * row[i];
    }
    return sum;
  };
  const double z = axes[2].GetWeights(0)[plane];
  const double zFirst = axes[2].GetWeights(first)[plane];
  const double value = dot(0, 0), x = dot(first, 0), y = dot(0, first);
  sums.Value += z * value;
  sums.Gradient[0] += z * x;
  sums.Gradient[1] += z * y;
  sums.Gradient[2] += zFirst * value;
  if (second > 0)
  {
    sums.Hessian[0] += z * dot(second, 0);
    sums.Hessian[1] += z * dot(0, second);
    sums.Hessian[2] += axes[2].GetWeights(second)[plane] * value;
    sums.Hessian[3] += z * dot(first, first);
    sums.Hessian[4] += zFirst * x;
    sums.Hessian[5] += zFirst * y;
  }
}

/// rows[s][i] = sum over j of weights[s][j] values[i + stride j], for `Count` stencils.
template <int Count, typename T>
ISTHMUS_VECTOR_CLONES void SumOverRows(const T* values, std::int64_t stride, const AxisWeights& y,
  std::int64_t length, double* __restrict rows)
{
  std::fill_n(rows, Count * length, 0.0);
  for (std::int64_t j = 0; j < y.Count; ++j)
  {
    const T* row = values + j * stride;
    std::array<double, Count> weights;
    for (int s = 0; s < Count; ++s)
    {
      weights[static_cast<std::size_t>(s)] = y.GetWeights(s)[j];
    }
    for (std::int64_t i = 0; i < length; ++i)
    {
      const auto value = static_cast<double>(row[i]);
      for (int s = 0; s < Count; ++s)
      {
        rows[s * length + i] += weights[static_cast<std::size_t>(s)] * value;
      }
    }
  }
}

/// Weights of a node on the three axes; false if the nodes are not available.
template <typename T>
bool WeightsAtNode(const GridPart<T>& part, const std::array<std::int64_t, 3>& node, double scale,
  const std::array<std::vector<Stencil>, 3>& stencils, std::array<AxisWeights, 3>& axes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    axes[axis] = SmoothedStencils(HalfGaussian(scale / part.Values.Spacing[axis]), stencils[axis],
      node[axis], part.Whole[axis]);
    axes[axis].First -= part.First[axis];
    if (axes[axis].First < 0 || axes[axis].First + axes[axis].Count > part.Values.Dimensions[axis])
    {
      return false;
    }
  }
  return true;
}

template <int Count, typename T, typename Plane>
void ForEachPlane(const GridPart<T>& part, const std::array<AxisWeights, 3>& axes, Plane&& plane)
{
  std::vector<double> rows(static_cast<std::size_t>(Count * axes[0].Count));
  for (std::int64_t k = 0; k < axes[2].Count; ++k)
  {
    const T* values = &part.Values(axes[0].First, axes[1].First, axes[2].First + k);
    SumOverRows<Count>(values, part.Values.Dimensions[0], axes[1], axes[0].Count, rows.data());
    plane(rows, k);
  }
}

/// sum over i, j of a[i] rho(i - j) b[j], the arrays aligned at their centers.
double Covariance(
  const std::vector<double>& a, const std::vector<double>& b, double correlation, double spacing)
{
  const auto shift =
    (static_cast<std::int64_t>(b.size()) - static_cast<std::int64_t>(a.size())) / 2;
  const std::size_t lags = std::max(a.size(), b.size()) + std::min(a.size(), b.size());
  std::vector<double> rho(lags, 0.0);
  rho[0] = 1.0;
  for (std::size_t lag = 1; lag < lags && correlation > 0.0; ++lag)
  {
    const double x = static_cast<double>(lag) * spacing / correlation;
    rho[lag] = std::exp(-0.25 * x * x);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::int64_t lag = static_cast<std::int64_t>(i) + shift - static_cast<std::int64_t>(j);
      sum += a[i] * rho[static_cast<std::size_t>(std::abs(lag))] * b[j];
    }
  }
  return sum;
}

/// Weights of value, first and second difference after smoothing, away from the border.
std::array<std::vector<double>, 3> SmoothedDifferences(
  const DerivativeFilter& filter, double spacing)
{
  const std::vector<double> gaussian = HalfGaussian(filter.Scale / spacing);
  const std::int64_t reach = DifferenceReach + static_cast<std::int64_t>(gaussian.size()) - 1;
  std::array<std::vector<double>, 3> result;
  for (int derivative = 0; derivative < 3; ++derivative)
  {
    result[static_cast<std::size_t>(derivative)] = SmoothedStencils(
      gaussian, { CentralDifference(derivative, filter.Accuracy, spacing) }, reach, 2 * reach + 1)
                                                     .Weights;
  }
  return result;
}

}

int ReferenceAccuracy(int accuracy)
{
  return accuracy + 2;
}

template <typename T>
bool DifferentiateSmoothed(const GridPart<T>& part, const std::array<std::int64_t, 3>& node,
  double scale, int accuracy, NodeDerivatives& filter, NodeDerivatives& reference)
{
  const int best = ReferenceAccuracy(accuracy);
  std::array<std::vector<Stencil>, 3> stencils;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = part.Values.Spacing[axis];
    stencils[axis] = { CentralDifference(0, 2, h), CentralDifference(1, accuracy, h),
      CentralDifference(2, accuracy, h), CentralDifference(1, best, h),
      CentralDifference(2, best, h) };
  }
  std::array<AxisWeights, 3> axes;
  if (!WeightsAtNode(part, node, scale, stencils, axes))
  {
    return false;
  }
  filter = reference = {};
  ForEachPlane<5>(part, axes,
    [&](const std::vector<double>& rows, std::int64_t plane)
    {
      AddPlane(rows, axes, plane, 1, 2, filter);
      AddPlane(rows, axes, plane, 3, 4, reference);
    });
  return true;
}

template <typename T>
bool SmoothedGradient(const GridPart<T>& part, const std::array<std::int64_t, 3>& node,
  double scale, NodeDerivatives& gradient)
{
  std::array<std::vector<Stencil>, 3> stencils;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double h = part.Values.Spacing[axis];
    stencils[axis] = { CentralDifference(0, 2, h), CentralDifference(1, 2, h) };
  }
  std::array<AxisWeights, 3> axes;
  if (!WeightsAtNode(part, node, scale, stencils, axes))
  {
    return false;
  }
  gradient = {};
  ForEachPlane<2>(part, axes,
    [&](const std::vector<double>& rows, std::int64_t plane)
    { AddPlane(rows, axes, plane, 1, 0, gradient); });
  return true;
}

NoiseCovariance CovarianceOfDerivatives(const CorrelatedNoise& noise, const DerivativeFilter& one,
  const DerivativeFilter& other, const std::array<double, 3>& spacing)
{
  using Matrix = std::array<std::array<double, 3>, 3>; // order of derivative of one, of the other
  std::array<Matrix, 3> c;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = SmoothedDifferences(one, spacing[axis]);
    const auto b = SmoothedDifferences(other, spacing[axis]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        c[axis][i][j] =
          (i + j) % 2 == 0 ? Covariance(a[i], b[j], noise.Correlation, spacing[axis]) : 0.0;
      }
    }
  }
  NoiseCovariance result;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const Matrix &a = c[axis], &b = c[(axis + 1) % 3], &rest = c[(axis + 2) % 3];
    result.Laplacian +=
      rest[0][0] * (a[2][2] * b[0][0] + a[0][0] * b[2][2] + a[2][0] * b[0][2] + a[0][2] * b[2][0]);
    result.Gradient += a[1][1] * b[0][0] * rest[0][0];
  }
  const double share = noise.Deviation * noise.Deviation / 3.0;
  result.Laplacian *= share;
  result.Gradient *= share;
  return result;
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template bool DifferentiateSmoothed(const GridPart<T>&, const std::array<std::int64_t, 3>&,      \
    double, int, NodeDerivatives&, NodeDerivatives&);                                              \
  template bool SmoothedGradient(                                                                  \
    const GridPart<T>&, const std::array<std::int64_t, 3>&, double, NodeDerivatives&)
ISTHMUS_INSTANTIATE(float);
ISTHMUS_INSTANTIATE(double);
#undef ISTHMUS_INSTANTIATE

}
