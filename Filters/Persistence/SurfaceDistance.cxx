#include "Persistence/SurfaceDistance.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/TriangleTree.h"

namespace isthmus
{

std::vector<double> SurfaceDistances(
  const SurfaceView& surface, const std::vector<Point3>& points, const ProgressCallback& progress)
{
  const TriangleTree tree(surface);
  constexpr std::size_t Block =
    256; // each starts without a guess, so results are identical on any number of threads
  std::vector<double> distance(points.size());
  ParallelFor(
    0, static_cast<std::int64_t>((points.size() + Block - 1) / Block), 4,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto block = static_cast<std::size_t>(begin); block < static_cast<std::size_t>(end);
           ++block)
      {
        TriangleTree::Nearest nearest{ 0.0, -1 };
        const std::size_t last = std::min(points.size(), (block + 1) * Block);
        for (std::size_t i = block * Block; i < last; ++i)
        {
          nearest = tree.Find(points[i], nearest.Guess);
          distance[i] = std::sqrt(nearest.Squared);
        }
      }
    },
    progress);
  return distance;
}

double DistanceGrid::At(const Point3& p) const
{
  std::array<std::int64_t, 3> cell;
  Point3 u;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double x = (p[a] - this->Origin[a]) / this->Spacing;
    cell[a] = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(std::floor(x)), 0, this->Dimensions[a] - 2);
    u[a] = std::clamp(x - static_cast<double>(cell[a]), 0.0, 1.0);
  }
  double value = 0.0;
  for (std::int64_t c = 0; c < 8; ++c)
  {
    const std::int64_t i = c & 1;
    const std::int64_t j = (c >> 1) & 1;
    const std::int64_t k = c >> 2;
    const double weight =
      (i ? u[0] : 1.0 - u[0]) * (j ? u[1] : 1.0 - u[1]) * (k ? u[2] : 1.0 - u[2]);
    value += weight *
      this->Values[static_cast<std::size_t>(
        cell[0] + i + this->Dimensions[0] * (cell[1] + j + this->Dimensions[1] * (cell[2] + k)))];
  }
  return value;
}

DistanceGrid ComputeDistanceGrid(const SurfaceView& surface, const Bounds3& box, std::int64_t cells,
  const ProgressCallback& progress)
{
  DistanceGrid grid;
  grid.Origin = box.Min;
  const Point3 size = box.Max - box.Min;
  grid.Spacing = std::max({ size[0], size[1], size[2] }) / static_cast<double>(cells);
  for (std::size_t a = 0; a < 3; ++a)
  {
    grid.Dimensions[a] = static_cast<std::int64_t>(std::ceil(size[a] / grid.Spacing - 1e-9)) + 1;
    grid.Dimensions[a] = std::max<std::int64_t>(grid.Dimensions[a], 2);
  }
  const std::vector<Point3> points = TranslatedPoints(grid.Origin, surface);
  grid.Values = DistanceToSurface(
    { points, surface.Triangles }, GetGridShape(grid), 2.0 * grid.Spacing, progress);
  return grid;
}

}
