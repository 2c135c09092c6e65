#include "ChokingLoops/CornerCutting.h"

#include "ChokingLoops/StripBend.h"
#include "ChokingLoops/StripFunnel.h"
#include "Core/Pi.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// How often the corners of a cut are cut again, half as far off each time.
constexpr int Generations = 6;

/// The shortest path in a strip from where its first edge is crossed to where its last one is.
void Straighten(const SurfaceAdjacency& surface, EdgeStrip& strip)
{
  const UnfoldedStrip plane = UnfoldOpen(surface, strip);
  const std::vector<double> fraction =
    ShortestCrossings(plane, PointOn(plane, 0, strip.front().Fraction),
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
    const EdgeStrip other = OtherWayRound(
      surface, strip[i].HalfEdge, SurfaceAdjacency::Triangle(strip[end - 1].HalfEdge), p);
    if (AngleBeyond(surface, other, p, PositionOf(surface, strip[i - 1]),
          PositionOf(surface, strip[end])) >= Pi - 1e-9)
    {
      continue;
    }
    const auto at = [&strip](std::size_t k)
    { return strip.begin() + static_cast<std::ptrdiff_t>(k); };
    EdgeStrip led(strip.begin(), at(i));
    led.insert(led.end(), other.begin(), other.end());
    led.insert(led.end(), at(end), strip.end());
    led = WithoutReturns(surface, led);
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
    const double angle =
      fan.empty() ? HUGE_VAL : AngleBeyond(this->Surface, fan, p, this->Place(-1), this->Place(1));
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
