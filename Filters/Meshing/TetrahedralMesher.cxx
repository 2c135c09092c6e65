#include "TetrahedralMesher.h"

#include "SurfaceRepair.h"
#include "SurfaceTopology.h"

#include <cmath>
#include <map>
#include <stdexcept>

namespace isthmus
{
namespace
{

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

/// Turns every tetrahedron to positive volume and returns the volume of each region.
std::map<int, double> OrientAndMeasure(TetrahedralMesh& mesh)
{
  std::map<int, double> volumes;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    Tetrahedron& t = mesh.Tetrahedra[i];
    const auto at = [&mesh, &t](std::size_t c)
    { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    const Point3 origin = at(0);
    double six = Dot(Cross(at(1) - origin, at(2) - origin), at(3) - origin);
    if (six < 0.0)
    {
      std::swap(t[2], t[3]);
      six = -six;
    }
    volumes[mesh.Regions[i]] += six / 6.0;
  }
  return volumes;
}

/// Do the tetrahedra fill each region asked for? Libraries are not taken at their word.
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
        std::to_string(region.Volume) +
        " got no tetrahedra: it is smaller than the sizes asked for.");
    }
    if (std::abs(found->second - region.Volume) > tolerance * region.Volume)
    {
      throw std::runtime_error("The tetrahedra of region " + std::to_string(region.Id) +
        " fill a volume of " + std::to_string(found->second) + " instead of " +
        std::to_string(region.Volume) + ": remesh the surface or use the other library.");
    }
  }
}

}

void CheckTetrahedralParameters(const TetrahedralParameters& p)
{
  const auto demand = [](bool fine, const char* sentence)
  {
    if (!fine)
    {
      throw std::invalid_argument(sentence);
    }
  };
  const TetGenCriteria& t = p.TetGen;
  demand(p.Side == MeshedSide::Inside || (p.BoxMargin > 0.0 && std::isfinite(p.BoxMargin)),
    "The margin of the box must be positive.");
  if (p.Library == TetrahedralLibrary::TetGen)
  {
    demand(t.RadiusEdgeRatio == 0.0 || (t.RadiusEdgeRatio >= 1.0 && t.RadiusEdgeRatio < 1e6),
      "TetGen's radius-edge ratio must be 0 (no refinement) or at least 1; below 2 it need not "
      "end.");
    demand(t.MinimumDihedral >= 0.0 && t.MinimumDihedral <= 40.0,
      "TetGen's minimum dihedral angle must be from 0 to 40 degrees.");
    demand(t.MaximumVolume >= 0.0 && std::isfinite(t.MaximumVolume),
      "The maximum volume must be positive, or 0 for none.");
    demand(t.Limits.Seconds > 0.0, "The time limit must be positive.");
    return;
  }
  const CGALCriteria& c = p.CGAL;
  demand(c.FacetAngle >= 0.0 && c.FacetAngle <= 30.0,
    "CGAL's facet angle must be from 0 to 30 degrees: above, refinement need not end.");
  demand(c.FacetSize >= 0.0 && c.FacetDistance >= 0.0 && c.CellSize >= 0.0,
    "CGAL's sizes must be positive, or 0 for the default.");
  demand(c.CellRadiusEdgeRatio >= 2.0,
    "CGAL's cell radius-edge ratio must be at least 2: below, refinement need not end.");
  demand(std::min(c.LloydIterations, c.ODTIterations) >= 0 &&
      std::max(c.LloydIterations, c.ODTIterations) <= 100,
    "Iterations of Lloyd and ODT must be from 0 to 100.");
  demand(c.OptimisationSeconds > 0.0 && c.PerturbSeconds >= 0.0 &&
      std::isfinite(c.OptimisationSeconds + c.PerturbSeconds),
    "Time limits of the optimisation must be positive.");
}

TetrahedralMesh MeshTetrahedra(const TriangleMesh& surface, const TetrahedralParameters& parameters,
  const ProgressCallback& progress)
{
  CheckTetrahedralParameters(parameters);
  if (surface.Triangles.empty())
  {
    return {};
  }
  DemandCleanSurface(surface);
  Report(progress, 0.05);
  const ShellNesting nesting = FindNesting(surface);
  TetrahedralTask task{ surface, nesting, parameters, {}, {} };
  if (parameters.Side != MeshedSide::Inside)
  {
    AddBox(task, BoundsOf(surface), parameters.BoxMargin);
  }
  Report(progress, 0.1);

  const bool tetgen = parameters.Library == TetrahedralLibrary::TetGen;
  const auto rest = Between(progress, 0.1, 0.98);
  TetrahedralMesh mesh = tetgen ? TetGenTetrahedra(task, rest) : CGALTetrahedra(task, rest);
  const std::map<int, double> volumes = OrientAndMeasure(mesh);
  // Without KeepSurface TetGen takes nearly flat neighbours as one facet; CGAL replaces the surface
  // by one of its own, of about the same volume only.
  const bool exact = tetgen && parameters.TetGen.KeepSurface;
  CheckVolumes(task, volumes, exact ? 1e-9 : tetgen ? 1e-3 : 0.5);
  Report(progress, 1.0);
  return mesh;
}

}
