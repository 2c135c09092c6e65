#include "Tetrahedra/TetrahedralMesher.h"

#include "Core/Geometry.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/UnitScale.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/ShellCrossings.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/MeshQuality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

/// The same criteria for a surface whose lengths are `factor` times as large.
TetrahedralParameters ScaleParameters(TetrahedralParameters p, double factor)
{
  p.TetGen.MaximumVolume *= factor * factor * factor;
  p.CGAL.FacetSize *= factor;
  p.CGAL.FacetDistance *= factor;
  p.CGAL.CellSize *= factor;
  return p;
}

/// Sizes so small that refinement would exceed MaximumPoints are refused before it begins.
void RequireCGALBudget(const SurfaceView& surface, const TetrahedralParameters& parameters)
{
  const CGALCriteria& c = parameters.CGAL;
  if (parameters.Library != TetrahedralLibrary::CGAL)
  {
    return;
  }
  const double area = SurfaceArea(surface);
  // No triangle of circumradius r is larger than (3 sqrt(3) / 4) r^2, and there are two per point.
  const double points = c.FacetSize > 0.0 ? area / (2.6 * c.FacetSize * c.FacetSize) : 0.0;
  const double cells = c.CellSize > 0.0
    ? std::abs(SignedVolume(surface)) / (3.6 * c.CellSize * c.CellSize * c.CellSize)
    : 0.0;
  const double least = std::max(points, cells);
  constexpr double hopeless = 1e12; // below, refinement ends at MaximumPoints, and can be stopped
  if (least > hopeless)
  {
    throw std::invalid_argument("The sizes requested from CGAL need at least " +
      FormatNumber(least) + " points, more than the limit of " +
      FormatNumber(static_cast<double>(c.MaximumPoints)) + ": choose larger ones.");
  }
  const double finest = 1e-7 * ComputeBounds(surface).Diagonal();
  for (const double length : { c.FacetSize, c.FacetDistance, c.CellSize })
  {
    if (length > 0.0 && length < finest)
    {
      throw std::invalid_argument("A size of " + FormatNumber(length) +
        " is requested from CGAL, which locates points to " + FormatNumber(finest) +
        " only (1e-7 of the surface's diagonal): choose larger ones.");
    }
  }
}

/// The box around `surface`, `margin` of its diagonal away, as 12 triangles facing outward.
void AddBox(TetrahedralTask& task, const Bounds3& bounds, double margin)
{
  const double d = margin * bounds.Diagonal();
  const Point3 low = bounds.Min - Point3{ d, d, d };
  const Point3 high = bounds.Max + Point3{ d, d, d };
  for (int corner = 0; corner < 8; ++corner)
  {
    task.Box.Points.push_back({ corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
      corner & 4 ? high[2] : low[2] });
  }
  task.Box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 },
    { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  task.Exterior.Seed = bounds.Min - (0.5 * d) * Point3{ 1, 1, 1 };
  task.Exterior.Volume = SignedVolume(task.Box);
  for (std::size_t s = 0; s < task.Nesting.Shells.size(); ++s)
  {
    if (task.Nesting.OuterRegionIds[s] == 0)
    {
      task.Exterior.Volume -= SignedVolume(task.Nesting.Shells[s]);
    }
  }
}

/// Orients the tetrahedra to positive volume, all of them or none, and returns the volume of each
/// region. Both libraries orient all of theirs alike; those so flat that rounding determines the
/// sign of their volume must agree with their neighbours, otherwise the boundary has triangles that
/// face inward.
std::map<int, double> OrientAndMeasure(TetrahedralMesh& mesh)
{
  std::map<int, double> volumes;
  double all = 0.0;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    const auto at = [&mesh, &t](std::size_t c)
    { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    const Point3 origin = at(0);
    const double volume = Dot(Cross(at(1) - origin, at(2) - origin), at(3) - origin) / 6.0;
    volumes[mesh.Regions[i]] += volume;
    all += volume;
  }
  if (all < 0.0)
  {
    for (Tetrahedron& t : mesh.Tetrahedra)
    {
      std::swap(t[2], t[3]);
    }
    for (auto& [region, volume] : volumes)
    {
      volume = -volume;
    }
  }
  return volumes;
}

/// Checks that the tetrahedra fill each requested region; the libraries do not guarantee it.
void CheckVolumes(
  const TetrahedralTask& task, const std::map<int, double>& volumes, double tolerance)
{
  std::vector<SpaceRegion> regions = task.Nesting.InnerRegions;
  if (!task.Box.Triangles.empty())
  {
    regions.push_back(task.Exterior);
  }
  for (const SpaceRegion& region : regions)
  {
    if (!task.IsWanted(region.Id))
    {
      continue;
    }
    const auto found = volumes.find(region.Id);
    if (found == volumes.end())
    {
      throw std::runtime_error("Region " + std::to_string(region.Id) + " of volume " +
        FormatNumber(region.Volume) +
        " got no tetrahedra: it is smaller than the requested sizes.");
    }
    if (std::abs(found->second - region.Volume) > tolerance * region.Volume)
    {
      throw std::runtime_error("The tetrahedra of region " + std::to_string(region.Id) +
        " fill a volume of " + FormatNumber(found->second) + " instead of " +
        FormatNumber(region.Volume) + ": remesh the surface or use the other library.");
    }
  }
}

}

void Check(const TetrahedralParameters& p)
{
  RequireChoice("Library", p.Library, TetrahedralLibrary::CGAL);
  RequireChoice("Side", p.Side, MeshedSide::Both);
  if (p.Side != MeshedSide::Inside)
  {
    RequireRange("BoxMargin", p.BoxMargin, 1e-3, 1e3, "It is in diagonals of the surface.");
  }
  if (p.Library == TetrahedralLibrary::TetGen)
  {
    const TetGenCriteria& t = p.TetGen;
    RequireThat(t.RadiusEdgeRatio == 0.0 || (t.RadiusEdgeRatio >= 1.0 && t.RadiusEdgeRatio < 1e6),
      "RadiusEdgeRatio", t.RadiusEdgeRatio,
      "it must be 0 (no refinement) or from 1 to 1e6; below 2, refinement may not terminate");
    RequireRange(
      "MinimumDihedralAngle", t.MinimumDihedralAngle, 0.0, 40.0, "It is an angle in degrees.");
    RequireRange("MaximumVolume", t.MaximumVolume, 0.0, Unlimited, "0 stands for no bound.");
    RequireAbove("TimeLimit", t.Limits.TimeLimit, 0.0, 1e7, "It is in seconds.");
    return;
  }
  const CGALCriteria& c = p.CGAL;
  RequireRange("FacetAngle", c.FacetAngle, 0.0, 30.0,
    "It is an angle in degrees; above 30, refinement may not terminate.");
  RequireRange("FacetSize", c.FacetSize, 0.0, LargestLength, "It is a length.");
  RequireRange("FacetDistance", c.FacetDistance, 0.0, LargestLength, "It is a length.");
  RequireRange("CellRadiusEdgeRatio", c.CellRadiusEdgeRatio, 2.0, LargestLength,
    "Below 2, refinement may not terminate.");
  RequireRange("CellSize", c.CellSize, 0.0, LargestLength, "It is a length.");
  RequireRange("LloydIterations", c.LloydIterations, 0, 100);
  RequireRange("ODTIterations", c.ODTIterations, 0, 100);
  RequireAbove(
    "OptimisationTimeLimit", c.OptimisationTimeLimit, 0.0, Unlimited, "It is in seconds.");
  RequireRange("PerturbTimeLimit", c.PerturbTimeLimit, 0.0, Unlimited, "It is in seconds.");
}

namespace
{

/// "radius-edge ratio up to 3 (bound 2) in 7"; empty where the bound holds.
std::string Excess(const char* what, double bound, const std::vector<double>& values)
{
  constexpr double rounding = 1.0 + 1e-3;
  double largest = 0.0;
  std::size_t count = 0;
  for (const double value : values)
  {
    count += value > bound * rounding ? 1 : 0;
    largest = std::max(largest, value);
  }
  if (bound <= 0.0 || count == 0)
  {
    return {};
  }
  return JoinText(
    what, " up to ", FormatNumber(largest, 3), " (bound ", FormatNumber(bound, 3), ") in ", count);
}

}

std::string UnmetBounds(const TetrahedralMesh& mesh, const TetrahedralParameters& parameters)
{
  const bool tetgen = parameters.Library == TetrahedralLibrary::TetGen;
  std::vector<CellAngles> cells(mesh.Tetrahedra.size());
  MeasureQuality(mesh.Points, mesh.Tetrahedra, 1, cells);
  std::vector<double> ratios, volumes;
  for (const CellAngles& cell : cells)
  {
    ratios.push_back(cell.RadiusEdge);
    volumes.push_back(cell.Size);
  }
  const std::string ratio = Excess("radius-edge ratio",
    tetgen ? parameters.TetGen.RadiusEdgeRatio : parameters.CGAL.CellRadiusEdgeRatio, ratios);
  const std::string volume =
    Excess("volume", tetgen ? parameters.TetGen.MaximumVolume : 0.0, volumes);
  if (ratio.empty() && volume.empty())
  {
    return {};
  }
  const bool kept = tetgen && parameters.TetGen.PreserveSurface;
  return JoinText("Some of the ", mesh.Tetrahedra.size(), " tetrahedra exceed the bounds: ", ratio,
    ratio.empty() || volume.empty() ? "" : ", ", volume, ".",
    kept ? " The triangles of the surface are kept, and tetrahedra next to them cannot be better "
           "than they are: remesh the surface (Surface Remesh), or switch PreserveSurface off."
      : tetgen ? " Remesh the surface (Surface Remesh) where it is sharp or thin."
               : " Optimisation may exceed these bounds: switch off Lloyd, ODT, perturbation and "
                 "exudation.");
}

TetrahedralMesh MeshTetrahedra(const SurfaceView& surface, const TetrahedralParameters& parameters,
  const ProgressCallback& progress)
{
  Check(parameters);
  if (surface.Triangles.empty())
  {
    return {};
  }
  const UnitScale scale(surface);
  if (!scale.IsOne())
  {
    if (FindDefects(surface).None())
    {
      RequireShellsApart(surface); // with the place in the user's unit
    }
    TriangleMesh scaled = CopyMesh(surface);
    scale.Apply(scaled.Points);
    TetrahedralMesh mesh =
      MeshTetrahedra(scaled, ScaleParameters(parameters, scale.Factor()), progress);
    scale.Undo(mesh.Points);
    return mesh;
  }
  RequireCleanSurface(surface, Between(progress, 0.0, 0.05), parameters.Repaired);
  RequireCGALBudget(surface, parameters);
  const ShellNesting nesting = FindNesting(surface, Between(progress, 0.05, 0.1));
  TetrahedralTask task{ surface, nesting, parameters, {}, {} };
  if (parameters.Side != MeshedSide::Inside)
  {
    AddBox(task, ComputeBounds(surface), parameters.BoxMargin);
  }
  Report(progress, 0.1);

  const bool tetgen = parameters.Library == TetrahedralLibrary::TetGen;
  const auto rest = Between(progress, 0.1, 0.98);
  TetrahedralMesh mesh = tetgen ? TetGenTetrahedra(task, rest) : CGALTetrahedra(task, rest);
  const std::map<int, double> volumes = OrientAndMeasure(mesh);
  // Without PreserveSurface TetGen takes nearly flat neighbours as one facet; CGAL replaces the
  // surface by one of its own, of about the same volume only.
  const bool exact = tetgen && parameters.TetGen.PreserveSurface;
  CheckVolumes(task, volumes, exact ? 1e-9 : tetgen ? 1e-3 : 0.5);
  Report(progress, 1.0);
  return mesh;
}

}
