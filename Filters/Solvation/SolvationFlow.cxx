#include "Solvation/SolvationFlow.h"

#include "Atoms/NearestBall.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/Dispersion.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"
#include "MolecularSurfaces/SurfaceFlow.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "Solvation/CoupledFlow.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

void CheckCharges(const SolvationAtoms& atoms)
{
  if (atoms.Dispersion.size() != atoms.Balls.size())
  {
    throw std::invalid_argument(
      "The number of dispersion parameters differs from the number of balls.");
  }
  const NearestBall nearest(atoms.Balls);
  for (std::size_t i = 0; i < atoms.Charges.size(); ++i)
  {
    const ChargedAtom& charge = atoms.Charges[i];
    const Ball& ball = atoms.Balls[nearest.At(charge.Position)];
    const double distance = std::hypot(charge.Position[0] - ball.Center[0],
      charge.Position[1] - ball.Center[1], charge.Position[2] - ball.Center[2]);
    if (charge.Charge != 0.0 && !(distance < ball.Radius))
    {
      throw std::invalid_argument("The charge of atom " + std::to_string(i) +
        " lies outside of all atoms with a radius: assign a radius to it, or set its charge to 0.");
    }
  }
}

}

SolvationFlow::SolvationFlow(SolvationAtoms atoms, const SolvationParameters& parameters)
  : Atoms(std::move(atoms))
  , Parameters(parameters)
  , Ions(parameters.Potential.AllIons(), parameters.Potential.Temperature)
  , Equation(parameters.Potential)
{
  CheckFlow(this->Atoms.Balls, parameters.Flow);
  Check(parameters);
  if (this->Atoms.Balls.empty())
  {
    throw std::invalid_argument("There are no atoms for which a surface could be computed.");
  }
  CheckCharges(this->Atoms);
  this->Surface.Grid = FlowGridAround(this->Atoms.Balls, parameters.Flow);
  CheckFlowMemory(this->Atoms.Balls, this->Surface.Grid);
  this->Placed = this->Atoms.Charges;
  for (ChargedAtom& charge : this->Placed)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      charge.Position[a] -= this->Surface.Grid.Origin[a];
    }
  }
}

SolvationFlow::~SolvationFlow() = default;

FlowField SolvationFlow::StartingField(const ProgressCallback& progress) const
{
  SurfaceFlowParameters flow = this->Parameters.Flow;
  const double probe = std::exchange(flow.ProbeRadius, 0.0); // here it is an inner bound
  const std::vector<Ball>& balls = this->Atoms.Balls;
  FlowField field = StartField(balls, flow, 1.0, flow.Enlargement,
    SolventPull(this->Atoms.Dispersion, this->Parameters.Solvent), Between(progress, 0.0, 0.6));
  // The field pulls harder than the tension resists: only an obstacle keeps the surface from
  // collapsing into the creases between atoms, so regions without room for the probe are solid.
  if (probe > 0.0)
  {
    std::vector<float> excluded(field.Distance.size());
    SolventExcludedDistance(field.Grid, balls, probe, excluded, Between(progress, 0.6, 0.9));
    for (std::size_t n = 0; n < excluded.size(); ++n)
    {
      field.Ceiling[n] = std::min(field.Ceiling[n], excluded[n]);
      field.Distance[n] = std::min(field.Distance[n], field.Ceiling[n]);
    }
    FindBand(field);
    RestoreDistances(field);
  }
  return field;
}

void SolvationFlow::Solve(const FlowField& field, const ProgressCallback& progress)
{
  this->LastDistance = std::move(this->Surface.Distance);
  StoreDistances(field, this->Surface);
  const DensityGrid& grid = this->Surface.Grid;
  const double h = grid.Spacing;
  this->Level.Floats = { this->Surface.Distance.data(), grid.Dimensions, { h, h, h } };
  this->Level.Level = 0.0;
  this->Level.InsideIsHigher = false;
  if (this->Solution)
  {
    // The border's values stay those of the first surface, and the iteration starts from the last.
    this->Solution->Release();
    this->Solution = SolveAgain(this->Level, *this->Solution, progress);
    return;
  }
  const SolverBox box = BoxAround(this->Level, this->Parameters.Potential.Padding);
  this->Solution =
    SolvePoissonBoltzmann(this->Level, box, this->Placed, this->Equation, this->Ions, progress);
}

/// After the first surface, from the change since the last one.
double SolvationFlow::Dispersion(const SolventParameters& solvent) const
{
  const std::vector<DispersionAtom>& atoms = this->Atoms.Dispersion;
  const DensityGrid& grid = this->Surface.Grid;
  const float* const now = this->Surface.Distance.data();
  if (!this->Updates.empty())
  {
    return this->Updates.back().DispersionEnergy +
      DispersionChange(atoms, grid, this->LastDistance.data(), now, solvent);
  }
  const std::vector<double> all = DispersionEnergies(atoms, grid, now, solvent);
  return std::accumulate(all.begin(), all.end(), 0.0);
}

void SolvationFlow::Record(const FlowField& field)
{
  const SolventParameters& solvent = this->Parameters.Solvent;
  const LevelMeasure measure = MeasureLevel(field);
  SolvationUpdate update;
  update.Time = this->Time;
  update.Area = measure.Area;
  update.Volume = measure.Volume;
  update.SurfaceEnergy = solvent.SurfaceTension * measure.Area;
  update.VolumeEnergy = solvent.Pressure * measure.Volume;
  update.DispersionEnergy = this->Dispersion(solvent);
  update.PolarEnergy = this->Solution->GetReport().SolvationEnergy *
    units::ThermalKilocalorie(this->Equation.Temperature);
  update.OnObstacle = FractionOnObstacle(field);
  this->Updates.push_back(update);
  this->Surface.History.push_back(
    { this->Time, field.Grid.Spacing(), measure.Area, measure.Volume });
}

void SolvationFlow::Pull(FlowField& field)
{
  const std::vector<float> electric =
    ExtendOffSurface(this->Solution->GetBox(), this->Solution->GetCrossings(),
      PullAtCrossings(*this->Solution, this->Equation.Temperature), field.Grid);
  const double part = this->Updates.size() > 1 ? this->Parameters.Policy.FieldRelaxation : 1.0;
  UpdatePull(field, this->Steady, electric,
    field.Grid.Spacing() / this->Parameters.Solvent.SurfaceTension, part);
}

bool SolvationFlow::IsStill() const
{
  const std::size_t n = this->Updates.size();
  const auto still = [&](std::size_t i)
  {
    const double total = this->Updates[i].Total();
    return std::abs(total - this->Updates[i - 1].Total()) <=
      this->Parameters.EnergyTolerance * std::abs(total);
  };
  // Twice in a row, since a single small change may be a turning point.
  return n > 2 && still(n - 1) && still(n - 2);
}

void SolvationFlow::Run(const ProgressCallback& progress)
{
  FlowField field = this->StartingField(Between(progress, 0.0, 0.1));
  LimitPull(field.Pull);
  this->Steady = field.Pull;
  for (int update = 0; update < this->Parameters.Policy.MaximumUpdates; ++update)
  {
    // The number of updates is unknown, so progress slows down.
    const auto at = [](int done) { return 0.1 + 0.9 * done / (done + 4.0); };
    this->Time += EvolveForPeriod(field, this->Parameters.Policy);
    this->Solve(field, Between(progress, at(update), at(update + 1)));
    this->Record(field);
    this->Converged = this->IsStill();
    if (this->Converged)
    {
      break;
    }
    this->Pull(field);
  }
  if (this->Equation.DielectricModel == DielectricModel::SmoothDielectric)
  {
    this->Equation.DielectricModel = DielectricModel::SharpInterface;
    this->Solve(field, {});
    this->Record(field);
  }
  Report(progress, 1.0);
}

SolvationErrors SolvationFlow::EstimateErrors(const ProgressCallback& progress) const
{
  constexpr double coarser = 1.5;
  SolvationErrors errors;
  errors.Polar = EstimateEnergyError(this->Level, *this->Solution, Between(progress, 0.0, 0.3)) *
    units::ThermalKilocalorie(this->Equation.Temperature);
  const double total = this->Updates.back().Total();
  SolvationParameters parameters = this->Parameters;
  parameters.Flow.Spacing *= coarser;
  double change = 0.1 * total;
  try
  {
    SolvationFlow flow(this->Atoms, parameters);
    flow.Run(Between(progress, 0.3, 1.0));
    change = flow.GetUpdates().back().Total() - total;
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&)
  {
  }
  errors.Total = std::hypot(errors.Polar, change);
  return errors;
}

}
