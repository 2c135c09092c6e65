#include "MolecularSurfaces/FlowField.h"

#include "MolecularSurfaces/FlowKernels.h"

#include <algorithm>
#include <cmath>
#include <utility>

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
  // Rows of whole chunks, so that loops over chunks have no remainder.
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

namespace
{

enum : unsigned char
{
  HasNear = 1,
  FirstIsNear = 2,
  LastIsNear = 4
};

/// Clamps the distances of a chunk, copies them to Next, and returns which part of it lies in the
/// band.
unsigned char ClampChunk(float* distance, float* next)
{
  bool any = false;
  for (std::int64_t i = 0; i < FlowGrid::Chunk; ++i)
  {
    const float value = std::clamp(distance[i], -FlowGrid::Band, FlowGrid::Band);
    distance[i] = value;
    next[i] = value;
    any = any || std::abs(value) < FlowGrid::Band;
  }
  const bool first = std::abs(distance[0]) < FlowGrid::Band;
  const bool last = std::abs(distance[FlowGrid::Chunk - 1]) < FlowGrid::Band;
  return static_cast<unsigned char>(
    (any ? HasNear : 0) | (first ? FirstIsNear : 0) | (last ? LastIsNear : 0));
}

void ClampRange(FlowField& field, std::int64_t first, std::int64_t last)
{
  for (std::int64_t node = first; node < last; node += FlowGrid::Chunk)
  {
    field.Near[static_cast<std::size_t>(node / FlowGrid::Chunk)] =
      ClampChunk(field.Distance.data() + node, field.Next.data() + node);
  }
}

/// Redistancing stencils have this radius, so that rows and planes at the border are never in a
/// run.
constexpr std::int64_t Reach = 2;

/// The runs of one plane: its chunks that are near, or next to a node that is.
void FindPlaneRuns(const FlowField& field, std::int64_t plane, std::vector<ChunkRun>& runs)
{
  const std::int64_t row = field.Grid.Row() / FlowGrid::Chunk;
  const std::int64_t rows = field.Grid.Dimensions()[1];
  const std::int64_t planeChunks = row * rows;
  for (std::int64_t j = Reach; j + Reach < rows; ++j)
  {
    const unsigned char* near = field.Near.data() + planeChunks * plane + row * j;
    for (std::int64_t c = 0; c < row; ++c)
    {
      const bool active = (near[c] | near[c - row] | near[c + row] | near[c - planeChunks] |
                            near[c + planeChunks]) != 0 ||
        (c > 0 && (near[c - 1] & LastIsNear) != 0) ||
        (c + 1 < row && (near[c + 1] & FirstIsNear) != 0);
      if (!active)
      {
        continue;
      }
      const std::int64_t node = FlowGrid::Chunk * (planeChunks * plane + row * j + c);
      if (!runs.empty() && c > 0 && runs.back().First + runs.back().Nodes == node)
      {
        runs.back().Nodes += FlowGrid::Chunk;
      }
      else
      {
        runs.push_back({ node, FlowGrid::Chunk });
      }
    }
  }
}

void GatherRuns(FlowField& field)
{
  const std::int64_t planes = field.Grid.Dimensions()[2];
  std::vector<std::vector<ChunkRun>> ofPlane(static_cast<std::size_t>(planes));
  ParallelFor(Reach, planes - Reach, 16,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        FindPlaneRuns(field, k, ofPlane[static_cast<std::size_t>(k)]);
      }
    });
  field.Runs.clear();
  for (const std::vector<ChunkRun>& runs : ofPlane)
  {
    field.Runs.insert(field.Runs.end(), runs.begin(), runs.end());
  }
}

}

void FindBand(FlowField& field)
{
  ParallelFor(0, field.Grid.NumberOfNodes() / FlowGrid::Chunk, 1 << 14,
    [&](std::int64_t first, std::int64_t last)
    { ClampRange(field, FlowGrid::Chunk * first, FlowGrid::Chunk * last); });
  GatherRuns(field);
}

void MoveBand(FlowField& field)
{
  ForEachRun(field, [&](std::int64_t first, std::int64_t last) { ClampRange(field, first, last); });
  GatherRuns(field);
}

void Advance(FlowField& field, double lambda)
{
  const FlowStep step{ field.Distance.data(), field.Next.data(), field.Ceiling.data(),
    field.Floor.empty() ? nullptr : field.Floor.data(),
    field.Pull.empty() ? nullptr : field.Pull.data(), static_cast<float>(lambda) };
  const FlowStrides strides{ field.Grid.Row(), field.Grid.Plane() };
  ForEachRun(
    field, [&](std::int64_t first, std::int64_t last) { AdvanceRow(step, strides, first, last); });
  std::swap(field.Distance, field.Next);
}

void Redistance(FlowField& field, int iterations, bool trusted)
{
  const FlowStrides strides{ field.Grid.Row(), field.Grid.Plane() };
  ForEachRun(field,
    [&](std::int64_t first, std::int64_t last)
    {
      HoldSurfaceRow(
        field.Distance.data(), field.Next.data(), field.Free.data(), trusted, strides, first, last);
    });
  std::swap(field.Distance, field.Next);
  for (int i = 0; i < iterations; ++i)
  {
    ForEachRun(field,
      [&](std::int64_t first, std::int64_t last)
      {
        RedistanceRow(
          field.Distance.data(), field.Next.data(), field.Free.data(), strides, first, last);
      });
    std::swap(field.Distance, field.Next);
  }
  MoveBand(field);
}

}
