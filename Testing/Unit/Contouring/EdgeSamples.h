/**
 * @file EdgeSamples.h
 * @brief Points on the sharp edges of a solid, and whether a grid of a given spacing can keep them.
 */
#ifndef isthmus_EdgeSamples_h
#define isthmus_EdgeSamples_h

#include "Core/TriangleMesh.h"
#include "Surfaces/HausdorffDistance.h"

#include <cmath>
#include <map>
#include <set>

namespace isthmus::testing
{

/// An edge over which a solid turns by more than 30 degrees.
struct SharpSide
{
  std::array<std::int64_t, 2> Ids;
  std::array<Point3, 2> Ends;
};

inline std::vector<SharpSide> SharpSides(const TriangleMesh& solid)
{
  const auto at = [&](std::int64_t id) { return solid.Points[static_cast<std::size_t>(id)]; };
  const double cosine = std::cos(std::atan(1.0) * 2.0 / 3.0);
  std::map<std::array<std::int64_t, 2>, Point3> normals;
  std::vector<SharpSide> sides;
  for (const Triangle& t : solid.Triangles)
  {
    const Point3 n = Cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
    const double length = std::sqrt(Dot(n, n));
    for (std::size_t c = 0; c < 3 && length > 0.0; ++c)
    {
      const std::int64_t a = t[c], b = t[(c + 1) % 3];
      const auto [other, isFirst] =
        normals.insert({ { std::min(a, b), std::max(a, b) }, (1.0 / length) * n });
      if (!isFirst && Dot(other->second, n) < cosine * length)
      {
        sides.push_back({ { a, b }, { at(a), at(b) } });
      }
    }
  }
  return sides;
}

/// Points as degenerate triangles, for the searches of HausdorffDistance.h.
inline TriangleMesh AsMesh(std::vector<Point3> points)
{
  TriangleMesh mesh;
  mesh.Points = std::move(points);
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(mesh.Points.size()); ++i)
  {
    mesh.Triangles.push_back({ i, i, i });
  }
  return mesh;
}

/// The share of `points` within `distance` of `surface`.
inline double ShareWithin(const TriangleMesh& points, const TriangleMesh& surface, double distance)
{
  const auto far = TrianglesFartherThan(points, surface, distance);
  return 1.0 - static_cast<double>(far.size()) / static_cast<double>(points.Triangles.size());
}

/**
 * Whether the sharp edges within `radius` of a point are one straight line, or straight rays from
 * one corner: each stays within `slack` of it.
 */
class StraightEdges
{
public:
  explicit StraightEdges(const std::vector<SharpSide>& sides)
    : Sides(sides)
  {
    for (const SharpSide& side : sides)
    {
      for (const std::size_t e : { 0u, 1u })
      {
        const Point3 d = side.Ends[1 - e] - side.Ends[e];
        this->Rays[side.Ids[e]].push_back((1.0 / std::sqrt(Dot(d, d))) * d);
      }
    }
  }

  bool At(const SharpSide& own, const Point3& p, double radius, double slack) const
  {
    std::vector<std::array<Point3, 2>> near; // pieces in the ball
    std::set<std::int64_t> corners;
    std::map<std::int64_t, Point3> places;
    for (const SharpSide& side : this->Sides)
    {
      const auto piece = InBall(side.Ends, p, radius);
      if (piece[0] == piece[1])
      {
        continue;
      }
      near.push_back(piece);
      if (IsBeside(own, side, p, radius))
      {
        return false;
      }
      for (const std::size_t e : { 0u, 1u })
      {
        if (Length(side.Ends[e] - p) < radius && this->IsCorner(side.Ids[e]))
        {
          corners.insert(side.Ids[e]);
          places[side.Ids[e]] = side.Ends[e];
        }
      }
    }
    if (corners.empty())
    {
      const Point3 d = own.Ends[1] - own.Ends[0];
      return AreOn({ { p, (1.0 / Length(d)) * d }, { p, (-1.0 / Length(d)) * d } }, near, slack);
    }
    std::vector<std::array<Point3, 2>> rays;
    for (const Point3& direction : this->Rays.at(*corners.begin()))
    {
      rays.push_back({ places.begin()->second, direction });
    }
    return corners.size() == 1 && AreOn(rays, near, slack);
  }

private:
  bool IsCorner(std::int64_t id) const
  {
    const auto& rays = this->Rays.at(id);
    return rays.size() != 2 || -Dot(rays[0], rays[1]) < std::cos(std::atan(1.0) * 2.0 / 3.0);
  }

  /// Another edge that passes within `radius` of `p`, adjacent edges that turn back included.
  static bool IsBeside(const SharpSide& own, const SharpSide& other, const Point3& p, double radius)
  {
    const Point3 d = own.Ends[1] - own.Ends[0];
    const double from = Dot(other.Ends[0] - p, d), to = Dot(other.Ends[1] - p, d);
    if (own.Ids == other.Ids || from * to >= 0.0)
    {
      return false;
    }
    const Point3 at = other.Ends[0] + (from / (from - to)) * (other.Ends[1] - other.Ends[0]);
    return Length(at - p) <= radius;
  }

  static std::array<Point3, 2> InBall(
    const std::array<Point3, 2>& ends, const Point3& p, double radius)
  {
    const Point3 v = ends[1] - ends[0], w = ends[0] - p;
    const double a = Dot(v, v), b = Dot(w, v), c = Dot(w, w) - radius * radius;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    const auto clamp = [](double t) { return std::min(1.0, std::max(0.0, t)); };
    return { ends[0] + clamp((-b - root) / a) * v, ends[0] + clamp((-b + root) / a) * v };
  }

  /// Ends of the pieces, each within `slack` of a ray (origin, unit direction).
  static bool AreOn(const std::vector<std::array<Point3, 2>>& rays,
    const std::vector<std::array<Point3, 2>>& pieces, double slack)
  {
    const auto isOn = [&](const Point3& x)
    {
      return std::any_of(rays.begin(), rays.end(),
        [&](const std::array<Point3, 2>& ray)
        {
          const Point3 w = x - ray[0];
          return Length(w - std::max(0.0, Dot(w, ray[1])) * ray[1]) <= slack;
        });
    };
    return std::all_of(pieces.begin(), pieces.end(),
      [&](const std::array<Point3, 2>& piece) { return isOn(piece[0]) && isOn(piece[1]); });
  }

  const std::vector<SharpSide>& Sides;
  std::map<std::int64_t, std::vector<Point3>> Rays; ///< of each point: unit directions of its sides
};

struct EdgeSamples
{
  TriangleMesh All;
  TriangleMesh Resolvable;
};

/**
 * Points on the sharp edges of `solid`, `step` apart or less. *Resolvable* at the spacing h are
 * those around which, within the diagonal of a cell, sqrt(3) h, all sharp edges are one line or
 * rays from one corner, to 0.2 h: the chord of an arc of radius R over that length is 3 h^2 / 8 R
 * from it, which is 0.05 h where the arc itself leaves its tangent by 3 h^2 / 2 R = 0.2 h.
 * Otherwise there are several edges in reach of a cell that has one vertex, or they bend by more
 * than the polygons between such vertices can follow.
 */
inline EdgeSamples SampleEdgedSurface(const TriangleMesh& solid, double h, double step)
{
  const std::vector<SharpSide> sides = SharpSides(solid);
  const StraightEdges straight(sides);
  std::vector<Point3> all, resolvable;
  for (const SharpSide& side : sides)
  {
    const Point3 along = side.Ends[1] - side.Ends[0];
    const int pieces = 1 + static_cast<int>(std::sqrt(Dot(along, along)) / step);
    for (int i = 0; i < pieces; ++i)
    {
      all.push_back(side.Ends[0] + ((i + 0.5) / pieces) * along);
      if (straight.At(side, all.back(), std::sqrt(3.0) * h, 0.2 * h))
      {
        resolvable.push_back(all.back());
      }
    }
  }
  return { AsMesh(all), AsMesh(resolvable) };
}

}

#endif
