#include "Electrostatics/InterfaceExtrapolation.h"

#include <algorithm>

namespace isthmus
{
namespace
{

Point3 EndOffset(const SolverBox& box, const InterfaceCrossing& c, bool upper)
{
  Point3 y{ 0.0, 0.0, 0.0 };
  const auto a = static_cast<std::size_t>(c.Axis);
  y[a] = (upper ? 1.0 - c.Fraction : -c.Fraction) * box.Spacing[a];
  return y;
}

/// Converts a functional of total potentials into one of u: the charges' part becomes a constant.
Continuation ExpressByU(const FitFunctional& functional, const FitNodes& nodes,
  const SecondOrderTaylor& charges, bool insideFunction, const Point3& target)
{
  Continuation c{};
  c.Constant = insideFunction ? -charges.At(target) : 0.0;
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    c.Coefficient[i] = functional[i];
    if (functional[i] != 0.0 && nodes.Node[i].Inside)
    {
      c.Constant += functional[i] * charges.At(nodes.Node[i].Offset);
    }
  }
  return c;
}

/// Half the square of y along the normal: the part of p+ with the Laplacian 1.
double Bulge(const SurfaceFrame& frame, const Point3& y)
{
  const auto& n = frame.Normal;
  const double along = n[0] * y[0] + n[1] * y[1] + n[2] * y[2];
  return 0.5 * along * along;
}

/// Adds the effect of a constant in the Laplacian outside on a continuation to `target`.
void AddLaplacian(const SurfaceFrame& frame, double laplacian, const FitNodes& nodes,
  bool insideFunction, const Point3& target, Continuation& c)
{
  c.Constant += insideFunction ? 0.0 : laplacian * Bulge(frame, target);
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    if (!nodes.Node[i].Inside)
    {
      c.Constant -= c.Coefficient[i] * laplacian * Bulge(frame, nodes.Node[i].Offset);
    }
  }
}

/// Whether the nodes outside alone could not determine an outside quadratic.
bool IsNarrow(const FitNodes& nodes)
{
  constexpr std::ptrdiff_t harmonicQuadratic = 9;
  return std::count_if(nodes.Node.begin(), nodes.Node.begin() + nodes.Count,
           [](const FitNode& node) { return !node.Inside; }) < harmonicQuadratic;
}

/// The ghost-fluid values: jumps taken along the edge alone.
void GhostFluid(const InterfaceProblem& problem, const InterfaceCrossing& c,
  const SecondOrderTaylor& charges, const FitNodes& nodes, InterfaceExtrapolation& values)
{
  const auto a = static_cast<std::size_t>(c.Axis);
  const std::int64_t step = problem.Box->Steps()[a];
  const bool lowerInside = (*problem.Inside)[static_cast<std::size_t>(c.Node)] != 0;
  // A surface on a node would make one of the parts' conductances infinite.
  const double theta = std::min(std::max(c.Fraction, 1e-6), 1.0 - 1e-6);
  const double epsLower =
    lowerInside ? problem.Medium.SoluteDielectric : problem.Medium.SolventDielectric;
  const double epsUpper =
    lowerInside ? problem.Medium.SolventDielectric : problem.Medium.SoluteDielectric;
  const double sl = epsLower / theta;
  const double su = epsUpper / (1.0 - theta);
  // Total potentials at the ends; the value on the surface makes the flux along the edge
  // continuous.
  FitFunctional lower{}, upper{};
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    const bool isLower = nodes.Id[i] == c.Node;
    const bool isUpper = nodes.Id[i] == c.Node + step;
    if (!isLower && !isUpper)
    {
      continue;
    }
    const double share = (isLower ? sl : su) / (sl + su);
    lower[i] = (share - (isLower ? 1.0 - theta : 0.0)) / theta;
    upper[i] = (share - (isUpper ? theta : 0.0)) / (1.0 - theta);
  }
  values.AtUpper = ExpressByU(lower, nodes, charges, lowerInside, EndOffset(*problem.Box, c, true));
  values.AtLower =
    ExpressByU(upper, nodes, charges, !lowerInside, EndOffset(*problem.Box, c, false));
}

}

FitNodes NodesAroundCrossing(const SolverBox& box, const std::vector<unsigned char>& inside,
  const InterfaceCrossing& crossing, double length)
{
  const auto a = static_cast<std::size_t>(crossing.Axis);
  const auto steps = box.Steps();
  FitNodes nodes;
  const std::size_t b = (a + 1) % 3;
  const std::size_t c = (a + 2) % 3;
  for (int k = -1; k <= 1; ++k)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 2; ++i)
      {
        FitNode& node = nodes.Node[nodes.Count];
        node.Offset[a] = (i - crossing.Fraction) * box.Spacing[a];
        node.Offset[b] = j * box.Spacing[b];
        node.Offset[c] = k * box.Spacing[c];
        const std::int64_t id = crossing.Node + i * steps[a] + j * steps[b] + k * steps[c];
        node.Inside = inside[static_cast<std::size_t>(id)] != 0;
        const auto& y = node.Offset;
        const double r2 = (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]) / (length * length);
        // The values continued across the edge enter the equations of its two ends, which the fit
        // therefore has to reproduce.
        const bool ends = j == 0 && k == 0 && (i == 0 || i == 1);
        node.Weight = (ends ? 1000.0 : 1.0) / ((r2 + 0.25) * (r2 + 0.25) * (r2 + 0.25));
        nodes.Id[nodes.Count++] = id;
      }
    }
  }
  return nodes;
}

Point3 AxisWeights(const SolverBox& box)
{
  const double h = *std::min_element(box.Spacing.begin(), box.Spacing.end());
  Point3 w;
  for (std::size_t a = 0; a < 3; ++a)
  {
    w[a] = h * h / (box.Spacing[a] * box.Spacing[a]);
  }
  return w;
}

InterfaceExtrapolation ValuesAtCrossing(const InterfaceProblem& problem, std::size_t index)
{
  const InterfaceCrossing& c = (*problem.Crossings)[index];
  const SecondOrderTaylor& charges = (*problem.Charges)[index];
  const FitNodes nodes =
    NodesAroundCrossing(*problem.Box, *problem.Inside, c, problem.Medium.Length);
  const bool lowerInside = (*problem.Inside)[static_cast<std::size_t>(c.Node)] != 0;
  InterfaceExtrapolation values{};
  std::copy_n(nodes.Id.begin(), nodes.Count, values.Id.begin());
  if (problem.Model == DielectricModel::SmoothDielectric)
  {
    values.Quality = FitQuality::Quadratic; // no fallback was needed
    GhostFluid(problem, c, charges, nodes, values);
    return values;
  }
  FitMedium medium = problem.Medium;
  SurfaceIons ions;
  if (!problem.Ions.empty())
  {
    ions = problem.Ions[index];
    medium.KappaSquared = ions.Slope;
  }
  const Point3 up = EndOffset(*problem.Box, c, true);
  const Point3 down = EndOffset(*problem.Box, c, false);
  const auto side = [](bool insideFunction)
  { return insideFunction ? FitTarget::InsideValue : FitTarget::OutsideValue; };
  const std::vector<FitTarget> targets{ { side(lowerInside), up }, { side(!lowerInside), down } };
  std::vector<FitFunctional> functionals;
  values.Quality = FitInterface(medium, c.Frame, nodes, targets, functionals);
  if (values.Quality == FitQuality::None || IsNarrow(nodes))
  {
    values.Quality = FitQuality::None;
    GhostFluid(problem, c, charges, nodes, values);
    return values;
  }
  values.AtUpper = ExpressByU(functionals[0], nodes, charges, lowerInside, up);
  values.AtLower = ExpressByU(functionals[1], nodes, charges, !lowerInside, down);
  if (ions.Constant != 0.0)
  {
    AddLaplacian(c.Frame, ions.Constant, nodes, lowerInside, up, values.AtUpper);
    AddLaplacian(c.Frame, ions.Constant, nodes, !lowerInside, down, values.AtLower);
  }
  return values;
}

}
