#include "LoopShortening.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Point2 = std::array<double, 2>;

std::size_t At(std::int64_t i)
{
  return static_cast<std::size_t>(i);
}

double Cross2(const Point2& o, const Point2& a, const Point2& b)
{
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

double Distance2(const Point2& a, const Point2& b)
{
  return std::hypot(b[0] - a[0], b[1] - a[1]);
}

Point2 Between2(const Point2& a, const Point2& b, double u)
{
  return { a[0] + u * (b[0] - a[0]), a[1] + u * (b[1] - a[1]) };
}

/// Angle at From(h) of the triangle left of h.
double Angle(const SurfaceAdjacency& s, SimplexId h)
{
  const double a = s.Length(h);
  const double b = s.Length(SurfaceAdjacency::Previous(h));
  const double c = s.Length(SurfaceAdjacency::Next(h));
  return std::acos(std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0));
}

/// The edges that a closed curve crosses, each as half edge of the triangle that the curve enters
/// there: seen along the curve, From is on the left and To on the right.
using Strip = std::vector<SurfaceCurvePoint>;

/// Takes out crossings that go back at once over the same edge.
void CancelReturns(const SurfaceAdjacency& s, Strip& strip)
{
  Strip kept;
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
  std::size_t first = 0;
  while (kept.size() - first >= 2 && s.Opposite(kept.back().HalfEdge) == kept[first].HalfEdge)
  {
    kept.pop_back();
    ++first;
  }
  strip.assign(kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end());
}

/// The strip just left of a loop of edges: at each point, the edges between the ways in and out.
Strip LeftOf(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  Strip strip;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const SimplexId in = s.Find(loop[(i + n - 1) % n], loop[i]);
    const SimplexId out = s.Find(loop[i], loop[(i + 1) % n]);
    if (in < 0 || out < 0)
    {
      throw std::invalid_argument("Points " + std::to_string(loop[i]) + " and " +
        std::to_string(loop[(in < 0 ? i + n - 1 : i + 1) % n]) +
        " of the loop are not joined by an edge of the surface.");
    }
    for (SimplexId h = s.Next(in); h != out; h = s.Next(s.Opposite(h)))
    {
      strip.push_back({ s.Opposite(h), 1.0 });
    }
  }
  CancelReturns(s, strip);
  return strip;
}

/// The strip laid into the plane from edge `start` round to its copy: both ends of every edge.
struct Unfolded
{
  std::vector<Point2> From;
  std::vector<Point2> To;
};

/// The corner left of (a, b), from the three lengths.
Point2 Corner(const Point2& a, const Point2& b, double toA, double toB)
{
  const double c = Distance2(a, b);
  const double x = (toA * toA - toB * toB + c * c) / (2.0 * c);
  const double y = std::sqrt(std::max(0.0, toA * toA - x * x));
  const Point2 u{ (b[0] - a[0]) / c, (b[1] - a[1]) / c };
  return { a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0] };
}

Unfolded Unfold(const SurfaceAdjacency& s, const Strip& strip, std::size_t start)
{
  Unfolded plane;
  const std::size_t n = strip.size();
  plane.From.push_back({ 0.0, 0.0 });
  plane.To.push_back({ s.Length(strip[start].HalfEdge), 0.0 });
  for (std::size_t i = 0; i < n; ++i)
  {
    const SimplexId h = strip[(start + i) % n].HalfEdge;
    const SimplexId next = strip[(start + i + 1) % n].HalfEdge;
    const SimplexId second = SurfaceAdjacency::Next(h);
    const SimplexId third = SurfaceAdjacency::Previous(h);
    const Point2 from = plane.From.back();
    const Point2 to = plane.To.back();
    const Point2 apex = Corner(from, to, s.Length(third), s.Length(second));
    const bool keepsTo = s.Opposite(next) == second;
    plane.From.push_back(keepsTo ? apex : from);
    plane.To.push_back(keepsTo ? to : apex);
  }
  return plane;
}

/// A point where the shortest path touches the border of the strip.
struct Bend
{
  std::size_t Edge; ///< index from the start of the strip
  bool AtFrom;
};

/// Shortest path from p to q through the unfolded edges 1 .. n - 1 (funnel).
std::vector<Bend> Funnel(const Unfolded& plane, const Point2& p, const Point2& q)
{
  const std::size_t n = plane.From.size() - 1;
  std::vector<Bend> bends;
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
  // Collinear corners may restart it in vain: a path has at most n bends.
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
  // The end itself, met as a corner, is no bend.
  while (!bends.empty() && bends.back().Edge >= n)
  {
    bends.pop_back();
  }
  return bends;
}

/// Where the polyline p, bends, q crosses each edge, as fractions from From to To.
std::vector<double> CrossingsOf(
  const Unfolded& plane, const std::vector<Bend>& bends, const Point2& p, const Point2& q)
{
  const std::size_t n = plane.From.size() - 1;
  std::vector<double> fraction(n, 0.0);
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
  return fraction;
}

/// One curve under shortening.
class Shortener
{
public:
  Shortener(const SurfaceAdjacency& surface, Strip strip)
    : Surface(surface)
    , Edges(std::move(strip))
  {
  }

  const Strip& Curve() const { return this->Edges; }

  double Length() const;

  /// The shortest closed path in the strip: shortest paths, each cut open at another edge.
  void Straighten(int turns, double tolerance);

  /// Leads the strip round the points at which the path bends needlessly; false: there are none.
  bool Lead();

private:
  void StraightenFrom(std::size_t start);
  bool Touches(std::size_t i, SimplexId p) const;
  bool LeadRound(std::size_t first, std::size_t count, SimplexId p);
  double AngleBeyond(
    const Strip& other, SimplexId p, const Point3& before, const Point3& after) const;

  static constexpr double Near = 1e-7;

  const SurfaceAdjacency& Surface;
  Strip Edges;
};

double Shortener::Length() const
{
  double length = 0.0;
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    const Point3 d = PositionOf(this->Surface, this->Edges[(i + 1) % this->Edges.size()]) -
      PositionOf(this->Surface, this->Edges[i]);
    length += std::sqrt(Dot(d, d));
  }
  return length;
}

void Shortener::Straighten(int turns, double tolerance)
{
  double before = HUGE_VAL;
  for (int turn = 0; turn<turns&& this->Edges.size()> 1; ++turn)
  {
    this->StraightenFrom(turn % 2 == 0 ? 0 : this->Edges.size() / 2);
    const double now = this->Length();
    if (turn > 1 && before - now <= tolerance * now)
    {
      break;
    }
    before = now;
  }
}

void Shortener::StraightenFrom(std::size_t start)
{
  const Unfolded plane = Unfold(this->Surface, this->Edges, start);
  const double u = this->Edges[start].Fraction;
  const Point2 p = Between2(plane.From.front(), plane.To.front(), u);
  const Point2 q = Between2(plane.From.back(), plane.To.back(), u);
  const std::vector<double> fraction = CrossingsOf(plane, Funnel(plane, p, q), p, q);
  for (std::size_t i = 1; i < fraction.size(); ++i)
  {
    this->Edges[(start + i) % this->Edges.size()].Fraction = fraction[i];
  }
}

bool Shortener::Touches(std::size_t i, SimplexId p) const
{
  const SurfaceCurvePoint& c = this->Edges[i];
  return (this->Surface.From(c.HalfEdge) == p && c.Fraction < Near) ||
    (this->Surface.To(c.HalfEdge) == p && c.Fraction > 1.0 - Near);
}

bool Shortener::Lead()
{
  bool led = false;
  std::size_t left = 2 * this->Edges.size(); // so that rounding can't make it go on for ever
  for (std::size_t i = 0; i < this->Edges.size() && left > 0; ++i, --left)
  {
    const std::size_t n = this->Edges.size();
    const SurfaceCurvePoint& c = this->Edges[i];
    if (c.Fraction >= Near && c.Fraction <= 1.0 - Near)
    {
      continue;
    }
    const SimplexId p =
      c.Fraction < Near ? this->Surface.From(c.HalfEdge) : this->Surface.To(c.HalfEdge);
    if (this->Touches((i + n - 1) % n, p))
    {
      continue;
    }
    std::size_t count = 1;
    while (count < n && this->Touches((i + count) % n, p))
    {
      ++count;
    }
    led = (count < n && this->LeadRound(i, count, p)) || led;
  }
  return led;
}

// Angle between the ways into and out of p on the side where the edges `other` lie.
double Shortener::AngleBeyond(
  const Strip& other, SimplexId p, const Point3& before, const Point3& after) const
{
  const Point3& centre = this->Surface.Mesh().Points[At(p)];
  const auto between = [&centre](const Point3& x, const Point3& y)
  {
    const Point3 c = Cross(x - centre, y - centre);
    return std::atan2(std::sqrt(Dot(c, c)), Dot(x - centre, y - centre));
  };
  if (other.empty())
  {
    return between(before, after);
  }
  const auto farEnd = [this, p](SimplexId h) -> const Point3&
  {
    const SimplexId end = this->Surface.From(h) == p ? this->Surface.To(h) : this->Surface.From(h);
    return this->Surface.Mesh().Points[At(end)];
  };
  double angle =
    between(before, farEnd(other.front().HalfEdge)) + between(farEnd(other.back().HalfEdge), after);
  for (std::size_t i = 0; i + 1 < other.size(); ++i)
  {
    const SimplexId h = other[i].HalfEdge;
    angle += Angle(this->Surface, this->Surface.From(h) == p ? h : SurfaceAdjacency::Next(h));
  }
  return angle;
}

// The path runs through point p along edges first .. first + count - 1 of the strip, which all end
// at p: with p on its right it turns clockwise there, and the other way is counter-clockwise.
bool Shortener::LeadRound(std::size_t first, std::size_t count, SimplexId p)
{
  const std::size_t n = this->Edges.size();
  const SurfaceAdjacency& s = this->Surface;
  const SimplexId enter = this->Edges[first].HalfEdge;
  const SimplexId last = SurfaceAdjacency::Triangle(this->Edges[(first + count - 1) % n].HalfEdge);
  const bool onRight = s.To(enter) == p;
  Strip other;
  for (SimplexId h = s.Opposite(enter); SurfaceAdjacency::Triangle(h) != last;)
  {
    h = onRight ? s.Turn(h) : s.Opposite(SurfaceAdjacency::Next(h));
    other.push_back({ h, onRight ? 0.0 : 1.0 });
  }
  const Point3 before = PositionOf(s, this->Edges[(first + n - 1) % n]);
  const Point3 after = PositionOf(s, this->Edges[(first + count) % n]);
  if (this->AngleBeyond(other, p, before, after) >= M_PI - 1e-9)
  {
    return false;
  }
  Strip strip;
  for (std::size_t k = 0; k < n - count; ++k)
  {
    strip.push_back(this->Edges[(first + count + k) % n]);
  }
  strip.insert(strip.end(), other.begin(), other.end());
  CancelReturns(s, strip);
  this->Edges = std::move(strip);
  return true;
}

double LengthOf(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point3 d =
      s.Mesh().Points[At(loop[(i + 1) % loop.size()])] - s.Mesh().Points[At(loop[i])];
    length += std::sqrt(Dot(d, d));
  }
  return length;
}

}

SurfaceCurve ShortenLoop(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const LoopShorteningParameters& parameters)
{
  SurfaceCurve curve;
  curve.Length = LengthOf(surface, loop);
  Shortener shortener(surface, LeftOf(surface, loop));
  double length = curve.Length;
  for (int round = 0; round < parameters.MaximumRounds && !curve.Converged; ++round)
  {
    shortener.Straighten(3, parameters.Tolerance);
    if (!shortener.Lead())
    {
      shortener.Straighten(100, 0.01 * parameters.Tolerance);
      curve.Converged = !shortener.Lead();
    }
    length = shortener.Length();
    if (length <= 1e-6 * curve.Length)
    {
      break;
    }
  }
  curve.Contractible = length <= 1e-6 * curve.Length;
  if (curve.Contractible || length > curve.Length)
  {
    curve.Converged = false;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      curve.Crossings.push_back({ surface.Find(loop[i], loop[(i + 1) % loop.size()]), 0.0 });
    }
    return curve;
  }
  curve.Crossings = shortener.Curve();
  curve.Length = length;
  return curve;
}

Point3 PositionOf(const SurfaceAdjacency& s, const SurfaceCurvePoint& p)
{
  const Point3& a = s.Mesh().Points[At(s.From(p.HalfEdge))];
  const Point3& b = s.Mesh().Points[At(s.To(p.HalfEdge))];
  return (1.0 - p.Fraction) * a + p.Fraction * b;
}

}
