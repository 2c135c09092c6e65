/**
 * @file DiffusionRows.h
 * @brief The vectorised arithmetic for one row of nodes, which takes nearly all the time of a
 * diffusion step.
 *
 * A row is stored in scratch memory with a margin (see RowMargin); the margin repeats the outermost
 * values, which implements the Neumann condition. Every kernel works on PaddedLength(n) nodes, a
 * multiple of the widest vector, so that no node is processed by a remainder loop with different
 * rounding. Results therefore depend neither on the threads nor on how a grid is cut into pieces.
 */
#ifndef isthmus_DiffusionRows_h
#define isthmus_DiffusionRows_h

#include <algorithm>
#include <array>
#include <cstdint>

namespace isthmus
{

/// Number of nodes that a row in scratch memory must have before the first and after the last one.
constexpr std::int64_t RowMargin = 16;

/// Number of nodes a kernel works on for a row of n nodes.
constexpr std::int64_t PaddedLength(std::int64_t n)
{
  return (n + RowMargin - 1) / RowMargin * RowMargin;
}

/// Number of nodes of scratch memory that a row of n nodes takes, with both margins.
constexpr std::int64_t PaddedStride(std::int64_t n)
{
  return PaddedLength(n) + 2 * RowMargin;
}

/// Repeats the ends of a row into its margins.
template <typename T>
void RepeatEnds(T* row, std::int64_t n)
{
  row[-1] = row[0];
  std::fill(row + n, row + PaddedLength(n) + 1, row[n - 1]);
}

/// A row and its four neighbouring rows in y and z; neighbours in x are in the row itself.
template <typename T>
struct RowStencil
{
  const T* Center;
  const T* Front;
  const T* Back;
  const T* Below;
  const T* Above;
};

/// out = source * own + weights . second differences of `in` (with weights 1/h^2: the Laplacian).
void LaplacianRow(const RowStencil<float>& in, const float* own, float source,
  const std::array<float, 3>& weights, std::int64_t n, float* out);
void LaplacianRow(const RowStencil<double>& in, const double* own, double source,
  const std::array<double, 3>& weights, std::int64_t n, double* out);

/// out = |gradient|^2 by central differences, with weights 1/(2h) (or that over a gradient's scale:
/// scaled before it is squared, so that tiny and huge values neither vanish nor overflow). At the
/// grid's ends, where a stencil repeats its center, differences are one-sided: the gradient of a
/// linear field is the same everywhere.
void GradientSquaredRow(
  const RowStencil<float>& in, const std::array<float, 3>& weights, std::int64_t n, float* out);
void GradientSquaredRow(
  const RowStencil<double>& in, const std::array<double, 3>& weights, std::int64_t n, double* out);

/// values = exp(-values), for values >= 0; relative error below 3e-7 in float, 1e-15 in double;
/// below exp(-87) and exp(-708), these.
void ExponentialRow(std::int64_t n, float* values);
void ExponentialRow(std::int64_t n, double* values);

/// out = div(c grad w): c at the nodes, its mean on the faces; weights 1/h^2.
void DivergenceRow(const RowStencil<float>& w, const RowStencil<float>& c,
  const std::array<float, 3>& weights, std::int64_t n, float* out);
void DivergenceRow(const RowStencil<double>& w, const RowStencil<double>& c,
  const std::array<double, 3>& weights, std::int64_t n, double* out);

/// out = sqrt(g) div(grad w / sqrt(g)) with g = 1 + slope, the mean of g on the faces.
void GramDivergenceRow(const RowStencil<float>& w, const RowStencil<float>& slope,
  const std::array<float, 3>& weights, std::int64_t n, float* out);
void GramDivergenceRow(const RowStencil<double>& w, const RowStencil<double>& slope,
  const std::array<double, 3>& weights, std::int64_t n, double* out);

/// out = |value - mean of its six neighbours|, or -1 where three of them or more have the value.
/// Rows of a volume, without margins; a missing neighbour row is the row itself, and `left` and
/// `right` are what lies beyond the n nodes.
void PseudoResidualRow(
  const RowStencil<float>& in, float left, float right, std::int64_t n, double* out);
void PseudoResidualRow(
  const RowStencil<double>& in, double left, double right, std::int64_t n, double* out);

/**
 * What one stage of a time step computes from a row:
 *
 *     first + CurrentFactor (current - first) + PreviousFactor (previous - first)
 *           + RateFactor rate + FirstRateFactor firstRate.
 *
 * Values are represented by differences from the first values of the step, so that a constant stays
 * exactly constant and only the changes are rounded.
 */
template <typename T>
struct RowUpdate
{
  T CurrentFactor = 1; ///< Factor of `current`, the values for which the rate was evaluated.
  T PreviousFactor = 0;
  T RateFactor = 0;
  T FirstRateFactor = 0;
};

/// Writes an update; `previous` and `out` may be one row. If `previous` is null, this is an
/// explicit step, and `first` and `firstRate` are not read. If `firstRate` is null, its term is
/// omitted.
void UpdateRow(const RowUpdate<float>& update, const float* current, const float* previous,
  const float* first, const float* rate, const float* firstRate, std::int64_t n, float* out);
void UpdateRow(const RowUpdate<double>& update, const double* current, const double* previous,
  const double* first, const double* rate, const double* firstRate, std::int64_t n, double* out);

/// sum += factor (values - first); `sum` must not be one of the others.
void AddChangeRow(
  float factor, const float* values, const float* first, std::int64_t n, float* sum);
void AddChangeRow(
  double factor, const double* values, const double* first, std::int64_t n, double* sum);

}

#endif
