#include "ChokingLoops/LoopShortening.h"

#include "ChokingLoops/StripBend.h"
#include "ChokingLoops/StripFunnel.h"
#include "Core/Index.h"
#include "Core/Pi.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// One curve under shortening.
class Shortener
{
public:
  Shortener(const SurfaceAdjacency& surface, EdgeStrip strip)
    : Surface(surface)
    , Edges(std::move(strip))
  {
  }

  const EdgeStrip& Curve() const { return this->Edges; }

  double Length() const { return LengthOf(this->Surface, this->Edges); }

  /// Shortest paths in the strip, each cut open at another edge than the one before.
  void Straighten(int turns);

  /// The shortest closed path in the strip: until that gains no more than `tolerance` of its
  /// length.
  void StraightenFully(double tolerance);

  /// Leads the strip round the points at which the path bends needlessly; false: there are none.
  bool Lead();

private:
  void StraightenFrom(std::size_t start);
  bool LeadRound(std::size_t first, std::size_t count, SimplexId p);

  const SurfaceAdjacency& Surface;
  EdgeStrip Edges;
};

void Shortener::Straighten(int turns)
{
  for (int turn = 0; turn<turns&& this->Edges.size()> 1; ++turn)
  {
    this->StraightenFrom(turn % 2 == 0 ? 0 : this->Edges.size() / 2);
  }
}

void Shortener::StraightenFully(double tolerance)
{
  this->Straighten(2);
  double before = this->Length();
  for (int turn = 2; turn < 100 && this->Edges.size() > 1; ++turn)
  {
    this->StraightenFrom(turn % 2 == 0 ? 0 : this->Edges.size() / 2);
    const double now = this->Length();
    if (before - now <= tolerance * now)
    {
      break;
    }
    before = now;
  }
}

void Shortener::StraightenFrom(std::size_t start)
{
  const UnfoldedStrip plane = Unfold(this->Surface, this->Edges, start);
  const double u = this->Edges[start].Fraction;
  const Point2 p = PointOn(plane, 0, u);
  const Point2 q = PointOn(plane, plane.From.size() - 1, u);
  const std::vector<double> fraction = ShortestCrossings(plane, p, q);
  for (std::size_t i = 1; i < fraction.size(); ++i)
  {
    this->Edges[(start + i) % this->Edges.size()].Fraction = fraction[i];
  }
}

bool Shortener::Lead()
{
  bool led = false;
  std::size_t left = 2 * this->Edges.size(); // so that rounding can't make it go on for ever
  for (std::size_t i = 0; i < this->Edges.size() && left > 0; ++i, --left)
  {
    const std::size_t n = this->Edges.size();
    const SimplexId p = TouchedBy(this->Surface, this->Edges[i]);
    if (p < 0 || Touches(this->Surface, this->Edges[(i + n - 1) % n], p))
    {
      continue;
    }
    std::size_t count = 1;
    while (count < n && Touches(this->Surface, this->Edges[(i + count) % n], p))
    {
      ++count;
    }
    led = (count < n && this->LeadRound(i, count, p)) || led;
  }
  return led;
}

// The path runs through p along edges first .. first + count - 1 of the strip, which all end there.
bool Shortener::LeadRound(std::size_t first, std::size_t count, SimplexId p)
{
  const std::size_t n = this->Edges.size();
  const SurfaceAdjacency& s = this->Surface;
  const HalfEdgeId enter = this->Edges[first].HalfEdge;
  for (std::size_t k = 1; k < count; ++k)
  {
    if (this->Edges[(first + k) % n].HalfEdge == enter) // once round the point, for nothing
    {
      EdgeStrip strip;
      for (std::size_t i = k; i < n; ++i)
      {
        strip.push_back(this->Edges[(first + i) % n]);
      }
      this->Edges = std::move(strip);
      return true;
    }
  }
  const SurfaceTriangleId last =
    SurfaceAdjacency::Triangle(this->Edges[(first + count - 1) % n].HalfEdge);
  const EdgeStrip other = OtherWayRound(s, enter, last, p);
  const Point3 before = PositionOf(s, this->Edges[(first + n - 1) % n]);
  const Point3 after = PositionOf(s, this->Edges[(first + count) % n]);
  if (AngleBeyond(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  EdgeStrip strip;
  for (std::size_t k = 0; k < n - count; ++k)
  {
    strip.push_back(this->Edges[(first + count + k) % n]);
  }
  strip.insert(strip.end(), other.begin(), other.end());
  CancelReturns(s, strip);
  this->Edges = std::move(strip);
  return true;
}

double LengthAlong(const SurfaceAdjacency& s, const std::vector<SimplexId>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point3 d =
      s.Mesh().Points[At(loop[(i + 1) % loop.size()])] - s.Mesh().Points[At(loop[i])];
    length += Length(d);
  }
  return length;
}

}

double LengthOf(const SurfaceAdjacency& surface, const std::vector<SurfaceCurvePoint>& crossings)
{
  double length = 0.0;
  if (crossings.empty())
  {
    return length;
  }
  const Point3 first = PositionOf(surface, crossings.front());
  Point3 here = first;
  for (std::size_t i = 1; i <= crossings.size(); ++i)
  {
    const Point3 next = i < crossings.size() ? PositionOf(surface, crossings[i]) : first;
    length += Distance(here, next);
    here = next;
  }
  return length;
}

SurfaceCurve ShortenLoop(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const LoopShorteningParameters& parameters, const ProgressCallback& progress)
{
  SurfaceCurve curve;
  curve.Length = LengthAlong(surface, loop);
  Shortener shortener(surface, StripLeftOf(surface, loop));
  double length = curve.Length;
  for (int round = 0; round < parameters.MaximumRounds && !curve.Converged; ++round)
  {
    // The number of rounds is not known: each takes a tenth of what is left of the bar.
    Report(progress, 1.0 - std::pow(0.9, round));
    shortener.Straighten(3);
    if (!shortener.Lead())
    {
      shortener.StraightenFully(0.01 * parameters.Tolerance);
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

}
