#include "Surfaces/ShellNesting.h"

#include "Core/Geometry.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/WindingNumber.h"

#include <limits>
#include <optional>
#include <stdexcept>
#include <unordered_map>

namespace isthmus
{
namespace
{

bool IsInside(const Point3& p, const SurfaceView& shell)
{
  double sum = 0.0;
  for (const Triangle& t : shell.Triangles)
  {
    sum += SolidAngle(shell.Point(t[0]) - p, shell.Point(t[1]) - p, shell.Point(t[2]) - p);
  }
  return std::abs(sum) > 2.0 * Pi; // half of 4 pi
}

/// Where the ray from `p` along `d` meets the triangle, in multiples of d (T. Moeller, B. Trumbore,
/// J. Graphics Tools 2 (1997) 21).
std::optional<double> Hit(
  const Point3& p, const Point3& d, const Point3& a, const Point3& b, const Point3& c)
{
  const Point3 e1 = b - a;
  const Point3 e2 = c - a;
  const Point3 h = Cross(d, e2);
  const double det = Dot(e1, h);
  if (det == 0.0)
  {
    return {};
  }
  const Point3 s = p - a;
  const double u = Dot(s, h) / det;
  const Point3 q = Cross(s, e1);
  const double v = Dot(d, q) / det;
  constexpr double slack = 1e-9; // an edge may be hit twice, never missed
  if (u < -slack || v < -slack || u + v > 1.0 + slack)
  {
    return {};
  }
  return Dot(e2, q) / det;
}

/// Distance along unit vector `d` from `p` to the next triangle; distances up to `own` are those to
/// the triangle of p.
double Gap(const SurfaceView& mesh, const Point3& p, const Point3& d, double own)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.Triangles)
  {
    const auto hit = Hit(p, d, mesh.Point(t[0]), mesh.Point(t[1]), mesh.Point(t[2]));
    if (hit && *hit > own)
    {
      nearest = std::min(nearest, *hit);
    }
  }
  return nearest;
}

/// A point right inside the first of `walls`: below the middle of one of its largest triangles,
/// half way to the next triangle; of several candidates, the one with the most space. The other
/// walls are the shells directly inside it: no other triangle can come next.
Point3 PointInside(const std::vector<SurfaceView>& walls)
{
  const SurfaceView& shell = walls.front();
  constexpr std::size_t tries = 8;
  std::vector<std::pair<double, Triangle>> largest;
  for (const Triangle& t : shell.Triangles)
  {
    const Point3& a = shell.Point(t[0]);
    const Point3 n = Cross(shell.Point(t[1]) - a, shell.Point(t[2]) - a);
    largest.emplace_back(-Dot(n, n), t);
  }
  const std::size_t count = std::min(tries, largest.size());
  std::partial_sort(
    largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(count), largest.end());
  const double tooThin = 1e-12 * ComputeBounds(shell).Diagonal();
  double best = tooThin;
  Point3 inside{ 0, 0, 0 };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Triangle& t = largest[i].second;
    const Point3 &a = shell.Point(t[0]), &b = shell.Point(t[1]), &c = shell.Point(t[2]);
    const Point3 n = Cross(b - a, c - a);
    const Point3 inward = (-1.0 / Length(n)) * n;
    const Point3 center = (1.0 / 3.0) * (a + b + c);
    double gap = std::numeric_limits<double>::infinity();
    for (const SurfaceView& wall : walls)
    {
      gap = std::min(gap, Gap(wall, center, inward, tooThin));
    }
    if (std::isfinite(gap) && gap > best)
    {
      best = gap;
      inside = center + (0.5 * gap) * inward;
    }
  }
  if (best == tooThin)
  {
    throw std::invalid_argument("A part of the surface is too thin to find a point inside it: "
                                "remove it or remesh the surface.");
  }
  return inside;
}

/// Gives `shell`, whose triangles index `points`, the points it uses and no others.
void CompactPoints(TriangleMesh& shell, const View<Point3>& points)
{
  std::unordered_map<std::int64_t, std::int64_t> compact;
  for (Triangle& t : shell.Triangles)
  {
    for (vtkIdType& p : t)
    {
      const auto [known, isNew] =
        compact.emplace(p, static_cast<std::int64_t>(shell.Points.size()));
      if (isNew)
      {
        shell.Points.push_back(points[static_cast<std::size_t>(p)]);
      }
      p = known->second;
    }
  }
}

/// The shells of `mesh`, each facing outward, and its volume.
void SplitShells(const SurfaceView& mesh, ShellNesting& nesting)
{
  nesting.ShellOfTriangle = Components(mesh);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto s = static_cast<std::size_t>(nesting.ShellOfTriangle[t]);
    if (s == nesting.Shells.size())
    {
      nesting.Shells.emplace_back();
    }
    nesting.Shells[s].Triangles.push_back(mesh.Triangles[t]);
  }
  nesting.InnerRegions.resize(nesting.Shells.size());
  for (std::size_t s = 0; s < nesting.Shells.size(); ++s)
  {
    TriangleMesh& shell = nesting.Shells[s];
    CompactPoints(shell, mesh.Points);
    const double volume = SignedVolume(shell);
    nesting.InnerRegions[s].Volume = std::abs(volume);
    if (volume < 0.0)
    {
      for (Triangle& t : shell.Triangles)
      {
        std::swap(t[1], t[2]);
      }
    }
  }
}

/// For each shell, the smallest shell around it (-1: none) and the number of shells around it.
void FindParents(const ShellNesting& nesting, std::vector<int>& parent, std::vector<int>& depth,
  const ProgressCallback& progress)
{
  const std::size_t n = nesting.Shells.size();
  std::vector<Bounds3> bounds;
  for (const TriangleMesh& shell : nesting.Shells)
  {
    bounds.push_back(ComputeBounds(shell));
  }
  parent.assign(n, -1);
  depth.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i)
  {
    Report(progress, static_cast<double>(i) / static_cast<double>(n));
    for (std::size_t j = 0; j < n; ++j)
    {
      if (i == j || !bounds[j].Contains(bounds[i]) ||
        !IsInside(nesting.Shells[i].Points.front(), nesting.Shells[j]))
      {
        continue;
      }
      ++depth[i];
      if (parent[i] < 0 ||
        nesting.InnerRegions[j].Volume <
          nesting.InnerRegions[static_cast<std::size_t>(parent[i])].Volume)
      {
        parent[i] = static_cast<int>(j);
      }
    }
  }
}

}

Bounds3 ComputeBounds(const SurfaceView& mesh)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  Bounds3 bounds{ { far, far, far }, { -far, -far, -far } };
  for (const Triangle& t : mesh.Triangles)
  {
    for (const vtkIdType p : t)
    {
      bounds.Add(mesh.Point(p));
    }
  }
  return bounds;
}

ShellNesting FindNesting(const SurfaceView& mesh, const ProgressCallback& progress)
{
  ShellNesting nesting;
  SplitShells(mesh, nesting);
  std::vector<int> parent;
  std::vector<int> depth;
  FindParents(nesting, parent, depth, Between(progress, 0.0, 0.5));

  const std::size_t n = nesting.Shells.size();
  std::vector<std::vector<SurfaceView>> walls(n);
  for (std::size_t s = 0; s < n; ++s)
  {
    walls[s].insert(walls[s].begin(), nesting.Shells[s]);
    if (parent[s] >= 0)
    {
      walls[static_cast<std::size_t>(parent[s])].push_back(nesting.Shells[s]);
    }
  }
  const auto rest = Between(progress, 0.5, 1.0);
  int solids = 0;
  int cavities = 0;
  for (std::size_t s = 0; s < n; ++s)
  {
    nesting.InnerRegions[s].Id = depth[s] % 2 == 0 ? ++solids : --cavities;
    nesting.InnerRegions[s].Seed = PointInside(walls[s]);
    Report(rest, static_cast<double>(s + 1) / static_cast<double>(n));
  }
  nesting.OuterRegionIds.assign(n, 0);
  std::vector<double> hollow(n, 0.0);
  for (std::size_t s = 0; s < n; ++s)
  {
    if (parent[s] >= 0)
    {
      const auto p = static_cast<std::size_t>(parent[s]);
      nesting.OuterRegionIds[s] = nesting.InnerRegions[p].Id;
      hollow[p] += nesting.InnerRegions[s].Volume;
    }
  }
  for (std::size_t s = 0; s < n; ++s)
  {
    nesting.InnerRegions[s].Volume -= hollow[s];
  }
  return nesting;
}

}
