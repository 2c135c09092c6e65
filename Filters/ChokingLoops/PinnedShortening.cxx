#include "ChokingLoops/PinnedShortening.h"

#include "ChokingLoops/StripBend.h"
#include "ChokingLoops/StripFunnel.h"
#include "Core/Pi.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
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
    ShortestCrossings(plane, plane.From.front(), plane.From.back());
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
  const EdgeStrip other = OtherWayRound(
    s, this->Edges[first].HalfEdge, SurfaceAdjacency::Triangle(this->Edges[end - 1].HalfEdge), p);
  const Point3 before = first > 0 ? PositionOf(s, this->Edges[first - 1]) : this->At(this->From);
  const Point3 after =
    end < this->Edges.size() ? PositionOf(s, this->Edges[end]) : this->At(this->To);
  if (AngleBeyond(s, other, p, before, after) >= Pi - 1e-9)
  {
    return false;
  }
  const auto at = [this](std::size_t i)
  { return this->Edges.begin() + static_cast<std::ptrdiff_t>(i); };
  EdgeStrip strip(at(0), at(first));
  strip.insert(strip.end(), other.begin(), other.end());
  strip.insert(strip.end(), at(end), this->Edges.end());
  CancelReturns(s, strip, this->From, this->To);
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

}
