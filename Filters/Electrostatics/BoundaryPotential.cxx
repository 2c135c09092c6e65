#include "BoundaryPotential.h"

#include "ChargeTree.h"
#include "ElectrostaticUnits.h"
#include "ParallelFor.h"

#include <cmath>
#include <memory>

namespace isthmus
{
namespace
{

constexpr double SampleLength = 3.0; // angstrom, on the border

/// A piece of the surface: charge and dipole that radiate.
struct Radiator
{
  Vector3 Position;
  double Source; ///< -d_n w dS / 4 pi
  double Dipole; ///< w dS / 4 pi, along +-Axis
  int Axis;
  double Sign;
};

double Radiated(const std::vector<Radiator>& all, double kappa, const Vector3& x)
{
  double sum = 0.0;
  for (const Radiator& s : all)
  {
    const Vector3 y{ x[0] - s.Position[0], x[1] - s.Position[1], x[2] - s.Position[2] };
    const double inverse = 1.0 / std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]);
    const double g = inverse * (kappa > 0.0 ? std::exp(-kappa / inverse) : 1.0);
    // The derivative of g along n at the source, n = Sign e_Axis.
    const double slope =
      s.Sign * y[static_cast<std::size_t>(s.Axis)] * inverse * g * (kappa + inverse);
    sum += s.Source * g + s.Dipole * slope;
  }
  return sum;
}

/// Nodes of a side of the range, every `stride`-th and the last, with trapezoidal weights.
struct Rule
{
  std::vector<std::int64_t> Node;
  std::vector<double> Weight;

  Rule(std::int64_t first, std::int64_t last, std::int64_t stride, double h)
  {
    for (std::int64_t i = first;; i = std::min(i + stride, last))
    {
      this->Node.push_back(i);
      this->Weight.push_back(0.0);
      const std::size_t n = this->Node.size();
      if (n > 1)
      {
        const double half = 0.5 * h * static_cast<double>(i - this->Node[n - 2]);
        this->Weight[n - 2] += half;
        this->Weight[n - 1] += half;
      }
      if (i == last)
      {
        return;
      }
    }
  }
};

std::int64_t StrideFor(double spacing, double length)
{
  return std::max<std::int64_t>(1, std::llround(length / spacing));
}

/// One face of the range: `axis` is fixed at node `at`, outwards by `sign`.
void AddFace(const SolverBox& box, const std::vector<double>& u, const BoxNodes& range,
  const PotentialFunction& base, std::size_t axis, bool upper, std::vector<Radiator>& all)
{
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  const auto steps = box.Steps();
  const double sign = upper ? 1.0 : -1.0;
  const double h = box.Spacing[axis];
  constexpr double patch = 2.5; // angstrom
  const Rule along(range.First[b], range.Last[b], StrideFor(box.Spacing[b], patch), box.Spacing[b]);
  const Rule across(
    range.First[c], range.Last[c], StrideFor(box.Spacing[c], patch), box.Spacing[c]);
  for (std::size_t j = 0; j < along.Node.size(); ++j)
  {
    for (std::size_t k = 0; k < across.Node.size(); ++k)
    {
      std::array<std::int64_t, 3> at{};
      at[axis] = upper ? range.Last[axis] : range.First[axis];
      at[b] = along.Node[j];
      at[c] = across.Node[k];
      const std::int64_t node = at[0] * steps[0] + at[1] * steps[1] + at[2] * steps[2];
      double w[5];
      for (int s = -2; s <= 2; ++s)
      {
        auto p = at;
        p[axis] += s;
        w[s + 2] = u[static_cast<std::size_t>(node + s * steps[axis])] -
          base(box.Position(p[0], p[1], p[2]));
      }
      const double slope = sign * ((w[0] - w[4]) + 8.0 * (w[3] - w[1])) / (12.0 * h);
      const double area = along.Weight[j] * across.Weight[k] / (4.0 * units::Pi);
      all.push_back({ box.Position(at[0], at[1], at[2]), -slope * area, w[2] * area,
        static_cast<int>(axis), sign });
    }
  }
}

/// Cubic weights at t in [0, 1) for samples -1, 0, 1, 2.
std::array<double, 4> CubicWeights(double t)
{
  return { -t * (t - 1.0) * (t - 2.0) / 6.0, (t * t - 1.0) * (t - 2.0) / 2.0,
    -t * (t + 1.0) * (t - 2.0) / 2.0, t * (t * t - 1.0) / 6.0 };
}

/// The face `axis` = `at` of the box, sampled and interpolated.
void FillFace(const SolverBox& box, const PotentialFunction& f, bool sampled, std::size_t axis,
  std::int64_t at, std::vector<double>& u)
{
  const std::size_t b = (axis + 1) % 3;
  const std::size_t c = (axis + 2) % 3;
  const auto steps = box.Steps();
  const std::int64_t sb = sampled ? StrideFor(box.Spacing[b], SampleLength) : 1;
  const std::int64_t sc = sampled ? StrideFor(box.Spacing[c], SampleLength) : 1;
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
    return [charges, kappa](const Vector3& x) { return ScreenedSum(*charges, kappa, x); };
  }
  // The tree refers to the charges, so both are kept.
  auto tree = std::make_shared<ChargeTree>(*charges);
  return [charges, tree, kappa](const Vector3& x)
  {
    thread_local ChargeList seen;
    tree->Gather(x, 0.0, seen);
    return ScreenedSum(seen, kappa, x);
  };
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

PotentialFunction RadiatedPotential(const SolverBox& box, const std::vector<double>& u,
  const BoxNodes& range, double kappa, PotentialFunction base)
{
  auto sources = std::make_shared<std::vector<Radiator>>();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    AddFace(box, u, range, base, axis, false, *sources);
    AddFace(box, u, range, base, axis, true, *sources);
  }
  return [sources, kappa, base](const Vector3& x)
  { return base(x) + Radiated(*sources, kappa, x); };
}

void FillBorder(
  const SolverBox& box, const PotentialFunction& f, bool sampled, std::vector<double>& u)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    FillFace(box, f, sampled, axis, 0, u);
    FillFace(box, f, sampled, axis, box.Dimensions[axis] - 1, u);
  }
}

}
