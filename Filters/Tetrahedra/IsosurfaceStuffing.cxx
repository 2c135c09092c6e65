#include "Tetrahedra/IsosurfaceStuffing.h"

#include "Tetrahedra/StuffingAngles.h"
#include "Tetrahedra/StuffingOutput.h"

#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

void Check(const StuffingParameters& p)
{
  if (!(p.CellSize > 0.0) || std::isinf(p.CellSize))
  {
    throw std::invalid_argument(
      "The cell size is " + std::to_string(p.CellSize) + ", but it must be a positive length.");
  }
  if (p.GradingLevels < 0 || p.GradingLevels > 8)
  {
    throw std::invalid_argument("The grading levels are " + std::to_string(p.GradingLevels) +
      ", but they must be from 0 (uniform) to 8.");
  }
  if (!(p.Margin >= 0.0) || std::isinf(p.Margin))
  {
    throw std::invalid_argument("The margin of the box must not be negative.");
  }
}

void AddOctant(const StuffingLattice& lattice, const StuffingBackground& background,
  const Octant& octant, StuffingOutput& output, std::vector<LatticeTetrahedron>& scratch)
{
  const LatticePoint& c = octant.First;
  const bool isNear = octant.Level == 0 && lattice.IsNear(lattice.Cell(c[0], c[1], c[2]));
  const int side = lattice.IsInside(lattice.Node(octant.Centre())) ? 1 : -1;
  if (!isNear && !output.Wants(side))
  {
    return;
  }
  scratch.clear();
  background.Append(octant, scratch);
  for (const LatticeTetrahedron& t : scratch)
  {
    if (isNear)
    {
      output.AddCut(t);
    }
    else
    {
      output.AddWhole(t, side);
    }
  }
}

}

IsosurfaceStuffingResult IsosurfaceStuffing(const std::function<double(const Point3&)>& field,
  const Bounds3& bounds, const StuffingParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  StuffingLattice lattice(bounds, parameters);
  lattice.Sample(field, Between(progress, 0.0, 0.4));
  lattice.Grade(parameters.GradingLevels);
  StuffingWarp warp(lattice, Between(progress, 0.4, 0.5));
  KeepAngles(lattice, warp, Between(progress, 0.5, 0.7));
  const StuffingBackground background(lattice);
  StuffingOutput output(warp, parameters.Side);
  std::vector<LatticeTetrahedron> scratch;
  const std::int64_t layers = lattice.Cells()[2];
  for (std::int64_t k = 0; k < layers; ++k)
  {
    Report(progress, 0.7 + 0.3 * static_cast<double>(k) / static_cast<double>(layers));
    background.ForEachOctant(
      k, [&](const Octant& octant) { AddOctant(lattice, background, octant, output, scratch); });
  }
  IsosurfaceStuffingResult result;
  result.OnSurface = output.OnSurface();
  result.Mesh = std::move(output.Mesh());
  result.Mesh.OriginalPoints.assign(result.Mesh.Points.size(), -1);
  result.KeptPoints = warp.Stayed();
  Report(progress, 1.0);
  return result;
}

}
