#include "MolecularSurfaces/SurfaceFlow.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

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

/// a <- the greater (or lesser) of a and b at each node.
template <typename Choose>
void Combine(std::vector<float>& a, const std::vector<float>& b, Choose choose)
{
  ParallelFor(0, static_cast<std::int64_t>(a.size()), 1 << 18,
    [&](std::int64_t first, std::int64_t last) {
      std::transform(a.data() + first, a.data() + last, b.data() + first, a.data() + first, choose);
    });
}

float Lower(float a, float b)
{
  return std::min(a, b);
}

float Higher(float a, float b)
{
  return std::max(a, b);
}

/// The position of each fine node along a coarse axis: the node below and the fraction.
struct AxisPlaces
{
  AxisPlaces(const FlowGrid& coarse, const FlowGrid& fine, std::size_t axis)
  {
    const auto nodes = static_cast<std::size_t>(fine.Dimensions()[axis]);
    const auto last = static_cast<double>(coarse.Dimensions()[axis] - 2);
    const double offset = fine.Origin()[axis] - coarse.Origin()[axis];
    for (std::size_t i = 0; i < nodes; ++i)
    {
      const double at = (offset + fine.Spacing() * static_cast<double>(i)) / coarse.Spacing();
      const double below = std::clamp(std::floor(at), 0.0, last);
      this->Below.push_back(static_cast<std::int64_t>(below));
      this->Part.push_back(static_cast<float>(std::clamp(at - below, 0.0, 1.0)));
    }
  }
  std::vector<std::int64_t> Below;
  std::vector<float> Part;
};

}

FlowField StartField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  double factor, double enlargement, const PullField& pull, const ProgressCallback& progress)
{
  constexpr int iterations = 10; // by 0.45 spacings each, all through the band
  FlowField field(FlowGrid(FlowGridAround(balls, parameters, factor)));
  const double band = static_cast<double>(FlowGrid::Band);
  DistanceToBalls(field.Grid, balls, 1.0, 0.0, band, field.Ceiling, Between(progress, 0.0, 0.3));
  if (factor == 1.0)
  {
    CheckGridResolvesAtoms(field, balls, parameters);
  }
  DistanceToBalls(
    field.Grid, balls, enlargement, 0.0, band, field.Distance, Between(progress, 0.3, 0.6));
  if (parameters.ProbeRadius > 0.0)
  {
    field.Floor.resize(field.Distance.size());
    SolventExcludedDistance(
      field.Grid, balls, parameters.ProbeRadius, field.Floor, Between(progress, 0.6, 0.9));
    Combine(field.Floor, field.Ceiling, Lower); // rounding must not cross them
    Combine(field.Distance, field.Floor, Higher);
  }
  if (pull)
  {
    field.Pull.assign(field.Distance.size(), 0.0F);
    pull(field.Grid, field.Pull);
    const auto h = static_cast<float>(field.Grid.Spacing());
    std::for_each(field.Pull.begin(), field.Pull.end(), [h](float& value) { value *= h; });
  }
  FindBand(field);
  Redistance(field, iterations, true);
  Advance(field, 0.0); // back between the bounds
  Report(progress, 1.0);
  return field;
}

namespace
{

/// The number of times that the spacing can be doubled until the grid no longer resolves the atoms:
/// a coarse cell is at most twice a mean radius wide, and 16 of them go along the grid's shortest
/// side.
int NumberOfCoarserLevels(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
{
  constexpr double leastNodes = 16.0;
  constexpr double widestInRadii = 2.0;
  double sum = 0.0;
  for (const Ball& ball : balls)
  {
    sum += ball.Radius;
  }
  const double mean = sum / static_cast<double>(balls.size());
  const auto& n = FlowGridAround(balls, parameters).Dimensions;
  const double byNodes = static_cast<double>(*std::min_element(n.begin(), n.end())) / leastNodes;
  const double byRadius = widestInRadii * mean / parameters.Spacing;
  const double most = std::min(byNodes, byRadius);
  return most < 1.0 ? 0 : static_cast<int>(std::floor(std::log2(most)));
}

/// Makes the inside of `fine` the union of its own and that of `coarse`, whose distances are
/// interpolated linearly along each axis.
void AddCoarseField(const FlowField& coarse, FlowField& fine)
{
  const AxisPlaces x(coarse.Grid, fine.Grid, 0);
  const AxisPlaces y(coarse.Grid, fine.Grid, 1);
  const AxisPlaces z(coarse.Grid, fine.Grid, 2);
  const auto n = fine.Grid.Dimensions();
  const std::int64_t row = coarse.Grid.Row();
  const std::int64_t plane = coarse.Grid.Plane();
  const auto scale = static_cast<float>(coarse.Grid.Spacing() / fine.Grid.Spacing());
  const auto between = [](float a, float b, float t) { return a + t * (b - a); };
  ParallelFor(0, n[1] * n[2], 64,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const auto j = static_cast<std::size_t>(line % n[1]);
        const auto k = static_cast<std::size_t>(line / n[1]);
        const float* from = coarse.Distance.data() + row * y.Below[j] + plane * z.Below[k];
        float* to = fine.Distance.data() + n[0] * line;
        for (std::size_t i = 0; i < static_cast<std::size_t>(n[0]); ++i)
        {
          const float* at = from + x.Below[i];
          const float t = x.Part[i];
          const float low =
            between(between(at[0], at[1], t), between(at[row], at[row + 1], t), y.Part[j]);
          const float high = between(between(at[plane], at[plane + 1], t),
            between(at[plane + row], at[plane + row + 1], t), y.Part[j]);
          // The union with the start, since coarse nodes miss small atoms.
          to[i] = std::min(to[i], scale * between(low, high, z.Part[k]));
        }
      }
    });
  constexpr int iterations = 10;
  FindBand(fine);
  Redistance(fine, iterations);
  Advance(fine, 0.0);
}

constexpr double Lambda = 0.16;      // dt / spacing^2; 0.25 is where it becomes unstable
constexpr int StepsToRedistance = 4; // see the README: with a longer period, necks break too early
constexpr int RedistanceIterations = 2; // by 0.45 spacings each
constexpr int FinalIterations = 10;     // through the whole band
constexpr int StepsToMeasure = 48;      // between two measures, a multiple of the above
constexpr double Rest = 1e-5;           // relative change of the volume in StepsToMeasure
constexpr int MostSteps = 20000;        // on one grid, or on the coarsest of several
constexpr int FinerSteps =
  4 * StepsToMeasure;              // at least, on finer grids, where only details remain
constexpr double Slow = 1.5e-4;    // relative change of the volume in a square angstrom
constexpr double StartAgain = 1.3; // enlargement of the atoms added on finer levels

/// The time of a running flow, and the record of its measures.
struct FlowHistory
{
  const FlowRecord& Measure(const FlowField& field)
  {
    RecordMeasures(field, this->Time, this->Result);
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
  FlowField& field, double time, FlowHistory& history, const ProgressCallback& progress)
{
  constexpr int measures = 40;
  const double h = field.Grid.Spacing();
  const double wanted = std::ceil(time / (Lambda * h * h));
  if (wanted > 1e7)
  {
    throw std::invalid_argument("EvolutionTime is " + FormatNumber(time) +
      " square angstrom, which takes more than ten million steps: choose Steady.");
  }
  const int steps = static_cast<int>(wanted);
  const double dt = steps > 0 ? time / steps : 0.0;
  // Right after redistancing, since the volume oscillates slightly in between.
  const int between = StepsToRedistance * std::max(1, steps / (measures * StepsToRedistance));
  history.Measure(field);
  for (int step = 1; step <= steps; ++step)
  {
    Step(field, step, dt / (h * h));
    history.Time += dt;
    if (step % between == 0 || step == steps)
    {
      history.Measure(field);
    }
    Report(progress, static_cast<double>(step) / steps);
  }
}

/// The volumes at the last measures, and whether they have converged.
class Trend
{
public:
  void Add(double volume) { this->Volumes.push_back(volume); }

  /// Relative change since the measure before.
  double Change() const
  {
    const std::size_t n = this->Volumes.size();
    return n < 2 ? 1.0 : std::abs(this->Volumes[n - 1] / this->Volumes[n - 2] - 1.0);
  }

  /// By two measures, since the volume may pass through a turning point; or by the means of four
  /// and the four before, since small surfaces can oscillate forever.
  bool HasConverged() const
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

/// Runs until the volume has converged, or from `enough` steps on until it changes slowly. Returns
/// whether either happened within MostSteps.
bool RunToConvergence(
  FlowField& field, int enough, FlowHistory& history, const ProgressCallback& progress)
{
  const double dt = Lambda * field.Grid.Spacing() * field.Grid.Spacing();
  Trend trend;
  trend.Add(history.Measure(field).Volume);
  for (int step = 1; step <= MostSteps; ++step)
  {
    Step(field, step, Lambda);
    history.Time += dt;
    // The number of steps is unknown, so progress slows down: half after 200 steps.
    Report(progress, step / (step + 200.0));
    if (step % StepsToMeasure == 0)
    {
      trend.Add(history.Measure(field).Volume);
      if (trend.HasConverged() || (step >= enough && trend.Change() < Slow * dt * StepsToMeasure))
      {
        return true;
      }
    }
  }
  return false;
}

FlowField SteadyField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const PullField& pull, FlowHistory& history, const ProgressCallback& progress)
{
  // With a probe, flows are short; with a pull, coarse grids do not resolve it.
  const bool coarse = parameters.CoarseToFine && parameters.ProbeRadius == 0.0 && !pull;
  const int levels = coarse ? NumberOfCoarserLevels(balls, parameters) : 0;
  const auto part = [&](int level) { return static_cast<double>(level) / (levels + 1); };
  FlowField field = StartField(balls, parameters, std::pow(2.0, levels), parameters.Enlargement,
    pull, Between(progress, 0.0, 0.3 * part(1)));
  bool converged =
    RunToConvergence(field, MostSteps, history, Between(progress, 0.3 * part(1), part(1)));
  for (int level = levels - 1; level >= 0; --level)
  {
    const int done = levels - level;
    const double third = part(done) + 0.3 * (part(done + 1) - part(done));
    FlowField finer = StartField(balls, parameters, std::pow(2.0, level),
      std::min(parameters.Enlargement, StartAgain), pull, Between(progress, part(done), third));
    AddCoarseField(field, finer);
    field = std::move(finer);
    converged =
      RunToConvergence(field, FinerSteps, history, Between(progress, third, part(done + 1)));
  }
  history.Result.Converged = converged;
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
  FlowHistory history{ result };
  FlowField field = parameters.Steady
    ? SteadyField(balls, parameters, pull, history, Between(progress, 0.0, 0.95))
    : StartField(balls, parameters, 1.0, parameters.Enlargement, pull, Between(progress, 0.0, 0.3));
  if (!parameters.Steady)
  {
    RunForTime(field, parameters.EvolutionTime, history, Between(progress, 0.3, 0.95));
  }
  Redistance(field, FinalIterations, true);
  Advance(field, 0.0);
  StoreDistances(field, result);
  Report(progress, 1.0);
  return result;
}

}
