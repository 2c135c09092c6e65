#include "LoopFeature.h"

#include "ChokeFit.h"
#include "PinnedShortening.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

double Distance(const Point3& a, const Point3& b)
{
  return std::sqrt(Dot(b - a, b - a));
}

/// Triangles between two closed curves, advancing on whichever has the shorter diagonal.
class Zipper
{
public:
  Zipper(LoopFeature& feature, const TriangleMesh& samples)
    : Feature(feature)
    , Samples(samples)
  {
  }

  void Close(const std::vector<SimplexId>& a, const std::vector<SimplexId>& b)
  {
    const std::size_t shift = this->Nearest(a.front(), b);
    std::size_t i = 0;
    std::size_t j = 0;
    const auto onB = [&](std::size_t k) { return b[(shift + k) % b.size()]; };
    while (i < a.size() || j < b.size())
    {
      const SimplexId p = a[i % a.size()];
      const SimplexId q = onB(j);
      const SimplexId nextP = a[(i + 1) % a.size()];
      const SimplexId nextQ = onB(j + 1);
      const bool onA = j == b.size() ||
        (i < a.size() &&
          Distance(this->At(nextP), this->At(q)) < Distance(this->At(p), this->At(nextQ)));
      this->Feature.Membrane.push_back(
        onA ? std::array<SimplexId, 3>{ p, nextP, q } : std::array<SimplexId, 3>{ p, nextQ, q });
      ++(onA ? i : j);
    }
  }

private:
  const Point3& At(SimplexId id) const { return this->Feature.Point(id, this->Samples); }

  std::size_t Nearest(SimplexId p, const std::vector<SimplexId>& loop) const
  {
    std::size_t best = 0;
    for (std::size_t k = 1; k < loop.size(); ++k)
    {
      if (Distance(this->At(p), this->At(loop[k])) < Distance(this->At(p), this->At(loop[best])))
      {
        best = k;
      }
    }
    return best;
  }

  LoopFeature& Feature;
  const TriangleMesh& Samples;
};

/// The points of a shortened curve, new ones where it crosses edges.
std::vector<SimplexId> AddCurve(
  const SurfaceAdjacency& surface, const SurfaceCurve& curve, LoopFeature& feature)
{
  std::vector<SimplexId> loop;
  for (const SurfaceCurvePoint& c : curve.Crossings)
  {
    const Point3 p = PositionOf(surface, c);
    // Edges crossed at one point, as round a corner of the surface, make one point of the curve.
    if (!loop.empty() &&
      Distance(feature.Point(loop.back(), surface.Mesh()), p) <= 1e-9 * curve.Length)
    {
      continue;
    }
    loop.push_back(static_cast<SimplexId>(surface.Mesh().Points.size() + feature.Extra.size()));
    feature.Extra.push_back(p);
  }
  if (loop.size() > 3 &&
    Distance(feature.Point(loop.back(), surface.Mesh()),
      feature.Point(loop.front(), surface.Mesh())) <= 1e-9 * curve.Length)
  {
    loop.pop_back();
  }
  return loop;
}

/// Loops this much longer than the shortest girth are worth another look.
constexpr double Roomy = 1.5;

/// Of ShortestGirth(): what discretisation may take off a loop.
constexpr double Slack = 0.98;

/// In radii: how far the choke point may be from the hull of its loops.
constexpr double Nearness = 0.3;

std::vector<SimplexId> PinsOn(
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins)
{
  std::vector<SimplexId> on;
  std::copy_if(pins.begin(), pins.end(), std::back_inserter(on),
    [&loop](SimplexId p) { return std::find(loop.begin(), loop.end(), p) != loop.end(); });
  return on;
}

/// Shortens one loop of a feature and lets its membrane follow; false: it can be drawn together on
/// M.
bool Tighten(const SurfaceAdjacency& surface, int rounds, const std::vector<SimplexId>& pins,
  std::vector<SimplexId>& loop, LoopFeature& feature, const ProgressCallback& progress)
{
  LoopShorteningParameters parameters;
  parameters.MaximumRounds = rounds;
  const std::vector<SimplexId> held = PinsOn(loop, pins);
  const SurfaceCurve curve = held.empty()
    ? ShortenLoop(surface, loop, parameters, progress)
    : ShortenPinned(surface, loop, held, parameters, progress);
  if (!curve.Contractible)
  {
    const std::vector<SimplexId> shortened = AddCurve(surface, curve, feature);
    Zipper(feature, surface.Mesh()).Close(loop, shortened);
    loop = shortened;
  }
  return !curve.Contractible;
}

void Measure(const TriangleMesh& samples, LoopFeature& feature)
{
  for (const auto& loop : feature.Loops)
  {
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      length += Distance(
        feature.Point(loop[i], samples), feature.Point(loop[(i + 1) % loop.size()], samples));
    }
    feature.Lengths.push_back(length);
  }
  for (const auto& t : feature.Membrane)
  {
    const Point3& p = feature.Point(t[0], samples);
    const Point3 n = Cross(feature.Point(t[1], samples) - p, feature.Point(t[2], samples) - p);
    feature.Area += 0.5 * std::sqrt(Dot(n, n));
  }
}

/// The loops of a membrane, shortened, all but held at the pins.
LoopFeature Drawn(const ChokingLoops& loops, const Membrane& membrane, int rounds,
  const std::vector<SimplexId>& pins, const ProgressCallback& progress)
{
  LoopFeature feature;
  feature.Membrane = membrane.Triangles;
  feature.Extra = membrane.Extra;
  const auto count = static_cast<double>(membrane.Loops.size());
  for (std::size_t i = 0; i < membrane.Loops.size(); ++i)
  {
    const auto part =
      Between(progress, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    std::vector<SimplexId> loop = membrane.Loops[i];
    const bool holds = rounds == 0 || Tighten(loops.Adjacency(), rounds, pins, loop, feature, part);
    if (!holds && i > 0)
    {
      AddFan(loop, feature.Membrane); // beside others, a border that M itself closes is none
      continue;
    }
    feature.Collapsed = feature.Collapsed || !holds;
    feature.Loops.push_back(std::move(loop));
    feature.Anchors.push_back(membrane.Loops[i].front());
  }
  Measure(loops.Samples(), feature);
  return feature;
}

double Longest(const LoopFeature& feature)
{
  return feature.Lengths.empty()
    ? 0.0
    : *std::max_element(feature.Lengths.begin(), feature.Lengths.end());
}

std::vector<Point3> PointsOf(
  const ChokingLoops& loops, const LoopFeature& feature, const std::vector<SimplexId>& loop)
{
  std::vector<Point3> points;
  for (const SimplexId p : loop)
  {
    points.push_back(feature.Point(p, loops.Samples()));
  }
  return points;
}

}

bool Belongs(const ChokingLoops& loops, std::size_t index, const LoopFeature& feature)
{
  const ShapeFeature& f = loops.Diagram().Features[index];
  std::vector<Point3> points;
  for (const auto& loop : feature.Loops)
  {
    const std::vector<Point3> polygon = PointsOf(loops, feature, loop);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return !feature.Collapsed && Longest(feature) >= Slack * ShortestGirth(f) &&
    IsSurrounded(loops.ChokePoint(index), Nearness * f.Distance(), points);
}

namespace
{

double SharpestTurnOf(const ChokingLoops& loops, const LoopFeature& feature)
{
  double sharpest = 0.0;
  for (const auto& loop : feature.Loops)
  {
    const std::vector<Point3> polygon = PointsOf(loops, feature, loop);
    sharpest = std::max(sharpest, SharpestTurn(polygon, 1e-6 * Longest(feature)));
  }
  return sharpest;
}

/// Of the loops held at some of the points where the ball touches M, those that belong and turn
/// least; where none belong, those held at all of them, if `best` could be drawn together.
void HoldAtContacts(ChokingLoops& loops, std::size_t index, int rounds,
  const std::array<const Membrane*, 2>& membranes, LoopFeature& best)
{
  const std::vector<SimplexId> contacts = loops.ContactsOf(index);
  const unsigned all = (1U << contacts.size()) - 1U;
  double least = HUGE_VAL;
  for (const Membrane* membrane : membranes)
  {
    const bool isFound = std::isfinite(least); // with the membrane before
    for (unsigned choice = all; membrane && !isFound && choice > 0; --choice)
    {
      std::vector<SimplexId> pins;
      for (std::size_t k = 0; k < contacts.size(); ++k)
      {
        if (choice >> k & 1U)
        {
          pins.push_back(contacts[k]);
        }
      }
      LoopFeature held = Drawn(loops, *membrane, rounds, pins, {});
      held.Held = true;
      const double turn = SharpestTurnOf(loops, held);
      if (Belongs(loops, index, held) ? turn < least : best.Collapsed && choice == all)
      {
        least = Belongs(loops, index, held) ? turn : least;
        best = std::move(held);
      }
    }
  }
}

}

LoopFeature MakeLoopFeature(
  ChokingLoops& loops, std::size_t index, int rounds, const ProgressCallback& progress)
{
  const ShapeFeature& f = loops.Diagram().Features[index];
  const Membrane& pushed = loops.MembraneOf(index);
  LoopFeature best = Drawn(loops, pushed, rounds, {}, Between(progress, 0.0, 0.4));
  bool belongs = Belongs(loops, index, best);
  if (rounds == 0 || !f.Trusted || f.Choke < 0 ||
    (belongs && Longest(best) < Roomy * ShortestGirth(f)))
  {
    return best;
  }
  const Membrane* tight = loops.TightMembraneOf(index, Between(progress, 0.4, 0.6));
  if (tight)
  {
    LoopFeature other = Drawn(loops, *tight, rounds, {}, Between(progress, 0.6, 0.8));
    if (Belongs(loops, index, other) && (!belongs || Longest(other) < Longest(best)))
    {
      best = std::move(other);
      belongs = true;
    }
  }
  if (!belongs)
  {
    HoldAtContacts(loops, index, rounds, { tight, &pushed }, best);
  }
  return best;
}

}
