#include "SurfacePotential.h"

#include "ChargesOnGrid.h"
#include "ElectrostaticUnits.h"
#include "ParallelFor.h"

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

}

SurfaceValues EvaluateAtSurface(const PotentialOnBox& problem, const LevelFunction& level,
  const std::vector<Point3>& points, double kelvin, const ProgressCallback& progress)
{
  const SolverBox& box = problem.GetBox();
  const FitMedium& medium = problem.GetMedium();
  const double rho = medium.SoluteDielectric / medium.SolventDielectric;
  const double fieldOfCharge = 4.0 * Pi * units::CoulombLength(kelvin);
  const std::vector<SecondOrderTaylor> charges =
    ChargesAtPoints(problem.GetCharges(), box, points, Between(progress, 0.0, 0.5));
  SurfaceValues values;
  const std::size_t count = points.size();
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  values.Potential.assign(count, none);
  values.NormalField.assign(count, none);
  values.ChargeDensity.assign(count, none);
  values.TangentialGradient.assign(count, { none, none, none });
  values.Normal.resize(count);
  const std::vector<FitTarget> targets{ { FitTarget::SurfaceValue, {} },
    { FitTarget::NormalSlope, {} }, { FitTarget::TangentX, {} }, { FitTarget::TangentY, {} },
    { FitTarget::TangentZ, {} } };
  ParallelFor(
    0, static_cast<std::int64_t>(count), 128,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<FitFunctional> functionals;
      for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
      {
        const SurfaceFrame frame = FrameAt(level, box, points[p]);
        values.Normal[p] = frame.Normal;
        const FitNodes nodes = NodesAroundPoint(box, problem.GetInside(), points[p], medium.Length);
        if (FitInterface(medium, frame, nodes, targets, functionals) == FitQuality::None)
        {
          continue;
        }
        double phi = 0.0, slope = 0.0;
        Point3 along{ 0.0, 0.0, 0.0 };
        for (std::size_t i = 0; i < nodes.Count; ++i)
        {
          const double total = problem.GetPotential()[static_cast<std::size_t>(nodes.Id[i])] +
            (nodes.Node[i].Inside ? charges[p].At(nodes.Node[i].Offset) : 0.0);
          phi += functionals[0][i] * total;
          slope += functionals[1][i] * total;
          for (std::size_t a = 0; a < 3; ++a)
          {
            along[a] += functionals[2 + a][i] * total;
          }
        }
        values.TangentialGradient[p] = along;
        values.Potential[p] = phi;
        values.NormalField[p] = -rho * slope;
        values.ChargeDensity[p] = (1.0 - rho) * slope / fieldOfCharge;
      }
    },
    Between(progress, 0.5, 1.0));
  for (const double phi : values.Potential)
  {
    values.Failed += std::isnan(phi) ? 1 : 0;
  }
  return values;
}

}
