#include "Persistence/SurfaceDistance.h"

#include "Core/Geometry.h"
#include "Core/ParallelFor.h"
#include "Persistence/EdgeDistances.h"
#include "Persistence/FastMarching.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/TriangleTree.h"

namespace isthmus
{

std::vector<double> SurfaceDistances(
  const SurfaceView& surface, const std::vector<Point3>& points, const ProgressCallback& progress)
{
  const TriangleTree tree(surface);
  constexpr std::size_t Block =
    256; // each starts without a guess: identical on any number of threads
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

DistanceGrid GridOfDistances(const SurfaceView& surface, const Bounds3& box, std::int64_t cells,
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
  const std::vector<Point3> points = PointsFrom(grid.Origin, surface);
  grid.Values =
    DistanceToSurface({ points, surface.Triangles }, ShapeOf(grid), 2.0 * grid.Spacing, progress);
  return grid;
}

DistanceGrid MarchedDistances(const SurfaceView& surface, const Bounds3& box, std::int64_t cells,
  const ProgressCallback& progress)
{
  DistanceGrid grid = GridOfDistances(surface, box, cells, Between(progress, 0.0, 0.7));
  // In spacings, since floats represent neither 1e40 nor 1e-40. No path on the grid is longer than
  // this.
  const auto farthest =
    static_cast<float>(grid.Dimensions[0] + grid.Dimensions[1] + grid.Dimensions[2]);
  std::vector<float> values(grid.Values.size(), farthest);
  std::vector<std::int64_t> known;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (grid.Values[i] <= 2.0 * grid.Spacing)
    {
      values[i] = static_cast<float>(grid.Values[i] / grid.Spacing);
      known.push_back(static_cast<std::int64_t>(i));
    }
  }
  FastMarch(grid.Dimensions, 1.0, known, farthest, values);
  std::transform(values.begin(), values.end(), grid.Values.begin(),
    [&grid](float v) { return grid.Spacing * static_cast<double>(v); });
  Report(progress, 1.0);
  return grid;
}

std::vector<double> MorseValues(const SurfaceView& surface, const TetrahedralMesh& mesh,
  MorseFunction function, const ProgressCallback& progress)
{
  std::vector<double> exact = SurfaceDistances(surface, mesh.Points, Between(progress, 0.0, 0.5));
  if (function == MorseFunction::ClosestPoint)
  {
    return exact;
  }
  Bounds3 box{ mesh.Points.front(), mesh.Points.front() };
  for (const Point3& p : mesh.Points)
  {
    box.Add(p);
  }
  std::vector<std::int64_t> sources;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    if (exact[i] <= 1e-12 * box.Diagonal())
    {
      sources.push_back(static_cast<std::int64_t>(i));
    }
  }
  const auto rest = Between(progress, 0.5, 1.0);
  if (function == MorseFunction::EdgePaths)
  {
    return EdgeDistances(mesh, sources, rest);
  }
  const DistanceGrid grid = function == MorseFunction::GridDistance
    ? GridOfDistances(surface, box, MorseGridCells, rest)
    : MarchedDistances(surface, box, MorseGridCells, rest);
  std::vector<double> values;
  for (const Point3& p : mesh.Points)
  {
    values.push_back(grid.At(p));
  }
  for (const std::int64_t p : sources)
  {
    values[static_cast<std::size_t>(p)] = 0.0;
  }
  return values;
}

}
