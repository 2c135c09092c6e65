#include "MolecularSurfaces/SurfaceFlow.h"

#include "MolecularSurfaces/FlowMemory.h"
#include "MolecularSurfaces/FlowResult.h"
#include "MolecularSurfaces/FlowSteps.h"

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

constexpr double Lambda = 0.16;             // dt / spacing^2; 0.25 is where it becomes unstable
constexpr int StepsToRedistance = 4;        // see the README: more seldom, necks break too early
constexpr int RedistanceIterations = 2;     // by 0.45 spacings each
constexpr int FinalIterations = 10;         // through the whole band
constexpr int StepsToLook = 48;             // between two measures, a multiple of the above
constexpr double Rest = 1e-5;               // relative change of the volume in StepsToLook
constexpr int MostSteps = 20000;            // on one grid, or on the coarsest of several
constexpr int FinerSteps = 4 * StepsToLook; // at least, on finer grids: details only are left
constexpr double Slow = 1.5e-4;             // relative change of the volume in a square angstrom
constexpr double StartAgain = 1.3;          // enlargement of what is added on finer levels

/// Where a run of a flow is, and what it writes down.
struct Chronicle
{
  const FlowRecord& Look(const FlowField& field)
  {
    Record(field, this->Time, this->Result);
    return this->Result.History.back();
  }

  SurfaceFlowResult& Result;
  double Time = 0.0;
};

void Step(FlowField& field, int step, double lambda)
{
  Advance(field, lambda);
  if (step % StepsToRedistance == 0)
  {
    Redistance(field, RedistanceIterations);
  }
}

void RunForTime(
  FlowField& field, double time, Chronicle& chronicle, const ProgressCallback& progress)
{
  constexpr int looks = 40;
  const double h = field.Grid.Spacing();
  const double wanted = std::ceil(time / (Lambda * h * h));
  if (wanted > 1e7)
  {
    throw std::invalid_argument("EvolutionTime is " + std::to_string(time) +
      " square angstrom, which takes more than ten million steps: choose Steady.");
  }
  const int steps = static_cast<int>(wanted);
  const double dt = steps > 0 ? time / steps : 0.0;
  // Where redistancing has just been, since the volume swings a little in between.
  const int between = StepsToRedistance * std::max(1, steps / (looks * StepsToRedistance));
  chronicle.Look(field);
  for (int step = 1; step <= steps; ++step)
  {
    Step(field, step, dt / (h * h));
    chronicle.Time += dt;
    if (step % between == 0 || step == steps)
    {
      chronicle.Look(field);
    }
    Report(progress, static_cast<double>(step) / steps);
  }
}

/// The volumes at the last looks, and what they say.
class Trend
{
public:
  void Add(double volume) { this->Volumes.push_back(volume); }

  /// Relative change since the look before.
  double Change() const
  {
    const std::size_t n = this->Volumes.size();
    return n < 2 ? 1.0 : std::abs(this->Volumes[n - 1] / this->Volumes[n - 2] - 1.0);
  }

  /// Has it come to rest? By two looks, since it may pass through a turning point; or by the means
  /// of four and the four before, since small surfaces can swing a little for ever.
  bool IsCalm() const
  {
    const std::size_t n = this->Volumes.size();
    if (n < 3)
    {
      return false;
    }
    const double last = this->Volumes[n - 1];
    const bool still = std::abs(last - this->Volumes[n - 2]) < Rest * last &&
      std::abs(this->Volumes[n - 2] - this->Volumes[n - 3]) < Rest * last;
    return still ||
      (n >= 12 && std::abs(this->MeanOfFour(4) - this->MeanOfFour(8)) < 4.0 * Rest * last);
  }

private:
  double MeanOfFour(std::size_t back) const
  {
    const auto first = this->Volumes.end() - static_cast<std::ptrdiff_t>(back);
    return 0.25 * std::accumulate(first, first + 4, 0.0);
  }

  std::vector<double> Volumes;
};

/// Runs until the volume rests, or from `enough` steps on until what still happens is slow. Tells
/// whether either came about in MostSteps.
bool RunToRest(FlowField& field, int enough, Chronicle& chronicle, const ProgressCallback& progress)
{
  const double dt = Lambda * field.Grid.Spacing() * field.Grid.Spacing();
  Trend trend;
  trend.Add(chronicle.Look(field).Volume);
  for (int step = 1; step <= MostSteps; ++step)
  {
    Step(field, step, Lambda);
    chronicle.Time += dt;
    // How long it takes is not known, so progress slows down: half after 200 steps.
    Report(progress, step / (step + 200.0));
    if (step % StepsToLook == 0)
    {
      trend.Add(chronicle.Look(field).Volume);
      if (trend.IsCalm() || (step >= enough && trend.Change() < Slow * dt * StepsToLook))
      {
        return true;
      }
    }
  }
  return false;
}

FlowField SteadyField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const PullField& pull, Chronicle& chronicle, const ProgressCallback& progress)
{
  // With a probe, flows are short; with a pull, coarse grids see too little of it.
  const bool coarse = parameters.CoarseToFine && parameters.ProbeRadius == 0.0 && !pull;
  const int levels = coarse ? CoarserLevels(balls, parameters) : 0;
  const auto part = [&](int level) { return static_cast<double>(level) / (levels + 1); };
  FlowField field = StartField(balls, parameters, std::pow(2.0, levels), parameters.Enlargement,
    pull, Between(progress, 0.0, 0.3 * part(1)));
  bool rests = RunToRest(field, MostSteps, chronicle, Between(progress, 0.3 * part(1), part(1)));
  for (int level = levels - 1; level >= 0; --level)
  {
    const int done = levels - level;
    const double third = part(done) + 0.3 * (part(done + 1) - part(done));
    FlowField finer = StartField(balls, parameters, std::pow(2.0, level),
      std::min(parameters.Enlargement, StartAgain), pull, Between(progress, part(done), third));
    AddCoarse(field, finer);
    field = std::move(finer);
    rests = RunToRest(field, FinerSteps, chronicle, Between(progress, third, part(done + 1)));
  }
  chronicle.Result.Rests = rests;
  return field;
}

}

DensityGrid FlowResultGrid(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double* bytes)
{
  CheckFlow(balls, parameters);
  const DensityGrid grid = FlowGridAround(balls, parameters);
  if (bytes)
  {
    *bytes = FlowBytes(grid);
  }
  return grid;
}

SurfaceFlowResult SurfaceFlow(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const PullField& pull, const ProgressCallback& progress)
{
  SurfaceFlowResult result;
  result.Grid = FlowResultGrid(balls, parameters);
  if (balls.empty())
  {
    return result;
  }
  CheckFlowMemory(balls, result.Grid);
  Chronicle chronicle{ result };
  FlowField field = parameters.Steady
    ? SteadyField(balls, parameters, pull, chronicle, Between(progress, 0.0, 0.95))
    : StartField(balls, parameters, 1.0, parameters.Enlargement, pull, Between(progress, 0.0, 0.3));
  if (!parameters.Steady)
  {
    RunForTime(field, parameters.EvolutionTime, chronicle, Between(progress, 0.3, 0.95));
  }
  Redistance(field, FinalIterations, true);
  Advance(field, 0.0);
  StoreDistances(field, result);
  Report(progress, 1.0);
  return result;
}

}
