#include "Electrostatics/BoundaryPotential.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ChargeTree.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace isthmus
{
namespace
{

std::int64_t StrideFor(double spacing, double length)
{
  return std::max<std::int64_t>(1, std::llround(length / spacing));
}

/// Cubic weights at t in [0, 1) for samples -1, 0, 1, 2.
std::array<double, 4> CubicWeights(double t)
{
  return { -t * (t - 1.0) * (t - 2.0) / 6.0, (t * t - 1.0) * (t - 2.0) / 2.0,
    -t * (t + 1.0) * (t - 2.0) / 2.0, t * (t * t - 1.0) / 6.0 };
}

/// The face `axis` = `at` of the box, sampled and interpolated.
void FillFace(const SolverBox& box, const PotentialFunction& f, double sampleLength,
  std::size_t axis, std::int64_t at, std::vector<double>& u)
{
  const bool sampled = sampleLength > 0.0;
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  const auto steps = box.Steps();
  const std::int64_t sb = StrideFor(box.Spacing[b], sampleLength);
  const std::int64_t sc = StrideFor(box.Spacing[c], sampleLength);
  const std::int64_t nb = (box.Dimensions[b] - 1) / sb + 4; // from one before to two after
  const std::int64_t nc = (box.Dimensions[c] - 1) / sc + 4;
  std::vector<double> sample(static_cast<std::size_t>(nb * nc));
  ParallelFor(0, nb * nc, 8,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t s = first; s < last; ++s)
      {
        std::array<std::int64_t, 3> p{};
        p[axis] = at;
        p[b] = (s % nb - 1) * sb;
        p[c] = (s / nb - 1) * sc;
        // Without sampling the function may end at the border.
        const bool beyond =
          p[b] < 0 || p[c] < 0 || p[b] >= box.Dimensions[b] || p[c] >= box.Dimensions[c];
        sample[static_cast<std::size_t>(s)] =
          !sampled && beyond ? 0.0 : f(box.Position(p[0], p[1], p[2]));
      }
    });
  for (std::int64_t k = 0; k < box.Dimensions[c]; ++k)
  {
    const auto wk = CubicWeights(static_cast<double>(k % sc) / static_cast<double>(sc));
    for (std::int64_t j = 0; j < box.Dimensions[b]; ++j)
    {
      const auto wj = CubicWeights(static_cast<double>(j % sb) / static_cast<double>(sb));
      double value = 0.0;
      for (std::int64_t r = 0; r < 4; ++r)
      {
        for (std::int64_t q = 0; q < 4; ++q)
        {
          value += wk[static_cast<std::size_t>(r)] * wj[static_cast<std::size_t>(q)] *
            sample[static_cast<std::size_t>((j / sb + q) + nb * (k / sc + r))];
        }
      }
      u[static_cast<std::size_t>(at * steps[axis] + j * steps[b] + k * steps[c])] = value;
    }
  }
}

}

PotentialFunction MultipleDebyeHueckel(const std::vector<ChargedAtom>& atoms, double coulombLength,
  double solventDielectric, double kappa)
{
  auto charges = std::make_shared<ChargeList>();
  for (const ChargedAtom& atom : atoms)
  {
    const double ka = kappa * std::max(atom.Radius, 0.0);
    charges->Add(
      atom.Position, coulombLength / solventDielectric * atom.Charge * std::exp(ka) / (1.0 + ka));
  }
  if (charges->Size() < FewestForTree)
  {
    return [charges, kappa](const Point3& x) { return ScreenedSum(*charges, kappa, x); };
  }
  auto tree = std::make_shared<ChargeTree>(*charges);
  return [tree, kappa](const Point3& x) { return tree->ScreenedSum(x, kappa); };
}

PotentialFunction SingleDebyeHueckel(const std::vector<ChargedAtom>& atoms, double coulombLength,
  double solventDielectric, double kappa)
{
  ChargedAtom all{ { 0.0, 0.0, 0.0 }, 0.0, 0.0 };
  for (const ChargedAtom& atom : atoms)
  {
    all.Charge += atom.Charge;
    for (std::size_t a = 0; a < 3; ++a)
    {
      all.Position[a] += atom.Position[a] / static_cast<double>(atoms.size());
    }
  }
  for (const ChargedAtom& atom : atoms)
  {
    const auto& p = atom.Position;
    const auto& q = all.Position;
    all.Radius = std::max(
      all.Radius, std::max(atom.Radius, 0.0) + std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return MultipleDebyeHueckel({ all }, coulombLength, solventDielectric, kappa);
}

void FillBorder(
  const SolverBox& box, const PotentialFunction& f, double sampleLength, std::vector<double>& u)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    FillFace(box, f, sampleLength, axis, 0, u);
    FillFace(box, f, sampleLength, axis, box.Dimensions[axis] - 1, u);
  }
}

namespace
{

/// Weights of n + 1 equidistant nodes: trapezoids, the three at each end corrected.
std::vector<double> GregoryWeights(std::int64_t pieces, double h)
{
  constexpr double ends[3] = { 3.0 / 8.0, 7.0 / 6.0, 23.0 / 24.0 };
  std::vector<double> weights(static_cast<std::size_t>(pieces) + 1, h);
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const std::size_t end = std::min(i, weights.size() - 1 - i);
    if (weights.size() >= 6)
    {
      weights[i] *= end < 3 ? ends[end] : 1.0;
    }
    else if (end == 0)
    {
      weights[i] *= pieces > 0 ? 0.5 : 0.0;
    }
  }
  return weights;
}

/// One face of the range: `axis` is fixed at its lower or upper end.
void AddFace(const SolverBox& box, const std::vector<double>& u, const RadiatingBox& range,
  std::size_t axis, bool upper, ChargeList& charges)
{
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  const auto steps = box.Steps();
  const double sign = upper ? 1.0 : -1.0;
  const double h = box.Spacing[axis];
  const auto weights = [&](std::size_t side)
  {
    return GregoryWeights((range.Last[side] - range.First[side]) / range.Stride[side],
      static_cast<double>(range.Stride[side]) * box.Spacing[side]);
  };
  const std::vector<double> along = weights(b);
  const std::vector<double> across = weights(c);
  // A dipole is two charges so close that the distance between them has no effect.
  const double apart = 0.05 * h;
  for (std::size_t j = 0; j < along.size(); ++j)
  {
    for (std::size_t k = 0; k < across.size(); ++k)
    {
      std::array<std::int64_t, 3> at{};
      at[axis] = upper ? range.Last[axis] : range.First[axis];
      at[b] = range.First[b] + static_cast<std::int64_t>(j) * range.Stride[b];
      at[c] = range.First[c] + static_cast<std::int64_t>(k) * range.Stride[c];
      const std::int64_t node = at[0] * steps[0] + at[1] * steps[1] + at[2] * steps[2];
      double w[5];
      for (int s = -2; s <= 2; ++s)
      {
        w[s + 2] = u[static_cast<std::size_t>(node + s * steps[axis])];
      }
      const double slope = sign * ((w[0] - w[4]) + 8.0 * (w[3] - w[1])) / (12.0 * h);
      const double area = along[j] * across[k] / (4.0 * Pi);
      Point3 x = box.Position(at[0], at[1], at[2]);
      const double half = -0.5 * slope * area;
      const double dipole = 0.5 * w[2] * area / apart;
      x[axis] += sign * apart;
      charges.Add(x, half + dipole);
      x[axis] -= 2.0 * sign * apart;
      charges.Add(x, half - dipole);
    }
  }
}

}

double GapAround(const BoxNodes& inside, const SolverBox& box)
{
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::int64_t nodes = std::min(inside.First[a], box.Dimensions[a] - 1 - inside.Last[a]);
    gap = std::min(gap, static_cast<double>(nodes) * box.Spacing[a]);
  }
  return gap;
}

RadiatingBox MakeIntermediateBox(const BoxNodes& inside, const SolverBox& box)
{
  constexpr std::int64_t reach = 3; // from a node inside, to have the stencil of a slope outside
  const double gap = GapAround(inside, box);
  RadiatingBox range;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::int64_t end = box.Dimensions[a] - 1;
    std::int64_t& first = range.First[a];
    std::int64_t& last = range.Last[a];
    std::int64_t& stride = range.Stride[a];
    first = std::max<std::int64_t>(2, inside.First[a] / 2);
    last = std::min(end - 2, (inside.Last[a] + end + 1) / 2);
    stride = std::max<std::int64_t>(1, std::llround(0.25 * gap / box.Spacing[a]));
    // Whole strides: the remainder is removed from the ends, as far as there is room.
    const std::int64_t below = std::max<std::int64_t>(0, inside.First[a] - reach - first);
    const std::int64_t above = std::max<std::int64_t>(0, last - inside.Last[a] - reach);
    while (std::min((last - first) % stride / 2, below) + above < (last - first) % stride)
    {
      --stride;
    }
    const std::int64_t rest = (last - first) % stride;
    const std::int64_t low = std::min(rest / 2, below);
    first += low;
    last -= rest - low;
  }
  return range;
}

// End corrections of Gregory's rule are of fourth order at the edges; inside a face the error falls
// as exp(-2 pi d / stride), d the distance between range and border. Each node yields a pair of
// charges for source and dipole.
PotentialFunction RadiatedPotential(
  const SolverBox& box, const std::vector<double>& u, const RadiatingBox& range, double kappa)
{
  auto charges = std::make_shared<ChargeList>();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    AddFace(box, u, range, axis, false, *charges);
    AddFace(box, u, range, axis, true, *charges);
  }
  if (charges->Size() < FewestForTree)
  {
    return [charges, kappa](const Point3& x) { return ScreenedSum(*charges, kappa, x); };
  }
  auto tree = std::make_shared<ChargeTree>(*charges);
  return [tree, kappa](const Point3& x) { return tree->ScreenedSum(x, kappa); };
}

}
