#include "Electrostatics/PoissonBoltzmann.h"

#include "Core/RangeChecks.h"

#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Minimum number of solvent nodes around the surface: stencils at the surface reach three, the
/// border function two.
constexpr std::int64_t FewestNodesAround = 6;

/// First and last nodes of the volume inside the level.
BoxNodes LevelNodeRange(const LevelFunction& level)
{
  const auto& n = level.Dimensions();
  BoxNodes range{ { n[0], n[1], n[2] }, { -1, -1, -1 } };
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        if (level.Inside(i, j, k))
        {
          const std::int64_t at[3] = { i, j, k };
          for (std::size_t a = 0; a < 3; ++a)
          {
            range.First[a] = std::min(range.First[a], at[a]);
            range.Last[a] = std::max(range.Last[a], at[a]);
          }
        }
      }
    }
  }
  return range;
}

PotentialFunction DebyeHueckel(
  const std::vector<ChargedAtom>& atoms, const PoissonBoltzmannParameters& p, double kappa)
{
  const double c = units::CoulombLength(p.Temperature);
  return p.BoundaryCondition == BoundaryCondition::SingleDebyeHueckel
    ? SingleDebyeHueckel(atoms, c, p.SolventDielectric, kappa)
    : MultipleDebyeHueckel(atoms, c, p.SolventDielectric, kappa);
}

/// Each other node of `box`, the first one moved by `shift` nodes (0 or 1); if `widened`, with
/// enough nodes around the surface.
SolverBox ShiftedCoarseBox(const BoxNodes& inside, const SolverBox& box,
  const std::array<std::int64_t, 3>& shift, bool widened)
{
  constexpr std::int64_t stride = 2;
  SolverBox coarse = CoarserBox(box, stride);
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::int64_t first = box.First[a] + shift[a];
    std::int64_t last = first + (box.Dimensions[a] - 1 - shift[a]) / stride * stride;
    while (widened && inside.First[a] - first < FewestNodesAround * stride)
    {
      first -= stride;
    }
    while (widened && last - inside.Last[a] < FewestNodesAround * stride)
    {
      last += stride;
    }
    coarse.First[a] = first;
    coarse.Dimensions[a] = (last - first) / stride + 1;
    coarse.Corner[a] = static_cast<double>(first) * box.Spacing[a];
  }
  return coarse;
}

/// The grid for the border's values: twice the spacing if that still resolves the surface, half an
/// angstrom if the spacing is very fine. The box of the equivalent sources lies halfway in the
/// solvent and needs two nodes on each side of its faces.
std::int64_t StrideForBorder(const LevelFunction& level, const SolverBox& box)
{
  const double h = *std::max_element(box.Spacing.begin(), box.Spacing.end());
  const BoxNodes inside = LevelNodeRange(level);
  std::int64_t gap = std::numeric_limits<std::int64_t>::max();
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::int64_t end = box.First[a] + box.Dimensions[a] - 1;
    gap = std::min({ gap, inside.First[a] - box.First[a], end - inside.Last[a] });
  }
  const auto suits = [&](std::int64_t stride) { return gap / stride >= FewestNodesAround; };
  std::int64_t stride = 2.0 * h <= 1.1 && suits(2) ? 2 : 1;
  while (2.0 * static_cast<double>(stride) * h <= 0.51 && suits(2 * stride))
  {
    stride *= 2;
  }
  return stride;
}

/// The border function of SelfConsistent, from solutions of `problem` with successively better
/// border values.
PotentialFunction SelfConsistentBorder(
  GridPotential& problem, PotentialFunction border, const ProgressCallback& progress)
{
  constexpr int rounds = 2;
  constexpr double tolerances[rounds] = { 1e-2, 1e-4 }; // the second corrects the first
  const RadiatingBox range = MakeIntermediateBox(problem.RangeInside(), problem.GetBox());
  for (int round = 0; round < rounds; ++round)
  {
    problem.SetBorder(border, true);
    problem.Solve(tolerances[round], Between(progress, 0.5 * round, 0.5 * (round + 1)));
    border = RadiatedPotential(problem.GetBox(), problem.GetPotential(), range, problem.Kappa());
  }
  return border;
}

}

void Check(const GridRequest& request)
{
  RequireAbove("Spacing", request.Spacing, 0.0, LargestLength, "It is in angstrom.");
  RequireRange("Padding", request.Padding, 0.0, 1e6, "It is in angstrom.");
}

void Check(const PoissonBoltzmannParameters& p)
{
  Check(static_cast<const GridRequest&>(p));
  RequireChoice("DielectricModel", p.DielectricModel, DielectricModel::SmoothDielectric);
  RequireAbove("SoluteDielectric", p.SoluteDielectric, 0.0, Unlimited, "Proteins have 1 to 20.");
  RequireAbove("SolventDielectric", p.SolventDielectric, 0.0, Unlimited, "Water has 80.");
  RequireRange("IonicStrength", p.IonicStrength, 0.0, units::LargestConcentration,
    "It is in mol/l: 0.15 is physiological.");
  RequireRange("IonRadius", p.IonRadius, 0.0, LargestLength, "It is in angstrom.");
  RequireRange("Temperature", p.Temperature, units::LowestTemperature, units::HighestTemperature,
    "It is in kelvin: 298.15 is 25 degrees Celsius.");
  RequireChoice("BoundaryCondition", p.BoundaryCondition, BoundaryCondition::Given);
  RequireAbove("Tolerance", p.Tolerance, 0.0, 1.0, "It is a fraction of the initial residual.");
  RequireRange("MaximumIterations", p.MaximumIterations, 1, 1e6);
}

SolverBox BoxAround(const LevelFunction& level, double padding)
{
  const auto& n = level.Dimensions();
  const BoxNodes inside = LevelNodeRange(level);
  if (inside.Last[0] < 0)
  {
    throw std::invalid_argument("No node is inside the surface: choose another Level, toggle "
                                "InsideIsHigher, or make the grid finer.");
  }
  SolverBox box;
  box.Spacing = level.Spacing();
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (inside.First[a] == 0 || inside.Last[a] == n[a] - 1)
    {
      throw std::invalid_argument(std::string("The surface leaves the volume along ") + "xyz"[a] +
        ", so it is not closed: choose another Level, switch InsideIsHigher, or make the volume "
        "larger.");
    }
    const auto wanted = std::max(
      FewestNodesAround, static_cast<std::int64_t>(std::ceil(padding / box.Spacing[a] - 1e-9)));
    const std::int64_t first = std::min<std::int64_t>(0, inside.First[a] - wanted);
    const std::int64_t last = std::max(n[a] - 1, inside.Last[a] + wanted);
    box.First[a] = first;
    box.Dimensions[a] = last - first + 1;
    box.Corner[a] = static_cast<double>(first) * box.Spacing[a];
  }
  return box;
}

SolverBox CoarserBox(const SolverBox& box, std::int64_t stride)
{
  SolverBox coarse = box;
  coarse.Stride = box.Stride * stride;
  for (std::size_t a = 0; a < 3; ++a)
  {
    coarse.Dimensions[a] = (box.Dimensions[a] - 1 + stride - 1) / stride + 1;
    coarse.Spacing[a] = box.Spacing[a] * static_cast<double>(stride);
  }
  return coarse;
}

std::unique_ptr<GridPotential> SolvePoissonBoltzmann(const LevelFunction& level,
  const SolverBox& box, const std::vector<ChargedAtom>& atoms,
  const PoissonBoltzmannParameters& parameters, const IonAtmosphere& ions,
  const ProgressCallback& progress)
{
  Check(parameters);
  const auto setUp = [&](const SolverBox& on, double from, double to)
  {
    return std::make_unique<GridPotential>(
      level, on, atoms, parameters, ions, Between(progress, from, to));
  };
  const double kappa = std::sqrt(ions.Linear() / parameters.SolventDielectric);
  std::unique_ptr<GridPotential> problem;
  PotentialFunction border;
  int borderIterations = 0;
  switch (parameters.BoundaryCondition)
  {
    case BoundaryCondition::Zero:
      border = [](const Point3&) { return 0.0; };
      break;
    case BoundaryCondition::Given:
      border = parameters.Boundary;
      break;
    case BoundaryCondition::SelfConsistent:
    {
      const std::int64_t stride = StrideForBorder(level, box);
      auto rough = setUp(CoarserBox(box, stride), 0.0, 0.1);
      border = SelfConsistentBorder(
        *rough, DebyeHueckel(atoms, parameters, kappa), Between(progress, 0.1, 0.25));
      borderIterations = stride == 1 ? 0 : rough->GetReport().Iterations;
      problem = stride == 1 ? std::move(rough) : nullptr;
      break;
    }
    default:
      border = DebyeHueckel(atoms, parameters, kappa);
      break;
  }
  // Without coarsening, the problem of the border is the final one.
  problem = problem ? std::move(problem) : setUp(box, 0.25, 0.5);
  problem->SetBorder(border, parameters.BoundaryCondition != BoundaryCondition::Given);
  if (parameters.Start)
  {
    problem->SetStart(parameters.Start);
  }
  problem->Solve(parameters.Tolerance, Between(progress, 0.5, 0.95));
  problem->SetBorderIterations(borderIterations);
  problem->Evaluate();
  return problem;
}

namespace
{

/// Half the charge times the largest potential of the charges in the solvent at the centres of the
/// sides of the box: what the condition of zero potential there neglects.
double EnergyOfZeroBorder(const GridPotential& solution)
{
  const PotentialFunction border =
    DebyeHueckel(solution.GetAtoms(), solution.GetParameters(), solution.Kappa());
  const SolverBox& box = solution.GetBox();
  double charge = 0.0;
  for (const ChargedAtom& atom : solution.GetAtoms())
  {
    charge += atom.Charge;
  }
  double largest = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (const bool upper : { false, true })
    {
      std::array<std::int64_t, 3> at;
      std::transform(box.Dimensions.begin(), box.Dimensions.end(), at.begin(),
        [](std::int64_t n) { return n / 2; });
      at[a] = upper ? box.Dimensions[a] - 1 : 0;
      largest = std::max(largest, std::abs(border(box.Position(at[0], at[1], at[2]))));
    }
  }
  return 0.5 * std::abs(charge) * largest;
}

/// A scale of the energy that does not vanish where the dielectrics are alike, and the spacing
/// relative to the radius of a ball with the same ratio of volume and area.
struct EnergyScale
{
  double Energy = 0.0; ///< kT
  double RelativeSpacing = 0.0;
};

/// The energy of the charges' own field beyond the surface, eps_m / (8 pi C) times the integral of
/// |grad G|^2 there, which is that of -G d_n G over the surface. For an ion it is Born's energy in
/// a solvent of infinite permittivity.
EnergyScale MeasureEnergyScale(const GridPotential& solution)
{
  const PoissonBoltzmannParameters& p = solution.GetParameters();
  const Point3& h = solution.GetBox().Spacing;
  double area = 0.0, integral = 0.0;
  for (std::size_t i = 0; i < solution.GetCrossings().size(); ++i)
  {
    const InterfaceCrossing& crossing = solution.GetCrossings()[i];
    const SecondOrderTaylor& charges = solution.GetChargesAtCrossings()[i];
    const auto axis = static_cast<std::size_t>(crossing.Axis);
    const Point3& normal = crossing.Frame.Normal;
    const double part = std::abs(normal[axis]) * h[(axis + 1) % 3] * h[(axis + 2) % 3];
    area += part;
    integral -= part * charges.Value * Dot(charges.Gradient, normal);
  }
  const std::vector<unsigned char>& inside = solution.GetInside();
  const double volume = h[0] * h[1] * h[2] *
    static_cast<double>(
      std::count_if(inside.begin(), inside.end(), [](unsigned char in) { return in != 0; }));
  return { p.SoluteDielectric / (8.0 * Pi * units::CoulombLength(p.Temperature)) * integral,
    volume > 0.0 ? std::max({ h[0], h[1], h[2] }) * area / (3.0 * volume) : 1.0 };
}

}

double EstimateEnergyError(
  const LevelFunction& level, const GridPotential& solution, const ProgressCallback& progress)
{
  constexpr double tolerance = 1e-4;
  // The share of the root mean square of the differences.
  constexpr double share = 0.7;
  // Error of the border values and of the interpolation at the charges, which all grids share.
  constexpr double floor = 3e-4;
  // Error of the potential in the solvent, which is as large as that of the charges where the
  // dielectrics are alike, and whose sign changes with the spacing.
  constexpr double ofSolvent = 0.1;
  const bool given = solution.GetParameters().BoundaryCondition == BoundaryCondition::Given;
  const BoxNodes inside = LevelNodeRange(level);
  const double energy = solution.GetReport().SolvationEnergy;
  const EnergyScale scale = MeasureEnergyScale(solution);
  const PoissonBoltzmannParameters& p = solution.GetParameters();
  const double largest = std::max(std::abs(energy), std::abs(scale.Energy));
  const double shared = largest *
    std::hypot(floor,
      ofSolvent * std::min(1.0, p.SoluteDielectric / p.SolventDielectric) * scale.RelativeSpacing *
        scale.RelativeSpacing);
  double sum = 0.0;
  int count = 0;
  // Opposite corners of a cell first; others if none of these gives a node at the surface.
  const std::array<std::int64_t, 3> shifts[] = { { 0, 0, 0 }, { 1, 1, 1 }, { 1, 0, 0 }, { 0, 1, 1 },
    { 0, 1, 0 }, { 1, 0, 1 }, { 0, 0, 1 }, { 1, 1, 0 } };
  for (const auto& shift : shifts)
  {
    if (count == 2)
    {
      break;
    }
    Report(progress, 0.5 * count);
    try
    {
      GridPotential coarse(level, ShiftedCoarseBox(inside, solution.GetBox(), shift, !given),
        solution.GetAtoms(), solution.GetParameters(), solution.GetIons());
      coarse.SetBorder(solution.GetBorder(), !given);
      coarse.Solve(tolerance);
      coarse.Evaluate();
      const double difference = coarse.GetReport().SolvationEnergy - energy;
      sum += difference * difference;
      ++count;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception&)
    {
      // This grid is too coarse for the surface; the estimate then says so.
    }
  }
  const double border = solution.GetParameters().BoundaryCondition == BoundaryCondition::Zero
    ? EnergyOfZeroBorder(solution)
    : 0.0;
  return border + (count == 0 ? 0.1 * largest : std::hypot(share * std::sqrt(sum / count), shared));
}

double EstimateMaskError(const LevelFunction& level, const GridPotential& solution)
{
  const auto& n = level.Dimensions();
  double inside = 0.0;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        inside += level.Inside(i, j, k) ? 1.0 : 0.0;
      }
    }
  }
  // Area / volume = 2/3 crossings / (nodes inside x spacing), and 3 volume / area is the radius.
  const double crossings = static_cast<double>(solution.GetCrossings().size());
  return std::abs(solution.GetReport().SolvationEnergy) * crossings / (18.0 * inside);
}

std::unique_ptr<GridPotential> SolveAgain(
  const LevelFunction& level, const GridPotential& last, const ProgressCallback& progress)
{
  auto problem = std::make_unique<GridPotential>(level, last.GetBox(), last.GetAtoms(),
    last.GetParameters(), last.GetIons(), Between(progress, 0.0, 0.5), &last);
  problem->Solve(last.GetParameters().Tolerance, Between(progress, 0.5, 0.95));
  problem->Evaluate();
  return problem;
}

}
