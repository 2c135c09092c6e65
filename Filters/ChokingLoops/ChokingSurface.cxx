#include "ChokingSurface.h"

#include "RangeGuard.h"
#include "SurfaceCheck.h"
#include "SurfaceRepair.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

std::size_t At(std::int64_t i)
{
  return static_cast<std::size_t>(i);
}

/// One point for each place that a triangle uses, in order of first use by point id.
TriangleMesh Merged(const TriangleMesh& surface)
{
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (const std::int64_t p : t)
    {
      if (p < 0 || At(p) >= surface.Points.size())
      {
        throw std::invalid_argument(
          "The surface has a triangle with point " + std::to_string(p) + ", which does not exist.");
      }
      used[At(p)] = 1;
    }
  }
  std::vector<std::int64_t> order;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      order.push_back(static_cast<std::int64_t>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&surface](std::int64_t a, std::int64_t b)
    {
      return surface.Points[At(a)] != surface.Points[At(b)]
        ? surface.Points[At(a)] < surface.Points[At(b)]
        : a < b;
    });
  std::vector<std::int64_t> first(surface.Points.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool same = i > 0 && surface.Points[At(order[i])] == surface.Points[At(order[i - 1])];
    first[At(order[i])] = same ? first[At(order[i - 1])] : order[i];
  }
  TriangleMesh merged;
  std::vector<std::int64_t> id(surface.Points.size(), -1);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i] && first[i] == static_cast<std::int64_t>(i))
    {
      id[i] = static_cast<std::int64_t>(merged.Points.size());
      merged.Points.push_back(surface.Points[i]);
    }
  }
  merged.Triangles.reserve(surface.Triangles.size());
  for (const Triangle& t : surface.Triangles)
  {
    merged.Triangles.push_back(
      { id[At(first[At(t[0])])], id[At(first[At(t[1])])], id[At(first[At(t[2])])] });
  }
  return merged;
}

void DemandUsableSize(const TriangleMesh& surface)
{
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    const Point3& p = surface.Points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw std::invalid_argument("Point " + std::to_string(i) +
        " of the surface is not finite: remove it or repair the surface.");
    }
  }
  Bounds3 box{ surface.Points.front(), surface.Points.front() };
  for (const Point3& p : surface.Points)
  {
    box.Add(p);
  }
  const double size =
    std::max({ box.Max[0] - box.Min[0], box.Max[1] - box.Min[1], box.Max[2] - box.Min[2] });
  if (!(size > 1e-40 && size < 1e40))
  {
    throw std::invalid_argument(
      "The surface is " + Shown(size) + " wide, which is out of range (1e-40 to 1e40): scale it.");
  }
}

}

TriangleMesh CheckedSurface(
  TriangleMesh surface, bool allowCrossings, const ProgressCallback& progress)
{
  if (surface.Triangles.empty() || surface.Points.empty())
  {
    throw std::invalid_argument("The surface has no triangles: choking loops need a closed one.");
  }
  DemandUsableSize(surface);
  Report(progress, 0.0);
  surface = Merged(surface);
  Report(progress, 0.1);
  const SurfaceDefects defects = FindDefects(surface, Between(progress, 0.1, 0.2));
  if (!defects.None())
  {
    throw std::invalid_argument(defects.Sentence() +
      " Choking loops need a closed, manifold, consistently oriented surface: repair it first "
      "(CapHoles fills holes).");
  }
  if (!allowCrossings)
  {
    const std::vector<std::int64_t> crossing =
      SelfIntersections(surface, Between(progress, 0.2, 1.0));
    if (!crossing.empty())
    {
      throw std::invalid_argument("The surface crosses itself in " +
        std::to_string(crossing.size()) + " triangles (" + FirstIds(crossing) +
        "): repair it, or allow self-intersections to go on all the same.");
    }
  }
  return surface;
}

}
