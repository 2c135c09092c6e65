#include "Solvation/PoissonNernstPlanck.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double LargestStep = 3.0;  // largest change of phi in the water, kT/e, in one Newton step
constexpr int MostNewtonSteps = 100; // a guard: a convex problem takes 3 to 20
constexpr double NewtonReduction = 1e-3;
constexpr double FinalAccuracy = 1e-7; // of a species' current, in all cross-sections
constexpr double MostImbalance =
  1e-4; // if more of a current than this is lost, it is not a solution

/// mV to kT/e.
double Thermal(double millivolt, double kelvin)
{
  return 1e-3 * millivolt * units::ElementaryCharge / (units::BoltzmannConstant * kelvin);
}

/// Fractions that approach 1, however many steps there are.
ProgressCallback Approaching(const ProgressCallback& progress, double& done)
{
  constexpr double part = 0.02;
  return [&progress, &done](double)
  {
    done += part * (1.0 - done);
    return !progress || progress(done);
  };
}

}

PoissonNernstPlanck::PoissonNernstPlanck(
  const TransportGrid& grid, const IonTransportParameters& parameters)
  : Grid(grid)
  , Parameters(parameters)
  , ChargeScale(4.0 * Pi * units::CoulombLength(parameters.Temperature) *
      units::IonsPerCubicAngstrom * std::pow(grid.Domain.Spacing, 3))
  , Open(static_cast<std::size_t>(grid.Domain.Size()), 0)
  , Phi(this->Open.size(), 0.0)
  , Source(this->Open.size(), 0.0)
  , Field(grid.Domain.Dimensions, grid.Baths)
  , Ions(grid.Domain.Dimensions, grid.Baths)
{
  Check(parameters);
  const std::array<std::int64_t, 3> steps = grid.Domain.Steps();
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::int64_t node = 0; node < grid.Domain.Size(); ++node)
    {
      const auto p = static_cast<std::size_t>(node);
      this->Field.Edge(a, node) =
        grid.Domain.Spacing * static_cast<double>(grid.Permittivity[a][p]);
      if (grid.Aperture[a][p] > 0.0F)
      {
        this->Open[p] = this->Open[static_cast<std::size_t>(node + steps[a])] = 1;
      }
    }
  }
  this->V.resize(parameters.Species.size());
  for (const SpeciesId k : this->V.Keys())
  {
    const TransportSpecies& s = parameters.Species[k.Index()];
    this->V[k].assign(this->Open.size(), 0.0);
    for (std::size_t p = 0; p < this->Open.size(); ++p)
    {
      this->V[k][p] = this->Open[p] == 0 ? 0.0 : this->Grid.Along[p] < 0.0F ? s.Below : s.Above;
    }
  }
  this->SetVoltage(parameters.Voltage);
}

void PoissonNernstPlanck::SetVoltage(double voltage)
{
  const double more = Thermal(voltage, this->Parameters.Temperature) -
    Thermal(this->Voltage, this->Parameters.Temperature);
  this->Voltage = voltage;
  for (std::size_t p = 0; p < this->Phi.size(); ++p)
  {
    this->Phi[p] += more * this->Parameters.PartBelow(static_cast<double>(this->Grid.Along[p]));
    if (this->Grid.Baths[p] != 0)
    {
      for (const SpeciesId k : this->V.Keys())
      {
        this->V[k][p] = this->BathValue(k, this->Grid.Baths[p]);
      }
    }
  }
  this->Report = {};
}

void PoissonNernstPlanck::StartFrom(const PoissonNernstPlanck& other)
{
  this->Phi = other.Phi;
  for (const SpeciesId k : this->V.Keys())
  {
    for (std::size_t p = 0; p < this->Open.size(); ++p)
    {
      if (this->Open[p] != 0 && other.Open[p] != 0)
      {
        this->V[k][p] = other.V[k][p];
      }
    }
  }
  this->SetVoltage(this->Voltage);
}

double PoissonNernstPlanck::BathValue(SpeciesId species, unsigned char bath) const
{
  const TransportSpecies& s = this->Parameters.Species[species.Index()];
  return bath == static_cast<unsigned char>(Bath::Above)
    ? s.Above
    : s.Below * std::exp(s.Valence * Thermal(this->Voltage, this->Parameters.Temperature));
}

double PoissonNernstPlanck::Concentration(SpeciesId species, std::int64_t node) const
{
  const auto p = static_cast<std::size_t>(node);
  return this->Open[p] == 0 ? 0.0
                            : this->V[species][p] *
      std::exp(-this->Parameters.Species[species.Index()].Valence * this->Phi[p]);
}

void PoissonNernstPlanck::ForNodes(const std::function<void(std::int64_t)>& work) const
{
  ParallelFor(0, this->Grid.Domain.Size(), 1 << 14,
    [&work](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        work(node);
      }
    });
}

void PoissonNernstPlanck::FillCharge()
{
  const double coulomb = 4.0 * Pi * units::CoulombLength(this->Parameters.Temperature);
  this->ForNodes(
    [&](std::int64_t node)
    {
      const auto p = static_cast<std::size_t>(node);
      double charge = 0.0, slope = 0.0;
      const HandleRange<SpeciesId> present(this->Open[p] != 0 ? this->V.size() : 0);
      for (const SpeciesId k : present)
      {
        const double z = this->Parameters.Species[k.Index()].Valence;
        const double ions = this->ChargeScale * static_cast<double>(this->Grid.Water[p]) *
          this->V[k][p] * std::exp(-z * this->Phi[p]);
        charge += z * ions;
        slope += z * z * ions;
      }
      this->Field.Diagonal(node) = slope;
      this->Source[p] = coulomb * this->Grid.Charge[p] + charge + slope * this->Phi[p];
    });
}

double PoissonNernstPlanck::NewtonStep(const ProgressCallback& progress)
{
  this->FillCharge();
  this->Field.Factor();
  this->Work = this->Phi;
  const auto answer =
    this->Field.Solve(this->Work, this->Source, { 0.0, NewtonReduction }, progress);
  this->Report.LinearIterations += answer.Iterations;
  double largest = 0.0;
  for (std::size_t p = 0; p < this->Phi.size(); ++p)
  {
    largest = std::max(largest, this->Open[p] != 0 ? std::abs(this->Work[p] - this->Phi[p]) : 0.0);
  }
  const double part = largest > LargestStep ? LargestStep / largest : 1.0;
  for (std::size_t p = 0; p < this->Phi.size(); ++p)
  {
    this->Phi[p] += part * (this->Work[p] - this->Phi[p]);
  }
  return largest;
}

double PoissonNernstPlanck::SolvePoisson(double accuracy, const ProgressCallback& progress)
{
  const std::vector<double> before = this->Phi;
  double step = HUGE_VAL;
  for (int count = 0; count < MostNewtonSteps && step > accuracy; ++count)
  {
    step = this->NewtonStep(progress);
  }
  double change = 0.0;
  for (std::size_t p = 0; p < this->Phi.size(); ++p)
  {
    change = std::max(change, this->Open[p] != 0 ? std::abs(this->Phi[p] - before[p]) : 0.0);
  }
  return step > accuracy ? std::max(change, step)
                         : change; // the remaining residual of Newton's method
}

const IonTransportReport& PoissonNernstPlanck::Solve(const ProgressCallback& progress)
{
  constexpr double coarse = 1e-2; // of the ions' currents, and kT/e, at first
  double done = 0.0;
  const ProgressCallback tick = Approaching(progress, done);
  double accuracy = coarse;
  double least = HUGE_VAL;
  std::vector<double> best;
  this->Report = {};
  while (!this->Report.Converged && this->Report.Iterations < this->Parameters.MaximumIterations)
  {
    this->SolveNernstPlanck(accuracy, tick);
    const double change =
      this->SolvePoisson(std::max(0.1 * this->Parameters.Tolerance, accuracy), tick);
    this->Report.Changes.push_back(change);
    ++this->Report.Iterations;
    this->Report.Converged = change <= this->Parameters.Tolerance;
    if (change < least)
    {
      least = change;
      best = this->Phi;
    }
    accuracy = std::clamp(0.1 * change, std::min(coarse, 0.1 * this->Parameters.Tolerance), coarse);
  }
  this->Phi = std::move(best);
  this->SolveNernstPlanck(FinalAccuracy, tick);
  this->Report.Converged = this->Report.Converged && this->Report.Imbalance <= MostImbalance;
  return this->Report;
}

namespace
{

constexpr double Rounding = 1e-16;

}

double PoissonNernstPlanck::Mobility(SpeciesId species, std::int64_t node) const
{
  const TransportSpecies& s = this->Parameters.Species[species.Index()];
  const auto along = static_cast<double>(this->Grid.Along[static_cast<std::size_t>(node)]);
  const bool slow = std::abs(along) < 0.5 * this->Parameters.MembraneThickness;
  return s.Diffusion * (slow ? s.ChannelFraction : 1.0);
}

double PoissonNernstPlanck::EdgeConductance(
  SpeciesId species, std::size_t axis, std::int64_t node, double rootHere, double rootThere) const
{
  const double here = this->Mobility(species, node);
  const double there = this->Mobility(species, node + this->Grid.Domain.Steps()[axis]);
  return static_cast<double>(this->Grid.Aperture[axis][static_cast<std::size_t>(node)]) *
    this->Grid.Domain.Spacing * 2.0 * here * there / (here + there) *
    SlotboomConductance(rootHere, rootThere);
}

void PoissonNernstPlanck::FillNernstPlanck(SpeciesId species)
{
  const double half = -0.5 * this->Parameters.Species[species.Index()].Valence;
  this->Work.resize(this->Phi.size());
  this->ForNodes(
    [&](std::int64_t node)
    {
      const auto p = static_cast<std::size_t>(node);
      this->Work[p] = this->Open[p] != 0 ? std::exp(half * this->Phi[p]) : 0.0;
    });
  const std::array<std::int64_t, 3> steps = this->Grid.Domain.Steps();
  this->ForNodes(
    [&](std::int64_t node)
    {
      const auto p = static_cast<std::size_t>(node);
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Ions.Edge(a, node) = this->Grid.Aperture[a][p] == 0.0F
          ? 0.0
          : this->EdgeConductance(species, a, node, this->Work[p],
              this->Work[static_cast<std::size_t>(node + steps[a])]);
      }
    });
}

double PoissonNernstPlanck::EdgeFlux(SpeciesId species, std::size_t axis, std::int64_t node) const
{
  const auto p = static_cast<std::size_t>(node);
  if (this->Grid.Aperture[axis][p] == 0.0F)
  {
    return 0.0;
  }
  const auto q = static_cast<std::size_t>(node + this->Grid.Domain.Steps()[axis]);
  const double half = -0.5 * this->Parameters.Species[species.Index()].Valence;
  return this->EdgeConductance(
           species, axis, node, std::exp(half * this->Phi[p]), std::exp(half * this->Phi[q])) *
    (this->V[species][p] - this->V[species][q]);
}

double PoissonNernstPlanck::Throughput(SpeciesId species) const
{
  const std::array<std::int64_t, 3> steps = this->Grid.Domain.Steps();
  const auto below = static_cast<unsigned char>(Bath::Below);
  const double total = ParallelReduce(this->Grid.Domain.Size(), 1 << 16, 0.0,
    [&](double& sum, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const auto p = static_cast<std::size_t>(node);
        for (std::size_t a = 0; a < 3; ++a)
        {
          if (this->Grid.Aperture[a][p] > 0.0F)
          {
            const bool here = this->Grid.Baths[p] == below;
            const bool there = this->Grid.Baths[static_cast<std::size_t>(node + steps[a])] == below;
            sum += here == there ? 0.0 : (here ? 1.0 : -1.0) * this->EdgeFlux(species, a, node);
          }
        }
      }
    });
  return std::abs(total);
}

/// The part of its current that nodes do not conserve at the end.
double PoissonNernstPlanck::SolveSpecies(
  SpeciesId k, double accuracy, const ProgressCallback& progress)
{
  constexpr int rounds = 12;
  std::vector<double>& v = this->V[k];
  this->FillNernstPlanck(k);
  this->Ions.Factor();
  const auto [low, high] =
    std::minmax({ this->BathValue(k, static_cast<unsigned char>(Bath::Below)),
      this->BathValue(k, static_cast<unsigned char>(Bath::Above)) });
  double left = this->Ions.Residual(v, {});
  // The accuracy needed depends on the current, which is known only gradually.
  for (int round = 0; round < rounds; ++round)
  {
    const double wanted = accuracy * this->Throughput(k);
    const double rounding = Rounding * this->Ions.SumOfMagnitudes(v);
    if (left <= std::max(wanted, rounding))
    {
      break;
    }
    const auto answer =
      this->Ions.Solve(v, {}, { std::max(0.5 * wanted, rounding), 1e-3 }, progress);
    this->Report.LinearIterations += answer.Iterations;
    // Solutions of the equation lie between the values of the baths, up to rounding.
    for (std::size_t p = 0; p < this->Open.size(); ++p)
    {
      v[p] = this->Open[p] != 0 ? std::clamp(v[p], low, high) : 0.0;
    }
    // Computed again: the clamp does not correct a solution that got stuck, it would only hide the
    // failure.
    const double before = std::exchange(left, this->Ions.Residual(v, {}));
    if (left > 0.5 * before)
    {
      break;
    }
  }
  return left / std::max(this->Throughput(k), this->NegligibleCurrent(k));
}

/// Losses of a current below this value are not reported: a millionth of what the larger bath would
/// send through the whole cylinder.
double PoissonNernstPlanck::NegligibleCurrent(SpeciesId species) const
{
  constexpr double part = 1e-6;
  const TransportSpecies& s = this->Parameters.Species[species.Index()];
  const TransportDomain& d = this->Grid.Domain;
  const double most = std::max(s.Below, s.Above);
  return std::max(part * s.Diffusion * most * Pi * d.Radius * d.Radius / (2.0 * d.HalfLength),
    std::numeric_limits<double>::min());
}

void PoissonNernstPlanck::SolveNernstPlanck(double accuracy, const ProgressCallback& progress)
{
  this->Report.Imbalance = 0.0;
  for (const SpeciesId k : this->V.Keys())
  {
    this->Report.Imbalance =
      std::max(this->Report.Imbalance, this->SolveSpecies(k, accuracy, progress));
  }
}

}
