#include "Surfaces/GridDistance.h"

#include "Core/ParallelFor.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Nodes in blocks, whose nearest triangles lie together in the tree and in the caches.
class ExactField
{
public:
  ExactField(const SurfaceView& mesh, const GridShape& grid)
    : Tree(mesh)
    , Grid(grid)
    , Distance(static_cast<std::size_t>(grid.Size()))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Blocks[axis] = (grid.Dimensions[axis] + Side - 1) / Side;
    }
  }

  std::vector<double> Run(const ProgressCallback& progress)
  {
    ParallelFor(
      0, this->Blocks[0] * this->Blocks[1] * this->Blocks[2], 4,
      [this](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t block = first; block < last; ++block)
        {
          const std::int64_t row = block / this->Blocks[0];
          this->FillBlock({ Side * (block % this->Blocks[0]), Side * (row % this->Blocks[1]),
            Side * (row / this->Blocks[1]) });
        }
      },
      progress);
    return std::move(this->Distance);
  }

private:
  static constexpr std::int64_t Side = 8;

  /// To and fro along its lines, each node with the answer of its neighbour as a guess; anew in
  /// each block, so that the bits do not depend on the pieces.
  void FillBlock(const std::array<std::int64_t, 3>& low)
  {
    const auto& n = this->Grid.Dimensions;
    std::int64_t guess = -1;
    for (std::int64_t k = low[2]; k < std::min(low[2] + Side, n[2]); ++k)
    {
      for (std::int64_t j = low[1]; j < std::min(low[1] + Side, n[1]); ++j)
      {
        const std::int64_t count = std::min(Side, n[0] - low[0]);
        for (std::int64_t step = 0; step < count; ++step)
        {
          const std::int64_t i = low[0] + (j % 2 == 0 ? step : count - 1 - step);
          const Point3 node{ static_cast<double>(i) * this->Grid.Spacing[0],
            static_cast<double>(j) * this->Grid.Spacing[1],
            static_cast<double>(k) * this->Grid.Spacing[2] };
          const TriangleTree::Nearest nearest = this->Tree.Find(node, guess);
          guess = nearest.Guess;
          this->Distance[static_cast<std::size_t>((k * n[1] + j) * n[0] + i)] =
            std::sqrt(nearest.Squared);
        }
      }
    }
  }

  const TriangleTree Tree;
  const GridShape& Grid;
  std::array<std::int64_t, 3> Blocks;
  std::vector<double> Distance;
};

}

std::vector<double> ExactDistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, const ProgressCallback& progress)
{
  ExactField field(mesh, grid);
  Report(progress, 0.1);
  return field.Run(Between(progress, 0.1, 1.0));
}

}
