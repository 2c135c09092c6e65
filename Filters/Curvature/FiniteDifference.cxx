#include "Curvature/FiniteDifference.h"

#include "Core/RangeChecks.h"
#include "Core/VectorClones.h"

#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Weights of central differences of radius R: first derivative sum_m First[m-1] (f(m) - f(-m)),
/// second derivative sum_m Second[m-1] ((f(m) - f(0)) + (f(-m) - f(0))). Differences come first, so
/// that constant data gives an exact zero.
template <int R>
struct Weights
{
  std::array<double, R> First;
  std::array<double, R> Second;
};

template <int R>
Weights<R> WeightsFor(double spacing);

template <>
Weights<1> WeightsFor<1>(double spacing)
{
  return { { 0.5 / spacing }, { 1.0 / (spacing * spacing) } };
}

template <>
Weights<2> WeightsFor<2>(double spacing)
{
  const double square = spacing * spacing;
  return { { 2.0 / (3.0 * spacing), -1.0 / (12.0 * spacing) },
    { 4.0 / (3.0 * square), -1.0 / (12.0 * square) } };
}

template <int R, typename T>
inline double First(const Weights<R>& weights, const T* at, std::int64_t stride)
{
  double sum = 0.0;
  for (int m = 1; m <= R; ++m)
  {
    sum += weights.First[m - 1] *
      (static_cast<double>(at[m * stride]) - static_cast<double>(at[-m * stride]));
  }
  return sum;
}

template <int R, typename T>
inline double Second(const Weights<R>& weights, const T* at, std::int64_t stride)
{
  const double center = static_cast<double>(*at);
  double sum = 0.0;
  for (int m = 1; m <= R; ++m)
  {
    sum += weights.Second[m - 1] *
      ((static_cast<double>(at[m * stride]) - center) +
        (static_cast<double>(at[-m * stride]) - center));
  }
  return sum;
}

/// Mixed derivatives with x are x differences of the y and z differences of the row, which are
/// therefore kept R nodes beyond both of its ends.
template <int R, typename T>
ISTHMUS_VECTOR_CLONES void DifferentiateRow(const GridView<const T>& grid,
  const std::array<std::int64_t, 3>& first, std::int64_t count, DerivativeRows& rows)
{
  const Weights<R> x = WeightsFor<R>(grid.Spacing[0]);
  const Weights<R> y = WeightsFor<R>(grid.Spacing[1]);
  const Weights<R> z = WeightsFor<R>(grid.Spacing[2]);
  const std::int64_t strideY = grid.Dimensions[0];
  const std::int64_t strideZ = grid.Dimensions[0] * grid.Dimensions[1];
  const T* row = &grid(first[0], first[1], first[2]);

  alignas(64) std::array<double, DerivativeRows::Capacity + 2 * R> alongY;
  alignas(64) std::array<double, DerivativeRows::Capacity + 2 * R> alongZ;
  for (std::int64_t i = 0; i < count + 2 * R; ++i)
  {
    alongY[i] = First<R>(y, row + i - R, strideY);
    alongZ[i] = First<R>(z, row + i - R, strideZ);
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    rows.Value[i] = static_cast<double>(row[i]);
    rows.X[i] = First<R>(x, row + i, 1);
    rows.Y[i] = alongY[i + R];
    rows.Z[i] = alongZ[i + R];
    rows.XX[i] = Second<R>(x, row + i, 1);
    rows.YY[i] = Second<R>(y, row + i, strideY);
    rows.ZZ[i] = Second<R>(z, row + i, strideZ);
    rows.XY[i] = First<R>(x, alongY.data() + i + R, 1);
    rows.XZ[i] = First<R>(x, alongZ.data() + i + R, 1);
    double yz = 0.0;
    for (int m = 1; m <= R; ++m)
    {
      yz += z.First[m - 1] *
        (First<R>(y, row + i + m * strideZ, strideY) - First<R>(y, row + i - m * strideZ, strideY));
    }
    rows.YZ[i] = yz;
  }
}

}

int StencilRadius(int accuracy)
{
  RequireThat(accuracy == 2 || accuracy == 4, "Accuracy", accuracy,
    "it must be 2 or 4, the order of the differences");
  return accuracy / 2;
}

template <typename T>
void DifferentiateAtNodes(const GridView<const T>& grid, const std::array<std::int64_t, 3>& first,
  std::int64_t count, int accuracy, DerivativeRows& rows)
{
  if (StencilRadius(accuracy) == 1)
  {
    DifferentiateRow<1>(grid, first, count, rows);
  }
  else
  {
    DifferentiateRow<2>(grid, first, count, rows);
  }
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template void DifferentiateAtNodes(const GridView<const T>&, const std::array<std::int64_t, 3>&, \
    std::int64_t, int, DerivativeRows&)
ISTHMUS_FOR_EACH_SCALAR_TYPE(ISTHMUS_INSTANTIATE);
#undef ISTHMUS_INSTANTIATE

}
