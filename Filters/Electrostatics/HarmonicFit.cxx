#include "Electrostatics/HarmonicFit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr int Most = 16;
using Terms = std::array<double, Most>;

/// Harmonic polynomials of degree 0 to 3.
Terms Harmonics(const Point3& y)
{
  const double a = y[0], b = y[1], c = y[2];
  return { 1.0, a, b, c, a * b, a * c, b * c, a * a - b * b, 2.0 * c * c - a * a - b * b, a * b * c,
    c * (a * a - b * b), a * (a * a - 3.0 * b * b), b * (3.0 * a * a - b * b),
    c * (2.0 * c * c - 3.0 * a * a - 3.0 * b * b), a * (4.0 * c * c - a * a - b * b),
    b * (4.0 * c * c - a * a - b * b) };
}

struct Datum
{
  Terms Row;
  double Value, Weight;
};

/// The nodes inside within three spacings, offsets in units of the largest.
std::vector<Datum> DataAround(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<double>& u, const Point3& x, double unit)
{
  std::array<std::int64_t, 3> low, high;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double place = (x[a] - box.Corner[a]) / box.Spacing[a];
    const double reach = 3.0 * unit / box.Spacing[a];
    const double end = static_cast<double>(box.Dimensions[a] - 1);
    low[a] = static_cast<std::int64_t>(std::clamp(std::ceil(place - reach), 0.0, end));
    high[a] = static_cast<std::int64_t>(std::clamp(std::floor(place + reach), 0.0, end));
  }
  std::vector<Datum> data;
  const auto steps = box.Steps();
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        const auto node = static_cast<std::size_t>(i + j * steps[1] + k * steps[2]);
        const Point3 p = box.Position(i, j, k);
        const Point3 y{ (p[0] - x[0]) / unit, (p[1] - x[1]) / unit, (p[2] - x[2]) / unit };
        const double r2 = y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
        if (inside[node] && r2 <= 9.0)
        {
          const double w = 1.0 / (r2 + 0.25);
          data.push_back({ Harmonics(y), u[node], w * w * w });
        }
      }
    }
  }
  return data;
}

/// The first `N` coefficients of the fit; false if the data do not determine them.
template <int N>
bool Solve(const std::vector<Datum>& data, std::array<double, 4>& answer)
{
  using Matrix = Eigen::Matrix<double, N, N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  // One and a half times as many nodes as coefficients, so that one-sided neighbourhoods stay
  // well-posed.
  if (data.size() * 2 < 3 * static_cast<std::size_t>(N))
  {
    return false;
  }
  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();
  for (const Datum& d : data)
  {
    const Eigen::Map<const Vector> row(d.Row.data());
    normal.template selfadjointView<Eigen::Lower>().rankUpdate(row, d.Weight);
    right += d.Weight * d.Value * row;
  }
  const Eigen::LDLT<Matrix> factor(normal);
  const Vector pivots = factor.vectorD();
  if (factor.info() != Eigen::Success || !(pivots.minCoeff() > 1e-8 * pivots.maxCoeff()))
  {
    return false;
  }
  const Vector c = factor.solve(right);
  answer.fill(0.0);
  std::copy_n(c.data(), std::min(N, 4), answer.begin());
  return c.allFinite();
}

}

std::optional<ValueAndGradient> HarmonicAt(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<double>& u, const Point3& x)
{
  const double unit = *std::max_element(box.Spacing.begin(), box.Spacing.end());
  const std::vector<Datum> data = DataAround(box, inside, u, x, unit);
  std::array<double, 4> c;
  if (Solve<16>(data, c) || Solve<9>(data, c) || Solve<4>(data, c) || Solve<1>(data, c))
  {
    return ValueAndGradient{ c[0], { c[1] / unit, c[2] / unit, c[3] / unit } };
  }
  return std::nullopt;
}

}
