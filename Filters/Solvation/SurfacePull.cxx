#include "Solvation/SurfacePull.h"

namespace isthmus
{
namespace
{

/// Nodes that have a value, the layers that follow from them, and the sums on the way.
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

  std::vector<float> Carried()
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
        this->Hand(node);
      }
    }
    return std::move(this->Values);
  }

private:
  static constexpr unsigned char Done = 255;

  void Hand(std::int64_t node)
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

std::vector<float> CarriedOff(const SolverBox& box, const std::vector<InterfaceCrossing>& crossings,
  const std::vector<double>& values, const FlowGrid& grid)
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
  return layers.Carried();
}

}
