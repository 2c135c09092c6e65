#include "Curvature/HessianCurvatureRows.h"

#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

using Vector = std::array<double, 3>;

inline double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Orthonormal tangents of the plane with unit normal n, without a branch (T. Duff et al., Building
/// an orthonormal basis, revisited, Journal of Computer Graphics Techniques 6(1), 2017).
inline void TangentBasis(const Vector& n, Vector& first, Vector& second)
{
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1.0 / (sign + n[2]);
  const double b = n[0] * n[1] * a;
  first = { 1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0] };
  second = { b, sign + n[1] * n[1] * a, -n[1] };
}

/// The shape operator [A C; C B] in the basis (First, Second) of the tangent plane.
struct ShapeOperator
{
  double A, B, C;
  Vector First, Second;
};

/// G = -P H P / |g|, or its negative where the inside is lower; not finite where g = 0.
inline ShapeOperator ShapeOperatorAt(
  const DerivativeRows& d, std::int64_t i, double gradientSquare, double sign)
{
  const double scale = 1.0 / std::sqrt(gradientSquare);
  ShapeOperator shape;
  TangentBasis({ d.X[i] * scale, d.Y[i] * scale, d.Z[i] * scale }, shape.First, shape.Second);
  const auto timesHessian = [&d, i](const Vector& v)
  {
    return Vector{ d.XX[i] * v[0] + d.XY[i] * v[1] + d.XZ[i] * v[2],
      d.XY[i] * v[0] + d.YY[i] * v[1] + d.YZ[i] * v[2],
      d.XZ[i] * v[0] + d.YZ[i] * v[1] + d.ZZ[i] * v[2] };
  };
  const Vector first = timesHessian(shape.First);
  shape.A = sign * scale * Dot(first, shape.First);
  shape.C = sign * scale * Dot(first, shape.Second);
  shape.B = sign * scale * Dot(timesHessian(shape.Second), shape.Second);
  return shape;
}

inline double GradientSquare(const DerivativeRows& d, std::int64_t i)
{
  return d.X[i] * d.X[i] + d.Y[i] * d.Y[i] + d.Z[i] * d.Z[i];
}

inline double HessianSquare(const DerivativeRows& d, std::int64_t i)
{
  return d.XX[i] * d.XX[i] + d.YY[i] * d.YY[i] + d.ZZ[i] * d.ZZ[i] +
    2.0 * (d.XY[i] * d.XY[i] + d.XZ[i] * d.XZ[i] + d.YZ[i] * d.YZ[i]);
}

/// The values from which all others are computed, zero at places that are not valid.
struct ShapeRow
{
  alignas(64) DerivativeRows::Row Gaussian;
  alignas(64) DerivativeRows::Row Mean;
  alignas(64) DerivativeRows::Row Half;
  alignas(64) DerivativeRows::Row Valid; // 1 or 0; a double, so that the loop has one vector width
};

double ConventionSign(const ShapeRule& rule)
{
  return rule.InsideIsHigher ? -1.0 : 1.0;
}

ISTHMUS_VECTOR_CLONES void ComputeShape(
  const DerivativeRows& d, std::int64_t count, const ShapeRule& rule, ShapeRow& __restrict shape)
{
  constexpr double critical = 1e-6;
  const double sign = ConventionSign(rule);
  const double hessianFactor = critical * critical * rule.Spacing * rule.Spacing;
  const double valueFactor =
    rule.ValueRounding * rule.ValueRounding / (rule.Spacing * rule.Spacing);
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double square = GradientSquare(d, i);
    const ShapeOperator s = ShapeOperatorAt(d, i, square, sign);
    const double mean = 0.5 * (s.A + s.B);
    const double skew = 0.5 * (s.A - s.B);
    const double gaussian = s.A * s.B - s.C * s.C;
    // Comparisons with NaN are false, so the place is then not valid.
    const bool sloped = square > hessianFactor * HessianSquare(d, i);
    const bool above = square > valueFactor * d.Value[i] * d.Value[i];
    const bool finite = std::abs(gaussian) <= rule.Largest && std::abs(mean) <= rule.Largest;
    const bool valid = sloped && above && finite;
    shape.Valid[i] = valid ? 1.0 : 0.0;
    shape.Gaussian[i] = valid ? gaussian : 0.0;
    shape.Mean[i] = valid ? mean : 0.0;
    shape.Half[i] = valid ? std::sqrt(skew * skew + s.C * s.C) : 0.0;
  }
}

/// Fills `out` with `value(i)` if it is requested.
template <typename T, typename Value>
inline void Fill(T* out, std::int64_t at, std::int64_t count, Value&& value)
{
  if (out)
  {
    for (std::int64_t i = 0; i < count; ++i)
    {
      out[at + i] = static_cast<T>(value(i));
    }
  }
}

/// Rotates a vector from the grid's axes to the world's and stores it.
template <typename T>
void StoreVector(const Vector& v, const std::array<double, 9>& axes, T* out)
{
  for (int row = 0; row < 3; ++row)
  {
    out[row] =
      static_cast<T>(axes[3 * row] * v[0] + axes[3 * row + 1] * v[1] + axes[3 * row + 2] * v[2]);
  }
}

/// Eigenvectors of the shape operator; at an umbilic, where all directions are principal, the
/// basis of the tangent plane itself.
void PrincipalDirections(const ShapeOperator& s, Vector& first, Vector& second)
{
  const double skew = 0.5 * (s.A - s.B);
  const double half = std::sqrt(skew * skew + s.C * s.C);
  // The row of the singular matrix that has no cancellation.
  double x = skew >= 0.0 ? half + skew : s.C;
  double y = skew >= 0.0 ? s.C : half - skew;
  const double length = std::hypot(x, y);
  x = length > 0.0 ? x / length : 1.0;
  y = length > 0.0 ? y / length : 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    first[axis] = x * s.First[axis] + y * s.Second[axis];
    second[axis] = x * s.Second[axis] - y * s.First[axis];
  }
}

template <typename T>
void WriteDirections(const DerivativeRows& d, std::int64_t count, const ShapeRow& shape,
  double sign, const std::array<double, 9>& axes, T* out1, T* out2)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    Vector first{}, second{};
    if (shape.Valid[i] != 0.0)
    {
      PrincipalDirections(ShapeOperatorAt(d, i, GradientSquare(d, i), sign), first, second);
    }
    if (out1)
    {
      StoreVector(first, axes, out1 + 3 * i);
    }
    if (out2)
    {
      StoreVector(second, axes, out2 + 3 * i);
    }
  }
}

/// Downhill where the inside is higher, uphill where it is lower.
template <typename T>
void WriteNormals(const DerivativeRows& d, std::int64_t count, const ShapeRow& shape, double sign,
  const std::array<double, 9>& axes, T* out)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double scale = shape.Valid[i] != 0.0 ? sign / std::sqrt(GradientSquare(d, i)) : 0.0;
    StoreVector({ scale * d.X[i], scale * d.Y[i], scale * d.Z[i] }, axes, out + 3 * i);
  }
}

}

void SetZeroGradient(DerivativeRows& d, std::int64_t place)
{
  for (DerivativeRows::Row* row :
    { &d.Value, &d.X, &d.Y, &d.Z, &d.XX, &d.YY, &d.ZZ, &d.XY, &d.XZ, &d.YZ })
  {
    (*row)[place] = 0.0;
  }
}

template <typename T>
ISTHMUS_VECTOR_CLONES void WriteCurvature(const DerivativeRows& derivatives, std::int64_t count,
  const ShapeRule& rule, const HessianCurvatureOptions& options, const CurvatureArrays<T>& arrays,
  std::int64_t at)
{
  ShapeRow s;
  ComputeShape(derivatives, count, rule, s);
  const auto fill = [at, count](auto* out, auto&& value) { Fill(out, at, count, value); };
  fill(arrays.Gaussian, [&](std::int64_t i) { return s.Gaussian[i]; });
  fill(arrays.Mean, [&](std::int64_t i) { return s.Mean[i]; });
  fill(arrays.Maximum, [&](std::int64_t i) { return s.Mean[i] + s.Half[i]; });
  fill(arrays.Minimum, [&](std::int64_t i) { return s.Mean[i] - s.Half[i]; });
  fill(arrays.ShapeIndex,
    [&](std::int64_t i) { return ShapeIndex(s.Mean[i], s.Half[i], options.ShapeIndexConvention); });
  fill(arrays.Curvedness, [&](std::int64_t i) { return Curvedness(s.Mean[i], s.Half[i]); });
  fill(arrays.Valid, [&](std::int64_t i) { return s.Valid[i]; });
  fill(arrays.Gradient,
    [&](std::int64_t i)
    { return s.Valid[i] == 0.0 ? 0.0 : std::sqrt(GradientSquare(derivatives, i)); });
  fill(arrays.SurfaceType,
    [&](std::int64_t i)
    {
      return s.Valid[i] == 0.0 ? SurfaceType::None
                               : ClassifySurface(s.Mean[i], s.Half[i], rule.Spacing, options);
    });
  if (arrays.Normal)
  {
    WriteNormals(derivatives, count, s, ConventionSign(rule), options.Axes, arrays.Normal + 3 * at);
  }
  if (arrays.Direction1 || arrays.Direction2)
  {
    WriteDirections(derivatives, count, s, ConventionSign(rule), options.Axes,
      arrays.Direction1 ? arrays.Direction1 + 3 * at : nullptr,
      arrays.Direction2 ? arrays.Direction2 + 3 * at : nullptr);
  }
}

template <typename T>
void ClearCurvature(const CurvatureArrays<T>& arrays, std::int64_t at, std::int64_t count)
{
  for (T* out : { arrays.Gaussian, arrays.Mean, arrays.Maximum, arrays.Minimum, arrays.ShapeIndex,
         arrays.Curvedness, arrays.Gradient })
  {
    Fill(out, at, count, [](std::int64_t) { return 0.0; });
  }
  for (T* out : { arrays.Direction1, arrays.Direction2, arrays.Normal })
  {
    Fill(out, 3 * at, 3 * count, [](std::int64_t) { return 0.0; });
  }
  for (unsigned char* out : { arrays.SurfaceType, arrays.Valid })
  {
    Fill(out, at, count, [](std::int64_t) { return 0; });
  }
}

#define ISTHMUS_INSTANTIATE(T)                                                                     \
  template void WriteCurvature(const DerivativeRows&, std::int64_t, const ShapeRule&,              \
    const HessianCurvatureOptions&, const CurvatureArrays<T>&, std::int64_t);                      \
  template void ClearCurvature(const CurvatureArrays<T>&, std::int64_t, std::int64_t)
ISTHMUS_INSTANTIATE(float);
ISTHMUS_INSTANTIATE(double);
#undef ISTHMUS_INSTANTIATE

}
