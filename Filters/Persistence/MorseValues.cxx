#include "Persistence/MorseValues.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Persistence/FastMarching.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace isthmus
{

std::vector<double> EdgeDistances(const TetrahedralMesh& mesh,
  const std::vector<std::int64_t>& sources, const ProgressCallback& progress)
{
  std::vector<std::vector<std::int64_t>> beside(mesh.Points.size());
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    for (const std::int64_t a : t)
    {
      for (const std::int64_t b : t)
      {
        if (a != b)
        {
          beside[At(a)].push_back(b);
        }
      }
    }
  }
  std::vector<double> distance(mesh.Points.size(), HUGE_VAL);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::int64_t p : sources)
  {
    distance[At(p)] = 0.0;
    queue.push({ 0.0, p });
  }
  Report(progress, 0.0);
  std::size_t settled = 0;
  while (!queue.empty())
  {
    const auto [d, p] = queue.top();
    queue.pop();
    if (d > distance[At(p)])
    {
      continue;
    }
    if (settled++ % (1U << 16) == 0)
    {
      Report(progress, static_cast<double>(settled) / static_cast<double>(mesh.Points.size()));
    }
    for (const std::int64_t q : beside[At(p)])
    {
      const Point3 step = mesh.Points[At(q)] - mesh.Points[At(p)];
      const double there = d + Length(step);
      if (there < distance[At(q)])
      {
        distance[At(q)] = there;
        queue.push({ there, q });
      }
    }
  }
  return distance;
}

DistanceGrid MarchedDistances(const SurfaceView& surface, const Bounds3& box, std::int64_t cells,
  const ProgressCallback& progress)
{
  DistanceGrid grid = ComputeDistanceGrid(surface, box, cells, Between(progress, 0.0, 0.7));
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
    ? ComputeDistanceGrid(surface, box, MorseGridCells, rest)
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
