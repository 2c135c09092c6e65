#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// The surface has this distance from the border, in spacings, so that it is closed.
constexpr double LeastPadding = 2.0;

std::vector<Ball> EnlargeBalls(const std::vector<Ball>& balls, double factor)
{
  std::vector<Ball> larger = balls;
  std::for_each(larger.begin(), larger.end(), [=](Ball& ball) { ball.Radius *= factor; });
  return larger;
}

double Nodes(const DensityGrid& grid)
{
  const auto& n = grid.Dimensions;
  return static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
}

/// The median of the balls' coordinates along each axis.
std::array<double, 3> Middle(const std::vector<Ball>& balls)
{
  std::array<double, 3> middle{};
  std::vector<double> places(balls.size());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::transform(balls.begin(), balls.end(), places.begin(),
      [axis](const Ball& ball) { return ball.Center[axis]; });
    const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), half, places.end());
    middle[axis] = *half;
  }
  return middle;
}

/// A message about the outermost atom if it is ten times as far out as nine tenths of the atoms.
std::string OutlierText(const std::vector<Ball>& balls)
{
  const std::array<double, 3> middle = Middle(balls);
  std::vector<double> distances(balls.size());
  std::transform(balls.begin(), balls.end(), distances.begin(),
    [&middle](const Ball& ball)
    {
      return std::hypot(
        ball.Center[0] - middle[0], ball.Center[1] - middle[1], ball.Center[2] - middle[2]);
    });
  const auto farthest = std::max_element(distances.begin(), distances.end());
  const double far = *farthest;
  const auto atom = farthest - distances.begin();
  const auto most = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), most, distances.end());
  if (far < 10.0 * *most || balls.size() < 2)
  {
    return "";
  }
  return JoinText(
    " Atom ", atom, " lies ", far, " from the middle of the others: is this intended?");
}

}

void CheckFlow(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
{
  Check(parameters);
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const Ball& ball = balls[i];
    if (!std::isfinite(ball.Center[0] + ball.Center[1] + ball.Center[2]) ||
      !std::isfinite(ball.Radius) || ball.Radius <= 0.0)
    {
      throw std::invalid_argument("Atom " + std::to_string(i) +
        " has a coordinate that is not finite, or a radius that is not a positive length: correct "
        "or remove it.");
    }
  }
}

void CheckGridResolvesAtoms(
  const FlowField& field, const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
{
  if (std::all_of(
        field.Ceiling.begin(), field.Ceiling.end(), [](float value) { return value > 0.0F; }))
  {
    const double largest = std::max_element(balls.begin(), balls.end(),
      [](const Ball& a, const Ball& b) {
        return a.Radius < b.Radius;
      })->Radius;
    throw std::runtime_error("No node of the grid lies inside of an atom, so the surface vanishes: "
                             "the Spacing is " +
      FormatNumber(parameters.Spacing) + ", the largest radius " + FormatNumber(largest) +
      ". Choose a Spacing below that.");
  }
}

DensityGrid FlowGridAround(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double factor)
{
  const double h = factor * parameters.Spacing;
  const double padding = std::max(parameters.Padding, LeastPadding * h);
  return GridAroundBalls(
    EnlargeBalls(balls, parameters.Enlargement), h, { padding, padding, padding });
}

double FlowBytes(const DensityGrid& grid)
{
  // Distance, Next, Ceiling, Floor, Pull: 4 each; Free 1, Near 1/8; an eighth of it all once more
  // for the coarser grid. The result's distances, and with S once more in the output.
  constexpr double field = (5 * 4 + 1 + 0.125) * 1.125;
  constexpr double result = 3 * 4;
  return FlowGrid::NodesFor(grid.Dimensions) * field + Nodes(grid) * result;
}

void CheckFlowMemory(const std::vector<Ball>& balls, const DensityGrid& grid)
{
  const double needed = FlowBytes(grid);
  const MemoryBudget budget;
  if (budget.Allows(needed))
  {
    return;
  }
  const auto& n = grid.Dimensions;
  const std::string flow = JoinText("The flow on a grid of ", n[0], " x ", n[1], " x ", n[2],
    " nodes (Spacing ", grid.Spacing, ")");
  const std::string remedy = JoinText("choose a Spacing of about ",
    1.1 * grid.Spacing * std::cbrt(needed / std::max(budget.Bytes(), 1e6)), " or more");
  throw std::runtime_error(budget.Message(needed, flow, remedy) + OutlierText(balls));
}

std::vector<float> InnerValues(
  const FlowGrid& grid, const std::vector<float>& values, float factor, float shift)
{
  const auto& n = grid.Inner().Dimensions;
  std::vector<float> inner(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  ParallelFor(0, n[1] * n[2], 256,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t line = first; line < last; ++line)
      {
        const float* from = values.data() + grid.Index(0, line % n[1], line / n[1]);
        std::transform(from, from + n[0], inner.data() + n[0] * line,
          [=](float value) { return factor * value + shift; });
      }
    });
  return inner;
}

void StoreDistances(const FlowField& field, SurfaceFlowResult& result)
{
  const double h = field.Grid.Spacing();
  result.Grid = field.Grid.Inner();
  result.Band = static_cast<double>(FlowGrid::Band) * h;
  result.Distance = InnerValues(field.Grid, field.Distance, static_cast<float>(h), 0.0F);
}

void RecordMeasures(const FlowField& field, double time, SurfaceFlowResult& result)
{
  const LevelMeasure measure = MeasureLevel(field);
  result.History.push_back({ time, field.Grid.Spacing(), measure.Area, measure.Volume });
}

}
