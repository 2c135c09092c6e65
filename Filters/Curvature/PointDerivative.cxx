#include "Curvature/PointDerivative.h"

#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Polynomial in t, lowest power first.
template <int N>
using Polynomial = std::array<double, N>;

/// The polynomial that is 1 at `node` and 0 at the other integers of [low, high].
template <int N>
constexpr Polynomial<N> LagrangeBasis(int low, int high, int node)
{
  Polynomial<N> basis{ 1.0 };
  for (int root = low; root <= high; ++root)
  {
    if (root != node)
    {
      for (int power = N - 1; power >= 0; --power)
      {
        const double shifted = power > 0 ? basis[power - 1] : 0.0;
        basis[power] = (shifted - root * basis[power]) / (node - root);
      }
    }
  }
  return basis;
}

template <int N>
constexpr Polynomial<N> Derivative(const Polynomial<N>& of)
{
  Polynomial<N> result{};
  for (int power = 1; power < N; ++power)
  {
    result[power - 1] = power * of[power];
  }
  return result;
}

template <int R>
constexpr int Width = 4 * R;

/// For each order of derivative m and each power of t, the weights of nodes 1 - 2R ... 2R.
template <int R>
using WeightTable = std::array<std::array<std::array<double, Width<R>>, Width<R>>, 3>;

/// Expands sum_a L_a(t) Q_a^(m)(t) in powers of t and node values.
template <int R>
constexpr WeightTable<R> MakeWeightTable()
{
  constexpr int N = Width<R>;
  WeightTable<R> table{};
  for (int a = 1 - R; a <= R; ++a)
  {
    const Polynomial<N> blend = LagrangeBasis<N>(1 - R, R, a);
    for (int node = a - R; node <= a + R; ++node)
    {
      Polynomial<N> local = LagrangeBasis<N>(a - R, a + R, node);
      for (int m = 0; m < 3; ++m, local = Derivative<N>(local))
      {
        for (int p = 0; p < 2 * R; ++p)
        {
          for (int q = 0; q <= 2 * R; ++q)
          {
            table[m][p + q][node + 2 * R - 1] += blend[p] * local[q];
          }
        }
      }
    }
  }
  return table;
}

template <int R>
using AxisWeights = std::array<std::array<double, Width<R>>, 3>;

/// Weights of value, first and second derivative at t, by Horner's rule for all nodes at once.
template <int R>
AxisWeights<R> WeightsAt(double t, double spacing)
{
  static constexpr WeightTable<R> table = MakeWeightTable<R>();
  AxisWeights<R> weights{};
  double scale = 1.0;
  for (int m = 0; m < 3; ++m, scale /= spacing)
  {
    for (int power = Width<R> - 1; power >= 0; --power)
    {
      for (int node = 0; node < Width<R>; ++node)
      {
        weights[m][node] = weights[m][node] * t + table[m][power][node];
      }
    }
    for (double& weight : weights[m])
    {
      weight *= scale;
    }
  }
  return weights;
}

/// First of the nodes that serve `index` on one axis; false where there are none. Next to the
/// border the nodes stay inside the grid, and t leaves [0, 1] instead.
template <int R>
bool FindNodes(double index, std::int64_t dimension, std::int64_t& node)
{
  constexpr double allowance = 1e-4;
  const auto last = static_cast<double>(dimension - 1 - R);
  if (!(index >= R - allowance && index <= last + allowance) || dimension < Width<R>)
  {
    return false;
  }
  const auto cell = static_cast<std::int64_t>(std::floor(index));
  node = std::clamp<std::int64_t>(cell + 1 - 2 * R, 0, dimension - Width<R>);
  return true;
}

/// The sums over y and z, one for each pair of orders of derivative that is needed, as rows in x.
template <int R>
struct PlaneSums
{
  using Row = std::array<double, Width<R>>;
  Row Value{}, Y{}, Z{}, YY{}, ZZ{}, YZ{};
};

template <int R, typename T>
PlaneSums<R> SumOverPlanes(const GridView<const T>& grid, const std::array<std::int64_t, 3>& corner,
  const AxisWeights<R>& y, const AxisWeights<R>& z)
{
  constexpr int N = Width<R>;
  PlaneSums<R> sums;
  for (int k = 0; k < N; ++k)
  {
    std::array<double, N> value{}, first{}, second{};
    for (int j = 0; j < N; ++j)
    {
      const T* row = &grid(corner[0], corner[1] + j, corner[2] + k);
      for (int i = 0; i < N; ++i)
      {
        const double v = static_cast<double>(row[i]);
        value[i] += y[0][j] * v;
        first[i] += y[1][j] * v;
        second[i] += y[2][j] * v;
      }
    }
    for (int i = 0; i < N; ++i)
    {
      sums.Value[i] += z[0][k] * value[i];
      sums.Y[i] += z[0][k] * first[i];
      sums.YY[i] += z[0][k] * second[i];
      sums.Z[i] += z[1][k] * value[i];
      sums.YZ[i] += z[1][k] * first[i];
      sums.ZZ[i] += z[2][k] * value[i];
    }
  }
  return sums;
}

template <int R>
double Dot(const std::array<double, Width<R>>& weights, const std::array<double, Width<R>>& row)
{
  double sum = 0.0;
  for (int i = 0; i < Width<R>; ++i)
  {
    sum += weights[i] * row[i];
  }
  return sum;
}

/// Flattened, since only inlined code is compiled for the vector units of each machine.
template <int R, typename T>
ISTHMUS_VECTOR_CLONES [[gnu::flatten]] bool Differentiate(const GridView<const T>& grid,
  const std::array<double, 3>& index, std::int64_t place, DerivativeRows& rows)
{
  std::array<std::int64_t, 3> corner{};
  std::array<AxisWeights<R>, 3> weights;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!FindNodes<R>(index[axis], grid.Dimensions[axis], corner[axis]))
    {
      return false;
    }
    const double t = index[axis] - static_cast<double>(corner[axis] + 2 * R - 1);
    weights[axis] = WeightsAt<R>(t, grid.Spacing[axis]);
  }
  const PlaneSums<R> sums = SumOverPlanes<R>(grid, corner, weights[1], weights[2]);
  const AxisWeights<R>& x = weights[0];
  rows.Value[place] = Dot<R>(x[0], sums.Value);
  rows.X[place] = Dot<R>(x[1], sums.Value);
  rows.Y[place] = Dot<R>(x[0], sums.Y);
  rows.Z[place] = Dot<R>(x[0], sums.Z);
  rows.XX[place] = Dot<R>(x[2], sums.Value);
  rows.YY[place] = Dot<R>(x[0], sums.YY);
  rows.ZZ[place] = Dot<R>(x[0], sums.ZZ);
  rows.XY[place] = Dot<R>(x[1], sums.Y);
  rows.XZ[place] = Dot<R>(x[1], sums.Z);
  rows.YZ[place] = Dot<R>(x[0], sums.YZ);
  return true;
}

}

template <typename T>
bool DifferentiateAtPoint(const GridView<const T>& grid, const std::array<double, 3>& index,
  int accuracy, std::int64_t place, DerivativeRows& rows)
{
  return StencilRadius(accuracy) == 1 ? Differentiate<1>(grid, index, place, rows)
                                      : Differentiate<2>(grid, index, place, rows);
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template bool DifferentiateAtPoint(                                                              \
    const GridView<const T>&, const std::array<double, 3>&, int, std::int64_t, DerivativeRows&)
ISTHMUS_FOR_EACH_SCALAR_TYPE(ISTHMUS_INSTANTIATE);
#undef ISTHMUS_INSTANTIATE

}
