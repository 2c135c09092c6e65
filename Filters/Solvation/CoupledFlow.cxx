#include "Solvation/CoupledFlow.h"

#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/LevelMeasure.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double Lambda = 0.16;          // dt / spacing^2
constexpr float MostPull = 0.4F / 0.16F; // a step moves the surface by at most 0.4 spacings
constexpr int StepsToRedistance = 4;
constexpr int StepsToMeasure = 8;
constexpr double Rest = 1e-5; // relative change of the volume in StepsToMeasure

}

void RestoreDistances(FlowField& field)
{
  constexpr int iterations = 10;
  Redistance(field, iterations, true);
  Advance(field, 0.0);
}

double EvolveForPeriod(FlowField& field, const UpdatePolicy& policy)
{
  const double h = field.Grid.Spacing();
  const double alpha = policy.SurfaceRelaxation;
  const std::vector<float> before = alpha < 1.0 ? field.Distance : std::vector<float>();
  double volume = MeasureLevel(field).Volume;
  int steps = 0;
  for (int step = 1; step <= policy.UpdatePeriod; ++step)
  {
    Advance(field, Lambda);
    ++steps;
    if (step % StepsToRedistance == 0)
    {
      Redistance(field, 2);
    }
    if (policy.AdaptiveUpdate && step % StepsToMeasure == 0)
    {
      const double last = std::exchange(volume, MeasureLevel(field).Volume);
      if (std::abs(volume - last) < Rest * volume)
      {
        break;
      }
    }
  }
  // Redistancing moves the surface slightly off the obstacle; all policies end with the same steps
  // after it.
  for (int step = 1; step < StepsToRedistance; ++step)
  {
    Advance(field, Lambda);
    ++steps;
  }
  if (!before.empty())
  {
    const auto part = static_cast<float>(alpha);
    for (std::size_t n = 0; n < before.size(); ++n)
    {
      field.Distance[n] = part * field.Distance[n] + (1.0F - part) * before[n];
    }
    FindBand(field);
  }
  RestoreDistances(field);
  return Lambda * h * h * steps;
}

double FractionOnObstacle(const FlowField& field)
{
  constexpr float near = 0.5F;
  constexpr float touching = 0.05F;
  double all = 0.0;
  double held = 0.0;
  for (std::size_t n = 0; n < field.Distance.size(); ++n)
  {
    if (std::abs(field.Distance[n]) < near)
    {
      all += 1.0;
      held += field.Distance[n] > field.Ceiling[n] - touching ? 1.0 : 0.0;
    }
  }
  return all > 0.0 ? held / all : 0.0;
}

void LimitPull(std::vector<float>& pull)
{
  for (float& value : pull)
  {
    value = std::clamp(value, -MostPull, MostPull);
  }
}

void UpdatePull(FlowField& field, const std::vector<float>& steady, const std::vector<float>& more,
  double scale, double part)
{
  const auto of = static_cast<float>(scale);
  const auto taken = static_cast<float>(part);
  for (std::size_t n = 0; n < more.size(); ++n)
  {
    const float wanted = std::clamp(steady[n] + of * more[n], -MostPull, MostPull);
    field.Pull[n] = taken * wanted + (1.0F - taken) * field.Pull[n];
  }
}

namespace
{

/// Nodes with a known value, the layers derived from them, and partial sums.
class Layers
{
public:
  explicit Layers(const FlowGrid& grid)
    : Grid(grid)
    , Values(static_cast<std::size_t>(grid.NumberOfNodes()), 0.0F)
    , Counts(this->Values.size(), 0)
  {
  }

  void Add(std::int64_t node, float value)
  {
    const auto n = static_cast<std::size_t>(node);
    if (this->Counts[n] == 0)
    {
      this->Front.push_back(node);
    }
    this->Values[n] += value;
    ++this->Counts[n];
  }

  std::vector<float> PropagateValues()
  {
    while (!this->Front.empty())
    {
      for (const std::int64_t node : this->Front)
      {
        const auto n = static_cast<std::size_t>(node);
        this->Values[n] /= static_cast<float>(this->Counts[n]);
        this->Counts[n] = Done;
      }
      const std::vector<std::int64_t> from = std::move(this->Front);
      this->Front.clear();
      for (const std::int64_t node : from)
      {
        this->PassOn(node);
      }
    }
    return std::move(this->Values);
  }

private:
  static constexpr unsigned char Done = 255;

  void PassOn(std::int64_t node)
  {
    const auto& n = this->Grid.Dimensions();
    const std::int64_t steps[3] = { 1, this->Grid.Row(), this->Grid.Plane() };
    const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / this->Grid.Plane() };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const std::int64_t side : { -1, 1 })
      {
        if (at[axis] + side < 0 || at[axis] + side >= n[axis])
        {
          continue;
        }
        const std::int64_t next = node + side * steps[axis];
        if (this->Counts[static_cast<std::size_t>(next)] != Done)
        {
          this->Add(next, this->Values[static_cast<std::size_t>(node)]);
        }
      }
    }
  }

  const FlowGrid& Grid;
  std::vector<float> Values;
  std::vector<unsigned char> Counts; ///< at most 6, or Done
  std::vector<std::int64_t> Front;
};

}

std::vector<float> ExtendOffSurface(const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const std::vector<double>& values,
  const FlowGrid& grid)
{
  const auto& n = box.Dimensions;
  const auto nodeOf = [&](std::int64_t node)
  {
    return grid.Index(box.First[0] + node % n[0], box.First[1] + node / n[0] % n[1],
      box.First[2] + node / (n[0] * n[1]));
  };
  Layers layers(grid);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const InterfaceCrossing& crossing = crossings[i];
    const std::int64_t next = crossing.Node + box.Steps()[static_cast<std::size_t>(crossing.Axis)];
    layers.Add(nodeOf(crossing.Node), static_cast<float>(values[i]));
    layers.Add(nodeOf(next), static_cast<float>(values[i]));
  }
  return layers.PropagateValues();
}

}
