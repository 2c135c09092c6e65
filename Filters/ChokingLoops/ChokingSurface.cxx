#include "ChokingLoops/ChokingSurface.h"

#include "Core/Bounds3.h"
#include "Core/RangeGuard.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceCheck.h"
#include "Surfaces/SurfaceIntake.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Flat = 1e-10; ///< thickness over width: what rounding leaves of a plane

/// Of all points the one where `measure` is greatest.
template <typename Measure>
const Point3& Farthest(const View<Point3>& points, Measure&& measure)
{
  return *std::max_element(points.begin(), points.end(),
    [&measure](const Point3& a, const Point3& b) { return measure(a) < measure(b); });
}

/// How far the points lie from the plane of three that are far from each other.
double Thickness(const View<Point3>& points)
{
  const Point3& origin = points.front();
  const auto square = [](const Point3& v) { return Dot(v, v); };
  const Point3 along =
    Farthest(points, [&](const Point3& p) { return square(p - origin); }) - origin;
  const Point3 normal = Cross(along,
    Farthest(points, [&](const Point3& p) { return square(Cross(along, p - origin)); }) - origin);
  const auto height = [&](const Point3& p) { return std::abs(Dot(normal, p - origin)); };
  const double length = std::sqrt(square(normal));
  return length > 0.0 ? height(Farthest(points, height)) / length : 0.0;
}

void DemandUsableSize(const SurfaceView& surface)
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
  // Squared circumradii are quotients of eighth powers of the spacing, a ten-thousandth of this.
  if (!(size > 1e-32 && size < 1e32))
  {
    throw std::invalid_argument(
      "The surface is " + Shown(size) + " wide, which is out of range (1e-32 to 1e32): scale it.");
  }
}

/// Repair would look for an inside for long, in vain.
void DemandThickness(const SurfaceView& surface)
{
  Bounds3 box{ surface.Points.front(), surface.Points.front() };
  for (const Point3& p : surface.Points)
  {
    box.Add(p);
  }
  if (Thickness(surface.Points) < Flat * box.Diagonal())
  {
    throw std::invalid_argument("All points of the surface lie in a plane, so that it has no "
                                "inside: give it a thickness.");
  }
}

/// Holes, missing points and triangles turned against each other are not guessed at.
bool CanBeMended(const SurfaceDefects& defects)
{
  return defects.InvalidPoints.empty() && defects.InvalidTriangles.empty() &&
    defects.BoundaryTriangles.empty() && defects.FlippedTriangles.empty();
}

/// The surface repaired where it has thin triangles; none: it has none, or it is as good with them,
/// since they are no defect by themselves and can't be taken out without making one.
std::optional<TriangleMesh> WithoutNeedles(const SurfaceView& surface, bool allowCrossings,
  SurfaceMending& mending, const ProgressCallback& progress)
{
  const std::vector<std::int64_t> thin = ThinTriangles(surface);
  if (thin.empty())
  {
    return std::nullopt;
  }
  try
  {
    return MendedSurface(surface,
      "The surface has " + std::to_string(thin.size()) + " triangles next to no area (" +
        FirstIds(thin) + ").",
      allowCrossings, mending, progress);
  }
  catch (const std::invalid_argument&)
  {
    mending = {};
    return std::nullopt;
  }
}

}

TriangleMesh CheckedSurface(TriangleMesh surface, bool allowCrossings,
  const ProgressCallback& progress, SurfaceMending* mending)
{
  if (surface.Triangles.empty() || surface.Points.empty())
  {
    throw std::invalid_argument("The surface has no triangles: choking loops need a closed one.");
  }
  DemandUsableSize(surface);
  Report(progress, 0.0);
  surface = MergePoints(surface);
  Report(progress, 0.1);
  const auto rest = Between(progress, 0.6, 1.0);
  const SurfaceDefects defects = FindDefects(surface, Between(progress, 0.1, 0.2));
  if (!defects.None() && !(mending && CanBeMended(defects)))
  {
    throw std::invalid_argument(defects.Sentence() + WhyOpen(surface, defects) +
      " Choking loops need a closed, manifold, consistently oriented surface: repair it first "
      "(Fill Holes, or CapHoles of Choking Loops, closes holes).");
  }
  DemandThickness(surface);
  if (!defects.None())
  {
    return MendedSurface(surface, defects.Sentence(), allowCrossings, *mending, rest);
  }
  if (mending)
  {
    std::optional<TriangleMesh> mended = WithoutNeedles(surface, allowCrossings, *mending, rest);
    if (mended)
    {
      return std::move(*mended);
    }
  }
  const std::vector<std::int64_t> crossing = allowCrossings
    ? std::vector<std::int64_t>{}
    : SelfIntersections(surface, Between(progress, 0.2, 0.6));
  if (crossing.empty())
  {
    return surface;
  }
  const std::string what = "The surface crosses itself in " + std::to_string(crossing.size()) +
    " triangles (" + FirstIds(crossing) + ").";
  if (!mending)
  {
    throw std::invalid_argument(what +
      " Repair it, or allow self-intersections to go on all the "
      "same.");
  }
  return MendedSurface(surface, what, allowCrossings, *mending, rest);
}

}
