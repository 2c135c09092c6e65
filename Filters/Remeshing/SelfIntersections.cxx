#include "Remeshing/SelfIntersections.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/UnitScale.h"
#include "Remeshing/CGALSurface.h"
#include "Surfaces/TriangleBoxTree.h"

#include <CGAL/intersections.h>

#include <mutex>

namespace isthmus
{
namespace
{

constexpr std::int64_t Grain = 2048;   ///< triangles
constexpr std::int64_t GroupGrain = 8; ///< as many, in groups of the tree

double Largest(const Point3& p)
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}

/// Bound of the error of Dot(n, x) for |x| <= `reach` that is itself a rounded difference: four
/// roundings of 2^-53 relative to the sum of products, doubled.
double DotError(const Point3& n, double reach)
{
  return 1e-15 * (std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2])) * reach;
}

/// True if the plane through the origin with normal `n` surely has a, b strictly on one side and
/// c, d strictly on the other.
bool HasOnOneSide(const Point3& n, const std::array<Point3, 4>& p, double reach)
{
  const double error = DotError(n, reach);
  const double a = Dot(n, p[0]);
  const double b = Dot(n, p[1]);
  const double c = Dot(n, p[2]);
  const double d = Dot(n, p[3]);
  return std::min(a, b) > error ? std::max(c, d) < -error
                                : std::max(a, b) < -error && std::min(c, d) > error;
}

/// True if `c` and `d` surely lie strictly on one side of the plane through a, b and the origin.
/// 1e-14: six products of three factors, eight roundings each, doubled.
bool OnSameSide(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  const Point3 n = Cross(a, b);
  const double error = 1e-14 * Largest(a) * Largest(b);
  const double atC = Dot(n, c);
  const double atD = Dot(n, d);
  const bool sure = std::abs(atC) > error * Largest(c) && std::abs(atD) > error * Largest(d);
  return sure && (atC > 0.0) == (atD > 0.0);
}

/// A direction in the plane of a and b across a, on b's side, leaning a little towards a.
Point3 AcrossEdge(const Point3& a, const Point3& b)
{
  const Point3 across = Cross(Cross(a, b), a);
  const double scale = Dot(a, a);
  return across + (scale > 0.0 ? 1e-9 * std::sqrt(Dot(across, across) / scale) : 0.0) * a;
}

/// Halfway between the directions of a and b.
Point3 Bisector(const Point3& a, const Point3& b)
{
  const Point3 sum = 1.0 / Length(a) * a + 1.0 / Length(b) * b;
  return 1.0 / Length(sum) * sum;
}

/// Triangles (0, a, b) and (0, c, d) surely meet only in the origin.
bool MeetInOriginOnly(const std::array<Point3, 4>& p)
{
  const auto& [a, b, c, d] = p;
  const double reach = std::max({ Largest(a), Largest(b), Largest(c), Largest(d) });
  // The fastest test first: between triangles of about the same size it is nearly always enough.
  if (HasOnOneSide(a + b - (c + d), p, reach) || OnSameSide(a, b, c, d) || OnSameSide(c, d, a, b))
  {
    return true;
  }
  return HasOnOneSide(Bisector(a, b) - Bisector(c, d), p, reach) ||
    HasOnOneSide(AcrossEdge(a, b), p, reach) || HasOnOneSide(AcrossEdge(b, a), p, reach) ||
    HasOnOneSide(AcrossEdge(c, d), p, reach) || HasOnOneSide(AcrossEdge(d, c), p, reach);
}

using Corners = std::array<Point3, 3>;

/// True if all of `p` is surely farther along `n` than all of `q`, or the other way round.
bool Separates(const Point3& n, const Corners& p, const Corners& q, double reach)
{
  const std::array<double, 3> atP{ Dot(n, p[0]), Dot(n, p[1]), Dot(n, p[2]) };
  const std::array<double, 3> atQ{ Dot(n, q[0]), Dot(n, q[1]), Dot(n, q[2]) };
  const double error = 2.0 * DotError(n, reach);
  const auto [lowP, highP] = std::minmax_element(atP.begin(), atP.end());
  const auto [lowQ, highQ] = std::minmax_element(atQ.begin(), atQ.end());
  return *lowP - *highQ > error || *lowQ - *highP > error;
}

/// Triangles without a common point surely do not meet. Coordinates are relative to one of them.
bool AreDisjoint(const Corners& p, const Corners& q)
{
  double reach = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    reach = std::max({ reach, Largest(p[k]), Largest(q[k]) });
  }
  const Point3 normalP = Cross(p[1] - p[0], p[2] - p[0]);
  const Point3 normalQ = Cross(q[1] - q[0], q[2] - q[0]);
  if (Separates(normalP, p, q, reach) || Separates(normalQ, p, q, reach))
  {
    return true;
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (Separates(Cross(normalP, p[(k + 1) % 3] - p[k]), p, q, reach) ||
      Separates(Cross(normalQ, q[(k + 1) % 3] - q[k]), p, q, reach))
    {
      return true;
    }
  }
  return false;
}

/// Decides pairs of triangles of a mesh.
/// Nearly all, including flat neighbours, are decided by a plane that separates the two triangles
/// with a margin above rounding errors; only the rest needs exact predicates.
class TrianglePairs
{
public:
  explicit TrianglePairs(const SurfaceView& mesh)
    : Mesh(mesh)
  {
  }

  bool IsFlat(std::int64_t t) const
  {
    const auto& [a, b, c] = this->Mesh.Triangles[At(t)];
    const Point3 u = this->Point(b) - this->Point(a);
    const Point3 v = this->Point(c) - this->Point(a);
    return Largest(Cross(u, v)) <= 4e-15 * Largest(u) * Largest(v) &&
      CGAL::collinear(this->Exact(a), this->Exact(b), this->Exact(c));
  }

  /// Whether two triangles with area intersect beyond their shared corners.
  bool Meet(std::int64_t first, std::int64_t second) const
  {
    Triangle a = this->Mesh.Triangles[At(first)];
    Triangle b = this->Mesh.Triangles[At(second)];
    // Shared corners come first.
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto same = std::find(b.begin() + static_cast<std::ptrdiff_t>(shared), b.end(), a[i]);
      if (same != b.end())
      {
        std::swap(a[shared], a[i]);
        std::swap(b[shared], *same);
        ++shared;
      }
    }
    return shared == 0 ? this->MeetApart(a, b)
      : shared == 1    ? this->MeetAtPoint(a, b)
                       : shared == 3 || this->Overlap(a, b);
  }

private:
  const Point3& Point(std::int64_t i) const { return this->Mesh.Points[At(i)]; }
  cgal::Point Exact(std::int64_t i) const { return cgal::ToCGAL(this->Point(i)); }

  cgal::Kernel::Triangle_3 Exact(const Triangle& t) const
  {
    return { this->Exact(t[0]), this->Exact(t[1]), this->Exact(t[2]) };
  }

  bool MeetApart(const Triangle& a, const Triangle& b) const
  {
    const Point3& origin = this->Point(a[0]);
    const Corners p{ Point3{ 0.0, 0.0, 0.0 }, this->Point(a[1]) - origin,
      this->Point(a[2]) - origin };
    const Corners q{ this->Point(b[0]) - origin, this->Point(b[1]) - origin,
      this->Point(b[2]) - origin };
    return !AreDisjoint(p, q) && CGAL::do_intersect(this->Exact(a), this->Exact(b));
  }

  /// Point 0 of both is the same.
  bool MeetAtPoint(const Triangle& a, const Triangle& b) const
  {
    const Point3& origin = this->Point(a[0]);
    if (MeetInOriginOnly({ this->Point(a[1]) - origin, this->Point(a[2]) - origin,
          this->Point(b[1]) - origin, this->Point(b[2]) - origin }))
    {
      return false;
    }
    using Segment = cgal::Kernel::Segment_3;
    return CGAL::do_intersect(this->Exact(a), Segment(this->Exact(b[1]), this->Exact(b[2]))) ||
      CGAL::do_intersect(this->Exact(b), Segment(this->Exact(a[1]), this->Exact(a[2])));
  }

  /// Points 0 and 1 of both are the same: one lies on the other if they are folded flat.
  bool Overlap(const Triangle& a, const Triangle& b) const
  {
    const Point3& origin = this->Point(a[0]);
    const Point3 edge = this->Point(a[1]) - origin;
    const Point3 r = this->Point(a[2]) - origin;
    const Point3 s = this->Point(b[2]) - origin;
    const double size = Largest(edge);
    if (Dot(Cross(edge, r), Cross(edge, s)) < -1e-13 * size * size * Largest(r) * Largest(s))
    {
      return false;
    }
    const auto p = this->Exact(a[0]), q = this->Exact(a[1]);
    const auto t = this->Exact(a[2]), u = this->Exact(b[2]);
    return CGAL::coplanar(p, q, t, u) && CGAL::coplanar_orientation(p, q, t, u) == CGAL::POSITIVE;
  }

  SurfaceView Mesh;
};

/// A flag for each of the triangles in [0, count): it has no area.
std::vector<char> FindDegenerate(const TrianglePairs& pairs, std::int64_t count)
{
  std::vector<char> flat(At(count), 0);
  ParallelFor(0, count, Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t t = begin; t < end; ++t)
      {
        flat[At(t)] = pairs.IsFlat(t) ? 1 : 0;
      }
    });
  return flat;
}

}

std::vector<std::int64_t> SelfIntersections(
  const SurfaceView& mesh, const ProgressCallback& progress)
{
  const UnitScale scale(mesh.Points);
  if (!scale.IsOne())
  {
    TriangleMesh scaled = CopyMesh(mesh);
    scale.Apply(scaled.Points);
    return SelfIntersections(scaled, progress);
  }
  Report(progress, 0.0);
  const TriangleBoxTree tree(mesh);
  Report(progress, 0.2);
  const TrianglePairs pairs(mesh);
  const std::vector<char> flat =
    FindDegenerate(pairs, static_cast<std::int64_t>(mesh.Triangles.size()));
  std::vector<std::int64_t> found;
  for (std::size_t t = 0; t < flat.size(); ++t)
  {
    if (flat[t])
    {
      found.push_back(static_cast<std::int64_t>(t));
    }
  }
  std::mutex mutex;
  ParallelFor(
    0, tree.Groups(), GroupGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<std::int64_t> mine;
      for (std::int64_t group = begin; group < end; ++group)
      {
        tree.ForEachPair(group,
          [&](std::int64_t a, std::int64_t b)
          {
            if (!flat[At(a)] && !flat[At(b)] && pairs.Meet(a, b))
            {
              mine.insert(mine.end(), { a, b });
            }
          });
      }
      const std::lock_guard<std::mutex> lock(mutex);
      found.insert(found.end(), mine.begin(), mine.end());
    },
    Between(progress, 0.2, 1.0));
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}
