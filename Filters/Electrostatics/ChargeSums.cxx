#include "ChargeSums.h"

#include "VectorClones.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr std::size_t Lanes = 8;

/// The ten sums over `blocks` x 8 charges, in the order of SecondOrderTaylor, each in eight lanes
/// that the compiler can hold in vector registers without leave to reorder additions.
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

/// One charge by itself, into lane 0.
void AddOne(const ChargeList& charges, std::size_t i, const Vector3& x, double (*sums)[Lanes])
{
  double px[Lanes], py[Lanes], pz[Lanes], q[Lanes] = {};
  std::fill(px, px + Lanes, charges.X[i]);
  std::fill(py, py + Lanes, charges.Y[i]);
  std::fill(pz, pz + Lanes, charges.Z[i]);
  q[0] = charges.Charge[i];
  CoulombLoop(1, px, py, pz, q, x.data(), sums);
}

}

SecondOrderTaylor CoulombSum(const ChargeList& charges, const Vector3& x)
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

double CoulombValue(const ChargeList& charges, const Vector3& x, double nearest)
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

double ScreenedSum(const ChargeList& charges, double kappa, const Vector3& x)
{
  if (!(kappa > 0.0))
  {
    return CoulombValue(charges, x, 0.0);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < charges.Size(); ++i)
  {
    const double dx = x[0] - charges.X[i];
    const double dy = x[1] - charges.Y[i];
    const double dz = x[2] - charges.Z[i];
    const double r = std::sqrt(dx * dx + dy * dy + dz * dz);
    sum += charges.Charge[i] * std::exp(-kappa * r) / r;
  }
  return sum;
}

}
