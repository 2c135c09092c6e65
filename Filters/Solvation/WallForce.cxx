#include "Solvation/WallForce.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/InterfaceExtrapolation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

/// Exponent of the weight of nodes inside the atoms in a fit, as a power of the ratio of the
/// dielectric constants: near charges, the potential is not quadratic.
constexpr double InsideExponent = 2.5;
/// Largest difference, in kT/e, between the water's potential at the wall and at the nearest node.
constexpr double LargestDrop = 2.0;

/// Fits of the potential and ion concentrations at individual crossings.
class Wall
{
public:
  Wall(const PoissonNernstPlanck& solution, const LevelFunction& level, const SolverBox& box,
    std::int64_t margin)
    : Solution(solution)
    , Domain(solution.GetGrid().Domain)
    , Box(box)
    , Margin(margin)
    , Inside(ClassifyNodes(level, box))
  {
    const IonTransportParameters& p = solution.GetParameters();
    const double ratio = p.SoluteDielectric / p.SolventDielectric;
    this->Medium.SoluteDielectric = p.SoluteDielectric;
    this->Medium.SolventDielectric = p.SolventDielectric;
    this->Medium.InsideWeight = std::pow(std::min(1.0, ratio), InsideExponent);
    this->Medium.Length = this->Domain.Spacing;
  }

  const std::vector<unsigned char>& Sides() const { return this->Inside; }

  /// kT/angstrom^3; NaN if it cannot be computed.
  double PullAt(const InterfaceCrossing& crossing) const;

private:
  FitNodes NodesAround(const InterfaceCrossing& crossing) const;
  std::int64_t InDomain(std::int64_t node) const;
  double Laplacian(std::int64_t water) const;
  double FieldPull(const std::array<double, 5>& fitted) const;
  double IonPressure(std::int64_t water, double phi) const;

  const PoissonNernstPlanck& Solution;
  const TransportDomain& Domain;
  const SolverBox& Box;
  const std::int64_t Margin;
  const std::vector<unsigned char> Inside;
  FitMedium Medium;
};

/// The nodes around an edge, weighted by their distances alone. Rows of equations depend on those
/// at its ends, which therefore have a thousandfold weight (InterfaceExtrapolation.h); but here one
/// permittivity per edge leaves the largest errors there, and at an end just behind the wall they
/// would dominate the slope.
FitNodes Wall::NodesAround(const InterfaceCrossing& crossing) const
{
  const double h = this->Domain.Spacing;
  FitNodes nodes = NodesAroundCrossing(this->Box, this->Inside, crossing, h);
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    const Point3& y = nodes.Node[i].Offset;
    nodes.Node[i].Weight = 1.0 / (1.0 + (y[0] * y[0] + y[1] * y[1] + y[2] * y[2]) / (h * h));
  }
  return nodes;
}

/// The node of the domain at a node of the box; -1 if there is no potential.
std::int64_t Wall::InDomain(std::int64_t node) const
{
  const auto& n = this->Box.Dimensions;
  const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  const std::array<std::int64_t, 3> steps = this->Domain.Steps();
  std::int64_t to = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::int64_t i = at[a] - this->Margin;
    if (i < 1 || i + 1 >= this->Domain.Dimensions[a])
    {
      return -1;
    }
    to += i * steps[a];
  }
  const auto& edges = this->Solution.GetGrid().Permittivity;
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (edges[a][static_cast<std::size_t>(to)] > 0.0F ||
      edges[a][static_cast<std::size_t>(to - steps[a])] > 0.0F)
    {
      return to;
    }
  }
  return -1;
}

/// Gradient of the potential just outside the wall.
double Wall::Laplacian(std::int64_t water) const
{
  const IonTransportParameters& p = this->Solution.GetParameters();
  double charge = 0.0;
  for (std::size_t k = 0; k < p.Species.size(); ++k)
  {
    charge += p.Species[k].Valence * this->Solution.Concentration(SpeciesId(k), water);
  }
  return -4.0 * Pi * units::CoulombLength(p.Temperature) * units::IonsPerCubicAngstrom * charge /
    p.SolventDielectric;
}

double Wall::FieldPull(const std::array<double, 5>& fitted) const
{
  const double in = this->Medium.SoluteDielectric;
  const double out = this->Medium.SolventDielectric;
  const double displacement = in * fitted[1];
  const double along = fitted[2] * fitted[2] + fitted[3] * fitted[3] + fitted[4] * fitted[4];
  return ((1.0 / in - 1.0 / out) * displacement * displacement + (out - in) * along) /
    (8.0 * Pi * units::CoulombLength(this->Solution.GetParameters().Temperature));
}

double Wall::IonPressure(std::int64_t water, double phi) const
{
  const IonTransportParameters& p = this->Solution.GetParameters();
  const auto along =
    static_cast<double>(this->Solution.GetGrid().Along[static_cast<std::size_t>(water)]);
  const double below = p.PartBelow(along);
  double excess = 0.0;
  for (std::size_t k = 0; k < p.Species.size() && this->Solution.IsWater(water); ++k)
  {
    const TransportSpecies& s = p.Species[k];
    const double bath = below * s.Below + (1.0 - below) * s.Above;
    excess += this->Solution.GetSlotboom(SpeciesId(k))[static_cast<std::size_t>(water)] *
        std::exp(-s.Valence * phi) -
      bath;
  }
  return units::IonsPerCubicAngstrom * excess;
}

double Wall::PullAt(const InterfaceCrossing& crossing) const
{
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const FitNodes nodes = this->NodesAround(crossing);
  const std::int64_t next =
    crossing.Node + this->Box.Steps()[static_cast<std::size_t>(crossing.Axis)];
  const std::int64_t water = this->InDomain(
    this->Inside[static_cast<std::size_t>(crossing.Node)] != 0 ? next : crossing.Node);
  FitFunctional data{};
  const double laplacian = water < 0 ? 0.0 : this->Laplacian(water);
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    const std::int64_t node = this->InDomain(nodes.Id[i]);
    if (node < 0 || water < 0)
    {
      return none;
    }
    const Point3& n = crossing.Frame.Normal;
    const Point3& y = nodes.Node[i].Offset;
    const double off = n[0] * y[0] + n[1] * y[1] + n[2] * y[2];
    data[i] = this->Solution.GetPotential()[static_cast<std::size_t>(node)] -
      (nodes.Node[i].Inside ? 0.0 : 0.5 * laplacian * off * off);
  }
  static const std::vector<FitTarget> wanted{ { FitTarget::SurfaceValue, {} },
    { FitTarget::NormalSlope, {} }, { FitTarget::TangentX, {} }, { FitTarget::TangentY, {} },
    { FitTarget::TangentZ, {} } };
  std::vector<FitFunctional> functionals;
  if (FitInterface(this->Medium, crossing.Frame, nodes, wanted, functionals) == FitQuality::None)
  {
    return none;
  }
  std::array<double, 5> fitted{};
  for (std::size_t t = 0; t < fitted.size(); ++t)
  {
    for (std::size_t i = 0; i < nodes.Count; ++i)
    {
      fitted[t] += functionals[t][i] * data[i];
    }
  }
  const double at = this->Solution.GetPotential()[static_cast<std::size_t>(water)];
  return this->FieldPull(fitted) +
    this->IonPressure(water, std::clamp(fitted[0], at - LargestDrop, at + LargestDrop));
}

}

WallValues ForceAtWall(const PoissonNernstPlanck& solution, const LevelFunction& level,
  const SolverBox& box, std::int64_t margin)
{
  const Wall wall(solution, level, box, margin);
  const std::vector<InterfaceCrossing> all = FindCrossings(level, box, wall.Sides());
  std::vector<double> pull(all.size());
  ParallelFor(0, static_cast<std::int64_t>(all.size()), 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        pull[i] = wall.PullAt(all[i]);
      }
    });
  const double unit = units::ThermalKilocalorie(solution.GetParameters().Temperature);
  WallValues values;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (std::isfinite(pull[i]))
    {
      values.Crossings.push_back(all[i]);
      values.Pull.push_back(unit * pull[i]);
    }
  }
  return values;
}

}
