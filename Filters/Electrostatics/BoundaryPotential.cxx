#include "Electrostatics/BoundaryPotential.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ChargeTree.h"

#include <cmath>
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

}
