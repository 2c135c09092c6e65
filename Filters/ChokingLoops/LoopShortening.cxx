#include "ChokingLoops/LoopShortening.h"

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Geometry.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// LoopShortening
namespace
{

/// A crossing with the data of the triangle that the curve enters there, which unfolding needs:
/// lengths are computed once for each crossing, not in each round.
struct StripEdge
{
  SurfaceCurvePoint Crossing;
  HalfEdgeId Behind; ///< the opposite half edge
  std::array<SimplexId, 2> Ends;
  std::array<double, 2> Sides; ///< from the third corner to the ends
};

StripEdge MakeStripEdge(const SurfaceAdjacency& s, const SurfaceCurvePoint& c)
{
  return { c, s.Opposite(c.HalfEdge), { s.From(c.HalfEdge), s.To(c.HalfEdge) },
    { s.Length(SurfaceAdjacency::Previous(c.HalfEdge)),
      s.Length(SurfaceAdjacency::Next(c.HalfEdge)) } };
}

/// A sequence of crossings in which some can be replaced by others. A replacement moves a number of
/// four bytes for each later crossing.
class StripEdges
{
public:
  StripEdges(const SurfaceAdjacency& surface, const EdgeStrip& strip)
    : Surface(surface)
  {
    this->Replace(0, 0, strip);
  }

  std::size_t Size() const { return this->Order.size(); }

  const StripEdge& operator[](std::size_t i) const { return this->Edges[this->Order[i]]; }
  StripEdge& operator[](std::size_t i) { return this->Edges[this->Order[i]]; }

  void Replace(std::size_t first, std::size_t count, const EdgeStrip& others);

  /// Crossing `first` becomes the first one.
  void Rotate(std::size_t first)
  {
    std::rotate(this->Order.begin(), this->Order.begin() + static_cast<std::ptrdiff_t>(first),
      this->Order.end());
  }

private:
  std::uint32_t Add(const SurfaceCurvePoint& c);

  const SurfaceAdjacency& Surface;
  std::vector<StripEdge> Edges;
  std::vector<std::uint32_t> Order; ///< places in Edges
  std::vector<std::uint32_t> Free;
};

std::uint32_t StripEdges::Add(const SurfaceCurvePoint& c)
{
  if (this->Free.empty())
  {
    this->Edges.push_back(MakeStripEdge(this->Surface, c));
    return static_cast<std::uint32_t>(this->Edges.size() - 1);
  }
  const std::uint32_t place = this->Free.back();
  this->Free.pop_back();
  this->Edges[place] = MakeStripEdge(this->Surface, c);
  return place;
}

void StripEdges::Replace(std::size_t first, std::size_t count, const EdgeStrip& others)
{
  const auto at = [this](std::size_t i)
  { return this->Order.begin() + static_cast<std::ptrdiff_t>(i); };
  this->Free.insert(this->Free.end(), at(first), at(first + count));
  const std::size_t common = std::min(count, others.size());
  for (std::size_t i = 0; i < common; ++i)
  {
    this->Order[first + i] = this->Add(others[i]);
  }
  this->Order.erase(at(first + common), at(first + count));
  std::vector<std::uint32_t> more;
  for (std::size_t i = common; i < others.size(); ++i)
  {
    more.push_back(this->Add(others[i]));
  }
  this->Order.insert(at(first + common), more.begin(), more.end());
}

Point3 ComputePosition(const SurfaceAdjacency& s, const StripEdge& e)
{
  const double u = e.Crossing.Fraction;
  return (1.0 - u) * s.Mesh().Points[At(e.Ends[0])] + u * s.Mesh().Points[At(e.Ends[1])];
}

/// Appends a crossing to a strip, or removes the last one if the new one goes back over its edge.
void AddReduced(const SurfaceAdjacency& s, const SurfaceCurvePoint& c, EdgeStrip& strip)
{
  if (!strip.empty() && s.Opposite(strip.back().HalfEdge) == c.HalfEdge)
  {
    strip.pop_back();
  }
  else
  {
    strip.push_back(c);
  }
}

/// The third corner of the triangle beyond an edge whose ends lie at `place` of the plane.
Point2 ThirdCorner(const StripEdge& e, std::size_t place, const UnfoldedStrip& plane)
{
  return UnfoldCorner(plane.From[place], plane.To[place], e.Sides[0], e.Sides[1]);
}

/// Unfolds the triangle beyond an edge at `place` of the plane, up to the next edge.
void UnfoldOver(const StripEdge& e, const StripEdge& next, std::size_t place, UnfoldedStrip& plane)
{
  const Point2 apex = ThirdCorner(e, place, plane);
  const bool keepsTo = next.Behind == SurfaceAdjacency::Next(e.Crossing.HalfEdge);
  plane.From[place + 1] = keepsTo ? apex : plane.From[place];
  plane.To[place + 1] = keepsTo ? plane.To[place] : apex;
}

/// A curve being shortened.
class Shortener
{
public:
  Shortener(const SurfaceAdjacency& surface, const EdgeStrip& strip)
    : Surface(surface)
    , Edges(surface, strip)
  {
  }

  EdgeStrip Curve() const;

  double Length() const;

  /// Shortest paths in the strip, each cut open at another edge than the one before.
  void Straighten(int turns);

  /// The shortest closed path in the strip: iterates until the gain is at most `tolerance` of its
  /// length.
  void StraightenFully(double tolerance);

  /// Leads the strip around the points at which the path bends needlessly; false if there is none.
  bool Lead();

  /// True when all edges of the strip end at one point, to which the curve contracts.
  bool IsAroundOnePoint() const;

private:
  std::size_t Size() const { return this->Edges.Size(); }

  std::size_t Wrapped(std::size_t i) const { return i < this->Size() ? i : i - this->Size(); }
  const StripEdge& At(std::size_t i) const { return this->Edges[this->Wrapped(this->First + i)]; }
  StripEdge& At(std::size_t i) { return this->Edges[this->Wrapped(this->First + i)]; }

  void StraightenFrom(bool isMiddle);
  const UnfoldedStrip& Unfolded(bool isMiddle);
  bool LeadRound(std::size_t first, std::size_t count, SimplexId p);
  void Replace(std::size_t first, std::size_t count, const EdgeStrip& others);

  const SurfaceAdjacency& Surface;
  StripEdges Edges;
  std::size_t First = 0; ///< where the curve begins among Edges
  /// The strip cut open at its first and at its middle edge, as long as it has the same edges.
  std::array<UnfoldedStrip, 2> Planes;
  std::array<bool, 2> IsUnfolded{ false, false };
  std::vector<double> Fractions;
};

EdgeStrip Shortener::Curve() const
{
  EdgeStrip strip;
  for (std::size_t i = 0; i < this->Size(); ++i)
  {
    strip.push_back(this->At(i).Crossing);
  }
  return strip;
}

double Shortener::Length() const
{
  double length = 0.0;
  if (this->Size() == 0)
  {
    return length;
  }
  const Point3 first = ComputePosition(this->Surface, this->At(0));
  Point3 here = first;
  for (std::size_t i = 1; i <= this->Size(); ++i)
  {
    const Point3 next = i < this->Size() ? ComputePosition(this->Surface, this->At(i)) : first;
    length += Distance(here, next);
    here = next;
  }
  return length;
}

void Shortener::Straighten(int turns)
{
  for (int turn = 0; turn<turns&& this->Size()> 1; ++turn)
  {
    this->StraightenFrom(turn % 2 != 0);
  }
}

void Shortener::StraightenFully(double tolerance)
{
  this->Straighten(2);
  double before = this->Length();
  for (int turn = 2; turn < 100 && this->Size() > 1; ++turn)
  {
    this->StraightenFrom(turn % 2 != 0);
    const double now = this->Length();
    if (before - now <= tolerance * now)
    {
      break;
    }
    before = now;
  }
}

const UnfoldedStrip& Shortener::Unfolded(bool isMiddle)
{
  const std::size_t n = this->Size();
  const std::size_t start = isMiddle ? n / 2 : 0;
  UnfoldedStrip& plane = this->Planes[isMiddle ? 1 : 0];
  if (!std::exchange(this->IsUnfolded[isMiddle ? 1 : 0], true))
  {
    plane.From.resize(n + 1);
    plane.To.resize(n + 1);
    plane.From[0] = { 0.0, 0.0 };
    plane.To[0] = { this->Surface.Length(this->At(start).Crossing.HalfEdge), 0.0 };
    for (std::size_t i = 0; i < n; ++i)
    {
      UnfoldOver(this->At((start + i) % n), this->At((start + i + 1) % n), i, plane);
    }
  }
  return plane;
}

void Shortener::StraightenFrom(bool isMiddle)
{
  const UnfoldedStrip& plane = this->Unfolded(isMiddle);
  const std::size_t start = isMiddle ? this->Size() / 2 : 0;
  const double u = this->At(start).Crossing.Fraction;
  const Point2 p = PointOn(plane, 0, u);
  const Point2 q = PointOn(plane, plane.From.size() - 1, u);
  FunnelCrossings(plane, p, q, this->Fractions);
  for (std::size_t i = 1; i < this->Fractions.size(); ++i)
  {
    this->At((start + i) % this->Size()).Crossing.Fraction = this->Fractions[i];
  }
}

bool Shortener::Lead()
{
  bool led = false;
  std::size_t left = 2 * this->Size(); // so that rounding cannot cause an endless loop
  for (std::size_t i = 0; i < this->Size() && left > 0; ++i, --left)
  {
    const std::size_t n = this->Size();
    const SimplexId p = TouchedBy(this->Surface, this->At(i).Crossing);
    if (p < 0 || Touches(this->Surface, this->At((i + n - 1) % n).Crossing, p))
    {
      continue;
    }
    std::size_t count = 1;
    while (count < n && Touches(this->Surface, this->At((i + count) % n).Crossing, p))
    {
      ++count;
    }
    led = (count < n && this->LeadRound(i, count, p)) || led;
  }
  return led;
}

bool Shortener::IsAroundOnePoint() const
{
  const auto endsAt = [this](SimplexId p)
  {
    for (std::size_t i = 0; i < this->Size(); ++i)
    {
      if (this->Edges[i].Ends[0] != p && this->Edges[i].Ends[1] != p)
      {
        return false;
      }
    }
    return true;
  };
  return this->Size() == 0 || endsAt(this->Edges[0].Ends[0]) || endsAt(this->Edges[0].Ends[1]);
}

/// Replaces crossings of the closed curve; it begins behind them from then on.
void Shortener::Replace(std::size_t first, std::size_t count, const EdgeStrip& others)
{
  std::size_t at = this->Wrapped(this->First + first);
  if (at + count > this->Size())
  {
    this->Edges.Rotate(at);
    at = 0;
  }
  this->Edges.Replace(at, count, others);
  this->First = at + others.size();
  this->First = this->First < this->Size() ? this->First : 0;
  this->IsUnfolded = { false, false };
}

// The path runs through p along edges first .. first + count - 1 of the strip, which all end there.
// No crossing of the strip goes back at once over the edge before, the first not over the last.
bool Shortener::LeadRound(std::size_t first, std::size_t count, SimplexId p)
{
  const std::size_t n = this->Size();
  const SurfaceAdjacency& s = this->Surface;
  const HalfEdgeId enter = this->At(first).Crossing.HalfEdge;
  for (std::size_t k = 1; k < count; ++k)
  {
    if (this->At((first + k) % n).Crossing.HalfEdge == enter) // once around the point, needlessly
    {
      this->Replace(first, k, {});
      return true;
    }
  }
  const SurfaceTriangleId last =
    SurfaceAdjacency::Triangle(this->At((first + count - 1) % n).Crossing.HalfEdge);
  const EdgeStrip other = StripOnOtherSide(s, enter, last, p);
  const Point3 before = ComputePosition(s, this->At((first + n - 1) % n));
  const Point3 after = ComputePosition(s, this->At((first + count) % n));
  if (AngleOnOtherSide(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  // The strip begins behind p and ends with the way around it. Removed are the `back` crossings
  // before p and those of the way that follow them, then the last and the `ahead` first ones.
  const std::size_t rest = n - count;
  std::size_t back = 0;
  std::size_t ahead = 0;
  const auto backEdge = [&]() -> const StripEdge& { return this->At((first + n - 1 - back) % n); };
  EdgeStrip way;
  for (const SurfaceCurvePoint& c : other)
  {
    if (way.empty() && back < rest && backEdge().Behind == c.HalfEdge)
    {
      ++back;
    }
    else
    {
      AddReduced(s, c, way);
    }
  }
  while (rest - back - ahead + way.size() >= 2)
  {
    const bool isOnWay = rest == back + ahead;
    const HalfEdgeId front =
      isOnWay ? way.front().HalfEdge : this->At((first + count + ahead) % n).Crossing.HalfEdge;
    if ((way.empty() ? backEdge().Behind : s.Opposite(way.back().HalfEdge)) != front)
    {
      break;
    }
    if (way.empty())
    {
      ++back;
    }
    else
    {
      way.pop_back();
    }
    if (isOnWay)
    {
      way.erase(way.begin());
    }
    else
    {
      ++ahead;
    }
  }
  this->Replace((first + n - back) % n, back + count + ahead, way);
  return true;
}

/// A loop of less than this part of its first length has contracted to a point.
constexpr double Vanishing = 1e-6;

/// The curve through points of the surface.
std::vector<SurfaceCurvePoint> AlongPoints(
  const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop)
{
  std::vector<SurfaceCurvePoint> crossings;
  crossings.reserve(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    crossings.push_back({ surface.Find(loop[i], loop[(i + 1) % loop.size()]), 0.0 });
  }
  return crossings;
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

double CurveLength(const SurfaceAdjacency& surface, const std::vector<SurfaceCurvePoint>& crossings)
{
  double length = 0.0;
  if (crossings.empty())
  {
    return length;
  }
  const Point3 first = ComputePosition(surface, crossings.front());
  Point3 here = first;
  for (std::size_t i = 1; i <= crossings.size(); ++i)
  {
    const Point3 next = i < crossings.size() ? ComputePosition(surface, crossings[i]) : first;
    length += Distance(here, next);
    here = next;
  }
  return length;
}

SurfaceCurve ShortenLoop(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const LoopShorteningParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  SurfaceCurve curve;
  curve.Length = LengthAlong(surface, loop);
  Shortener shortener(surface, LeftStrip(surface, loop));
  double length = curve.Length;
  for (int round = 0; round < parameters.MaximumRounds && !curve.Converged; ++round)
  {
    // The number of rounds is not known: each takes a tenth of the remaining progress.
    Report(progress, 1.0 - std::pow(0.9, round));
    shortener.Straighten(3);
    if (!shortener.Lead())
    {
      shortener.StraightenFully(0.01 * parameters.Tolerance);
      curve.Converged = !shortener.Lead();
    }
    length = shortener.IsAroundOnePoint() ? 0.0 : shortener.Length();
    if (length <= Vanishing * curve.Length)
    {
      break;
    }
  }
  curve.Contractible = length <= Vanishing * curve.Length;
  if (curve.Contractible || length > curve.Length)
  {
    curve.Converged = false;
    curve.Crossings = AlongPoints(surface, loop);
    return curve;
  }
  curve.Crossings = shortener.Curve();
  curve.Length = length;
  return curve;
}

// ------------------------------------------------------------------------------------------
// PinnedShortening
namespace
{

/// A path on the surface between two of its points.
class GeodesicArc
{
public:
  GeodesicArc(const SurfaceAdjacency& surface, const std::vector<SimplexId>& path)
    : Surface(surface)
    , From(path.front())
    , To(path.back())
    , Edges(surface, StripLeftOfPath(surface, path))
  {
  }

  EdgeStrip Crossings() const;

  /// The shortest path in the strip.
  void Straighten();

  /// Leads the strip around the points at which the path bends needlessly; false if there is none.
  bool Lead();

private:
  void Unfold();
  bool LeadRound(std::size_t first, std::size_t end, SimplexId p);
  void Replace(std::size_t first, std::size_t count, const EdgeStrip& others);
  void TrimEnds(bool isStart, bool isEnd);

  const Point3& At(SimplexId p) const
  {
    return this->Surface.Mesh().Points[static_cast<std::size_t>(p)];
  }

  const SurfaceAdjacency& Surface;
  SimplexId From;
  SimplexId To;
  StripEdges Edges;
  UnfoldedStrip Plane;
  std::size_t Unfolded =
    0; ///< of the edges, at least this many are still laid out correctly in the plane
  std::vector<double> Fractions;
};

EdgeStrip GeodesicArc::Crossings() const
{
  EdgeStrip strip;
  for (std::size_t i = 0; i < this->Edges.Size(); ++i)
  {
    strip.push_back(this->Edges[i].Crossing);
  }
  return strip;
}

/// As UnfoldPath().
void GeodesicArc::Unfold()
{
  const std::size_t n = this->Edges.Size();
  this->Plane.From.resize(n + 2);
  this->Plane.To.resize(n + 2);
  if (this->Unfolded == 0)
  {
    const UnfoldedStrip first = UnfoldPath(this->Surface, { this->Edges[0].Crossing });
    std::copy_n(first.From.begin(), 2, this->Plane.From.begin());
    std::copy_n(first.To.begin(), 2, this->Plane.To.begin());
    this->Unfolded = 1;
  }
  for (; this->Unfolded < n; ++this->Unfolded)
  {
    UnfoldOver(
      this->Edges[this->Unfolded - 1], this->Edges[this->Unfolded], this->Unfolded, this->Plane);
  }
  const Point2 end = ThirdCorner(this->Edges[n - 1], n, this->Plane);
  this->Plane.From[n + 1] = end;
  this->Plane.To[n + 1] = end;
}

void GeodesicArc::Straighten()
{
  if (this->Edges.Size() == 0)
  {
    return;
  }
  this->Unfold();
  FunnelCrossings(this->Plane, this->Plane.From.front(), this->Plane.From.back(), this->Fractions);
  for (std::size_t i = 0; i < this->Edges.Size(); ++i)
  {
    this->Edges[i].Crossing.Fraction = this->Fractions[i + 1];
  }
}

bool GeodesicArc::Lead()
{
  bool led = false;
  std::size_t left = 2 * this->Edges.Size(); // so that rounding cannot cause an endless loop
  for (std::size_t i = 0; i < this->Edges.Size() && left > 0; ++i, --left)
  {
    const SimplexId p = TouchedBy(this->Surface, this->Edges[i].Crossing);
    if (p < 0 || (i > 0 && Touches(this->Surface, this->Edges[i - 1].Crossing, p)))
    {
      continue;
    }
    std::size_t end = i + 1;
    while (end < this->Edges.Size() && Touches(this->Surface, this->Edges[end].Crossing, p))
    {
      ++end;
    }
    led = this->LeadRound(i, end, p) || led;
  }
  return led;
}

void GeodesicArc::Replace(std::size_t first, std::size_t count, const EdgeStrip& others)
{
  this->Edges.Replace(first, count, others);
  this->Unfolded = std::min(this->Unfolded, first);
}

/// Removes crossings of edges on which the ends of the path lie.
void GeodesicArc::TrimEnds(bool isStart, bool isEnd)
{
  const auto endsAt = [this](std::size_t i, SimplexId p)
  { return this->Edges[i].Ends[0] == p || this->Edges[i].Ends[1] == p; };
  std::size_t first = 0;
  while (isStart && first < this->Edges.Size() && endsAt(first, this->From))
  {
    ++first;
  }
  if (first > 0)
  {
    this->Replace(0, first, {});
  }
  std::size_t last = this->Edges.Size();
  while (isEnd && last > 0 && endsAt(last - 1, this->To))
  {
    --last;
  }
  if (last < this->Edges.Size())
  {
    this->Replace(last, this->Edges.Size() - last, {});
  }
}

// The path runs through p along edges first .. end - 1 of the strip, which all end there. No
// crossing of the strip goes back at once over the edge before.
bool GeodesicArc::LeadRound(std::size_t first, std::size_t end, SimplexId p)
{
  const SurfaceAdjacency& s = this->Surface;
  const std::size_t n = this->Edges.Size();
  const EdgeStrip other = StripOnOtherSide(s, this->Edges[first].Crossing.HalfEdge,
    SurfaceAdjacency::Triangle(this->Edges[end - 1].Crossing.HalfEdge), p);
  const Point3 before =
    first > 0 ? ComputePosition(s, this->Edges[first - 1]) : this->At(this->From);
  const Point3 after = end < n ? ComputePosition(s, this->Edges[end]) : this->At(this->To);
  if (AngleOnOtherSide(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  std::size_t begin = first; // crossings before p that stay
  EdgeStrip way;
  const auto goesBack = [&](HalfEdgeId h)
  { return way.empty() && begin > 0 && this->Edges[begin - 1].Behind == h; };
  for (const SurfaceCurvePoint& c : other)
  {
    if (goesBack(c.HalfEdge))
    {
      --begin;
    }
    else
    {
      AddReduced(s, c, way);
    }
  }
  for (; end < n; ++end)
  {
    const HalfEdgeId h = this->Edges[end].Crossing.HalfEdge;
    if (goesBack(h))
    {
      --begin;
    }
    else if (!way.empty() && s.Opposite(way.back().HalfEdge) == h)
    {
      way.pop_back();
    }
    else
    {
      break;
    }
  }
  this->Replace(begin, end - begin, way);
  this->TrimEnds(begin == 0, end == n);
  return true;
}

/// The loop from each pin to the next.
std::vector<std::vector<SimplexId>> SplitAtPins(
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins)
{
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    if (std::find(pins.begin(), pins.end(), loop[i]) != pins.end())
    {
      at.push_back(i);
    }
  }
  if (at.empty())
  {
    throw std::invalid_argument(
      "The loop passes through none of the points at which it is to be fixed.");
  }
  std::vector<std::vector<SimplexId>> pieces;
  for (std::size_t k = 0; k < at.size(); ++k)
  {
    const std::size_t last = k + 1 < at.size() ? at[k + 1] : at[0] + loop.size();
    pieces.emplace_back();
    for (std::size_t i = at[k]; i <= last; ++i)
    {
      pieces.back().push_back(loop[i % loop.size()]);
    }
  }
  return pieces;
}

}

SurfaceCurve ShortenPinned(const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop,
  const std::vector<SimplexId>& pins, const LoopShorteningParameters& parameters,
  const ProgressCallback& progress)
{
  Check(parameters);
  SurfaceCurve curve;
  curve.Converged = true;
  const auto pieces = SplitAtPins(loop, pins);
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    Report(progress, static_cast<double>(k) / static_cast<double>(pieces.size()));
    GeodesicArc arc(surface, pieces[k]);
    bool isStraight = false;
    for (int round = 0; round < parameters.MaximumRounds && !isStraight; ++round)
    {
      arc.Straighten();
      isStraight = !arc.Lead();
    }
    curve.Converged = curve.Converged && isStraight;
    curve.Pins.push_back(curve.Crossings.size());
    curve.Crossings.push_back({ surface.Find(pieces[k][0], pieces[k][1]), 0.0 });
    const EdgeStrip crossings = arc.Crossings();
    curve.Crossings.insert(curve.Crossings.end(), crossings.begin(), crossings.end());
  }
  curve.Length = CurveLength(surface, curve.Crossings);
  if (const double before = LengthAlong(surface, loop); curve.Length <= Vanishing * before)
  {
    curve = {};
    curve.Contractible = true;
    curve.Length = before;
    curve.Crossings = AlongPoints(surface, loop);
  }
  return curve;
}

// ------------------------------------------------------------------------------------------
// CornerCutting
namespace
{

/// How often the corners of a cut are cut again, at half of the previous distance each time.
constexpr int Generations = 6;

/// The shortest path in a strip from where its first edge is crossed to where its last one is.
void Straighten(const SurfaceAdjacency& surface, EdgeStrip& strip)
{
  const UnfoldedStrip plane = UnfoldOpen(surface, strip);
  const std::vector<double> fraction =
    FunnelCrossings(plane, PointOn(plane, 0, strip.front().Fraction),
      PointOn(plane, strip.size() - 1, strip.back().Fraction));
  for (std::size_t i = 1; i + 1 < strip.size(); ++i)
  {
    strip[i].Fraction = fraction[i];
  }
}

/// Leads the strip around the first point at which the path bends needlessly; false if there is
/// none.
bool Lead(const SurfaceAdjacency& surface, EdgeStrip& strip)
{
  for (std::size_t i = 1; i + 1 < strip.size(); ++i)
  {
    const SimplexId p = TouchedBy(surface, strip[i]);
    std::size_t end = i + 1;
    while (p >= 0 && end + 1 < strip.size() && Touches(surface, strip[end], p))
    {
      ++end;
    }
    if (p < 0 || Touches(surface, strip[i - 1], p) || Touches(surface, strip[end], p))
    {
      continue;
    }
    const EdgeStrip other = StripOnOtherSide(
      surface, strip[i].HalfEdge, SurfaceAdjacency::Triangle(strip[end - 1].HalfEdge), p);
    if (AngleOnOtherSide(surface, other, p, ComputePosition(surface, strip[i - 1]),
          ComputePosition(surface, strip[end])) >= Pi - 1e-9)
    {
      continue;
    }
    const auto at = [&strip](std::size_t k)
    { return strip.begin() + static_cast<std::ptrdiff_t>(k); };
    EdgeStrip led(strip.begin(), at(i));
    led.insert(led.end(), other.begin(), other.end());
    led.insert(led.end(), at(end), strip.end());
    led = WithoutBacktracking(surface, led);
    if (led.size() >= 2 && led.front().HalfEdge == strip.front().HalfEdge &&
      led.back().HalfEdge == strip.back().HalfEdge)
    {
      strip = std::move(led);
      return true;
    }
  }
  return false;
}

/// A crossing where the curve may turn.
struct Bend
{
  std::size_t Crossing;
  int Generation; ///< 0: a pin, at a point of the surface; otherwise the end of a cut, on an edge
};

/// A closed curve, and where it may turn.
struct BentCurve
{
  std::vector<SurfaceCurvePoint> Crossings;
  std::vector<Bend> Bends;
};

/// One corner of it: crossing k steps ahead is At(k), also below 0.
class Corner
{
public:
  Corner(const SurfaceAdjacency& surface, const BentCurve& curve, const Bend& bend)
    : Surface(surface)
    , Curve(curve)
    , Here(bend)
  {
  }

  double Turn() const
  {
    const Point3 p = this->Place(0);
    const Point3 in = p - this->Place(-1);
    const Point3 out = this->Place(1) - p;
    return std::atan2(Length(Cross(in, out)), Dot(in, out));
  }

  /// The curve without the corner; nothing if that is impossible.
  BentCurve Cut(double reach) const;

private:
  std::size_t Index(std::ptrdiff_t k) const
  {
    const auto n = static_cast<std::ptrdiff_t>(this->Curve.Crossings.size());
    return static_cast<std::size_t>(
      ((static_cast<std::ptrdiff_t>(this->Here.Crossing) + k) % n + n) % n);
  }
  const SurfaceCurvePoint& At(std::ptrdiff_t k) const
  {
    return this->Curve.Crossings[this->Index(k)];
  }
  Point3 Place(std::ptrdiff_t k) const { return ComputePosition(this->Surface, this->At(k)); }
  const Bend* BendAt(std::ptrdiff_t k) const
  {
    const auto& bends = this->Curve.Bends;
    const auto found = std::find_if(bends.begin(), bends.end(),
      [at = this->Index(k)](const Bend& bend) { return bend.Crossing == at; });
    return found == bends.end() ? nullptr : &*found;
  }
  bool IsPin(std::ptrdiff_t k) const
  {
    const Bend* bend = this->BendAt(k);
    return bend && bend->Generation == 0;
  }
  std::ptrdiff_t StepsWithin(std::ptrdiff_t way, double reach) const;
  EdgeStrip FanBeside(bool isLeft) const;
  EdgeStrip Beside() const;

  const SurfaceAdjacency& Surface;
  const BentCurve& Curve;
  Bend Here;
};

/// How many crossings ahead (way 1) or back (-1) the cut begins; 0: there is a pin next to it.
std::ptrdiff_t Corner::StepsWithin(std::ptrdiff_t way, double reach) const
{
  const auto most = static_cast<std::ptrdiff_t>(this->Curve.Crossings.size()) / 2 - 1;
  std::ptrdiff_t steps = 0;
  double length = 0.0;
  while (steps < most && length < reach && !this->IsPin(way * (steps + 1)))
  {
    length += Length(this->Place(way * (steps + 1)) - this->Place(way * steps));
    ++steps;
  }
  return steps;
}

/// The edges at the pin between the triangles of the ways in and out, on one side.
EdgeStrip Corner::FanBeside(bool isLeft) const
{
  const SurfaceAdjacency& s = this->Surface;
  const HalfEdgeId in = this->At(-1).HalfEdge;
  const SurfaceTriangleId last = SurfaceAdjacency::Triangle(s.Opposite(this->At(1).HalfEdge));
  const SurfaceTriangleId first = SurfaceAdjacency::Triangle(in);
  EdgeStrip fan;
  HalfEdgeId h = s.Opposite(isLeft ? SurfaceAdjacency::Previous(in) : SurfaceAdjacency::Next(in));
  for (; SurfaceAdjacency::Triangle(h) != first;
       h = isLeft ? s.Opposite(SurfaceAdjacency::Next(h)) : s.Turn(h))
  {
    fan.push_back({ h, 0.0 });
    if (SurfaceAdjacency::Triangle(h) == last)
    {
      return fan;
    }
  }
  return {};
}

/// The edges that the curve crosses at the bend: a pin on the side where the angle is smaller;
/// empty if the curve leaves through the triangle by which it enters.
EdgeStrip Corner::Beside() const
{
  if (this->Here.Generation > 0)
  {
    return { this->At(0) };
  }
  const SimplexId p = this->Surface.From(this->At(0).HalfEdge);
  EdgeStrip best;
  double least = HUGE_VAL;
  for (const bool isLeft : { true, false })
  {
    const EdgeStrip fan = this->FanBeside(isLeft);
    const double angle = fan.empty()
      ? HUGE_VAL
      : AngleOnOtherSide(this->Surface, fan, p, this->Place(-1), this->Place(1));
    if (angle < least)
    {
      least = angle;
      best = fan;
    }
  }
  return best;
}

BentCurve Corner::Cut(double reach) const
{
  const std::ptrdiff_t back = this->StepsWithin(-1, reach);
  const std::ptrdiff_t ahead = this->StepsWithin(1, reach);
  EdgeStrip fan = back > 0 && ahead > 0 ? this->Beside() : EdgeStrip{};
  if (fan.empty())
  {
    return {};
  }
  EdgeStrip strip;
  for (std::ptrdiff_t k = -back; k < 0; ++k)
  {
    strip.push_back(this->At(k));
  }
  strip.insert(strip.end(), fan.begin(), fan.end());
  for (std::ptrdiff_t k = 1; k <= ahead; ++k)
  {
    strip.push_back(this->At(k));
  }
  // The strip goes around each point beside it once or twice; the bound exists since rounding could
  // cause an endless loop.
  std::size_t left = 4 * strip.size() + 100;
  do
  {
    Straighten(this->Surface, strip);
  } while (left-- > 0 && Lead(this->Surface, strip));
  BentCurve cut{ strip,
    { { 0, this->Here.Generation + 1 }, { strip.size() - 1, this->Here.Generation + 1 } } };
  const auto n = static_cast<std::ptrdiff_t>(this->Curve.Crossings.size());
  for (std::ptrdiff_t k = ahead + 1; k < n - back; ++k)
  {
    if (const Bend* bend = this->BendAt(k))
    {
      cut.Bends.push_back({ cut.Crossings.size(), bend->Generation });
    }
    cut.Crossings.push_back(this->At(k));
  }
  return cut;
}

}

SurfaceCurve CutCorners(
  const SurfaceAdjacency& surface, SurfaceCurve curve, double sharpest, double reach)
{
  BentCurve bent{ curve.Crossings, {} };
  for (const std::size_t pin : curve.Pins)
  {
    bent.Bends.push_back({ pin, 0 });
  }
  std::size_t left =
    std::size_t{ 2 } * Generations * bent.Bends.size() * (reach > 0.0 ? 1 : 0); // cuts
  for (std::size_t i = 0; i < bent.Bends.size() && left > 0;)
  {
    const Bend bend = bent.Bends[i];
    const Corner corner(surface, bent, bend);
    BentCurve cut = bend.Generation < Generations && corner.Turn() > sharpest
      ? corner.Cut(reach * std::pow(0.5, bend.Generation))
      : BentCurve{};
    if (cut.Crossings.empty())
    {
      ++i;
      continue;
    }
    bent = std::move(cut);
    i = 0; // they have been renumbered
    --left;
  }
  curve.SharpestBend = 0.0;
  for (const Bend& bend : bent.Bends)
  {
    curve.SharpestBend = std::max(curve.SharpestBend, Corner(surface, bent, bend).Turn());
  }
  curve.Crossings = std::move(bent.Crossings);
  curve.Pins.clear();
  for (const Bend& bend : bent.Bends)
  {
    if (bend.Generation == 0)
    {
      curve.Pins.push_back(bend.Crossing);
    }
  }
  curve.Length = CurveLength(surface, curve.Crossings);
  return curve;
}

}
