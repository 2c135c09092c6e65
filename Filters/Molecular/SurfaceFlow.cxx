#include "SurfaceFlow.h"

#include "FlowMemory.h"
#include "FlowSteps.h"
#include "LevelMeasure.h"
#include "ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Lambda = 0.16;          // dt / spacing^2; 0.25 is where it becomes unstable
constexpr int StepsToRedistance = 4;     // see the README: more seldom, necks break too early
constexpr int RedistanceIterations = 2;  // by 0.45 spacings each
constexpr int FinalIterations = 10;      // through the whole band
constexpr int StepsToLook = 48;          // between two measures, a multiple of the above
constexpr double Rest = 1e-5;            // relative change of the volume in StepsToLook
constexpr int CoarseSteps = 1000;        // at most, on each coarser level
constexpr int FinestSteps = 20000;       // at most, on the finest
constexpr double StartAgain = 1.3;       // enlargement of what is added on finer levels

/// What a run of a flow writes down.
class Chronicle
{
public:
  explicit Chronicle(std::vector<FlowRecord>& history)
    : History(history)
  {
  }

  const LevelMeasure& Look(const FlowField& field)
  {
    this->Last = MeasureLevel(field);
    this->History.push_back(
      { this->Time, field.Grid.Spacing(), this->Last.Area, this->Last.Volume });
    return this->Last;
  }

  double Time = 0.0;

private:
  std::vector<FlowRecord>& History;
  LevelMeasure Last;
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
  const int between =
    StepsToRedistance * std::max(1, steps / (looks * StepsToRedistance));
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

/// Runs until the volume stays: twice in a row, since it may pass through a turning point.
bool RunToRest(
  FlowField& field, int most, Chronicle& chronicle, const ProgressCallback& progress)
{
  const double dt = Lambda * field.Grid.Spacing() * field.Grid.Spacing();
  double volume = chronicle.Look(field).Volume;
  int calm = 0;
  for (int step = 1; step <= most && calm < 2; ++step)
  {
    Step(field, step, Lambda);
    chronicle.Time += dt;
    if (step % StepsToLook == 0)
    {
      const double now = chronicle.Look(field).Volume;
      calm = std::abs(now - volume) < Rest * volume ? calm + 1 : 0;
      volume = now;
    }
    // How long it takes is not known, so progress slows down: half after 200 steps.
    Report(progress, step / (step + 200.0));
  }
  return calm == 2;
}

FlowField SteadyField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const PullField& pull, Chronicle& chronicle, bool& rests, const ProgressCallback& progress)
{
  // With a probe, flows are short; with a pull, coarse grids see too little of it.
  const bool coarse = parameters.CoarseToFine && parameters.ProbeRadius == 0.0 && !pull;
  const int levels = coarse ? CoarserLevels(balls, parameters) : 0;
  const auto part = [&](int level) { return static_cast<double>(level) / (levels + 1); };
  FlowField field = StartField(balls, parameters, std::pow(2.0, levels), parameters.Enlargement,
    pull, Between(progress, 0.0, 0.3 * part(1)));
  rests = RunToRest(field, levels > 0 ? CoarseSteps : FinestSteps, chronicle,
    Between(progress, 0.3 * part(1), part(1)));
  for (int level = levels - 1; level >= 0; --level)
  {
    const int done = levels - level;
    const double third = part(done) + 0.3 * (part(done + 1) - part(done));
    FlowField finer = StartField(balls, parameters, std::pow(2.0, level),
      std::min(parameters.Enlargement, StartAgain), pull, Between(progress, part(done), third));
    AddCoarse(field, finer);
    field = std::move(finer);
    rests = RunToRest(field, level > 0 ? CoarseSteps : FinestSteps, chronicle,
      Between(progress, third, part(done + 1)));
  }
  return field;
}

std::vector<float> InnerDistances(const FlowField& field)
{
  const auto& n = field.Grid.Inner().Dimensions;
  const auto h = static_cast<float>(field.Grid.Spacing());
  std::vector<float> inner(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  ParallelFor(0, n[1] * n[2], 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const float* from = field.Distance.data() + field.Grid.Index(0, line % n[1], line / n[1]);
        std::transform(from, from + n[0], inner.data() + n[0] * line,
          [h](float value) { return h * value; });
      }
    });
  return inner;
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
  Chronicle chronicle(result.History);
  FlowField field = parameters.Steady
    ? SteadyField(balls, parameters, pull, chronicle, result.Rests, Between(progress, 0.0, 0.95))
    : StartField(balls, parameters, 1.0, parameters.Enlargement, pull, Between(progress, 0.0, 0.3));
  if (!parameters.Steady)
  {
    RunForTime(field, parameters.EvolutionTime, chronicle, Between(progress, 0.3, 0.95));
  }
  Redistance(field, FinalIterations, true);
  Advance(field, 0.0);
  result.Band = static_cast<double>(FlowGrid::Band) * parameters.Spacing;
  result.Distance = InnerDistances(field);
  Report(progress, 1.0);
  return result;
}

}
