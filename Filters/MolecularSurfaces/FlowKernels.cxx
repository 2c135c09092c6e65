#include "MolecularSurfaces/FlowKernels.h"

#include "Core/VectorClones.h"

#include <cmath>

namespace isthmus
{
namespace
{

constexpr float Fading = 2.0F;        // where steps begin to fade out
constexpr float Faded = 4.0F;         // where they have faded out
constexpr float Flat = 1e-6F;         // avoids 0 / 0 where the distance has a ridge
constexpr float LeastGradient = 0.5F; // a node is moved to at most twice its distance
constexpr float PseudoTime = 0.45F;   // of a step of redistancing

// By value: std::min of references keeps GCC from vectorising.
inline float Lesser(float a, float b)
{
  return a < b ? a : b;
}

inline float Greater(float a, float b)
{
  return a > b ? a : b;
}

inline float Minmod(float a, float b)
{
  const float least = std::fabs(a) < std::fabs(b) ? a : b;
  return a * b > 0.0F ? least : 0.0F;
}

/// The squared upwind slope along one axis, of sign * phi: from below or from above, the steeper of
/// those that point away from the surface.
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

inline float Slope(float below, float above)
{
  return 0.5F * (above - below);
}

inline float Bend(float below, float here, float above)
{
  return above - 2.0F * here + below;
}

inline float MixedDifference(float belowBelow, float belowAbove, float aboveBelow, float aboveAbove)
{
  return 0.25F * (aboveAbove - aboveBelow - belowAbove + belowBelow);
}

/// Represents Factor * Values[n] + Shift.
struct ScaledRow
{
  const float* Values;
  float Factor;
  float Shift;
};

/// 1 near the surface, 0 from Faded on.
inline float Fade(float value)
{
  return Lesser(1.0F, Greater(0.0F, (Faded - std::fabs(value)) / (Faded - Fading)));
}

// Plain pointers, since GCC 12 does not vectorise loads through a struct in clones.
ISTHMUS_VECTOR_CLONES
void AdvanceNodes(const float* from, float* __restrict to, const float* ceiling,
  const ScaledRow& floor, const ScaledRow& pull, float lambda, FlowStrides strides,
  std::int64_t first, std::int64_t last)
{
  const float* floorAt = floor.Values;
  const float floorFactor = floor.Factor;
  const float floorShift = floor.Shift;
  const float* pullAt = pull.Values;
  const float pullFactor = pull.Factor;
  const std::int64_t row = strides.Row;
  const std::int64_t plane = strides.Plane;
  for (std::int64_t n = first; n < last; ++n)
  {
    const float* at = from + n;
    const float c = at[0];
    const float x = Slope(at[-1], at[1]);
    const float y = Slope(at[-row], at[row]);
    const float z = Slope(at[-plane], at[plane]);
    const float xx = Bend(at[-1], c, at[1]);
    const float yy = Bend(at[-row], c, at[row]);
    const float zz = Bend(at[-plane], c, at[plane]);
    const float xy = MixedDifference(at[-1 - row], at[row - 1], at[1 - row], at[1 + row]);
    const float xz = MixedDifference(at[-1 - plane], at[plane - 1], at[1 - plane], at[1 + plane]);
    const float yz =
      MixedDifference(at[-row - plane], at[plane - row], at[row - plane], at[row + plane]);
    const float squared = x * x + y * y + z * z;
    const float bent = (y * y + z * z) * xx + (x * x + z * z) * yy + (x * x + y * y) * zz -
      2.0F * (x * y * xy + x * z * xz + y * z * yz);
    const float rate = bent / (squared + Flat) + pullFactor * pullAt[n] * std::sqrt(squared);
    const float moved = Lesser(c + lambda * Fade(c) * rate, ceiling[n]);
    to[n] = Greater(moved, floorFactor * floorAt[n] + floorShift);
  }
}

}

void AdvanceRow(const FlowStep& step, FlowStrides strides, std::int64_t first, std::int64_t last)
{
  // Without floor or pull, the ceiling is used in their place with a factor of zero: one loop for
  // all cases, without a condition.
  const ScaledRow nowhere{ step.Ceiling, 0.0F, -1e6F };
  const ScaledRow floor = step.Floor ? ScaledRow{ step.Floor, 1.0F, 0.0F } : nowhere;
  const ScaledRow pull = step.Pull ? ScaledRow{ step.Pull, 1.0F, 0.0F } : nowhere;
  AdvanceNodes(step.From, step.To, step.Ceiling, floor, pull, step.Lambda, strides, first, last);
}

ISTHMUS_VECTOR_CLONES
void HoldSurfaceRow(const float* from, float* __restrict to, unsigned char* __restrict free,
  bool trusted, FlowStrides strides, std::int64_t first, std::int64_t last)
{
  const std::int64_t row = strides.Row;
  const std::int64_t plane = strides.Plane;
  // Trusted values are divided by 1.
  const float least = trusted ? 1.0F : LeastGradient;
  const float steepest = trusted ? 1.0F : 10.0F;
  for (std::int64_t n = first; n < last; ++n)
  {
    const float* at = from + n;
    const float c = at[0];
    const float lowest = Lesser(
      Lesser(Lesser(at[1], at[-1]), Lesser(at[row], at[-row])), Lesser(at[plane], at[-plane]));
    const float highest = Greater(
      Greater(Greater(at[1], at[-1]), Greater(at[row], at[-row])), Greater(at[plane], at[-plane]));
    // Bitwise, without branches; 0 counts as inside.
    const bool held = ((c > 0.0F) & (lowest <= 0.0F)) | ((c <= 0.0F) & (highest > 0.0F));
    const float x = 0.5F * (at[1] - at[-1]);
    const float y = 0.5F * (at[row] - at[-row]);
    const float z = 0.5F * (at[plane] - at[-plane]);
    const float slope = Lesser(steepest, Greater(least, std::sqrt(x * x + y * y + z * z)));
    to[n] = held ? c / slope : c;
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
