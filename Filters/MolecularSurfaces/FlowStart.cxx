#include "MolecularSurfaces/FlowStart.h"

#include "Core/ParallelFor.h"
#include "Core/RangeGuard.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowBand.h"
#include "MolecularSurfaces/FlowSteps.h"
#include "MolecularSurfaces/SolventExcludedDistance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// The surface keeps this distance from the border, in spacings, so that it is closed.
constexpr double LeastPadding = 2.0;

void CheckNumber(const char* name, double value, double least, bool allowed, const char* what)
{
  if (!(value > least || (allowed && value == least)) || !std::isfinite(value))
  {
    throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) +
      ", but it is " + what + ": give a number " + (allowed ? "of at least " : "above ") +
      std::to_string(static_cast<int>(least)) + ".");
  }
}

std::vector<Ball> Enlarged(const std::vector<Ball>& balls, double factor)
{
  std::vector<Ball> larger = balls;
  std::for_each(larger.begin(), larger.end(), [=](Ball& ball) { ball.Radius *= factor; });
  return larger;
}

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

/// Where along a coarse axis each fine node lies: the node below and the part of the way.
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

void CheckFlow(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
{
  CheckNumber("Spacing", parameters.Spacing, 0.0, false, "the distance of nodes");
  CheckNumber("Enlargement", parameters.Enlargement, 1.0, true,
    "the factor of the radii that the flow starts from");
  CheckNumber("EvolutionTime", parameters.EvolutionTime, 0.0, true,
    "how long the flow goes on, in square angstrom");
  CheckNumber("ProbeRadius", parameters.ProbeRadius, 0.0, true, "a radius, and 0 for none");
  CheckNumber("Padding", parameters.Padding, 0.0, true, "the room around the enlarged atoms");
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    const Ball& ball = balls[i];
    if (!std::isfinite(ball.Centre[0] + ball.Centre[1] + ball.Centre[2]) ||
      !std::isfinite(ball.Radius) || ball.Radius <= 0.0)
    {
      throw std::invalid_argument("Atom " + std::to_string(i) +
        " has a coordinate that is not finite, or a radius that is not a positive length: correct "
        "it or leave it out.");
    }
  }
}

void CheckAnythingInside(
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
      Shown(parameters.Spacing) + ", the largest radius " + Shown(largest) +
      ". Choose a Spacing below that.");
  }
}

DensityGrid FlowGridAround(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double factor)
{
  const double h = factor * parameters.Spacing;
  const double padding = std::max(parameters.Padding, LeastPadding * h);
  return GridAroundBalls(Enlarged(balls, parameters.Enlargement), h, { padding, padding, padding });
}

int CoarserLevels(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters)
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

FlowField StartField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  double factor, double enlargement, const PullField& pull, const ProgressCallback& progress)
{
  constexpr int iterations = 10; // by 0.45 spacings each, all through the band
  FlowField field(FlowGrid(FlowGridAround(balls, parameters, factor)));
  const double band = static_cast<double>(FlowGrid::Band);
  DistanceToBalls(field.Grid, balls, 1.0, 0.0, band, field.Ceiling, Between(progress, 0.0, 0.3));
  if (factor == 1.0)
  {
    CheckAnythingInside(field, balls, parameters);
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

void AddCoarse(const FlowField& coarse, FlowField& fine)
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
          to[i] = std::min(to[i], scale * between(low, high, z.Part[k]));
        }
      }
    });
  constexpr int iterations = 10;
  FindBand(fine);
  Redistance(fine, iterations);
  Advance(fine, 0.0);
}

}
