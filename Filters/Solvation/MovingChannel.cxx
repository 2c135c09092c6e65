#include "Solvation/MovingChannel.h"

#include "Core/RangeChecks.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "Solvation/CoupledFlow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::int64_t Margin = 6; // nodes, of the flow's grid around the domain's
constexpr double Rim = 2.0;        // of the membrane beyond the domain's side, spacings

/// Distance to the membrane as a disk that reaches a little beyond the domain.
double ToMembrane(
  const TransportDomain& d, const MembraneSlab& membrane, const std::array<double, 2>& alongAndOff)
{
  const auto [along, off] = alongAndOff;
  const double across = std::abs(along) - 0.5 * membrane.MembraneThickness;
  const double within = std::max(membrane.LumenRadius - off, off - (d.Radius + Rim * d.Spacing));
  return std::hypot(std::max(across, 0.0), std::max(within, 0.0)) +
    std::min(std::max(across, within), 0.0) - MembraneExcess * d.Spacing;
}

/// In the frame of the box, from its first node.
DensityGrid FlowNodes(const TransportDomain& room)
{
  return { {}, room.Dimensions, room.Spacing };
}

SolverBox FlowBox(const TransportDomain& room)
{
  SolverBox box;
  box.Dimensions = room.Dimensions;
  box.Spacing = { room.Spacing, room.Spacing, room.Spacing };
  return box;
}

std::vector<DispersionAtom> InAxes(const TransportDomain& room, std::vector<DispersionAtom> atoms)
{
  for (DispersionAtom& atom : atoms)
  {
    atom.Center = room.InAxes(atom.Center);
  }
  return atoms;
}

/// value(i, j, k) at the domain's own nodes, given by their indices in the padded domain.
template <typename Value>
std::vector<float> AtNodesOf(const TransportDomain& domain, Value&& value)
{
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(domain.Size()));
  for (std::int64_t node = 0; node < domain.Size(); ++node)
  {
    const std::array<std::int64_t, 3> at = domain.Indices(node);
    values.push_back(value(at[0] + Margin, at[1] + Margin, at[2] + Margin));
  }
  return values;
}

/// Distances of the flow on the domain's own nodes, angstrom.
std::vector<float> OnDomain(const FlowField& field, const TransportDomain& domain)
{
  const auto h = static_cast<float>(domain.Spacing);
  return AtNodesOf(domain,
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    { return h * field.Distance[static_cast<std::size_t>(field.Grid.Index(i, j, k))]; });
}

double Size(const ChannelUpdate& update)
{
  double size = 0.0;
  for (const double current : update.Currents)
  {
    size += std::abs(current);
  }
  return size;
}

}

double ChannelUpdate::Current() const
{
  double all = 0.0;
  for (const double current : this->Currents)
  {
    all += current;
  }
  return all;
}

TransportDomain MovingChannel::Padded(const TransportDomain& domain)
{
  TransportDomain room = domain;
  const double wide = static_cast<double>(Margin) * domain.Spacing;
  const Point3 before = domain.Turned({ wide, wide, wide });
  for (std::size_t a = 0; a < 3; ++a)
  {
    room.Dimensions[a] += 2 * Margin;
    room.Origin[a] -= before[a];
  }
  return room;
}

std::vector<float> MovingChannel::Unpadded(
  const std::vector<float>& values, const TransportDomain& domain)
{
  const auto steps = Padded(domain).Steps();
  return AtNodesOf(domain,
    [&](std::int64_t i, std::int64_t j, std::int64_t k)
    { return values[static_cast<std::size_t>(i + j * steps[1] + k * steps[2])]; });
}

MovingChannel::MovingChannel(const TransportDomain& domain, const std::vector<float>& obstacle,
  std::vector<ChargedAtom> charges, const std::vector<DispersionAtom>& atoms,
  const IonTransportParameters& transport, const MovingChannelParameters& parameters)
  : Domain(domain)
  , Room(Padded(domain))
  , Charges(std::move(charges))
  , Transport(transport)
  , Parameters(parameters)
  , Field(FlowGrid(FlowNodes(this->Room)))
  , ForceFraction(parameters.Policy.FieldRelaxation)
{
  Check(transport);
  Check(parameters);
  this->Start(obstacle);
  this->Steady.assign(this->Field.Distance.size(), 0.0F);
  SolventPull(InAxes(this->Room, atoms), parameters.Solvent)(this->Field.Grid, this->Steady);
  for (float& value : this->Steady)
  {
    value *= static_cast<float>(domain.Spacing);
  }
  this->Field.Pull = this->Steady;
  LimitPull(this->Field.Pull);
}

MovingChannel::~MovingChannel() = default;

void MovingChannel::Start(const std::vector<float>& obstacle)
{
  const double h = this->Domain.Spacing;
  for (std::int64_t node = 0; node < this->Room.Size(); ++node)
  {
    const std::array<std::int64_t, 3> at = this->Room.Indices(node);
    const double membrane =
      ToMembrane(this->Domain, this->Transport, this->Room.AxialAndRadial(this->Room.Place(node)));
    const double solute =
      obstacle.empty() ? membrane : static_cast<double>(obstacle[static_cast<std::size_t>(node)]);
    const auto to = static_cast<std::size_t>(this->Field.Grid.Index(at[0], at[1], at[2]));
    this->Field.Ceiling[to] = std::clamp(
      static_cast<float>(std::min(solute, membrane) / h), -FlowGrid::Band, FlowGrid::Band);
    this->Field.Distance[to] = this->Field.Ceiling[to];
  }
  FindBand(this->Field);
  RestoreDistances(this->Field);
}

void MovingChannel::Solve(const ProgressCallback& progress)
{
  auto grid = std::make_unique<TransportGrid>(
    MakeTransportGrid(this->Domain, OnDomain(this->Field, this->Domain), this->Charges,
      this->Transport, PermittivityMean::AlongEdge));
  this->Passage = FindPassage(*grid);
  if (!(this->Passage.Radius > 0.0) && !this->Updates.empty())
  {
    const Point3& at = this->Passage.Bottleneck;
    throw std::runtime_error("The moving surface has closed the channel at (" +
      FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) + "), " +
      FormatNumber(this->Passage.Along) +
      " angstrom along the normal from the membrane's center, after " + FormatNumber(this->Time) +
      " square angstrom of flow: its tension is stronger there than pressure, field and ions. "
      "Choose a smaller SurfaceTension or a larger Pressure, or keep the surface fixed.");
  }
  RequireOpen(this->Passage);
  CloseIsolatedPockets(*grid);
  auto solution = std::make_unique<PoissonNernstPlanck>(*grid, this->Transport);
  if (this->Solution)
  {
    solution->StartFrom(*this->Solution);
  }
  solution->Solve(progress);
  this->Solution = std::move(solution);
  this->Grid = std::move(grid);
}

/// The energy of tension, pressure and dispersion, kcal/mol, up to a constant.
double MovingChannel::SteadyEnergy() const
{
  const double h = this->Domain.Spacing;
  double inside = 0.0;
  for (std::size_t n = 0; n < this->Steady.size(); ++n)
  {
    const double part = std::clamp(0.5 - static_cast<double>(this->Field.Distance[n]), 0.0, 1.0);
    inside += part * static_cast<double>(this->Steady[n]);
  }
  return this->Parameters.Solvent.SurfaceTension *
    (MeasureLevel(this->Field).Area + h * h * inside);
}

void MovingChannel::Record()
{
  ChannelUpdate update;
  update.Time = this->Time;
  const double area = MeasureLevel(this->Field).Area;
  const double energy = this->SteadyEnergy();
  if (this->Updates.empty())
  {
    this->FirstArea = area;
    this->FirstEnergy = energy;
  }
  update.AreaChange = area - this->FirstArea;
  update.EnergyChange = energy - this->FirstEnergy;
  double water = 0.0;
  for (std::size_t p = 0; p < this->Grid->Water.size(); ++p)
  {
    const bool within =
      std::abs(static_cast<double>(this->Grid->Along[p])) < 0.5 * this->Transport.MembraneThickness;
    water += within ? static_cast<double>(this->Grid->Water[p]) : 0.0;
  }
  update.LumenVolume = water * std::pow(this->Domain.Spacing, 3);
  update.OnObstacle = FractionOnObstacle(this->Field);
  update.Bottleneck = this->Passage.Radius;
  const CurrentProfile currents = ComputeCurrents(*this->Solution);
  for (std::size_t k = 0; k < this->Transport.Species.size(); ++k)
  {
    update.Currents.push_back(currents.Mean(k));
  }
  this->Updates.push_back(std::move(update));
  const std::size_t last = this->Updates.size() - 1;
  if (last == 0 || this->Change(last) < this->LeastChange)
  {
    this->LeastChange = last == 0 ? std::numeric_limits<double>::infinity() : this->Change(last);
    this->ShownUpdate = last;
    this->Best = this->Field.Distance;
  }
}

/// Change since the previous update, relative to the currents or the water, whichever is larger.
double MovingChannel::Change(std::size_t update) const
{
  constexpr double nothing = 1e-6; // pA
  const ChannelUpdate& now = this->Updates[update];
  const ChannelUpdate& before = this->Updates[update - 1];
  double currents = 0.0;
  for (std::size_t k = 0; k < now.Currents.size(); ++k)
  {
    currents += std::abs(now.Currents[k] - before.Currents[k]);
  }
  return std::max(
    currents / std::max(Size(now), nothing), std::abs(now.LumenVolume / before.LumenVolume - 1.0));
}

double MovingChannel::LastChange() const
{
  return this->Updates.size() > 1 ? this->Change(this->Updates.size() - 1)
                                  : std::numeric_limits<double>::infinity();
}

bool MovingChannel::HasConverged() const
{
  const std::size_t n = this->Updates.size();
  const double tolerance = this->Parameters.UpdateTolerance;
  return n > 2 && this->Change(n - 1) <= tolerance && this->Change(n - 2) <= tolerance;
}

WallValues MovingChannel::ForceAtWall() const
{
  SurfaceFlowResult surface;
  StoreDistances(this->Field, surface);
  const double h = this->Domain.Spacing;
  LevelFunction level;
  level.Floats = { surface.Distance.data(), this->Room.Dimensions, { h, h, h } };
  level.InsideIsHigher = false;
  return isthmus::ForceAtWall(*this->Solution, level, FlowBox(this->Room), Margin);
}

/// Whether the last change reversed some of the one before.
bool MovingChannel::Oscillates() const
{
  const std::size_t n = this->Updates.size();
  double product = 0.0;
  for (std::size_t k = 0; n > 2 && k < this->Transport.Species.size(); ++k)
  {
    const double now = this->Updates[n - 1].Currents[k];
    const double before = this->Updates[n - 2].Currents[k];
    product += (now - before) * (before - this->Updates[n - 3].Currents[k]);
  }
  return product < 0.0;
}

void MovingChannel::Pull()
{
  const WallValues wall = this->ForceAtWall();
  this->ForceFraction *= this->Oscillates() ? 0.5 : 1.0;
  UpdatePull(this->Field, this->Steady,
    ExtendOffSurface(FlowBox(this->Room), wall.Crossings, wall.Pull, this->Field.Grid),
    this->Domain.Spacing / this->Parameters.Solvent.SurfaceTension,
    this->Updates.size() > 1 ? this->ForceFraction : 1.0);
}

void MovingChannel::Run(const ProgressCallback& progress)
{
  // The number of updates is unknown, so progress slows down.
  const auto at = [](int done) { return 0.95 * done / (done + 3.0); };
  for (int update = 0; update < this->Parameters.Policy.MaximumUpdates && !this->HasConverged();
       ++update)
  {
    if (update > 0)
    {
      this->Pull();
      this->Time += EvolveForPeriod(this->Field, this->Parameters.Policy);
    }
    this->Solve(Between(progress, at(update), at(update + 1)));
    this->Record();
  }
  if (this->HasConverged())
  {
    this->ShownUpdate = this->Updates.size() - 1;
  }
  else if (this->ShownUpdate + 1 < this->Updates.size())
  {
    this->Field.Distance = this->Best;
    FindBand(this->Field);
    this->Solve(Between(progress, 0.95, 1.0));
  }
  Report(progress, 1.0);
}

}
