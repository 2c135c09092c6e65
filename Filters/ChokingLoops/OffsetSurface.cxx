#include "ChokingLoops/OffsetSurface.h"

#include "Core/Geometry.h"
#include "Core/MemoryBudget.h"
#include "Core/RangeChecks.h"
#include "Core/UnitScale.h"
#include "Surfaces/GridDistance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

Point3 NodeOf(const DistanceGrid& grid, std::size_t i)
{
  const auto node = static_cast<std::int64_t>(i);
  const std::int64_t layer = grid.Dimensions[0] * grid.Dimensions[1];
  const std::int64_t k = node / layer;
  const std::int64_t j = node % layer / grid.Dimensions[0];
  return grid.Origin +
    grid.Spacing *
    Point3{ static_cast<double>(node % grid.Dimensions[0]), static_cast<double>(j),
      static_cast<double>(k) };
}

/// Bounding box of the offset and two cells beyond it.
Bounds3 BoxAround(const SurfaceView& surface, double distance, std::int64_t cells)
{
  if (surface.Triangles.empty())
  {
    throw std::invalid_argument("The surface has no triangles: give a triangulated surface.");
  }
  const auto& first = surface.Points[static_cast<std::size_t>(surface.Triangles[0][0])];
  Bounds3 box{ first, first };
  for (const Triangle& t : surface.Triangles)
  {
    for (const std::int64_t id : t)
    {
      const Point3& p = surface.Points[static_cast<std::size_t>(id)];
      if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      {
        throw std::invalid_argument("Point " + std::to_string(id) +
          " of the surface is not finite: remove it or repair the surface.");
      }
      box.Add(p);
    }
  }
  const Point3 size = box.Max - box.Min;
  const double farthest = std::max({ std::abs(box.Min[0]), std::abs(box.Min[1]),
    std::abs(box.Min[2]), std::abs(box.Max[0]), std::abs(box.Max[1]), std::abs(box.Max[2]) });
  if (distance > 1e6 * farthest || distance < 1e-9 * farthest)
  {
    throw std::invalid_argument("Distance is " + FormatNumber(distance) +
      ", but the surface reaches to " + FormatNumber(farthest) +
      ": choose a distance between 1e-9 and 1e6 of that.");
  }
  const double width = std::max({ size[0], size[1], size[2] }) + 2.0 * distance;
  const double margin = distance + 2.0 * width / static_cast<double>(cells - 4);
  for (std::size_t a = 0; a < 3; ++a)
  {
    box.Min[a] -= margin;
    box.Max[a] += margin;
  }
  return box;
}

/// Replaces values within two spacings of the level by exact ones.
void MakeExact(
  const SurfaceView& surface, double distance, DistanceGrid& grid, const ProgressCallback& progress)
{
  std::vector<std::size_t> near;
  std::vector<Point3> points;
  for (std::size_t i = 0; i < grid.Values.size(); ++i)
  {
    if (std::abs(grid.Values[i] - distance) < 2.0 * grid.Spacing)
    {
      near.push_back(i);
      points.push_back(NodeOf(grid, i));
    }
  }
  const std::vector<double> exact = SurfaceDistances(surface, points, progress);
  for (std::size_t k = 0; k < near.size(); ++k)
  {
    grid.Values[near[k]] = exact[k];
  }
}

/// For ComputeDistanceGrid(), the copy that is contoured, and the contour.
double GridBytes(const Bounds3& box, std::int64_t cells)
{
  constexpr double bytes = 40.0; // for each node
  const Point3 size = box.Max - box.Min;
  const double h = std::max({ size[0], size[1], size[2] }) / static_cast<double>(cells);
  return bytes * (size[0] / h + 1.0) * (size[1] / h + 1.0) * (size[2] / h + 1.0);
}

}

DistanceGrid OffsetDistances(const SurfaceView& surface, const OffsetSurfaceParameters& parameters,
  const ProgressCallback& progress)
{
  Check(parameters);
  const UnitScale scale(surface.Points);
  if (!scale.IsOne())
  {
    if (parameters.Side != SideSelection::Both)
    {
      RequireShellsApart(surface); // with the place in the user's unit
    }
    TriangleMesh scaled = CopyMesh(surface);
    scale.Apply(scaled.Points);
    OffsetSurfaceParameters scaledParameters = parameters;
    scaledParameters.Distance *= scale.Factor();
    DistanceGrid grid = OffsetDistances(scaled, scaledParameters, progress);
    const double back = 1.0 / scale.Factor();
    scale.Undo(grid.Origin);
    grid.Spacing *= back;
    for (double& value : grid.Values)
    {
      value *= back;
    }
    return grid;
  }
  const double distance = parameters.Distance;
  const std::int64_t cells = parameters.Resolution;
  const Bounds3 box = BoxAround(surface, distance, cells);
  MemoryBudget().Require(GridBytes(box, cells),
    "A grid with a Resolution of " + std::to_string(cells), "choose a lower Resolution");
  DistanceGrid grid = ComputeDistanceGrid(surface, box, cells, Between(progress, 0.0, 0.5));
  if (parameters.Side == SideSelection::Both && distance < grid.Spacing)
  {
    throw std::invalid_argument("Distance is " + FormatNumber(distance / grid.Spacing, 2) +
      " times the grid spacing, but to separate the two sides of the offset it must be one or "
      "more: "
      "choose a Resolution of at least " +
      FormatNumber(std::ceil(static_cast<double>(cells) * grid.Spacing / distance)) +
      ", or one side.");
  }
  if (distance > 2.0 * grid.Spacing)
  {
    MakeExact(surface, distance, grid, Between(progress, 0.5, 0.9));
  }
  if (!std::all_of(grid.Values.begin(), grid.Values.end(), [](double d) { return d < HUGE_VAL; }))
  {
    throw std::runtime_error("At a Distance of " + FormatNumber(distance) +
      " the grid is too coarse: no node is near the surface. Use a smaller Distance or a higher "
      "Resolution.");
  }
  if (parameters.Side != SideSelection::Both)
  {
    const std::vector<Point3> points = TranslatedPoints(grid.Origin, surface);
    const std::vector<unsigned char> inside = NodesInside({ points, surface.Triangles },
      GetGridShape(grid), [&](const Point3& p) { return p + grid.Origin; });
    const bool wanted = parameters.Side == SideSelection::Inside;
    for (std::size_t i = 0; i < inside.size(); ++i)
    {
      grid.Values[i] = (inside[i] != 0) == wanted ? grid.Values[i] : -grid.Values[i];
    }
  }
  Report(progress, 1.0);
  return grid;
}

}
