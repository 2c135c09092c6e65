#include "MolecularSurfaces/ThesisFlow.h"

#include "Core/ParallelFor.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

constexpr double ThesisLambda = 0.1;     // dt / spacing^2, without the thesis' stability condition
constexpr int ThesisStepsToMeasure = 50; // between two measures
constexpr int ThesisMostSteps = 5000;    // when Steady
constexpr double ThesisRest = 1e-5;      // relative change of the volume in ThesisStepsToMeasure
constexpr float Half = 0.5F;             // the field is 1/2 - S, negative inside as distances are
constexpr float SpacingsToS = 2.4F;      // S changes by 1 in this distance, as in the filter's S

/// All nodes but the border's and the margin's run; those of the balls are held at S = 1.
FlowField ThesisField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  const ProgressCallback& progress)
{
  FlowField field(FlowGrid(FlowGridAround(balls, parameters)));
  const double band = static_cast<double>(FlowGrid::Band);
  DistanceToBalls(field.Grid, balls, 1.0, 0.0, band, field.Ceiling, Between(progress, 0.0, 0.5));
  CheckGridResolvesAtoms(field, balls, parameters);
  DistanceToBalls(field.Grid, balls, parameters.Enlargement, 0.0, band, field.Distance,
    Between(progress, 0.5, 1.0));
  field.Floor.resize(field.Distance.size());
  for (std::size_t node = 0; node < field.Distance.size(); ++node)
  {
    const bool held = field.Ceiling[node] <= 0.0F;
    field.Ceiling[node] = held ? -Half : FlowGrid::Band;
    field.Floor[node] = held ? -Half : -FlowGrid::Band;
    field.Distance[node] = field.Distance[node] <= 0.0F ? -Half : Half;
  }
  field.Next = field.Distance;
  const auto& n = field.Grid.Inner().Dimensions;
  for (std::int64_t k = 0; k < n[2]; ++k)
  {
    for (std::int64_t j = 0; j < n[1]; ++j)
    {
      const bool border = j == 0 || k == 0 || j == n[1] - 1 || k == n[2] - 1;
      const std::int64_t first = field.Grid.Index(0, j, k);
      for (std::int64_t i = 0; i < n[0]; ++i)
      {
        if (border || i == 0 || i == n[0] - 1)
        {
          field.Floor[static_cast<std::size_t>(first + i)] = Half;
        }
      }
      field.Runs.push_back({ first, n[0] });
    }
  }
  return field;
}

}

SurfaceFlowResult ThesisFlow(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const ProgressCallback& progress)
{
  constexpr int iterations = 10;
  SurfaceFlowResult result;
  CheckFlow(balls, parameters);
  if (balls.empty())
  {
    return result;
  }
  CheckFlowMemory(balls, FlowGridAround(balls, parameters));
  FlowField field = ThesisField(balls, parameters, Between(progress, 0.0, 0.1));
  const double h = parameters.Spacing;
  const double wanted = std::ceil(parameters.EvolutionTime / (ThesisLambda * h * h));
  const int steps =
    parameters.Steady ? ThesisMostSteps : static_cast<int>(std::min<double>(wanted, 1e7));
  const double dt =
    parameters.Steady ? ThesisLambda * h * h : (steps > 0 ? parameters.EvolutionTime / steps : 0.0);
  RecordMeasures(field, 0.0, result);
  bool converged = false;
  for (int step = 1; step <= steps && !(converged && parameters.Steady); ++step)
  {
    Advance(field, dt / (h * h));
    if (step % ThesisStepsToMeasure == 0 || step == steps)
    {
      const double before = result.History.back().Volume;
      RecordMeasures(field, dt * step, result);
      converged = std::abs(result.History.back().Volume - before) < ThesisRest * before;
    }
    Report(progress, 0.1 + 0.8 * step / (parameters.Steady ? step + 300.0 : steps));
  }
  result.Converged = converged || !parameters.Steady;
  result.S = InnerValues(field.Grid, field.Distance, -1.0F, Half);
  // Where S is 0 or 1 it does not determine a distance: such nodes lie beyond the band, like the
  // whole margin.
  std::for_each(field.Distance.begin(), field.Distance.end(),
    [](float& value) {
      value = std::abs(value) < Half ? value * SpacingsToS : std::copysign(FlowGrid::Band, value);
    });
  field.Next = field.Distance;
  FindBand(field);
  Redistance(field, iterations);
  StoreDistances(field, result);
  Report(progress, 1.0);
  return result;
}

}
