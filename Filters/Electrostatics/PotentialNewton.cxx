// Newton's method for the full Poisson-Boltzmann equation.

#include "Electrostatics/NodeLoops.h"
#include "Electrostatics/PotentialOnBox.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{

double PotentialOnBox::SurfaceValue(
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

SurfaceIons PotentialOnBox::IonsAt(double phi) const
{
  const double solvent = this->Parameters.SolventDielectric;
  const double length = this->Medium.Length;
  const double most = std::max(1.0 / (length * length), this->Medium.KappaSquared) * solvent;
  // The tangent at phi, or as near to it as the slope allows.
  double part = 1.0;
  for (double step = 0.5; step > 1e-9 && this->DerivativeAtSurface(phi) > most; step *= 0.5)
  {
    part += this->DerivativeAtSurface(part * phi) > most ? -step : step;
  }
  const double v = part * phi;
  const double slope = std::min(this->DerivativeAtSurface(v), most);
  return { slope / solvent, (this->ChargeAtSurface(v) - slope * v) / solvent };
}

std::vector<SurfaceIons> PotentialOnBox::IonsAtCrossings() const
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

double PotentialOnBox::IonEnergyOfCutCells() const
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

double PotentialOnBox::NonlinearResidual(
  const std::vector<double>& u, std::vector<double>& out) const
{
  this->Matrix->SetDiagonal(nullptr);
  this->Matrix->Residual(u, out);
  const double h2 = this->Spacing * this->Spacing;
  // Fitted rows are scaled, and with them the ions' term.
  const IrregularRows& rows = this->Matrix->GetRows();
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
  return NormOf(out);
}

double PotentialOnBox::TakeStep(const std::vector<double>& step, double before)
{
  double factor = 1.0;
  for (int halving = 0; halving < 8; ++halving)
  {
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
    "Newton's method for the nonlinear Poisson-Boltzmann equation found no "
    "step that makes the residual smaller: solve the linear equation, give a "
    "potential to start from, or choose a finer grid.");
}

void PotentialOnBox::ClipStart()
{
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

double PotentialOnBox::NewtonStep(double tolerance, double norm)
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

void PotentialOnBox::SolveNonlinear(double tolerance, const ProgressCallback& progress)
{
  this->ClipStart();
  const bool lagged = this->Medium.KappaSquared > 0.0 &&
    this->Parameters.Dielectric == DielectricModel::SharpInterface;
  std::vector<double> zero(this->U.size(), 0.0);
  const double reference = this->NonlinearResidual(zero, this->Work.Residual);
  zero = {};
  double norm = this->NonlinearResidual(this->U, this->Work.Residual);
  // Where ions reach the surface, the fits depend on the potential there, and are linearised anew
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
        " steps: the residual is " + std::to_string(norm / reference) +
        " of that of no potential.");
    }
    norm = this->NewtonStep(newton == 0 ? 1e-2 : 1e-3, norm);
    this->Report.Residuals.push_back(norm / reference);
    isthmus::Report(progress, std::min(0.9, 0.1 * newton));
  }
}

}
