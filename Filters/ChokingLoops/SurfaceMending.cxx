#include "ChokingLoops/SurfaceMending.h"

#include "Core/Index.h"
#include "Core/RangeGuard.h"
#include "Remeshing/SurfaceRepair.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceCheck.h"
#include "Surfaces/SurfaceIntake.h"

#include <map>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// How far copies of a point are drawn to the middle of their neighbours.
constexpr double DrawnBy = 0.01;

/// Thin triangles may hide others, and repair may make some.
constexpr int MostRounds = 3;

/// Moves points that lie at the place of another one into the sheet they belong to.
void DrawApart(TriangleMesh& mesh)
{
  std::map<Point3, std::int64_t> count;
  for (const Point3& p : mesh.Points)
  {
    ++count[p];
  }
  std::map<std::int64_t, std::pair<Point3, double>> around; // sum and number of neighbours
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (count[mesh.Points[At(t[k])]] > 1)
      {
        auto& [sum, number] = around.try_emplace(t[k], Point3{ 0, 0, 0 }, 0.0).first->second;
        sum = sum + mesh.Points[At(t[(k + 1) % 3])] + mesh.Points[At(t[(k + 2) % 3])];
        number += 2.0;
      }
    }
  }
  std::vector<std::pair<std::int64_t, Point3>> moved;
  for (const auto& [id, neighbours] : around)
  {
    const Point3 middle = (1.0 / neighbours.second) * neighbours.first;
    moved.emplace_back(id, (1.0 - DrawnBy) * mesh.Points[At(id)] + DrawnBy * middle);
  }
  for (const auto& [id, place] : moved)
  {
    mesh.Points[At(id)] = place;
  }
}

/// Of the surface as turned, parts that face inward counted as holes.
double VolumeOf(const SurfaceView& mesh)
{
  double six = 0.0;
  const Point3 origin = mesh.Points.empty() ? Point3{ 0, 0, 0 } : mesh.Points.front();
  for (const Triangle& t : mesh.Triangles)
  {
    six += Dot(mesh.Points[At(t[0])] - origin,
      Cross(mesh.Points[At(t[1])] - origin, mesh.Points[At(t[2])] - origin));
  }
  return std::abs(six / 6.0);
}

/// Corners of a triangle, the least first, in their order round it.
std::array<Point3, 3> PlacesOf(const SurfaceView& mesh, const Triangle& t)
{
  std::array<Point3, 3> p{ mesh.Points[At(t[0])], mesh.Points[At(t[1])], mesh.Points[At(t[2])] };
  std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
  return p;
}

/// Counts and places the triangles of `before` that are not in `after`.
void TellChanged(const SurfaceView& before, const SurfaceView& after, SurfaceMending& mending)
{
  std::map<std::array<Point3, 3>, int> left;
  for (const Triangle& t : after.Triangles)
  {
    ++left[PlacesOf(after, t)];
  }
  for (const Triangle& t : before.Triangles)
  {
    const std::array<Point3, 3> places = PlacesOf(before, t);
    const auto found = left.find(places);
    if (found != left.end() && found->second > 0)
    {
      --found->second;
      continue;
    }
    ++mending.Changed;
    mending.Places.push_back((1.0 / 3.0) * (places[0] + places[1] + places[2]));
  }
}

/// One round of repair.
TriangleMesh Repaired(const SurfaceView& surface, const ProgressCallback& progress)
{
  TriangleMesh mesh = CopyOf(surface);
  if (FindDefects(mesh).None() && !ThinTriangles(mesh).empty())
  {
    mesh = WithoutThinTriangles(mesh);
  }
  const SurfaceDefects defects = FindDefects(mesh);
  if (!defects.None() || !SelfIntersections(mesh, Between(progress, 0.0, 0.3)).empty())
  {
    mesh = RepairSurface(mesh, Between(progress, 0.3, 1.0)).Mesh;
    DrawApart(mesh);
    mesh = MergePoints(mesh);
  }
  return mesh;
}

bool IsClean(const SurfaceView& mesh, bool allowCrossings, const ProgressCallback& progress)
{
  return !mesh.Triangles.empty() && FindDefects(mesh).None() && ThinTriangles(mesh).empty() &&
    (allowCrossings || SelfIntersections(mesh, progress).empty());
}

}

TriangleMesh MendedSurface(const SurfaceView& surface, const std::string& what, bool allowCrossings,
  SurfaceMending& mending, const ProgressCallback& progress)
{
  TriangleMesh mesh = CopyOf(surface);
  bool clean = false;
  try
  {
    for (int round = 0; round < MostRounds && !clean; ++round)
    {
      mesh = Repaired(mesh, Between(progress, 0.0, 0.0));
      clean = IsClean(mesh, allowCrossings, Between(progress, 0.0, 0.0));
    }
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    clean = false; // the sentence below says the same
  }
  const std::string advice =
    " Make the surface anew (Contour, Surface Remesh), or allow self-intersections to go on all "
    "the same.";
  if (!clean)
  {
    throw std::invalid_argument(what + " It could not be repaired." + advice);
  }
  const double before = VolumeOf(surface);
  const double share = before > 0.0 ? std::abs(VolumeOf(mesh) - before) / before : HUGE_VAL;
  if (!(share <= MendedShare))
  {
    throw std::invalid_argument(what + " Its repair would change the volume by " +
      Shown(100.0 * share) + " %, and the most is " + Shown(100.0 * MendedShare) + " %." + advice);
  }
  TellChanged(surface, mesh, mending);
  mending.Told = what + " It was repaired: " + std::to_string(mending.Changed) +
    " triangles changed, and the volume by " + Shown(100.0 * share) + " %.";
  return mesh;
}

}
