#include "SolvationFlow.h"

#include "BallDistance.h"
#include "ElectrostaticUnits.h"
#include "FlowBand.h"
#include "FlowMemory.h"
#include "FlowResult.h"
#include "FlowStart.h"
#include "FlowSteps.h"
#include "LevelMeasure.h"
#include "NearestBall.h"
#include "NonpolarEnergy.h"
#include "SolventExcludedDistance.h"
#include "SurfacePull.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Lambda = 0.16;          // dt / spacing^2
constexpr float MostPull = 0.4F / 0.16F; // a step moves the surface by at most 0.4 spacings
constexpr int StepsToRedistance = 4;
constexpr int StepsToLook = 8;
constexpr double Rest = 1e-5; // relative change of the volume in StepsToLook

void Require(bool fine, const char* name, double value, const char* what)
{
  if (!fine)
  {
    throw std::invalid_argument(
      std::string(name) + " is " + std::to_string(value) + ", but " + what + ".");
  }
}

void CheckSolvation(const SolvationParameters& p)
{
  const auto part = [](double x) { return x > 0.0 && x <= 1.0; };
  Require(p.UpdatePeriod > 0, "UpdatePeriod", p.UpdatePeriod, "at least one step is needed");
  Require(p.MaximumUpdates > 0, "MaximumUpdates", p.MaximumUpdates, "at least one is needed");
  Require(part(p.SurfaceRelaxation), "SurfaceRelaxation", p.SurfaceRelaxation,
    "it is a part of each motion: above 0, at most 1");
  Require(part(p.FieldRelaxation), "FieldRelaxation", p.FieldRelaxation,
    "it is a part of each new force: above 0, at most 1");
  Require(p.Tolerance > 0.0 && p.Tolerance < 1.0, "Tolerance", p.Tolerance,
    "it is a part of the energy: above 0, below 1");
  Require(p.Solvent.SurfaceTension > 0.0 && std::isfinite(p.Solvent.SurfaceTension),
    "SurfaceTension", p.Solvent.SurfaceTension,
    "it is an energy for each square angstrom: give a positive number");
  Require(std::isfinite(p.Solvent.Pressure), "Pressure", p.Solvent.Pressure,
    "it is an energy for each cubic angstrom: give a finite number");
}

void CheckCharges(const SolvationAtoms& atoms)
{
  if (atoms.Dispersion.size() != atoms.Balls.size())
  {
    throw std::invalid_argument("There are not as many dispersion parameters as balls.");
  }
  const NearestBall nearest(atoms.Balls);
  for (std::size_t i = 0; i < atoms.Charges.size(); ++i)
  {
    const ChargedAtom& charge = atoms.Charges[i];
    const Ball& ball = atoms.Balls[nearest.At(charge.Position)];
    const double distance = std::hypot(charge.Position[0] - ball.Centre[0],
      charge.Position[1] - ball.Centre[1], charge.Position[2] - ball.Centre[2]);
    if (charge.Charge != 0.0 && !(distance < ball.Radius))
    {
      throw std::invalid_argument("The charge of atom " + std::to_string(i) +
        " lies outside of all atoms with a radius: give it one, or take its charge away.");
    }
  }
}

/// The value that `values` have at the node of `box` nearest to a place.
PotentialFunction OnBox(const SolverBox& box, const std::vector<double>& values)
{
  return [&box, &values](const Vector3& place)
  {
    const std::array<std::int64_t, 3> steps = box.Steps();
    std::int64_t node = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double at = std::round((place[a] - box.Corner[a]) / box.Spacing[a]);
      node += steps[a] *
        std::clamp<std::int64_t>(static_cast<std::int64_t>(at), 0, box.Dimensions[a] - 1);
    }
    return values[static_cast<std::size_t>(node)];
  };
}

/// Distances through the whole band, between the bounds.
void Settle(FlowField& field)
{
  constexpr int iterations = 10;
  Redistance(field, iterations, true);
  Advance(field, 0.0);
}

/// The part of the nodes next to the surface that its obstacle holds.
double PartOnObstacle(const FlowField& field)
{
  constexpr float near = 0.5F;
  constexpr float touching = 0.05F;
  double all = 0.0;
  double held = 0.0;
  for (std::size_t n = 0; n < field.Distance.size(); ++n)
  {
    if (std::abs(field.Distance[n]) < near)
    {
      all += 1.0;
      held += field.Distance[n] > field.Ceiling[n] - touching ? 1.0 : 0.0;
    }
  }
  return all > 0.0 ? held / all : 0.0;
}

}

SolvationFlow::SolvationFlow(SolvationAtoms atoms, const SolvationParameters& parameters)
  : Atoms(std::move(atoms))
  , Parameters(parameters)
  , Ions(parameters.Potential.Ions, parameters.Potential.Temperature)
  , Equation(parameters.Potential)
{
  CheckFlow(this->Atoms.Balls, parameters.Flow);
  CheckSolvation(parameters);
  CheckParameters(parameters.Potential);
  if (this->Atoms.Balls.empty())
  {
    throw std::invalid_argument("There are no atoms to make a surface around.");
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
  const double probe = std::exchange(flow.ProbeRadius, 0.0); // here it bounds from within
  const std::vector<Ball>& balls = this->Atoms.Balls;
  FlowField field = StartField(balls, flow, 1.0, flow.Enlargement,
    SolventPull(this->Atoms.Dispersion, this->Parameters.Solvent), Between(progress, 0.0, 0.6));
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
    Settle(field);
  }
  return field;
}

void SolvationFlow::Evolve(FlowField& field)
{
  const double h = field.Grid.Spacing();
  const double alpha = this->Parameters.SurfaceRelaxation;
  const std::vector<float> before = alpha < 1.0 ? field.Distance : std::vector<float>();
  double volume = MeasureLevel(field).Volume;
  for (int step = 1; step <= this->Parameters.UpdatePeriod; ++step)
  {
    Advance(field, Lambda);
    this->Time += Lambda * h * h;
    if (step % StepsToRedistance == 0)
    {
      Redistance(field, 2);
    }
    if (this->Parameters.AdaptiveUpdate && step % StepsToLook == 0)
    {
      const double last = std::exchange(volume, MeasureLevel(field).Volume);
      if (std::abs(volume - last) < Rest * volume)
      {
        break;
      }
    }
  }
  // Redistancing leaves the obstacle by a little: all policies end with the same steps after it.
  for (int step = 1; step < StepsToRedistance; ++step)
  {
    Advance(field, Lambda);
    this->Time += Lambda * h * h;
  }
  if (!before.empty())
  {
    const auto part = static_cast<float>(alpha);
    for (std::size_t n = 0; n < before.size(); ++n)
    {
      field.Distance[n] = part * field.Distance[n] + (1.0F - part) * before[n];
    }
    FindBand(field);
  }
  Settle(field);
}

void SolvationFlow::Solve(const FlowField& field, const ProgressCallback& progress)
{
  if (this->Solution)
  {
    this->Before = std::move(this->Solution->GetPotential());
    this->Equation.Condition = BoundaryCondition::Given;
    this->Equation.Boundary = OnBox(this->Box, this->Before);
    this->Equation.Start = this->Equation.Boundary;
    this->Solution.reset(); // it refers to the distances that are made anew
  }
  StoreDistances(field, this->Surface);
  const DensityGrid& grid = this->Surface.Grid;
  const double h = grid.Spacing;
  this->Level.Floats = { this->Surface.Distance.data(), grid.Dimensions, { h, h, h } };
  this->Level.Level = 0.0;
  this->Level.InsideIsHigher = false;
  if (this->Before.empty())
  {
    this->Box = BoxAround(this->Level, this->Parameters.Potential.Padding);
  }
  this->Solution = SolvePoissonBoltzmann(
    this->Level, this->Box, this->Placed, this->Equation, this->Ions, progress);
}

void SolvationFlow::Record(const FlowField& field)
{
  const NonpolarTerms nonpolar = NonpolarEnergy(this->Atoms.Balls, this->Atoms.Dispersion,
    this->Surface.Grid, this->Surface.Distance.data(), this->Parameters.Solvent)
                                   .Whole;
  SolvationUpdate update;
  update.Time = this->Time;
  update.Area = nonpolar.Area;
  update.Volume = nonpolar.Volume;
  update.SurfaceEnergy = nonpolar.SurfaceEnergy;
  update.VolumeEnergy = nonpolar.VolumeEnergy;
  update.DispersionEnergy = nonpolar.DispersionEnergy;
  update.PolarEnergy = this->Solution->GetReport().SolvationEnergy *
    units::ThermalKilocalorie(this->Equation.Temperature);
  update.OnObstacle = PartOnObstacle(field);
  this->Updates.push_back(update);
  this->Surface.History.push_back(
    { this->Time, field.Grid.Spacing(), nonpolar.Area, nonpolar.Volume });
}

void SolvationFlow::Pull(FlowField& field)
{
  const std::vector<float> electric = CarriedOff(*this->Solution,
    PullAtCrossings(*this->Solution, this->Level, this->Equation.Temperature), field.Grid);
  const auto scale =
    static_cast<float>(field.Grid.Spacing() / this->Parameters.Solvent.SurfaceTension);
  const auto part =
    static_cast<float>(this->Updates.size() > 1 ? this->Parameters.FieldRelaxation : 1.0);
  for (std::size_t n = 0; n < electric.size(); ++n)
  {
    const float wanted = std::clamp(this->Steady[n] + scale * electric[n], -MostPull, MostPull);
    field.Pull[n] = part * wanted + (1.0F - part) * field.Pull[n];
  }
}

bool SolvationFlow::Rests() const
{
  const std::size_t n = this->Updates.size();
  const auto still = [&](std::size_t i)
  {
    const double total = this->Updates[i].Total();
    return std::abs(total - this->Updates[i - 1].Total()) <=
      this->Parameters.Tolerance * std::abs(total);
  };
  return n > 2 && still(n - 1) && still(n - 2);
}

void SolvationFlow::Run(const ProgressCallback& progress)
{
  FlowField field = this->StartingField(Between(progress, 0.0, 0.1));
  for (float& pull : field.Pull)
  {
    pull = std::clamp(pull, -MostPull, MostPull);
  }
  this->Steady = field.Pull;
  for (int update = 0; update < this->Parameters.MaximumUpdates && !this->Rests(); ++update)
  {
    // How many it takes is not known, so progress slows down.
    const auto at = [](int done) { return 0.1 + 0.9 * done / (done + 4.0); };
    this->Evolve(field);
    this->Solve(field, Between(progress, at(update), at(update + 1)));
    this->Record(field);
    this->Pull(field);
  }
  Report(progress, 1.0);
}

}
