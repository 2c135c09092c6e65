#include "Remeshing/LineCorners.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <array>
#include <utility>

namespace isthmus::cgal
{
namespace
{

/// Feature lines inside a surface, which are jagged where it is noisy, are followed less closely
/// than boundaries: their points do not change what the surface covers.
constexpr double InsideShare = 100.0;

using VertexIndex = SurfaceMesh::Vertex_index;
using HalfedgeIndex = SurfaceMesh::Halfedge_index;

/// Halfedges of lines that leave `v`.
std::vector<HalfedgeIndex> LeavingLines(
  const SurfaceMesh& mesh, const std::vector<bool>& isLine, VertexIndex v)
{
  std::vector<HalfedgeIndex> leaving;
  if (!mesh.is_isolated(v))
  {
    for (const HalfedgeIndex h : mesh.halfedges_around_target(mesh.halfedge(v)))
    {
      if (isLine[mesh.edge(h)])
      {
        leaving.push_back(mesh.opposite(h));
      }
    }
  }
  return leaving;
}

/// The line that begins with `h`, to the next junction, or back to its beginning.
std::vector<HalfedgeIndex> Follow(const SurfaceMesh& mesh, const std::vector<bool>& isLine,
  const std::vector<bool>& isJunction, HalfedgeIndex h)
{
  std::vector<HalfedgeIndex> line{ h };
  const VertexIndex start = mesh.source(h);
  for (VertexIndex at = mesh.target(h); at != start && !isJunction[at]; at = mesh.target(h))
  {
    const std::vector<HalfedgeIndex> leaving = LeavingLines(mesh, isLine, at);
    h = leaving[mesh.edge(leaving[0]) == mesh.edge(h) ? 1 : 0];
    line.push_back(h);
  }
  return line;
}

double DistanceToSegment(const Point3& p, const Point3& a, const Point3& b)
{
  const Point3 along = b - a;
  const double square = Dot(along, along);
  const double share = square > 0.0 ? std::clamp(Dot(p - a, along) / square, 0.0, 1.0) : 0.0;
  return Length(p - a - share * along);
}

/// The point of `points` between `first` and `last` that is farthest from the segment of these.
std::pair<std::size_t, double> Farthest(
  const std::vector<Point3>& points, std::size_t first, std::size_t last)
{
  std::pair<std::size_t, double> farthest{ first, -1.0 };
  for (std::size_t i = first + 1; i < last; ++i)
  {
    const double distance = DistanceToSegment(points[i], points[first], points[last]);
    if (distance > farthest.second)
    {
      farthest = { i, distance };
    }
  }
  return farthest;
}

/// Marks corners between `first` and `last`.
void MarkCorners(const std::vector<Point3>& points, std::size_t first, std::size_t last,
  double tolerance, std::vector<bool>& isCorner)
{
  std::vector<std::array<std::size_t, 2>> open{ { first, last } };
  while (!open.empty())
  {
    const auto [from, to] = open.back();
    open.pop_back();
    const auto [at, distance] = Farthest(points, from, to);
    if (distance > tolerance)
    {
      isCorner[at] = true;
      open.push_back({ from, at });
      open.push_back({ at, to });
    }
  }
}

/// Begins a closed line at the point that is farthest from the mean, which is a corner if there is
/// one.
void BeginAtCorner(const SurfaceMesh& mesh, std::vector<HalfedgeIndex>& line)
{
  Point3 mean{ 0, 0, 0 };
  for (const HalfedgeIndex h : line)
  {
    mean = mean + (1.0 / static_cast<double>(line.size())) * FromCGAL(mesh.point(mesh.source(h)));
  }
  const auto distance = [&](HalfedgeIndex h)
  { return Length(FromCGAL(mesh.point(mesh.source(h))) - mean); };
  std::rotate(line.begin(),
    std::max_element(line.begin(), line.end(),
      [&](HalfedgeIndex a, HalfedgeIndex b) { return distance(a) < distance(b); }),
    line.end());
}

/// Appends the parts of one line from junction to junction, or of a closed one.
void CutAtCorners(const SurfaceMesh& mesh, std::vector<HalfedgeIndex> line, double tolerance,
  std::vector<LineBetweenCorners>& parts)
{
  const bool isClosed = mesh.source(line.front()) == mesh.target(line.back());
  std::vector<Point3> points;
  points.reserve(line.size() + 1);
  for (const HalfedgeIndex h : line)
  {
    points.push_back(FromCGAL(mesh.point(mesh.source(h))));
  }
  points.push_back(FromCGAL(mesh.point(mesh.target(line.back()))));
  std::vector<bool> isCorner(points.size(), false);
  const std::size_t last = points.size() - 1;
  const std::size_t middle = isClosed ? Farthest(points, 0, last).first : last;
  isCorner[middle] = isCorner[last] = true;
  MarkCorners(points, 0, middle, tolerance, isCorner);
  MarkCorners(points, middle, last, tolerance, isCorner);
  LineBetweenCorners part;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    part.Points.push_back(mesh.source(line[i]));
    part.Edges.push_back(mesh.edge(line[i]));
    if (isCorner[i + 1])
    {
      part.Points.push_back(mesh.target(line[i]));
      parts.push_back(std::exchange(part, {}));
    }
  }
}

}

std::vector<LineBetweenCorners> CutLinesAtCorners(
  const SurfaceMesh& mesh, const std::vector<bool>& isLine, double tolerance)
{
  std::vector<bool> isJunction(mesh.num_vertices(), false);
  for (const VertexIndex v : mesh.vertices())
  {
    const std::vector<HalfedgeIndex> leaving = LeavingLines(mesh, isLine, v);
    const auto along = [&](HalfedgeIndex h)
    { return FromCGAL(mesh.point(mesh.target(h))) - FromCGAL(mesh.point(v)); };
    isJunction[v] =
      leaving.size() == 2 ? Dot(along(leaving[0]), along(leaving[1])) > 0.0 : !leaving.empty();
  }
  std::vector<LineBetweenCorners> parts;
  std::vector<bool> isDone(mesh.num_edges(), false);
  const auto cut = [&](HalfedgeIndex first, bool isLoop)
  {
    if (isDone[mesh.edge(first)])
    {
      return;
    }
    std::vector<HalfedgeIndex> line = Follow(mesh, isLine, isJunction, first);
    for (const HalfedgeIndex h : line)
    {
      isDone[mesh.edge(h)] = true;
    }
    if (isLoop)
    {
      BeginAtCorner(mesh, line);
    }
    const bool isBorder = mesh.is_border(mesh.edge(first));
    CutAtCorners(mesh, std::move(line), isBorder ? tolerance : InsideShare * tolerance, parts);
  };
  for (const VertexIndex v : mesh.vertices())
  {
    if (isJunction[v])
    {
      for (const HalfedgeIndex h : LeavingLines(mesh, isLine, v))
      {
        cut(h, false);
      }
    }
  }
  for (const auto e : mesh.edges())
  {
    if (isLine[e])
    {
      cut(mesh.halfedge(e), true);
    }
  }
  return parts;
}

}
