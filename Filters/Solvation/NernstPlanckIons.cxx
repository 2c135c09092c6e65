// The half of PoissonNernstPlanck that solves for the ions, with the potential given.
#include "Solvation/PoissonNernstPlanck.h"

#include "Core/Geometry.h"
#include "Solvation/ScharfetterGummel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Rounding = 1e-16;

}

double PoissonNernstPlanck::Mobility(SpeciesId species, std::int64_t node) const
{
  const TransportSpecies& s = this->Parameters.Species[species.Index()];
  const auto along = static_cast<double>(this->Grid.Along[static_cast<std::size_t>(node)]);
  const bool slow = std::abs(along) < 0.5 * this->Parameters.Membrane.Thickness;
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
  for (std::size_t p = 0; p < this->Phi.size(); ++p)
  {
    this->Work[p] = this->Open[p] != 0 ? std::exp(half * this->Phi[p]) : 0.0;
  }
  const std::array<std::int64_t, 3> steps = this->Grid.Domain.Steps();
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::int64_t node = 0; node < this->Grid.Domain.Size(); ++node)
    {
      const auto p = static_cast<std::size_t>(node);
      this->Ions.Edge(a, node) = this->Grid.Aperture[a][p] == 0.0F
        ? 0.0
        : this->EdgeConductance(
            species, a, node, this->Work[p], this->Work[static_cast<std::size_t>(node + steps[a])]);
    }
  }
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
  double total = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::int64_t node = 0; node < this->Grid.Domain.Size(); ++node)
    {
      const auto p = static_cast<std::size_t>(node);
      if (this->Grid.Aperture[a][p] > 0.0F)
      {
        const bool here = this->Grid.Baths[p] == below;
        const bool there = this->Grid.Baths[static_cast<std::size_t>(node + steps[a])] == below;
        total += here == there ? 0.0 : (here ? 1.0 : -1.0) * this->EdgeFlux(species, a, node);
      }
    }
  }
  return std::abs(total);
}

/// The part of its current that nodes do not pass on when it is done.
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
  // How much is enough is known only when the current is: so by and by.
  for (int round = 0; round < rounds; ++round)
  {
    const double wanted = accuracy * this->Throughput(k);
    const double rounding = Rounding * this->Ions.Turnover(v);
    if (left <= std::max(wanted, rounding))
    {
      break;
    }
    const auto answer =
      this->Ions.Solve(v, {}, { std::max(0.5 * wanted, rounding), 1e-3 }, progress);
    this->Report.LinearIterations += answer.Iterations;
    // A value between the baths' is what the equation has; rounding leaves that by its own size.
    for (std::size_t p = 0; p < this->Open.size(); ++p)
    {
      v[p] = this->Open[p] != 0 ? std::clamp(v[p], low, high) : 0.0;
    }
    // Anew: the clamp does not make a solution whole that got stuck, it only hides it.
    const double before = std::exchange(left, this->Ions.Residual(v, {}));
    if (left > 0.5 * before)
    {
      break;
    }
  }
  return left / std::max(this->Throughput(k), this->Trickle(k));
}

/// A current that nobody asks for: a millionth of what the larger bath would send through the whole
/// cylinder. Of less than that no part is worth telling.
double PoissonNernstPlanck::Trickle(SpeciesId species) const
{
  constexpr double part = 1e-6;
  const TransportSpecies& s = this->Parameters.Species[species.Index()];
  const TransportDomain& d = this->Grid.Domain;
  const double most = this->Factor * std::max(s.Below, s.Above);
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
