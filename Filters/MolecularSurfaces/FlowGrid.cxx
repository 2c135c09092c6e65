#include "MolecularSurfaces/FlowGrid.h"

namespace isthmus
{
namespace
{

std::int64_t RoundedUp(std::int64_t value, std::int64_t step)
{
  return (value + step - 1) / step * step;
}

}

FlowGrid::FlowGrid(const DensityGrid& inner)
  : InnerGrid(inner)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] = inner.Dimensions[axis] + 2 * Margin[axis];
  }
  this->Size[0] = RoundedUp(this->Size[0], Chunk);
}

std::array<double, 3> FlowGrid::Origin() const
{
  std::array<double, 3> origin = this->InnerGrid.Origin;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    origin[axis] -= this->InnerGrid.Spacing * static_cast<double>(Margin[axis]);
  }
  return origin;
}

double FlowGrid::NodesFor(const std::array<std::int64_t, 3>& inner)
{
  double nodes = static_cast<double>(RoundedUp(inner[0] + 2 * Margin[0], Chunk));
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    nodes *= static_cast<double>(inner[axis] + 2 * Margin[axis]);
  }
  return nodes;
}

FlowField::FlowField(const FlowGrid& grid)
  : Grid(grid)
  , Distance(static_cast<std::size_t>(grid.NumberOfNodes()), FlowGrid::Band)
  , Next(this->Distance)
  , Ceiling(this->Distance)
  , Free(this->Distance.size(), 1)
  , Near(this->Distance.size() / static_cast<std::size_t>(FlowGrid::Chunk), 0)
{
}

}
