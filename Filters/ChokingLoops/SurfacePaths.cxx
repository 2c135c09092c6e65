#include "ChokingLoops/SurfacePaths.h"

#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// SurfaceAdjacency

SurfaceAdjacency::SurfaceAdjacency(const SurfaceView& mesh)
  : Surface(mesh)
  , Opposites(3 * mesh.Triangles.size(), HalfEdgeId::None())
  , EdgeIds(3 * mesh.Triangles.size(), SurfaceEdgeId::None())
  , Outgoing(mesh.Points.size(), HalfEdgeId::None())
{
  // Half edges in buckets by their smaller end; partners meet in a short list.
  std::vector<SimplexId> first(mesh.Points.size() + 1, 0);
  const auto smaller = [this](HalfEdgeId h)
  { return static_cast<std::size_t>(std::min(this->From(h), this->To(h))); };
  for (const HalfEdgeId h : this->HalfEdges())
  {
    ++first[smaller(h) + 1];
    this->Outgoing[static_cast<std::size_t>(this->From(h))] = h;
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SimplexId> next(first.begin(), first.end() - 1);
  std::vector<HalfEdgeId> bucket(this->Opposites.size());
  for (const HalfEdgeId h : this->HalfEdges())
  {
    const std::size_t p = smaller(h);
    for (SimplexId i = first[p]; i < next[p]; ++i)
    {
      const HalfEdgeId other = bucket[static_cast<std::size_t>(i)];
      if (this->From(other) == this->To(h) && this->To(other) == this->From(h))
      {
        this->Opposites[h] = other;
        this->Opposites[other] = h;
        this->EdgeIds[h] = SurfaceEdgeId::At(this->Halves.size());
        this->EdgeIds[other] = this->EdgeIds[h];
        this->Halves.push_back(other);
      }
    }
    bucket[static_cast<std::size_t>(next[p]++)] = h;
  }
  if (std::find(this->Opposites.begin(), this->Opposites.end(), HalfEdgeId::None()) !=
    this->Opposites.end())
  {
    throw std::invalid_argument("The surface is not closed: an edge has one triangle only.");
  }
}

HalfEdgeId SurfaceAdjacency::Find(SimplexId a, SimplexId b) const
{
  const HalfEdgeId start = this->Leaving(a);
  if (!start.Exists())
  {
    return HalfEdgeId::None();
  }
  HalfEdgeId h = start;
  do
  {
    if (this->To(h) == b)
    {
      return h;
    }
    h = this->Turn(h);
  } while (h != start);
  return HalfEdgeId::None();
}

// ------------------------------------------------------------------------------------------
// SurfacePaths

SurfacePaths::SurfacePaths(
  const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to)
  : Surface(surface)
  , Goal(to)
{
  this->Queue.push({ this->Left(from), from, HalfEdgeId::None(), 0.0 });
  this->Grow(reach);
}

/// A lower bound of the paths from p to the goal; 0 without a goal.
double SurfacePaths::Left(SimplexId p) const
{
  const auto& points = this->Surface.Mesh().Points;
  return this->Goal < 0 ? 0.0 : Distance(points[At(p)], points[At(this->Goal)]);
}

void SurfacePaths::Grow(double reach)
{
  while (!this->Queue.empty() && this->Queue.top().Least <= reach)
  {
    const Entry entry = this->Queue.top();
    this->Queue.pop();
    if (!this->Has(entry.Point))
    {
      this->Settle(entry);
      if (entry.Point == this->Goal)
      {
        return;
      }
    }
  }
}

void SurfacePaths::Settle(const Entry& entry)
{
  this->Places[entry.Point] = static_cast<std::int32_t>(this->Settled.size());
  this->Settled.push_back(entry.Point);
  this->Lengths.push_back(entry.Length);
  this->Lasts.push_back(entry.Last);
  const HalfEdgeId first = this->Surface.Leaving(entry.Point);
  if (!first.Exists())
  {
    return; // no triangle uses it
  }
  HalfEdgeId h = first;
  do
  {
    const SimplexId next = this->Surface.To(h);
    if (!this->Has(next))
    {
      const double edge = this->Surface.Length(h);
      const double length = entry.Length + edge;
      this->Longest = std::max(this->Longest, edge);
      this->Queue.push({ length + this->Left(next), next, h, length });
    }
    h = this->Surface.Turn(h);
  } while (h != first);
}

// ------------------------------------------------------------------------------------------
// EdgeStrip

Point3 ComputePosition(const SurfaceAdjacency& s, const SurfaceCurvePoint& p)
{
  const Point3& a = s.Mesh().Points[static_cast<std::size_t>(s.From(p.HalfEdge))];
  const Point3& b = s.Mesh().Points[static_cast<std::size_t>(s.To(p.HalfEdge))];
  return (1.0 - p.Fraction) * a + p.Fraction * b;
}

EdgeStrip WithoutBacktracking(const SurfaceAdjacency& s, const EdgeStrip& strip)
{
  EdgeStrip kept;
  for (const SurfaceCurvePoint& c : strip)
  {
    if (!kept.empty() && s.Opposite(kept.back().HalfEdge) == c.HalfEdge)
    {
      kept.pop_back();
    }
    else
    {
      kept.push_back(c);
    }
  }
  return kept;
}

namespace
{

/// The edges at path[i] left of the way from path[i - 1] to path[i + 1], added to the strip.
void AddLeftCrossings(
  const SurfaceAdjacency& s, const std::vector<SimplexId>& path, std::size_t i, EdgeStrip& strip)
{
  const std::size_t n = path.size();
  const HalfEdgeId in = s.Find(path[(i + n - 1) % n], path[i]);
  const HalfEdgeId out = s.Find(path[i], path[(i + 1) % n]);
  if (!in.Exists() || !out.Exists())
  {
    throw std::invalid_argument("Points " + std::to_string(path[i]) + " and " +
      std::to_string(path[(in.Exists() ? i + 1 : i + n - 1) % n]) +
      " of the loop are not joined by an edge of the surface.");
  }
  for (HalfEdgeId h = s.Next(in); h != out; h = s.Next(s.Opposite(h)))
  {
    strip.push_back({ s.Opposite(h), 1.0 });
  }
}

}

void RemoveBacktracking(const SurfaceAdjacency& s, EdgeStrip& strip)
{
  EdgeStrip kept = WithoutBacktracking(s, strip);
  std::size_t first = 0;
  while (kept.size() - first >= 2 && s.Opposite(kept.back().HalfEdge) == kept[first].HalfEdge)
  {
    kept.pop_back();
    ++first;
  }
  strip.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

void RemoveBacktracking(const SurfaceAdjacency& s, EdgeStrip& strip, SimplexId from, SimplexId to)
{
  const EdgeStrip kept = WithoutBacktracking(s, strip);
  const auto endsAt = [&s](const SurfaceCurvePoint& c, SimplexId p)
  { return s.From(c.HalfEdge) == p || s.To(c.HalfEdge) == p; };
  const auto first =
    std::find_if(kept.begin(), kept.end(), [&](const auto& c) { return !endsAt(c, from); });
  const auto last = std::find_if(kept.rbegin(), std::make_reverse_iterator(first),
    [&](const auto& c) { return !endsAt(c, to); });
  strip.assign(first, last.base());
}

EdgeStrip LeftStrip(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  EdgeStrip strip;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    AddLeftCrossings(s, loop, i, strip);
  }
  RemoveBacktracking(s, strip);
  return strip;
}

EdgeStrip StripLeftOfPath(const SurfaceAdjacency& s, const std::vector<SimplexId>& path)
{
  EdgeStrip strip;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    AddLeftCrossings(s, path, i, strip);
  }
  RemoveBacktracking(s, strip, path.front(), path.back());
  return strip;
}

namespace
{

/// Unfolds the triangle beyond the last edge, up to the edge over which the strip continues.
void UnfoldOver(const SurfaceAdjacency& s, HalfEdgeId h, HalfEdgeId next, UnfoldedStrip& plane)
{
  const HalfEdgeId second = SurfaceAdjacency::Next(h);
  const Point2 from = plane.From.back();
  const Point2 to = plane.To.back();
  const Point2 apex =
    UnfoldCorner(from, to, s.Length(SurfaceAdjacency::Previous(h)), s.Length(second));
  const bool keepsTo = s.Opposite(next) == second;
  plane.From.push_back(keepsTo ? apex : from);
  plane.To.push_back(keepsTo ? to : apex);
}

}

UnfoldedStrip UnfoldPath(const SurfaceAdjacency& s, const EdgeStrip& strip)
{
  const HalfEdgeId first = strip.front().HalfEdge;
  const HalfEdgeId behind = s.Opposite(first);
  const Point2 from{ 0.0, 0.0 };
  const Point2 to{ s.Length(first), 0.0 };
  const Point2 start = UnfoldCorner(to, from, s.Length(SurfaceAdjacency::Previous(behind)),
    s.Length(SurfaceAdjacency::Next(behind)));
  UnfoldedStrip plane{ { start, from }, { start, to } };
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
  {
    UnfoldOver(s, strip[i].HalfEdge, strip[i + 1].HalfEdge, plane);
  }
  const HalfEdgeId last = strip.back().HalfEdge;
  const Point2 end = UnfoldCorner(plane.From.back(), plane.To.back(),
    s.Length(SurfaceAdjacency::Previous(last)), s.Length(SurfaceAdjacency::Next(last)));
  plane.From.push_back(end);
  plane.To.push_back(end);
  return plane;
}

UnfoldedStrip UnfoldOpen(const SurfaceAdjacency& s, const EdgeStrip& strip)
{
  UnfoldedStrip plane{ { { 0.0, 0.0 } }, { { s.Length(strip.front().HalfEdge), 0.0 } } };
  for (std::size_t i = 0; i + 1 < strip.size(); ++i)
  {
    UnfoldOver(s, strip[i].HalfEdge, strip[i + 1].HalfEdge, plane);
  }
  return plane;
}

UnfoldedStrip Unfold(const SurfaceAdjacency& s, const EdgeStrip& strip, std::size_t start)
{
  UnfoldedStrip plane;
  const std::size_t n = strip.size();
  plane.From.reserve(n + 1);
  plane.To.reserve(n + 1);
  plane.From.push_back({ 0.0, 0.0 });
  plane.To.push_back({ s.Length(strip[start].HalfEdge), 0.0 });
  std::size_t here = start;
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t next = here + 1 < n ? here + 1 : 0;
    UnfoldOver(s, strip[here].HalfEdge, strip[next].HalfEdge, plane);
    here = next;
  }
  return plane;
}

// ------------------------------------------------------------------------------------------
// StripFunnel
namespace
{

/// A point where the shortest path touches the border of the strip.
struct FunnelTurn
{
  std::size_t Edge; ///< index from the start of the strip
  bool AtFrom;
};

/// Shortest path from p to q through the unfolded edges 1 .. n - 1 (funnel).
std::vector<FunnelTurn> Funnel(const UnfoldedStrip& plane, const Point2& p, const Point2& q)
{
  const std::size_t n = plane.From.size() - 1;
  std::vector<FunnelTurn> bends;
  Point2 apex = p;
  std::size_t left = 0;
  std::size_t right = 0;
  Point2 leftEnd = p;
  Point2 rightEnd = p;
  const auto restart = [&](const Point2& at, std::size_t edge)
  {
    apex = leftEnd = rightEnd = at;
    left = right = edge;
    return edge;
  };
  // Collinear corners may restart it needlessly: a path has at most n bends.
  for (std::size_t i = 1; i <= n && bends.size() <= n; ++i)
  {
    const Point2& newLeft = i < n ? plane.From[i] : q;
    const Point2& newRight = i < n ? plane.To[i] : q;
    // The right side swings inward (to the left), or starts.
    if (Cross2(apex, rightEnd, newRight) >= 0.0)
    {
      if (apex == rightEnd || Cross2(apex, leftEnd, newRight) < 0.0 || apex == leftEnd)
      {
        rightEnd = newRight;
        right = i;
      }
      else
      {
        bends.push_back({ left, true });
        i = restart(leftEnd, left);
        continue;
      }
    }
    if (Cross2(apex, leftEnd, newLeft) <= 0.0)
    {
      if (apex == leftEnd || Cross2(apex, rightEnd, newLeft) > 0.0 || apex == rightEnd)
      {
        leftEnd = newLeft;
        left = i;
      }
      else
      {
        bends.push_back({ right, false });
        i = restart(rightEnd, right);
        continue;
      }
    }
  }
  // The end itself does not count as a bend.
  while (!bends.empty() && bends.back().Edge >= n)
  {
    bends.pop_back();
  }
  return bends;
}

/// Where the polyline p, bends, q crosses each edge, as fractions from From to To.
void ComputeCrossings(const UnfoldedStrip& plane, const std::vector<FunnelTurn>& bends,
  const Point2& p, const Point2& q, std::vector<double>& fraction)
{
  const std::size_t n = plane.From.size() - 1;
  fraction.assign(n, 0.0);
  Point2 here = p;
  std::size_t edge = 1;
  for (std::size_t b = 0; b <= bends.size(); ++b)
  {
    const bool last = b == bends.size();
    const Point2 there =
      last ? q : (bends[b].AtFrom ? plane.From[bends[b].Edge] : plane.To[bends[b].Edge]);
    for (const std::size_t end = last ? n : bends[b].Edge + 1; edge < end; ++edge)
    {
      const double a = Cross2(here, there, plane.From[edge]);
      const double c = Cross2(here, there, plane.To[edge]);
      fraction[edge] = a == c ? 0.5 : std::clamp(a / (a - c), 0.0, 1.0);
    }
    if (!last)
    {
      fraction[bends[b].Edge] = bends[b].AtFrom ? 0.0 : 1.0;
    }
    here = there;
  }
}

}

void FunnelCrossings(
  const UnfoldedStrip& plane, const Point2& p, const Point2& q, std::vector<double>& fraction)
{
  ComputeCrossings(plane, Funnel(plane, p, q), p, q, fraction);
}

std::vector<double> FunnelCrossings(const UnfoldedStrip& plane, const Point2& p, const Point2& q)
{
  std::vector<double> fraction;
  FunnelCrossings(plane, p, q, fraction);
  return fraction;
}

// ------------------------------------------------------------------------------------------
// StripBend
namespace
{

/// Fractions this close to an end of the edge count as the end.
constexpr double Near = 1e-7;

const Point3& PointAt(const SurfaceAdjacency& s, SimplexId p)
{
  return s.Mesh().Points[static_cast<std::size_t>(p)];
}

}

double CornerAngle(const SurfaceAdjacency& s, HalfEdgeId h)
{
  const double a = s.Length(h);
  const double b = s.Length(SurfaceAdjacency::Previous(h));
  const double c = s.Length(SurfaceAdjacency::Next(h));
  return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0));
}

EdgeStrip StripOnOtherSide(
  const SurfaceAdjacency& s, HalfEdgeId enter, SurfaceTriangleId last, SimplexId p)
{
  const bool onRight = s.To(enter) == p;
  EdgeStrip other;
  for (HalfEdgeId h = s.Opposite(enter); SurfaceAdjacency::Triangle(h) != last;)
  {
    h = onRight ? s.Turn(h) : s.Opposite(SurfaceAdjacency::Next(h));
    other.push_back({ h, onRight ? 0.0 : 1.0 });
  }
  return other;
}

double AngleOnOtherSide(const SurfaceAdjacency& s, const EdgeStrip& other, SimplexId p,
  const Point3& before, const Point3& after)
{
  const Point3& center = PointAt(s, p);
  const auto between = [&center](const Point3& x, const Point3& y)
  {
    const Point3 c = Cross(x - center, y - center);
    return std::atan2(Length(c), Dot(x - center, y - center));
  };
  if (other.empty())
  {
    return between(before, after);
  }
  const auto farEnd = [&s, p](HalfEdgeId h) -> const Point3&
  { return PointAt(s, s.From(h) == p ? s.To(h) : s.From(h)); };
  double angle =
    between(before, farEnd(other.front().HalfEdge)) + between(farEnd(other.back().HalfEdge), after);
  for (std::size_t i = 0; i + 1 < other.size(); ++i)
  {
    const HalfEdgeId h = other[i].HalfEdge;
    angle += CornerAngle(s, s.From(h) == p ? h : SurfaceAdjacency::Next(h));
  }
  return angle;
}

bool Touches(const SurfaceAdjacency& s, const SurfaceCurvePoint& c, SimplexId p)
{
  return (s.From(c.HalfEdge) == p && c.Fraction < Near) ||
    (s.To(c.HalfEdge) == p && c.Fraction > 1.0 - Near);
}

SimplexId TouchedBy(const SurfaceAdjacency& s, const SurfaceCurvePoint& c)
{
  return c.Fraction < Near ? s.From(c.HalfEdge) : c.Fraction > 1.0 - Near ? s.To(c.HalfEdge) : -1;
}

}
