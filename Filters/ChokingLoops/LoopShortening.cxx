#include "ChokingLoops/LoopShortening.h"

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Geometry.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// LoopShortening
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
  const std::vector<double> fraction = FunnelCrossings(plane, p, q);
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
  const EdgeStrip other = StripOnOtherSide(s, enter, last, p);
  const Point3 before = PositionOf(s, this->Edges[(first + n - 1) % n]);
  const Point3 after = PositionOf(s, this->Edges[(first + count) % n]);
  if (AngleOnOtherSide(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  EdgeStrip strip;
  for (std::size_t k = 0; k < n - count; ++k)
  {
    strip.push_back(this->Edges[(first + count + k) % n]);
  }
  strip.insert(strip.end(), other.begin(), other.end());
  RemoveBacktracking(s, strip);
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
    , Edges(StripLeftOfPath(surface, path))
  {
  }

  const EdgeStrip& Crossings() const { return this->Edges; }

  /// The shortest path in the strip.
  void Straighten();

  /// Leads the strip round the points at which the path bends needlessly; false: there are none.
  bool Lead();

private:
  bool LeadRound(std::size_t first, std::size_t end, SimplexId p);

  const Point3& At(SimplexId p) const
  {
    return this->Surface.Mesh().Points[static_cast<std::size_t>(p)];
  }

  const SurfaceAdjacency& Surface;
  SimplexId From;
  SimplexId To;
  EdgeStrip Edges;
};

void GeodesicArc::Straighten()
{
  if (this->Edges.empty())
  {
    return;
  }
  const UnfoldedStrip plane = UnfoldPath(this->Surface, this->Edges);
  const std::vector<double> fraction =
    FunnelCrossings(plane, plane.From.front(), plane.From.back());
  for (std::size_t i = 0; i < this->Edges.size(); ++i)
  {
    this->Edges[i].Fraction = fraction[i + 1];
  }
}

bool GeodesicArc::Lead()
{
  bool led = false;
  std::size_t left = 2 * this->Edges.size(); // so that rounding can't make it go on for ever
  for (std::size_t i = 0; i < this->Edges.size() && left > 0; ++i, --left)
  {
    const SimplexId p = TouchedBy(this->Surface, this->Edges[i]);
    if (p < 0 || (i > 0 && Touches(this->Surface, this->Edges[i - 1], p)))
    {
      continue;
    }
    std::size_t end = i + 1;
    while (end < this->Edges.size() && Touches(this->Surface, this->Edges[end], p))
    {
      ++end;
    }
    led = this->LeadRound(i, end, p) || led;
  }
  return led;
}

// The path runs through p along edges first .. end - 1 of the strip, which all end there.
bool GeodesicArc::LeadRound(std::size_t first, std::size_t end, SimplexId p)
{
  const SurfaceAdjacency& s = this->Surface;
  const EdgeStrip other = StripOnOtherSide(
    s, this->Edges[first].HalfEdge, SurfaceAdjacency::Triangle(this->Edges[end - 1].HalfEdge), p);
  const Point3 before = first > 0 ? PositionOf(s, this->Edges[first - 1]) : this->At(this->From);
  const Point3 after =
    end < this->Edges.size() ? PositionOf(s, this->Edges[end]) : this->At(this->To);
  if (AngleOnOtherSide(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  const auto at = [this](std::size_t i)
  { return this->Edges.begin() + static_cast<std::ptrdiff_t>(i); };
  EdgeStrip strip(at(0), at(first));
  strip.insert(strip.end(), other.begin(), other.end());
  strip.insert(strip.end(), at(end), this->Edges.end());
  RemoveBacktracking(s, strip, this->From, this->To);
  this->Edges = std::move(strip);
  return true;
}

/// The loop from each pin to the next.
std::vector<std::vector<SimplexId>> PiecesOf(
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
    throw std::invalid_argument("The loop passes none of the points that it is to pass.");
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
  SurfaceCurve curve;
  curve.Converged = true;
  const auto pieces = PiecesOf(loop, pins);
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
    const EdgeStrip& crossings = arc.Crossings();
    curve.Crossings.insert(curve.Crossings.end(), crossings.begin(), crossings.end());
  }
  curve.Length = LengthOf(surface, curve.Crossings);
  return curve;
}

// ------------------------------------------------------------------------------------------
// CornerCutting
namespace
{

/// How often the corners of a cut are cut again, half as far off each time.
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

/// Leads the strip round the first point at which the path bends needlessly; false: there is none.
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
    if (AngleOnOtherSide(surface, other, p, PositionOf(surface, strip[i - 1]),
          PositionOf(surface, strip[end])) >= Pi - 1e-9)
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
  int Generation; ///< 0: a pin, at a point of the surface; else where a cut ended, on an edge
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

  /// The curve without the corner; nothing where that can't be.
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
  Point3 Place(std::ptrdiff_t k) const { return PositionOf(this->Surface, this->At(k)); }
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

/// What the curve crosses at the bend: a pin on the side where the angle is smaller; empty where
/// the way out is in the triangle of the way in.
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
  // Each point beside the strip is led round once or twice; the bound is against rounding, which
  // could make it go on for ever.
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
    i = 0; // they are numbered anew
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
  curve.Length = LengthOf(surface, curve.Crossings);
  return curve;
}

}
