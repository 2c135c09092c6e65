#include "Imaging/DiffusionRows.h"

#include "Core/VectorClones.h"

#include <cmath>
#include <cstring>
#include <type_traits>

#if defined(__GNUC__)
#define ISTHMUS_INLINE inline __attribute__((always_inline))
#else
#define ISTHMUS_INLINE inline
#endif

// The loop below may write the row that it reads, but not a shifted row.
#if defined(__GNUC__) && !defined(__clang__)
#define ISTHMUS_IN_PLACE _Pragma("GCC ivdep")
#else
#define ISTHMUS_IN_PLACE
#endif

namespace isthmus
{
namespace
{

template <typename T>
ISTHMUS_INLINE void Laplacian(const RowStencil<T>& in, const T* __restrict own, T source,
  const std::array<T, 3>& weights, std::int64_t n, T* __restrict out)
{
  const T *c = in.Center, *f = in.Front, *b = in.Back, *d = in.Below, *u = in.Above;
  const T x = weights[0], y = weights[1], z = weights[2];
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    const T twice = 2 * c[i];
    out[i] = source * own[i] + x * (c[i - 1] + c[i + 1] - twice) + y * (f[i] + b[i] - twice) +
      z * (d[i] + u[i] - twice);
  }
}

template <typename T>
ISTHMUS_INLINE void GradientSquared(
  const RowStencil<T>& in, const std::array<T, 3>& weights, std::int64_t n, T* __restrict out)
{
  const T *c = in.Center, *f = in.Front, *b = in.Back, *d = in.Below, *u = in.Above;
  // A repeated neighbour halves the distance too.
  const T x = weights[0], y = f == c || b == c ? 2 * weights[1] : weights[1],
          z = d == c || u == c ? 2 * weights[2] : weights[2];
  auto node = [=](std::int64_t i, T ofX)
  {
    const T dx = ofX * (c[i + 1] - c[i - 1]);
    const T dy = y * (b[i] - f[i]);
    const T dz = z * (u[i] - d[i]);
    return dx * dx + dy * dy + dz * dz;
  };
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    out[i] = node(i, x);
  }
  out[0] = node(0, 2 * x);
  out[n - 1] = node(n - 1, 2 * x);
}

/// Below it an exponential is taken to be that of this argument.
template <typename T>
constexpr T LowestExponent = std::is_same_v<T, float> ? T(-87) : T(-708);

/// exp(x) for LowestExponent <= x <= 0: 2^n by its bits, times Taylor's series on |r| <= ln(2)/2.
template <typename T>
ISTHMUS_INLINE T ExponentialOfNegative(T x)
{
  constexpr bool single = std::is_same_v<T, float>;
  using Bits = std::conditional_t<single, std::int32_t, std::int64_t>;
  constexpr T log2e = T(1.4426950408889634074);
  constexpr T ln2High = single ? T(0.693359375) : T(0.693147180369123816490);
  constexpr T ln2Low = single ? T(-2.12194440054690583e-4) : T(1.90821492927058770002e-10);
  const auto power = static_cast<std::int32_t>(x * log2e - T(0.5));
  const T r = (x - static_cast<T>(power) * ln2High) - static_cast<T>(power) * ln2Low;
  T series = 1;
#pragma GCC unroll 16
  for (int k = single ? 7 : 12; k > 0; --k)
  {
    series = 1 + series * (r * (T(1) / static_cast<T>(k)));
  }
  const Bits bits = (static_cast<Bits>(power) + (single ? 127 : 1023)) << (single ? 23 : 52);
  T scale;
  std::memcpy(&scale, &bits, sizeof(T));
  return series * scale;
}

template <typename T>
ISTHMUS_INLINE void Exponential(std::int64_t n, T* __restrict values)
{
  // A separate loop: within that of the rest, a compiler would generate a branch and not vectorise.
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    const T x = -values[i];
    values[i] = x > LowestExponent<T> ? x : LowestExponent<T>;
  }
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    values[i] = ExponentialOfNegative(values[i]);
  }
}

template <typename T>
ISTHMUS_INLINE void Divergence(const RowStencil<T>& w, const RowStencil<T>& c,
  const std::array<T, 3>& weights, std::int64_t n, T* __restrict out)
{
  const T *w0 = w.Center, *wf = w.Front, *wb = w.Back, *wd = w.Below, *wu = w.Above;
  const T *c0 = c.Center, *cf = c.Front, *cb = c.Back, *cd = c.Below, *cu = c.Above;
  const T x = weights[0] / 2, y = weights[1] / 2, z = weights[2] / 2; // the mean's half
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    const T a = w0[i];
    const T m = c0[i];
    out[i] = x * ((m + c0[i + 1]) * (w0[i + 1] - a) - (m + c0[i - 1]) * (a - w0[i - 1])) +
      y * ((m + cb[i]) * (wb[i] - a) - (m + cf[i]) * (a - wf[i])) +
      z * ((m + cu[i]) * (wu[i] - a) - (m + cd[i]) * (a - wd[i]));
  }
}

template <typename T>
ISTHMUS_INLINE void GramDivergence(const RowStencil<T>& w, const RowStencil<T>& slope,
  const std::array<T, 3>& weights, std::int64_t n, T* __restrict out)
{
  const T *w0 = w.Center, *wf = w.Front, *wb = w.Back, *wd = w.Below, *wu = w.Above;
  const T *s0 = slope.Center, *sf = slope.Front, *sb = slope.Back, *sd = slope.Below,
          *su = slope.Above;
  const T x = weights[0], y = weights[1], z = weights[2];
  for (std::int64_t i = 0; i < PaddedLength(n); ++i)
  {
    const T a = w0[i];
    const T s = s0[i];
    auto face = [s](T other) { return 1 / std::sqrt(1 + (s + other) / 2); };
    out[i] = std::sqrt(1 + s) *
      (x * (face(s0[i + 1]) * (w0[i + 1] - a) - face(s0[i - 1]) * (a - w0[i - 1])) +
        y * (face(sb[i]) * (wb[i] - a) - face(sf[i]) * (a - wf[i])) +
        z * (face(su[i]) * (wu[i] - a) - face(sd[i]) * (a - wd[i])));
  }
}

template <typename T>
ISTHMUS_INLINE void PseudoResidual(
  const RowStencil<T>& in, T left, T right, std::int64_t n, double* __restrict out)
{
  const T *c = in.Center, *f = in.Front, *b = in.Back, *d = in.Below, *u = in.Above;
  auto node = [=](std::int64_t i, T before, T after)
  {
    const T value = c[i];
    const int equal = (before == value) + (after == value) + (f[i] == value) + (b[i] == value) +
      (d[i] == value) + (u[i] == value);
    const double sum = static_cast<double>(before) + static_cast<double>(after) +
      static_cast<double>(f[i]) + static_cast<double>(b[i]) + static_cast<double>(d[i]) +
      static_cast<double>(u[i]);
    const double residual = std::abs(static_cast<double>(value) - sum / 6.0);
    return equal >= 3 ? -1.0 : residual;
  };
  for (std::int64_t i = 1; i + 1 < n; ++i)
  {
    out[i] = node(i, c[i - 1], c[i + 1]);
  }
  out[n - 1] = node(n - 1, n > 1 ? c[n - 2] : left, right);
  out[0] = node(0, left, n > 1 ? c[1] : right);
}

template <typename T>
ISTHMUS_INLINE void Update(const RowUpdate<T>& update, const T* current, const T* previous,
  const T* first, const T* __restrict rate, const T* firstRate, std::int64_t n, T* out)
{
  const T ofCurrent = update.CurrentFactor, ofPrevious = update.PreviousFactor;
  const T ofRate = update.RateFactor, ofFirstRate = update.FirstRateFactor;
  if (!previous)
  {
    for (std::int64_t i = 0; i < n; ++i)
    {
      out[i] = current[i] + ofRate * rate[i];
    }
    return;
  }
  if (!firstRate)
  {
    ISTHMUS_IN_PLACE
    for (std::int64_t i = 0; i < n; ++i)
    {
      const T f = first[i];
      out[i] =
        f + (ofCurrent * (current[i] - f) + ofPrevious * (previous[i] - f) + ofRate * rate[i]);
    }
    return;
  }
  ISTHMUS_IN_PLACE
  for (std::int64_t i = 0; i < n; ++i)
  {
    const T f = first[i];
    out[i] = f +
      (ofCurrent * (current[i] - f) + ofPrevious * (previous[i] - f) + ofRate * rate[i] +
        ofFirstRate * firstRate[i]);
  }
}

template <typename T>
ISTHMUS_INLINE void AddChange(
  T factor, const T* values, const T* first, std::int64_t n, T* __restrict sum)
{
  for (std::int64_t i = 0; i < n; ++i)
  {
    sum[i] += factor * (values[i] - first[i]);
  }
}

}

// The exported overloads, once for each type: clones can't be made of templates.
#define ISTHMUS_ROW_KERNELS(T)                                                                     \
  ISTHMUS_VECTOR_CLONES void LaplacianRow(const RowStencil<T>& in, const T* own, T source,         \
    const std::array<T, 3>& weights, std::int64_t n, T* out)                                       \
  {                                                                                                \
    Laplacian(in, own, source, weights, n, out);                                                   \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void GradientSquaredRow(                                                   \
    const RowStencil<T>& in, const std::array<T, 3>& weights, std::int64_t n, T* out)              \
  {                                                                                                \
    GradientSquared(in, weights, n, out);                                                          \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void ExponentialRow(std::int64_t n, T* values)                             \
  {                                                                                                \
    Exponential(n, values);                                                                        \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void DivergenceRow(const RowStencil<T>& w, const RowStencil<T>& c,         \
    const std::array<T, 3>& weights, std::int64_t n, T* out)                                       \
  {                                                                                                \
    Divergence(w, c, weights, n, out);                                                             \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void GramDivergenceRow(const RowStencil<T>& w, const RowStencil<T>& slope, \
    const std::array<T, 3>& weights, std::int64_t n, T* out)                                       \
  {                                                                                                \
    GramDivergence(w, slope, weights, n, out);                                                     \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void PseudoResidualRow(                                                    \
    const RowStencil<T>& in, T left, T right, std::int64_t n, double* out)                         \
  {                                                                                                \
    PseudoResidual(in, left, right, n, out);                                                       \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void UpdateRow(const RowUpdate<T>& update, const T* current,               \
    const T* previous, const T* first, const T* rate, const T* firstRate, std::int64_t n, T* out)  \
  {                                                                                                \
    Update(update, current, previous, first, rate, firstRate, n, out);                             \
  }                                                                                                \
  ISTHMUS_VECTOR_CLONES void AddChangeRow(                                                         \
    T factor, const T* values, const T* first, std::int64_t n, T* sum)                             \
  {                                                                                                \
    AddChange(factor, values, first, n, sum);                                                      \
  }

ISTHMUS_ROW_KERNELS(float)
ISTHMUS_ROW_KERNELS(double)

}
