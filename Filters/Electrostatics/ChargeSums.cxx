#include "Electrostatics/ChargeSums.h"

#include "Core/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace isthmus
{
namespace
{

constexpr std::size_t Lanes = 8;

/// The ten sums over `blocks` x 8 charges, in the order of SecondOrderTaylor, each in eight lanes
/// that the compiler can keep in vector registers without permission to reorder additions.
ISTHMUS_VECTOR_CLONES void CoulombLoop(std::size_t blocks, const double* px, const double* py,
  const double* pz, const double* pq, const double* at, double (*sums)[Lanes])
{
  for (std::size_t b = 0; b < blocks; ++b)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double dx = at[0] - px[b * Lanes + l];
      const double dy = at[1] - py[b * Lanes + l];
      const double dz = at[2] - pz[b * Lanes + l];
      const double inverse2 = 1.0 / (dx * dx + dy * dy + dz * dz);
      const double potential = pq[b * Lanes + l] * std::sqrt(inverse2);
      const double slope = potential * inverse2;
      const double bend = 3.0 * slope * inverse2;
      sums[0][l] += potential;
      sums[1][l] -= slope * dx;
      sums[2][l] -= slope * dy;
      sums[3][l] -= slope * dz;
      sums[4][l] += bend * dx * dx - slope;
      sums[5][l] += bend * dy * dy - slope;
      sums[6][l] += bend * dz * dz - slope;
      sums[7][l] += bend * dx * dy;
      sums[8][l] += bend * dx * dz;
      sums[9][l] += bend * dy * dz;
    }
  }
}

/// The potential alone, with squared distances of `least` at least.
ISTHMUS_VECTOR_CLONES void ValueLoop(std::size_t blocks, const double* px, const double* py,
  const double* pz, const double* pq, const double* at, double least, double* sums)
{
  for (std::size_t b = 0; b < blocks; ++b)
  {
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double dx = at[0] - px[b * Lanes + l];
      const double dy = at[1] - py[b * Lanes + l];
      const double dz = at[2] - pz[b * Lanes + l];
      const double r2 = dx * dx + dy * dy + dz * dz;
      sums[l] += pq[b * Lanes + l] / std::sqrt(r2 > least ? r2 : least);
    }
  }
}

/// exp(x) for x <= 0 in eight lanes, relative error 1e-15; plain arithmetic, for vector
/// instructions. 2^n by its bits, the rest by its series (|rest| <= ln 2 / 2).
inline void ExponentialLanes(double* x)
{
  constexpr double shift = 6755399441055744.0; // 1.5 * 2^52: the sum's low bits are the integer
  constexpr double inverseLog2 = 1.4426950408889634074;
  constexpr double log2High = 6.93147180369123816490e-01; // exact in 33 bits
  constexpr double log2Low = 1.90821492927058770002e-10;
  double whole[Lanes], power[Lanes];
  std::uint64_t bits[Lanes];
  for (std::size_t l = 0; l < Lanes; ++l)
  {
    x[l] = x[l] > -700.0 ? x[l] : -700.0;
    whole[l] = x[l] * inverseLog2 + shift;
  }
  std::memcpy(bits, whole, sizeof(bits));
  for (std::size_t l = 0; l < Lanes; ++l)
  {
    bits[l] = (bits[l] + 1023U) << 52U;
  }
  std::memcpy(power, bits, sizeof(bits));
  for (std::size_t l = 0; l < Lanes; ++l)
  {
    const double n = whole[l] - shift;
    const double f = (x[l] - n * log2High) - n * log2Low;
    double sum = 1.0 / 39916800.0;
    for (const double c : { 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0,
           1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0 })
    {
      sum = sum * f + c;
    }
    x[l] = sum * power[l];
  }
}

/// sum q exp(-kappa r) / r.
ISTHMUS_VECTOR_CLONES void ScreenedLoop(std::size_t blocks, const double* px, const double* py,
  const double* pz, const double* pq, const double* at, double kappa, double* sums)
{
  for (std::size_t b = 0; b < blocks; ++b)
  {
    double factor[Lanes], decay[Lanes];
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      const double dx = at[0] - px[b * Lanes + l];
      const double dy = at[1] - py[b * Lanes + l];
      const double dz = at[2] - pz[b * Lanes + l];
      const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
      factor[l] = pq[b * Lanes + l] / r;
      decay[l] = -kappa * r;
    }
    ExponentialLanes(decay);
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      sums[l] += factor[l] * decay[l];
    }
  }
}

/// A single charge, into lane 0.
void AddOne(const ChargeList& charges, std::size_t i, const Point3& x, double (*sums)[Lanes])
{
  double px[Lanes], py[Lanes], pz[Lanes], q[Lanes] = {};
  std::fill(px, px + Lanes, charges.X[i]);
  std::fill(py, py + Lanes, charges.Y[i]);
  std::fill(pz, pz + Lanes, charges.Z[i]);
  q[0] = charges.Charge[i];
  CoulombLoop(1, px, py, pz, q, x.data(), sums);
}

}

SecondOrderTaylor CoulombSum(const ChargeList& charges, const Point3& x)
{
  double sums[10][Lanes] = {};
  const std::size_t blocks = charges.Size() / Lanes;
  CoulombLoop(blocks, charges.X.data(), charges.Y.data(), charges.Z.data(), charges.Charge.data(),
    x.data(), sums);
  for (std::size_t i = blocks * Lanes; i < charges.Size(); ++i)
  {
    AddOne(charges, i, x, sums);
  }
  double s[10];
  for (std::size_t term = 0; term < 10; ++term)
  {
    s[term] = 0.0;
    for (std::size_t l = 0; l < Lanes; ++l)
    {
      s[term] += sums[term][l];
    }
  }
  return { s[0], { s[1], s[2], s[3] }, { s[4], s[5], s[6], s[7], s[8], s[9] } };
}

double CoulombValue(const ChargeList& charges, const Point3& x, double nearest)
{
  double lanes[Lanes] = {};
  const std::size_t blocks = charges.Size() / Lanes;
  ValueLoop(blocks, charges.X.data(), charges.Y.data(), charges.Z.data(), charges.Charge.data(),
    x.data(), nearest * nearest, lanes);
  double sum = 0.0;
  for (const double lane : lanes)
  {
    sum += lane;
  }
  for (std::size_t i = blocks * Lanes; i < charges.Size(); ++i)
  {
    const double r = std::hypot(x[0] - charges.X[i], x[1] - charges.Y[i], x[2] - charges.Z[i]);
    sum += charges.Charge[i] / std::max(r, nearest);
  }
  return sum;
}

double ScreenedSum(
  const ChargeList& charges, double kappa, const Point3& x, std::size_t first, std::size_t last)
{
  double lanes[Lanes] = {};
  const std::size_t blocks = (last - first) / Lanes;
  const double* const from[4] = { charges.X.data() + first, charges.Y.data() + first,
    charges.Z.data() + first, charges.Charge.data() + first };
  if (kappa > 0.0)
  {
    ScreenedLoop(blocks, from[0], from[1], from[2], from[3], x.data(), kappa, lanes);
  }
  else
  {
    ValueLoop(blocks, from[0], from[1], from[2], from[3], x.data(), 0.0, lanes);
  }
  double sum = 0.0;
  for (const double lane : lanes)
  {
    sum += lane;
  }
  for (std::size_t i = first + blocks * Lanes; i < last; ++i)
  {
    const double r = std::hypot(x[0] - charges.X[i], x[1] - charges.Y[i], x[2] - charges.Z[i]);
    sum += charges.Charge[i] * std::exp(-kappa * r) / r;
  }
  return sum;
}

}
