#include "Surfaces/SurfaceCheck.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Surfaces/StarDefects.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 1 << 14;

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

enum class TriangleKind : char
{
  Sound,
  Degenerate,
  Invalid
};

TriangleKind KindOf(const SurfaceView& mesh, const Triangle& ids)
{
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  const bool inRange =
    std::all_of(ids.begin(), ids.end(), [points](std::int64_t p) { return p >= 0 && p < points; });
  if (!inRange || ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
  {
    return TriangleKind::Invalid;
  }
  return HasNoArea(mesh.Points[At(ids[0])], mesh.Points[At(ids[1])], mesh.Points[At(ids[2])])
    ? TriangleKind::Degenerate
    : TriangleKind::Sound;
}

/// Invalid and degenerate triangles; a flag each for those that have no usable point ids.
std::vector<char> CheckTriangles(const SurfaceView& mesh, SurfaceDefects& found)
{
  std::vector<TriangleKind> kinds(mesh.Triangles.size());
  ParallelFor(0, static_cast<std::int64_t>(kinds.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t t = begin; t < end; ++t)
      {
        kinds[At(t)] = KindOf(mesh, mesh.Triangles[At(t)]);
      }
    });
  std::vector<char> skip(kinds.size());
  for (std::size_t t = 0; t < kinds.size(); ++t)
  {
    if (kinds[t] == TriangleKind::Degenerate)
    {
      found.DegenerateTriangles.push_back(static_cast<std::int64_t>(t));
    }
    else if (kinds[t] == TriangleKind::Invalid)
    {
      found.InvalidTriangles.push_back(static_cast<std::int64_t>(t));
      skip[t] = 1;
    }
  }
  return skip;
}

}

SurfaceDefects FindDefects(const SurfaceView& mesh, const ProgressCallback& progress)
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
  const std::vector<char> skip = CheckTriangles(mesh, found);
  Report(progress, 0.3);
  FindStarDefects(mesh, skip, found);
  Report(progress, 1.0);
  return found;
}

void DemandResolved(const SurfaceView& mesh)
{
  constexpr double resolution = 0x1p-50; // what a few sums of coordinates round away
  double reach = 0.0;
  std::vector<double> longest(mesh.Points.size(), -1.0); // edge of each point; < 0: none
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto a = static_cast<std::size_t>(t[c]);
      const auto b = static_cast<std::size_t>(t[(c + 1) % 3]);
      const double edge = Distance(mesh.Points[a], mesh.Points[b]);
      longest[a] = std::max(longest[a], edge);
      longest[b] = std::max(longest[b], edge);
      reach = std::max({ reach, std::abs(mesh.Points[a][0]), std::abs(mesh.Points[a][1]),
        std::abs(mesh.Points[a][2]) });
    }
  }
  for (std::size_t i = 0; i < longest.size(); ++i)
  {
    if (longest[i] >= 0.0 && longest[i] < resolution * reach)
    {
      throw std::invalid_argument("The edges at point " + std::to_string(i) + " are " +
        FormatNumber(longest[i]) + " long at most, and coordinates of " + FormatNumber(reach) +
        " are told no finer than that: remove the points that are far off, or the tiny part.");
    }
  }
}

}
