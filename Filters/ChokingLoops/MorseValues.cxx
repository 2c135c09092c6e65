#include "ChokingLoops/MorseValues.h"

#include "ChokingLoops/SurfaceDistance.h"
#include "Core/Geometry.h"
#include "Persistence/EdgeDistances.h"

namespace isthmus
{

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
