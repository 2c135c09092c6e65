#include "Electrostatics/SurfacePotential.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ChargesOnGrid.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/InterfaceExtrapolation.h"

#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

/// The 4 x 4 x 4 nodes around a point that are within the box.
FitNodes NodesAroundPoint(
  const SolverBox& box, const std::vector<unsigned char>& inside, const Point3& x, double length)
{
  std::array<std::int64_t, 3> low;
  for (std::size_t a = 0; a < 3; ++a)
  {
    low[a] = static_cast<std::int64_t>(std::floor((x[a] - box.Corner[a]) / box.Spacing[a])) - 1;
  }
  const auto& n = box.Dimensions;
  FitNodes nodes;
  for (int m = 0; m < 64; ++m)
  {
    const std::int64_t i = low[0] + m % 4;
    const std::int64_t j = low[1] + m / 4 % 4;
    const std::int64_t k = low[2] + m / 16;
    if (i < 0 || j < 0 || k < 0 || i >= n[0] || j >= n[1] || k >= n[2])
    {
      continue;
    }
    FitNode& node = nodes.Node[nodes.Count];
    const Point3 p = box.Position(i, j, k);
    node.Offset = { p[0] - x[0], p[1] - x[1], p[2] - x[2] };
    const std::int64_t id = i + n[0] * (j + n[1] * k);
    node.Inside = inside[static_cast<std::size_t>(id)] != 0;
    const auto& y = node.Offset;
    const double r2 = (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]) / (length * length);
    node.Weight = 1.0 / ((r2 + 0.25) * (r2 + 0.25) * (r2 + 0.25));
    nodes.Id[nodes.Count++] = id;
  }
  return nodes;
}

/// Values at points, one after another, from fits around each.
class Evaluation
{
public:
  Evaluation(const GridPotential& problem, std::size_t count, double kelvin)
    : Problem(problem)
    , Ratio(problem.GetMedium().SoluteDielectric / problem.GetMedium().SolventDielectric)
    , FieldOfCharge(4.0 * Pi * units::CoulombLength(kelvin))
  {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    this->Values.Potential.assign(count, none);
    this->Values.NormalField.assign(count, none);
    this->Values.ChargeDensity.assign(count, none);
    this->Values.TangentialGradient.assign(count, { none, none, none });
    this->Values.Normal.resize(count);
  }

  /// `charges` is the charges' own potential at the point.
  void Fit(std::size_t point, const SurfaceFrame& frame, const FitNodes& nodes,
    const SecondOrderTaylor& charges, std::vector<FitFunctional>& functionals)
  {
    static const std::vector<FitTarget> targets{ { FitTarget::SurfaceValue, {} },
      { FitTarget::NormalSlope, {} }, { FitTarget::TangentX, {} }, { FitTarget::TangentY, {} },
      { FitTarget::TangentZ, {} } };
    this->Values.Normal[point] = frame.Normal;
    if (FitInterface(this->Problem.GetMedium(), frame, nodes, targets, functionals) ==
      FitQuality::None)
    {
      return;
    }
    std::array<double, 5> fitted{};
    for (std::size_t i = 0; i < nodes.Count; ++i)
    {
      const double total = this->Problem.GetPotential()[static_cast<std::size_t>(nodes.Id[i])] +
        (nodes.Node[i].Inside ? charges.At(nodes.Node[i].Offset) : 0.0);
      for (std::size_t t = 0; t < fitted.size(); ++t)
      {
        fitted[t] += functionals[t][i] * total;
      }
    }
    this->Values.Potential[point] = fitted[0];
    this->Values.NormalField[point] = -this->Ratio * fitted[1];
    this->Values.ChargeDensity[point] = (1.0 - this->Ratio) * fitted[1] / this->FieldOfCharge;
    this->Values.TangentialGradient[point] = { fitted[2], fitted[3], fitted[4] };
  }

  SurfaceValues Finish()
  {
    for (const double phi : this->Values.Potential)
    {
      this->Values.Failed += std::isnan(phi) ? 1 : 0;
    }
    return std::move(this->Values);
  }

private:
  const GridPotential& Problem;
  const double Ratio;
  const double FieldOfCharge;
  SurfaceValues Values;
};

}

SurfaceValues EvaluateAtSurface(const GridPotential& problem, const LevelFunction& level,
  const std::vector<Point3>& points, double kelvin, const ProgressCallback& progress)
{
  const SolverBox& box = problem.GetBox();
  const std::vector<SecondOrderTaylor> charges =
    ChargesAtPoints(problem.GetCharges(), box, points, Between(progress, 0.0, 0.5));
  Evaluation values(problem, points.size(), kelvin);
  ParallelFor(
    0, static_cast<std::int64_t>(points.size()), 128,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<FitFunctional> functionals;
      for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
      {
        const FitNodes nodes =
          NodesAroundPoint(box, problem.GetInside(), points[p], problem.GetMedium().Length);
        values.Fit(p, FrameAt(level, box, points[p]), nodes, charges[p], functionals);
      }
    },
    Between(progress, 0.5, 1.0));
  return values.Finish();
}

SurfaceValues EvaluateAtCrossings(const GridPotential& problem, double kelvin)
{
  const std::vector<InterfaceCrossing>& crossings = problem.GetCrossings();
  Evaluation values(problem, crossings.size(), kelvin);
  ParallelFor(0, static_cast<std::int64_t>(crossings.size()), 128,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<FitFunctional> functionals;
      for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c)
      {
        const FitNodes nodes = NodesAroundCrossing(
          problem.GetBox(), problem.GetInside(), crossings[c], problem.GetMedium().Length);
        values.Fit(c, crossings[c].Frame, nodes, problem.GetChargesAtCrossings()[c], functionals);
      }
    });
  return values.Finish();
}

}
