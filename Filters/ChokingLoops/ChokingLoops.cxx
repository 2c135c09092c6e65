#include "ChokingLoops/ChokingLoops.h"

#include "ChokingLoops/ChokingAnalysis.h"
#include "ChokingLoops/ChokingSurface.h"
#include "ChokingLoops/EncirclingLoops.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Persistence/DelaunayFiltration.h"
#include "Persistence/LowerStarFiltration.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Rounds of refinement round features that the sampling blurs.
constexpr int Rounds = 3;

/// What a finer sampling everywhere leaves, one finer in places leaves as well; and where a round
/// settles less than half of its places, the next would settle less and take as long again.
bool IsInVain(std::size_t before, std::size_t left)
{
  return 2 * left > before || (before > ManyPlaces && left <= ManyPlaces);
}

/// What the samples of round `round` take, by what those before took; `own` points has the surface
/// itself.
AnalysisCost NextCost(const SurfaceView& samples, const ChokingAnalysis& before,
  const ChokingLoopTimes& times, int round, std::size_t own)
{
  AnalysisCost cost = CostOf(samples);
  const std::size_t unsettled = CountUnsettled(before.Found);
  cost.LearnFrom(before.Cost, times.LastRound);
  if (unsettled > (round < Rounds ? ManyPlaces : 0))
  {
    cost.ExpectCompletion(own);
  }
  return cost;
}

}

ChokingLoops::ChokingLoops(
  TriangleMesh surface, const ChokingLoopParameters& parameters, const ProgressCallback& progress)
{
  ChokingLoopTimes times;
  Stopwatch watch;
  SurfaceMending mended;
  surface = CheckedSurface(
    std::move(surface), parameters.AllowSelfIntersections, Between(progress, 0.0, 0.2), &mended);
  times.Check = watch.Lap();
  const bool automatic = parameters.SampleSpacing <= 0.0;
  double spacing = parameters.SampleSpacing;
  TriangleMesh samples = FirstSamples(surface, spacing, Between(progress, 0.2, 0.25));
  times.Sampling = watch.Lap();
  const std::size_t own = surface.Points.size();
  // One as fine as its samples is not kept twice.
  if (samples.Triangles.size() == surface.Triangles.size())
  {
    surface = {};
  }
  std::string tooMuch;
  std::size_t before = 0; // places that the round before left blurred
  AnalysisCost cost = CostOf(samples);
  if (!FitsMemory(cost, parameters.MemoryLimit, tooMuch))
  {
    throw std::runtime_error(tooMuch);
  }
  for (int round = 0;; ++round)
  {
    // Later rounds are the exception: each takes half of what is left of the bar.
    const double from = 1.0 - 0.75 * std::pow(0.5, round);
    const double to = 0.5 * (1.0 + from);
    const auto part = Between(progress, from, to);
    this->AnalyseSamples(std::move(samples), cost, parameters, times, part);
    times.LastRound = watch.Lap();
    const std::vector<Refinement> blurred = this->State->Blurred();
    const bool isLast = round == Rounds || (round > 0 && IsInVain(before, blurred.size()));
    if (!automatic || isLast || blurred.empty())
    {
      break;
    }
    before = blurred.size();
    if (surface.Points.empty())
    {
      surface = this->State->Samples;
    }
    samples = Refined(this->State->Samples, blurred, spacing * std::pow(0.6, round),
      spacing * std::pow(0.6, Rounds), Between(progress, to, to));
    times.Sampling += watch.Lap();
    cost = NextCost(samples, *this->State, times, round + 1, own);
    if (samples.Points.empty() || !FitsMemory(cost, parameters.MemoryLimit, tooMuch))
    {
      break; // too much to ask: what is blurred stays marked as not trusted
    }
  }
  this->Complete(parameters, surface, own, times, Between(progress, 0.96, 1.0));
  this->State->Times = times;
  this->State->Mended = std::move(mended);
  Report(progress, 1.0);
}

void ChokingLoops::Complete(const ChokingLoopParameters& parameters, const SurfaceView& surface,
  std::size_t own, ChokingLoopTimes& times, const ProgressCallback& progress)
{
  AnalysisCost& cost = this->State->Cost;
  if (cost.Own == 0 && !AllSettled(this->State->Found))
  {
    cost.ExpectCompletion(own);
    cost.Seconds = times.LastRound + cost.Completion();
    if (parameters.Estimated)
    {
      parameters.Estimated(cost);
    }
  }
  Stopwatch watch;
  this->State->Complete(
    surface.Points.empty() ? SurfaceView(this->State->Samples) : surface, progress);
  const double took = watch.Lap();
  times.Features += took;
  times.LastRound += took;
}

void ChokingLoops::AnalyseSamples(TriangleMesh samples, AnalysisCost cost,
  const ChokingLoopParameters& parameters, ChokingLoopTimes& times,
  const ProgressCallback& progress)
{
  Stopwatch watch;
  const auto tell = [&]
  {
    if (parameters.Estimated)
    {
      parameters.Estimated(cost);
    }
  };
  tell();
  this->State.reset(); // what a coarser round found
  std::vector<double> errors = SamplingErrors(samples);
  CellFiltration filtration = DelaunayFiltration(samples.Points, Between(progress, 0.0, 0.6),
    [&](double seconds)
    {
      cost = cost.After(seconds);
      tell();
    });
  times.Filtration += watch.Lap();
  this->State = std::make_unique<ChokingAnalysis>(std::move(samples), std::move(filtration),
    std::move(errors), times, Between(progress, 0.6, 1.0));
  this->State->Cost = cost;
}

ChokingLoops::ChokingLoops(const SurfaceView& surface, const TetrahedralMesh& mesh,
  const std::vector<double>& values, const ProgressCallback& progress)
{
  ChokingLoopTimes times;
  Stopwatch watch;
  TriangleMesh checked = CheckedSurface(CopyOf(surface), true, Between(progress, 0.0, 0.1));
  times.Check = watch.Lap();
  CellFiltration filtration =
    LowerStarFiltration(mesh, values, checked, Between(progress, 0.1, 0.5));
  times.Filtration = watch.Lap();
  this->State = std::make_unique<ChokingAnalysis>(std::move(checked), std::move(filtration),
    std::vector<double>{}, times, Between(progress, 0.5, 1.0));
  this->State->Times = times;
}

ChokingLoops::~ChokingLoops() = default;
ChokingLoops::ChokingLoops(ChokingLoops&&) noexcept = default;
ChokingLoops& ChokingLoops::operator=(ChokingLoops&&) noexcept = default;

const FeatureDiagram& ChokingLoops::Diagram() const
{
  return this->State->Found.Diagram;
}

const TriangleMesh& ChokingLoops::Samples() const
{
  return this->State->Samples;
}

const SurfaceAdjacency& ChokingLoops::Adjacency() const
{
  return this->State->Adjacency;
}

const SurfaceHomology& ChokingLoops::Homology() const
{
  return this->State->Homology;
}

const ChokingLoopTimes& ChokingLoops::Times() const
{
  return this->State->Times;
}

const SurfaceMending& ChokingLoops::Mended() const
{
  return this->State->Mended;
}

const AnalysisCost& ChokingLoops::Cost() const
{
  return this->State->Cost;
}

double ChokingLoops::LargestError() const
{
  const auto& errors = this->State->Context.PointError;
  return errors.empty() ? 0.0 : *std::max_element(errors.begin(), errors.end());
}

std::vector<std::size_t> ChokingLoops::Select(const FeatureSelection& selection) const
{
  return SelectFeatures(this->Diagram(), selection);
}

const Membrane& ChokingLoops::MembraneOf(std::size_t feature)
{
  std::optional<Membrane>& membrane = this->State->Found.Membranes[feature];
  if (!membrane)
  {
    membrane = FeatureMembrane(
      this->State->Context, this->State->Regions, this->State->Found.Diagram.Features[feature]);
  }
  return *membrane;
}

const Membrane& ChokingLoops::MembraneOfMade(std::size_t feature) const
{
  return this->State->Found.Membranes[feature].value();
}

const Membrane* ChokingLoops::TightMembraneOf(std::size_t feature, const ProgressCallback& progress)
{
  ChokingAnalysis& state = *this->State;
  auto known = state.Tight.find(feature);
  if (known == state.Tight.end())
  {
    std::optional<Membrane> membrane = TightMembrane(
      state.Context, state.Found.Diagram.Features[feature], state.Found.Centres[feature], progress);
    if (membrane && !IsInterchangeable(state.Context, state.Found, feature, *membrane))
    {
      membrane.reset();
    }
    known = state.Tight.emplace(feature, std::move(membrane)).first;
  }
  return known->second ? &*known->second : nullptr;
}

std::vector<Membrane> ChokingLoops::EncirclingMembranesOf(
  std::size_t feature, double longest, std::size_t most) const
{
  return EncirclingMembranes(this->State->Context, this->State->Found, feature, longest, most);
}

std::optional<Membrane> ChokingLoops::ContactMembraneOf(std::size_t feature, double longest) const
{
  return ContactMembrane(this->State->Context, this->State->Found, feature, longest);
}

std::vector<SimplexId> ChokingLoops::ContactsOf(std::size_t feature) const
{
  const TriangleId choke = this->State->Found.Diagram.Features[feature].Choke;
  if (!choke.Exists())
  {
    return {};
  }
  const auto corners = this->State->Filtration.TrianglePoints(choke);
  return { corners.begin(), corners.end() };
}

const std::string& ChokingLoops::Remark() const
{
  return this->State->Remark;
}

Point3 ChokingLoops::ChokePoint(std::size_t feature) const
{
  return this->State->Found.Centres[feature];
}

}
