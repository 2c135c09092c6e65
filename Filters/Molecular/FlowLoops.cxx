#include "FlowLoops.h"

#include "VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr float Fading = 2.0F;         // where steps begin to fade out
constexpr float Faded = 4.0F;          // where they have
constexpr float Flat = 1e-6F;          // keeps 0 / 0 out where the distance has a ridge
constexpr float LeastGradient = 0.5F;  // a node is moved to at most twice its distance
constexpr float PseudoTime = 0.45F;    // of a step of redistancing

inline float Minmod(float a, float b)
{
  const float least = std::fabs(a) < std::fabs(b) ? a : b;
  return a * b > 0.0F ? least : 0.0F;
}

/// The squared upwind slope along one axis, of sign * phi: from below or from above, the steeper
/// of those that come from the surface.
inline float UpwindSquared(float mm, float m, float c, float p, float pp, float sign)
{
  const float curveBelow = Minmod(mm - 2.0F * m + c, m - 2.0F * c + p);
  const float curveAbove = Minmod(m - 2.0F * c + p, c - 2.0F * p + pp);
  const float below = sign * (c - m + 0.5F * curveBelow);
  const float above = sign * (p - c - 0.5F * curveAbove);
  const float fromBelow = below > 0.0F ? below : 0.0F;
  const float fromAbove = above < 0.0F ? -above : 0.0F;
  const float slope = fromBelow > fromAbove ? fromBelow : fromAbove;
  return slope * slope;
}

/// One node: the rate of change by mean curvature, and |grad phi|^2.
inline float CurvatureRate(const float* at, std::int64_t row, std::int64_t plane, float& squared)
{
  const float c2 = 2.0F * at[0];
  const float x = 0.5F * (at[1] - at[-1]);
  const float y = 0.5F * (at[row] - at[-row]);
  const float z = 0.5F * (at[plane] - at[-plane]);
  const float xx = at[1] + at[-1] - c2;
  const float yy = at[row] + at[-row] - c2;
  const float zz = at[plane] + at[-plane] - c2;
  const float xy = 0.25F * (at[1 + row] - at[1 - row] - at[row - 1] + at[-1 - row]);
  const float xz = 0.25F * (at[1 + plane] - at[1 - plane] - at[plane - 1] + at[-1 - plane]);
  const float yz = 0.25F * (at[row + plane] - at[row - plane] - at[plane - row] + at[-row - plane]);
  const float x2 = x * x;
  const float y2 = y * y;
  const float z2 = z * z;
  squared = x2 + y2 + z2;
  return ((y2 + z2) * xx + (x2 + z2) * yy + (x2 + y2) * zz -
           2.0F * (x * y * xy + x * z * xz + y * z * yz)) /
    (squared + Flat);
}

}

ISTHMUS_VECTOR_CLONES
void AdvanceRow(const FlowStep& step, FlowStrides strides, std::int64_t first, std::int64_t last)
{
  const float* from = step.From;
  const float* ceiling = step.Ceiling;
  // Without a floor or a pull, stand-ins that change nothing: one loop for all.
  const bool floored = step.Floor != nullptr;
  const float* floor = floored ? step.Floor : ceiling;
  const bool pulled = step.Pull != nullptr;
  const float* pull = pulled ? step.Pull : ceiling;
  float* __restrict to = step.To;
  const float lambda = step.Lambda;
  for (std::int64_t n = first; n < last; ++n)
  {
    float squared = 0.0F;
    float rate = CurvatureRate(from + n, strides.Row, strides.Plane, squared);
    rate += pulled ? pull[n] * std::sqrt(squared) : 0.0F;
    const float value = from[n];
    const float fade =
      std::min(1.0F, std::max(0.0F, (Faded - std::fabs(value)) / (Faded - Fading)));
    float moved = std::min(value + lambda * fade * rate, ceiling[n]);
    moved = floored ? std::max(moved, floor[n]) : moved;
    to[n] = moved;
  }
}

ISTHMUS_VECTOR_CLONES
void HoldSurfaceRow(const float* from, float* __restrict to, unsigned char* __restrict free,
  bool trusted, FlowStrides strides, std::int64_t first, std::int64_t last)
{
  const std::int64_t row = strides.Row;
  const std::int64_t plane = strides.Plane;
  for (std::int64_t n = first; n < last; ++n)
  {
    const float* at = from + n;
    const float c = at[0];
    const float lowest = std::min(std::min(std::min(at[1], at[-1]), std::min(at[row], at[-row])),
      std::min(at[plane], at[-plane]));
    const float highest = std::max(std::max(std::max(at[1], at[-1]), std::max(at[row], at[-row])),
      std::max(at[plane], at[-plane]));
    const bool held = c > 0.0F ? lowest <= 0.0F : highest > 0.0F;
    const float x = 0.5F * (at[1] - at[-1]);
    const float y = 0.5F * (at[row] - at[-row]);
    const float z = 0.5F * (at[plane] - at[-plane]);
    const float slope = std::max(LeastGradient, std::sqrt(x * x + y * y + z * z));
    to[n] = held && !trusted ? c / slope : c;
    free[n] = held ? 0 : 1;
  }
}

ISTHMUS_VECTOR_CLONES
void RedistanceRow(const float* from, float* __restrict to, const unsigned char* free,
  FlowStrides strides, std::int64_t first, std::int64_t last)
{
  const std::int64_t row = strides.Row;
  const std::int64_t plane = strides.Plane;
  for (std::int64_t n = first; n < last; ++n)
  {
    const float* at = from + n;
    const float c = at[0];
    const float sign = c > 0.0F ? 1.0F : -1.0F;
    const float squared = UpwindSquared(at[-2], at[-1], c, at[1], at[2], sign) +
      UpwindSquared(at[-2 * row], at[-row], c, at[row], at[2 * row], sign) +
      UpwindSquared(at[-2 * plane], at[-plane], c, at[plane], at[2 * plane], sign);
    const float change = PseudoTime * sign * (1.0F - std::sqrt(squared));
    to[n] = c + static_cast<float>(free[n]) * change;
  }
}

}
