#include "SurfaceCheck.h"

#include "DisjointSets.h"
#include "MeshEdges.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

void Sort(std::vector<std::int64_t>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Edges are brought to about 1 first, by a power of two: the square of an area of 1e-100 is 0.
bool HasNoArea(const Point3& p, const Point3& q, const Point3& r)
{
  Point3 u = q - p, v = r - p;
  double largest = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    largest = std::max({ largest, std::abs(u[a]), std::abs(v[a]) });
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double scale = std::ldexp(1.0, -exponent);
  const Point3 normal = Cross(scale * u, scale * v);
  return Dot(normal, normal) == 0.0;
}

/// Invalid, degenerate and duplicate triangles; returns which ones have no usable point ids.
std::vector<bool> CheckTriangles(const TriangleMesh& mesh, SurfaceDefects& found)
{
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  std::vector<bool> skip(mesh.Triangles.size());
  std::vector<std::pair<Triangle, std::int64_t>> sorted;
  sorted.reserve(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Triangle& ids = mesh.Triangles[t];
    const auto id = static_cast<std::int64_t>(t);
    const bool inRange = std::all_of(
      ids.begin(), ids.end(), [points](std::int64_t p) { return p >= 0 && p < points; });
    if (!inRange || ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
    {
      found.InvalidTriangles.push_back(id);
      skip[t] = true;
      continue;
    }
    if (HasNoArea(mesh.Points[static_cast<std::size_t>(ids[0])],
          mesh.Points[static_cast<std::size_t>(ids[1])],
          mesh.Points[static_cast<std::size_t>(ids[2])]))
    {
      found.DegenerateTriangles.push_back(id);
    }
    Triangle key = ids;
    std::sort(key.begin(), key.end());
    sorted.emplace_back(key, id);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].first == sorted[i - 1].first)
    {
      found.DuplicateTriangles.push_back(sorted[i].second);
    }
  }
  Sort(found.DuplicateTriangles);
  return skip;
}

void CheckEdges(const std::vector<HalfEdge>& edges, SurfaceDefects& found)
{
  ForEachEdge(edges,
    [&found](auto first, auto last)
    {
      const auto count = last - first;
      if (count == 1)
      {
        found.BoundaryTriangles.push_back(first->Triangle);
      }
      else if (count > 2)
      {
        std::for_each(first, last,
          [&found](const HalfEdge& e) { found.NonManifoldTriangles.push_back(e.Triangle); });
      }
      else if (first->Ascending == (first + 1)->Ascending)
      {
        found.FlippedTriangles.push_back(first->Triangle);
        found.FlippedTriangles.push_back((first + 1)->Triangle);
      }
    });
  Sort(found.BoundaryTriangles);
  Sort(found.NonManifoldTriangles);
  Sort(found.FlippedTriangles);
}

/// Points whose triangles hang together at the point only.
void CheckFans(const TriangleMesh& mesh, const std::vector<HalfEdge>& edges,
  const std::vector<bool>& skip, SurfaceDefects& found)
{
  const auto cornerAt = [&mesh](std::int64_t triangle, std::int64_t point)
  {
    const Triangle& ids = mesh.Triangles[static_cast<std::size_t>(triangle)];
    const auto corner = std::find(ids.begin(), ids.end(), point) - ids.begin();
    return 3 * triangle + corner;
  };
  DisjointSets<std::int64_t> corners(static_cast<std::int64_t>(3 * mesh.Triangles.size()));
  ForEachEdge(edges,
    [&](auto first, auto last)
    {
      for (auto e = first + 1; e != last; ++e)
      {
        corners.Join(cornerAt(first->Triangle, e->Low), cornerAt(e->Triangle, e->Low));
        corners.Join(cornerAt(first->Triangle, e->High), cornerAt(e->Triangle, e->High));
      }
    });
  std::vector<std::int64_t> fan(mesh.Points.size(), -1);
  for (std::size_t c = 0; c < 3 * mesh.Triangles.size(); ++c)
  {
    if (skip[c / 3])
    {
      continue;
    }
    const std::int64_t point = mesh.Triangles[c / 3][c % 3];
    std::int64_t& root = fan[static_cast<std::size_t>(point)];
    const std::int64_t mine = corners.Find(static_cast<std::int64_t>(c));
    if (root < 0)
    {
      root = mine;
    }
    else if (root != mine)
    {
      found.NonManifoldPoints.push_back(point);
    }
  }
  Sort(found.NonManifoldPoints);
}

}

bool SurfaceDefects::None() const
{
  return this->InvalidPoints.empty() && this->InvalidTriangles.empty() &&
    this->DegenerateTriangles.empty() && this->DuplicateTriangles.empty() &&
    this->BoundaryTriangles.empty() && this->NonManifoldTriangles.empty() &&
    this->FlippedTriangles.empty() && this->NonManifoldPoints.empty();
}

std::string FirstIds(const std::vector<std::int64_t>& ids)
{
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, ids.size()); ++i)
  {
    text += (i ? ", " : "") + std::to_string(ids[i]);
  }
  return ids.size() > shown ? text + " and " + std::to_string(ids.size() - shown) + " more" : text;
}

std::string SurfaceDefects::Sentence() const
{
  std::string text;
  const auto add = [&text](const std::vector<std::int64_t>& ids, const char* what)
  {
    if (!ids.empty())
    {
      text += (text.empty() ? "" : "; ") + std::string(what) + " (" + FirstIds(ids) + ")";
    }
  };
  add(this->InvalidPoints, "points that are not finite");
  add(this->InvalidTriangles, "triangles with a repeated or missing point");
  add(this->DegenerateTriangles, "triangles without area");
  add(this->DuplicateTriangles, "duplicate triangles");
  add(this->BoundaryTriangles, "triangles at a hole");
  add(this->NonManifoldTriangles, "triangles at an edge of more than two");
  add(this->FlippedTriangles, "neighbouring triangles of opposite orientation");
  add(this->NonManifoldPoints, "points where sheets touch");
  return text.empty() ? text : "The surface has " + text + ".";
}

SurfaceDefects FindDefects(const TriangleMesh& mesh, const ProgressCallback& progress)
{
  SurfaceDefects found;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Point3& p = mesh.Points[i];
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
    {
      found.InvalidPoints.push_back(static_cast<std::int64_t>(i));
    }
  }
  const std::vector<bool> skip = CheckTriangles(mesh, found);
  Report(progress, 0.3);
  const std::vector<HalfEdge> edges = SortedHalfEdges(mesh, skip);
  Report(progress, 0.8);
  CheckEdges(edges, found);
  CheckFans(mesh, edges, skip, found);
  Report(progress, 1.0);
  return found;
}

}
