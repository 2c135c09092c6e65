// Patches are replaced, not smoothed first: by triangles without area smoothing moves points to
// NaN, for which GMP raises SIGFPE (CGAL 5.5); and it took 16 times as long for 2 % more clean
// surfaces.
#define CGAL_PMP_REMOVE_SELF_INTERSECTIONS_NO_SMOOTHING

#include "Remeshing/SurfaceRepair.h"

#include "Core/UnitScale.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/CGALVersions.h"
#include "Remeshing/OrderedTraits.h"
#include "Surfaces/ShellCrossings.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceMeasures.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>

#include <cmath>
#include <map>
#include <set>

namespace isthmus
{
namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;
using cgal::SurfaceMesh;

/// Points and triangles in the form of CGAL's soup functions.
struct Soup
{
  std::vector<cgal::Point> Points;
  std::vector<std::vector<std::size_t>> Triangles;
};

/// The triangles of `mesh` that have finite, distinct points.
Soup RemoveDefects(const SurfaceView& mesh, const SurfaceDefects& defects)
{
  std::set<std::int64_t> badPoints(defects.InvalidPoints.begin(), defects.InvalidPoints.end());
  std::set<std::int64_t> badTriangles(
    defects.InvalidTriangles.begin(), defects.InvalidTriangles.end());
  Soup soup;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const bool usable = badPoints.count(static_cast<std::int64_t>(i)) == 0;
    soup.Points.push_back(usable ? cgal::ToCGAL(mesh.Points[i]) : cgal::Point(CGAL::ORIGIN));
  }
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const Triangle& t = mesh.Triangles[i];
    const bool usable = badTriangles.count(static_cast<std::int64_t>(i)) == 0 &&
      badPoints.count(t[0]) + badPoints.count(t[1]) + badPoints.count(t[2]) == 0;
    if (usable)
    {
      soup.Triangles.push_back({ static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]),
        static_cast<std::size_t>(t[2]) });
    }
  }
  return soup;
}

/// The same with cracks between facets closed.
Soup CloseCracks(
  const SurfaceView& mesh, const SurfaceDefects& defects, SurfaceCorrection& correction)
{
  if (!defects.InvalidPoints.empty() || !defects.InvalidTriangles.empty() ||
    defects.BoundaryTriangles.empty())
  {
    return RemoveDefects(mesh, defects);
  }
  const std::vector<Triangle> merged = MergedCorners(mesh);
  const std::vector<Triangle> joined = JoinCracks(SurfaceView(mesh.Points, merged), correction);
  return RemoveDefects(
    SurfaceView(mesh.Points, correction.Joined > 0 ? View<Triangle>(joined) : mesh.Triangles), {});
}

/// Number of holes filled; those that cannot be filled stay open.
std::size_t FillHoles(SurfaceMesh& mesh)
{
  std::size_t filled = 0;
  for (const auto border : cgal::BorderCycles(mesh))
  {
    // A hole that remains is found afterwards, by the check that the result is closed.
    filled += cgal::FillHole(mesh, border).empty() ? 0 : 1;
  }
  return filled;
}

SurfaceMesh ToSurface(Soup soup)
{
  PMP::repair_polygon_soup(soup.Points, soup.Triangles);
  PMP::orient_polygon_soup(soup.Points, soup.Triangles);
  SurfaceMesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.Points, soup.Triangles, mesh);
  PMP::stitch_borders(mesh);
  return mesh;
}

/// Passes of the removal: triangles that still cross after one pass may be replaced by the next,
/// with more triangles around them. Of 700 damaged surfaces (TestDamagedSurfaces' kinds) 517 were
/// clean after one, 555 after three.
constexpr int MostPasses = 3;

/// Called by CGAL before each patch that it replaces; CGAL copies it, so it holds references only.
struct RemovalVisitor : PMP::experimental::Remove_self_intersection_default_visitor<SurfaceMesh>
{
  const SurfaceMesh* Mesh = nullptr;
  const ProgressCallback* Progress = nullptr;
  int* Rounds = nullptr;

  /// A patch that does not fit leaves a hole with borders wrongly linked, on which CGAL 5.5
  /// accesses its arrays out of bounds. The counts reveal it: each edge of a closed mesh has two
  /// triangles.
  bool stop() const
  {
    Report(*this->Progress, 1.0 - std::pow(0.8, *this->Rounds));
    if (std::size_t{ 3 } * this->Mesh->number_of_faces() !=
      std::size_t{ 2 } * this->Mesh->number_of_edges())
    {
      throw std::runtime_error(
        "Triangles that cross could not be replaced without tearing the surface: recreate it "
        "(Contour, Offset Surface), or remove the part.");
    }
    return false;
  }
  void end_iteration() { ++*this->Rounds; }
};

void RemoveSelfIntersections(SurfaceMesh& mesh, const ProgressCallback& progress)
{
  int rounds = 0;
  RemovalVisitor watch;
  watch.Mesh = &mesh;
  watch.Progress = &progress;
  watch.Rounds = &rounds;
  for (int pass = 0; pass < MostPasses; ++pass)
  {
    if (PMP::experimental::remove_self_intersections(mesh,
          CGAL::parameters::preserve_genus(false).visitor(watch).geom_traits(
            cgal::OrderedTraits())))
    {
      return;
    }
  }
}

std::string ChangesBetween(const SurfaceDefects& defects, const SurfaceView& before,
  const SurfaceView& after, std::size_t holes, bool crossings)
{
  std::string text;
  const auto add = [&text](const std::string& what) { text += (text.empty() ? "" : ", ") + what; };
  if (!defects.None())
  {
    add("removed invalid and duplicate triangles and oriented the rest consistently");
  }
  if (holes > 0)
  {
    add("filled " + std::to_string(holes) + (holes == 1 ? " hole" : " holes"));
  }
  if (crossings)
  {
    add("replaced crossing triangles");
  }
  return text.empty() ? text
                      : "Repair " + text + ": " + std::to_string(before.Triangles.size()) +
      " triangles became " + std::to_string(after.Triangles.size()) + ".";
}

}

TriangleMesh OrientConsistently(const SurfaceView& mesh)
{
  return cgal::RethrowWithContext("orienting triangles consistently",
    [&]
    {
      const SurfaceDefects defects = FindDefects(mesh);
      if (defects.FlippedTriangles.empty())
      {
        return CopyMesh(mesh); // its parts may face inward: cavities do
      }
      Soup soup = RemoveDefects(mesh, defects);
      PMP::repair_polygon_soup(soup.Points, soup.Triangles);
      PMP::orient_polygon_soup(soup.Points, soup.Triangles);
      TriangleMesh result;
      for (const cgal::Point& p : soup.Points)
      {
        result.Points.push_back(cgal::FromCGAL(p));
      }
      for (const auto& t : soup.Triangles)
      {
        result.Triangles.push_back({ static_cast<std::int64_t>(t[0]),
          static_cast<std::int64_t>(t[1]), static_cast<std::int64_t>(t[2]) });
      }
      return result;
    });
}

void RequireCleanSurface(const SurfaceView& mesh, const ProgressCallback& progress, bool repaired)
{
  const std::string advice = repaired
    ? " Repair failed: recreate the surface (Contour, Offset Surface), or remove the part."
    : " Switch on Repair, or repair the surface beforehand.";
  const SurfaceDefects defects = FindDefects(mesh, Between(progress, 0.0, 0.3));
  if (!defects.None())
  {
    throw std::invalid_argument(defects.Message() + DescribeOpenBoundary(mesh, defects) + advice);
  }
  const std::vector<std::int64_t> crossing = SelfIntersections(mesh, Between(progress, 0.3, 1.0));
  if (!crossing.empty())
  {
    const auto shells = FindShellCrossing(mesh);
    throw std::invalid_argument("The surface intersects itself in " +
      std::to_string(crossing.size()) + " triangles (" + FirstIds(crossing) + ")." +
      (shells ? " " + shells->Message() : advice));
  }
}

RepairedSurface RepairSurface(const SurfaceView& mesh, const ProgressCallback& progress)
{
  const UnitScale scale(mesh);
  if (!scale.IsOne())
  {
    TriangleMesh scaled = CopyMesh(mesh);
    scale.Apply(scaled.Points);
    RepairedSurface result = RepairSurface(scaled, progress);
    scale.Undo(result.Mesh.Points);
    return result;
  }
  return cgal::RethrowWithContext("repairing the surface",
    [&]
    {
      const SurfaceDefects defects = FindDefects(mesh);
      SurfaceCorrection correction;
      SurfaceMesh surface = ToSurface(CloseCracks(mesh, defects, correction));
      Report(progress, 0.3);
      const std::size_t holes = FillHoles(surface);
      if (surface.is_empty() || !CGAL::is_closed(surface))
      {
        throw std::invalid_argument("No closed part of the surface remains after repair: " +
          (defects.None() ? std::string("it is empty.") : defects.Message()));
      }
      Report(progress, 0.5);
      const bool crossings = PMP::does_self_intersect(surface);
      std::string topology;
      if (crossings)
      {
        const TriangleMesh crossing = cgal::FromSurfaceMesh(surface);
        RemoveSelfIntersections(surface, Between(progress, 0.5, 0.9));
        topology = DescribeTopologyChange(crossing, cgal::FromSurfaceMesh(surface));
      }
      Report(progress, 0.9);
      RepairedSurface result;
      result.Mesh = cgal::FromSurfaceMesh(surface);
      std::map<Point3, std::int64_t> original;
      for (std::size_t i = 0; i < mesh.Points.size(); ++i)
      {
        // Points that are not finite cannot be ordered; all have been removed.
        if (std::isfinite(mesh.Points[i][0] + mesh.Points[i][1] + mesh.Points[i][2]))
        {
          original.emplace(mesh.Points[i], static_cast<std::int64_t>(i));
        }
      }
      for (const Point3& p : result.Mesh.Points)
      {
        const auto found = original.find(p);
        result.OriginalPoints.push_back(found == original.end() ? -1 : found->second);
      }
      result.Changes = ChangesBetween(defects, mesh, result.Mesh, holes, crossings);
      if (!correction.Message().empty())
      {
        result.Changes =
          correction.Message() + (result.Changes.empty() ? "" : " ") + result.Changes;
      }
      result.Changes += (topology.empty() ? "" : " ") + topology;
      return result;
    });
}

}
