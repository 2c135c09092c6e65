#include "Electrostatics/GridPotential.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Electrostatics/ChargesOnGrid.h"
#include "Electrostatics/ClosedCavities.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/HarmonicFit.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Calls `each(i)` for all nodes i below n, in parallel.
template <typename Each>
void ForEachNode(std::size_t n, Each&& each)
{
  ParallelFor(0, static_cast<std::int64_t>(n), 1 << 15,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        each(i);
      }
    });
}

bool OnBorder(const SolverBox& box, std::int64_t node)
{
  const auto& n = box.Dimensions;
  const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (at[a] == 0 || at[a] == n[a] - 1)
    {
      return true;
    }
  }
  return false;
}

constexpr std::int64_t Block = 1 << 15;
constexpr unsigned char InSolvent = 0;
constexpr unsigned char InSolute = 255;

}

GridPotential::GridPotential(const LevelFunction& level, const SolverBox& box,
  const std::vector<ChargedAtom>& atoms, const PoissonBoltzmannParameters& parameters,
  const IonAtmosphere& ions, const ProgressCallback& progress, const GridPotential* last)
  : Box(box)
  , Atoms(atoms)
  , Parameters(parameters)
  , Ions(ions)
  , Spacing(*std::min_element(box.Spacing.begin(), box.Spacing.end()))
{
  this->Inside = ClassifyNodes(level, this->Box);
  this->Crossings = FindCrossings(level, this->Box, this->Inside, Between(progress, 0.0, 0.2));
  this->EvaluateCharges(last, Between(progress, 0.2, 0.6));
  // Equations inside have a truncation error that is larger by eps_s / eps_m: their weight in the
  // fits is a power of its inverse.
  this->Medium = { parameters.SoluteDielectric, parameters.SolventDielectric,
    std::pow(parameters.SoluteDielectric / parameters.SolventDielectric, parameters.FitExponent),
    0.0, std::cbrt(box.Spacing[0] * box.Spacing[1] * box.Spacing[2]) };
  for (std::size_t layer = 0; layer < ions.NumberOfLayers(); ++layer)
  {
    this->Access.push_back(
      IonAccess(this->Box, this->Inside, this->Crossings, this->LayerRadius(layer)));
  }
  // Only ions without a layer reach the surface itself and enter the jump conditions.
  this->Medium.KappaSquared = this->DerivativeAtSurface(0.0) / parameters.SolventDielectric;
  this->Matrix = std::make_unique<InterfaceOperator>(
    this->Box, this->Inside, parameters.SoluteDielectric, parameters.SolventDielectric);
  this->Assemble({}, Between(progress, 0.6, 1.0));
  // The preconditioner uses permittivities in series, not the fitted rows, so it stays symmetric.
  this->Multigrid = std::make_unique<MultigridPoisson>(
    this->Box.Dimensions, AxisWeights(this->Box), this->Permittivities());
  if (last)
  {
    this->U = last->U;
    this->Border = last->Border;
    this->Report.Reference = last->Report.Reference;
  }
  this->U.resize(this->Inside.size(), 0.0);
  this->Report.Crossings = static_cast<std::int64_t>(this->Crossings.size());
}

double GridPotential::Kappa() const
{
  return std::sqrt(this->Ions.Linear() / this->Parameters.SolventDielectric);
}

double GridPotential::LayerRadius(std::size_t layer) const
{
  const double radius = this->Ions.LayerRadius(layer);
  return radius < 0.0 ? this->Parameters.IonRadius : radius;
}

double GridPotential::ChargeAtSurface(double phi) const
{
  double sum = 0.0;
  for (std::size_t layer = 0; layer < this->Ions.NumberOfLayers(); ++layer)
  {
    sum += this->LayerRadius(layer) <= 0.0 ? this->Ions.Charge(layer, phi) : 0.0;
  }
  return sum;
}

double GridPotential::DerivativeAtSurface(double phi) const
{
  double sum = 0.0;
  for (std::size_t layer = 0; layer < this->Ions.NumberOfLayers(); ++layer)
  {
    sum += this->LayerRadius(layer) <= 0.0 ? this->Ions.Derivative(layer, phi) : 0.0;
  }
  return sum;
}

bool GridPotential::IonsReach(std::size_t node) const
{
  return std::any_of(this->Access.begin(), this->Access.end(),
    [&](const std::vector<float>& access) { return access[node] > 0.0F; });
}

double GridPotential::ScaledDerivative(std::size_t node, bool nonlinear) const
{
  double sum = 0.0;
  for (std::size_t layer = 0; layer < this->Access.size(); ++layer)
  {
    const auto access = static_cast<double>(this->Access[layer][node]);
    sum +=
      access == 0.0 ? 0.0 : access * this->Ions.Derivative(layer, nonlinear ? this->U[node] : 0.0);
  }
  return this->Spacing * this->Spacing * sum;
}

void GridPotential::EvaluateCharges(const GridPotential* last, const ProgressCallback& progress)
{
  const double factor =
    units::CoulombLength(this->Parameters.Temperature) / this->Parameters.SoluteDielectric;
  for (const ChargedAtom& atom : this->Atoms)
  {
    if (atom.Charge != 0.0)
    {
      this->Charges.Add(atom.Position, factor * atom.Charge);
    }
  }
  // Sums at crossings that the last surface had as well are not computed again.
  const KnownCharges known =
    last ? KnownCharges{ &last->Crossings, &last->AtCrossing } : KnownCharges();
  this->AtCrossing = ChargesAtCrossings(this->Charges, this->Box, this->Crossings, known, progress);
}

void GridPotential::Assemble(std::vector<SurfaceIons> ions, const ProgressCallback& progress)
{
  const InterfaceProblem problem{ &this->Box, &this->Inside, &this->Crossings, &this->AtCrossing,
    this->Medium, std::move(ions), this->Parameters.DielectricModel,
    FindCavityWalls(this->Box, this->Inside, this->Crossings) };
  InterfaceMatrixRows rows = AssembleIrregularRows(problem, progress);
  this->Report.LinearFits = rows.LinearFits;
  this->Report.GhostFits = rows.GhostFits;
  this->Matrix->SetRows(std::move(rows));
}

/// One byte per edge, the part of it in the solute, looked up in a table of permittivities.
EdgePermittivity GridPotential::Permittivities() const
{
  EdgePermittivity edges;
  for (std::size_t c = 0; c < edges.Table.size(); ++c)
  {
    edges.Table[c] = static_cast<float>(SeriesPermittivity(this->Parameters.SoluteDielectric,
      this->Parameters.SolventDielectric, static_cast<double>(c) / InSolute));
  }
  for (auto& code : edges.Code)
  {
    code.resize(this->Inside.size());
    std::transform(this->Inside.begin(), this->Inside.end(), code.begin(),
      [](unsigned char in) { return in ? InSolute : InSolvent; });
  }
  for (const InterfaceCrossing& c : this->Crossings)
  {
    const bool in = this->Inside[static_cast<std::size_t>(c.Node)] != 0;
    const double part = in ? c.Fraction : 1.0 - c.Fraction;
    edges.Code[static_cast<std::size_t>(c.Axis)][static_cast<std::size_t>(c.Node)] =
      static_cast<unsigned char>(std::lround(part * InSolute));
  }
  return edges;
}

void GridPotential::SetBorder(const PotentialFunction& border, bool sampled)
{
  this->Border = border;
  // The field of charges and surface is smooth on the border if they are far from it.
  const double length = 0.3 * GapAround(this->RangeInside(), this->Box);
  FillBorder(this->Box, border, sampled ? length : 0.0, this->U);
}

void GridPotential::SetStart(const PotentialFunction& start)
{
  ParallelFor(0, static_cast<std::int64_t>(this->U.size()), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        if (!OnBorder(this->Box, node))
        {
          this->U[static_cast<std::size_t>(node)] = start(this->Box.Position(node));
        }
      }
    });
}

void GridPotential::FillDiagonal(bool nonlinear)
{
  if (this->Access.empty())
  {
    return;
  }
  if (!this->IonDiagonal)
  {
    this->IonDiagonal = std::make_shared<std::vector<float>>(this->U.size());
  }
  ForEachNode(this->U.size(),
    [&](std::size_t i)
    { (*this->IonDiagonal)[i] = static_cast<float>(this->ScaledDerivative(i, nonlinear)); });
  this->Matrix->SetDiagonal(this->IonDiagonal);
  this->Multigrid->SetDiagonal(this->IonDiagonal);
}

void GridPotential::Solve(double tolerance, const ProgressCallback& progress)
{
  this->Report.NewtonSteps = 0;
  this->Report.Residuals.clear();
  if (!this->Parameters.Nonlinear || this->Access.empty())
  {
    this->SolveLinear(tolerance, progress);
    return;
  }
  this->SolveLinear(tolerance, Between(progress, 0.0, 0.3));
  this->SolveNonlinear(tolerance, Between(progress, 0.3, 1.0));
}

void GridPotential::SolveLinear(double tolerance, const ProgressCallback& progress)
{
  this->FillDiagonal(false);
  this->Work.Residual.resize(this->U.size());
  this->Matrix->Residual(this->U, this->Work.Residual);
  // Later solutions are measured against the first residual, not their own smaller ones.
  if (!(this->Report.Reference > 0.0))
  {
    this->Report.Reference = ComputeNorm(this->Work.Residual);
  }
  SolverControl control;
  control.Tolerance = tolerance;
  control.Reference = this->Report.Reference;
  control.MaximumIterations = this->Parameters.MaximumIterations;
  const SolverReport report =
    SolveInterface(*this->Matrix, *this->Multigrid, control, this->Work, this->U, progress);
  this->Report.Iterations += report.Iterations;
  this->Report.Residuals.insert(
    this->Report.Residuals.end(), report.Residuals.begin(), report.Residuals.end());
  RequireConvergence(report, control);
}

void GridPotential::Evaluate()
{
  auto& report = this->Report;
  report.AtomPotentials.assign(this->Atoms.size(), 0.0);
  report.AtomForces.assign(this->Atoms.size(), { 0.0, 0.0, 0.0 });
  ParallelFor(0, static_cast<std::int64_t>(this->Atoms.size()), 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        if (this->Atoms[i].Charge != 0.0)
        {
          // u is harmonic inside, where it is the reaction potential: no self-energy is subtracted.
          const std::optional<ValueAndGradient> u =
            HarmonicAt(this->Box, this->Inside, this->U, this->Atoms[i].Position);
          if (!u)
          {
            throw std::invalid_argument("No node of the grid inside the surface is near the charge "
                                        "of atom " +
              std::to_string(i) + ": choose a smaller Spacing, or a finer volume on input 1.");
          }
          report.AtomPotentials[i] = u->Value;
          for (std::size_t a = 0; a < 3; ++a)
          {
            report.AtomForces[i][a] = -this->Atoms[i].Charge * u->Gradient[a];
          }
        }
      }
    });
  report.AtomEnergies.resize(this->Atoms.size());
  report.SolvationEnergy = 0.0;
  for (std::size_t i = 0; i < this->Atoms.size(); ++i)
  {
    report.AtomEnergies[i] = 0.5 * this->Atoms[i].Charge * report.AtomPotentials[i];
    report.SolvationEnergy += report.AtomEnergies[i];
  }
  report.IonEnergy = 0.0;
  for (std::size_t l = 0; this->Parameters.Nonlinear && l < this->Access.size(); ++l)
  {
    report.IonEnergy += this->Box.Spacing[0] * this->Box.Spacing[1] * this->Box.Spacing[2] *
      ParallelReduce<double>(static_cast<std::int64_t>(this->U.size()), Block, 0.0,
        [&](double& partial, std::int64_t first, std::int64_t last)
        {
          for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
          {
            partial += static_cast<double>(this->Access[l][i]) * this->Ions.Energy(l, this->U[i]);
          }
        });
  }
  // The sum above counts whole cells: those that the surface cuts are corrected by their fractions.
  report.IonEnergy += this->Parameters.Nonlinear ? this->IonEnergyOfCutCells() : 0.0;
  report.SolvationEnergy += report.IonEnergy;
}

void GridPotential::Release()
{
  this->Matrix.reset();
  this->Multigrid.reset();
  this->Work = {};
  this->IonDiagonal.reset();
  this->Access = {};
}

BoxNodes GridPotential::RangeInside() const
{
  const auto& n = this->Box.Dimensions;
  BoxNodes range{ { n[0], n[1], n[2] }, { -1, -1, -1 } };
  for (std::size_t node = 0; node < this->Inside.size(); ++node)
  {
    if (this->Inside[node])
    {
      const auto p = static_cast<std::int64_t>(node);
      const std::int64_t at[3] = { p % n[0], p / n[0] % n[1], p / (n[0] * n[1]) };
      for (std::size_t a = 0; a < 3; ++a)
      {
        range.First[a] = std::min(range.First[a], at[a]);
        range.Last[a] = std::max(range.Last[a], at[a]);
      }
    }
  }
  return range;
}

double GridPotential::SurfaceValue(
  std::size_t crossing, const FitNodes& nodes, const FitFunctional& functional) const
{
  double phi = 0.0;
  for (std::size_t i = 0; i < nodes.Count; ++i)
  {
    const double g =
      nodes.Node[i].Inside ? this->AtCrossing[crossing].At(nodes.Node[i].Offset) : 0.0;
    phi += functional[i] * (this->U[static_cast<std::size_t>(nodes.Id[i])] + g);
  }
  return phi;
}

SurfaceIons GridPotential::IonsAt(double phi) const
{
  const double solvent = this->Parameters.SolventDielectric;
  const double length = this->Medium.Length;
  // A quadratic cannot represent a layer of ions that is thinner than the spacing.
  const double most = std::max(1.0 / (length * length), this->Medium.KappaSquared) * solvent;
  // The tangent at phi, or the nearest one that the slope allows.
  double part = 1.0;
  for (double step = 0.5; step > 1e-9 && this->DerivativeAtSurface(phi) > most; step *= 0.5)
  {
    part += this->DerivativeAtSurface(part * phi) > most ? -step : step;
  }
  const double v = part * phi;
  const double slope = std::min(this->DerivativeAtSurface(v), most);
  return { slope / solvent, (this->ChargeAtSurface(v) - slope * v) / solvent };
}

std::vector<SurfaceIons> GridPotential::IonsAtCrossings() const
{
  std::vector<SurfaceIons> ions(this->Crossings.size(), { this->Medium.KappaSquared, 0.0 });
  ParallelFor(0, static_cast<std::int64_t>(ions.size()), 256,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<FitFunctional> functionals;
      for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c)
      {
        const FitNodes nodes =
          NodesAroundCrossing(this->Box, this->Inside, this->Crossings[c], this->Medium.Length);
        if (FitInterface(this->Medium, this->Crossings[c].Frame, nodes,
              { { FitTarget::SurfaceValue, {} } }, functionals) != FitQuality::None)
        {
          ions[c] = this->IonsAt(this->SurfaceValue(c, nodes, functionals[0]));
        }
      }
    });
  return ions;
}

double GridPotential::IonEnergyOfCutCells() const
{
  if (!(this->Medium.KappaSquared > 0.0))
  {
    return 0.0; // no ions reach the surface
  }
  double sum = 0.0;
  std::vector<FitFunctional> functionals;
  for (const CutCell& cell : CutCells(this->Box, this->Inside, this->Crossings))
  {
    double phi = this->U[static_cast<std::size_t>(cell.Node)];
    if (this->Inside[static_cast<std::size_t>(cell.Node)])
    {
      const InterfaceCrossing& crossing = this->Crossings[cell.Crossing];
      const FitNodes nodes =
        NodesAroundCrossing(this->Box, this->Inside, crossing, this->Medium.Length);
      if (FitInterface(this->Medium, crossing.Frame, nodes, { { FitTarget::SurfaceValue, {} } },
            functionals) == FitQuality::None)
      {
        continue;
      }
      phi = this->SurfaceValue(cell.Crossing, nodes, functionals[0]);
    }
    for (std::size_t layer = 0; layer < this->Ions.NumberOfLayers(); ++layer)
    {
      sum += this->LayerRadius(layer) <= 0.0 ? cell.Excess * this->Ions.Energy(layer, phi) : 0.0;
    }
  }
  return this->Box.Spacing[0] * this->Box.Spacing[1] * this->Box.Spacing[2] * sum;
}

double GridPotential::NonlinearResidual(
  const std::vector<double>& u, std::vector<double>& out) const
{
  // The ions' term is nonlinear here, so the linearised one in the diagonal is omitted here.
  this->Matrix->SetDiagonal(nullptr);
  this->Matrix->Residual(u, out);
  const double h2 = this->Spacing * this->Spacing;
  // Fitted rows are scaled, and with them the ions' term.
  const InterfaceMatrixRows& rows = this->Matrix->GetRows();
  ForEachNode(u.size(),
    [&](std::size_t i)
    {
      if (this->IonsReach(i) && !OnBorder(this->Box, static_cast<std::int64_t>(i)))
      {
        const auto row =
          std::lower_bound(rows.Node.begin(), rows.Node.end(), static_cast<std::int64_t>(i));
        const bool fitted = row != rows.Node.end() && *row == static_cast<std::int64_t>(i);
        const double scale =
          fitted ? rows.Scale[static_cast<std::size_t>(row - rows.Node.begin())] : 1.0;
        double charge = 0.0;
        for (std::size_t l = 0; l < this->Access.size(); ++l)
        {
          charge += static_cast<double>(this->Access[l][i]) * this->Ions.Charge(l, u[i]);
        }
        out[i] -= scale * h2 * charge;
      }
    });
  this->Matrix->SetDiagonal(this->IonDiagonal);
  return ComputeNorm(out);
}

double GridPotential::TakeStep(const std::vector<double>& step, double before)
{
  double factor = 1.0;
  for (int halving = 0; halving < 8; ++halving)
  {
    // The first trial takes the full step; each further one halves it.
    const double change = halving == 0 ? factor : -factor;
    ForEachNode(this->U.size(), [&](std::size_t i) { this->U[i] += change * step[i]; });
    const double after = this->NonlinearResidual(this->U, this->Work.Residual);
    if (after < before)
    {
      return after;
    }
    factor *= 0.5;
  }
  throw std::runtime_error(
    "Newton's method for the nonlinear Poisson-Boltzmann equation found no step that reduces the "
    "residual: solve the linear equation, provide an initial potential, or choose a finer grid.");
}

void GridPotential::ClipStart()
{
  // Where potentials are high, the linear solution exceeds the nonlinear one, and so does exp(u).
  constexpr double clip = 3.0;
  ForEachNode(this->U.size(),
    [&](std::size_t i)
    {
      if (this->IonsReach(i) && !OnBorder(this->Box, static_cast<std::int64_t>(i)))
      {
        this->U[i] = std::clamp(this->U[i], -clip, clip);
      }
    });
}

double GridPotential::NewtonStep(double tolerance, double norm)
{
  this->FillDiagonal(true);
  SolverControl control;
  control.Tolerance = tolerance;
  control.MaximumIterations = this->Parameters.MaximumIterations;
  std::vector<double> step(this->U.size(), 0.0);
  const SolverReport report =
    SolveInterface(*this->Matrix, *this->Multigrid, control, this->Work, step);
  RequireConvergence(report, control);
  this->Report.Iterations += report.Iterations;
  ++this->Report.NewtonSteps;
  return this->TakeStep(step, norm);
}

void GridPotential::SolveNonlinear(double tolerance, const ProgressCallback& progress)
{
  this->ClipStart();
  const bool lagged = this->Medium.KappaSquared > 0.0 &&
    this->Parameters.DielectricModel == DielectricModel::SharpInterface;
  std::vector<double> zero(this->U.size(), 0.0);
  const double reference = this->NonlinearResidual(zero, this->Work.Residual);
  zero = {};
  double norm = this->NonlinearResidual(this->U, this->Work.Residual);
  // Where ions reach the surface, the fits depend on the potential there, and are linearised again
  // for each step.
  const double goal = tolerance * std::max(reference, 1e-300);
  for (int newton = 0;; ++newton)
  {
    if (lagged && newton > 0)
    {
      this->Assemble(this->IonsAtCrossings(), {});
      norm = this->NonlinearResidual(this->U, this->Work.Residual);
    }
    if (norm <= goal)
    {
      return;
    }
    if (newton >= this->Parameters.MaximumNewtonSteps)
    {
      throw std::runtime_error("Newton's method did not converge in " + std::to_string(newton) +
        " steps: the residual is " + FormatNumber(norm / reference) +
        " of that of a zero potential.");
    }
    // Linear systems far from the solution need not be solved accurately.
    norm = this->NewtonStep(newton == 0 ? 1e-2 : 1e-3, norm);
    this->Report.Residuals.push_back(norm / reference);
    isthmus::Report(progress, std::min(0.9, 0.1 * newton));
  }
}

}
