#include "ChokingLoops/LoopDrawing.h"

#include "ChokingLoops/LoopShortening.h"
#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/Stopwatch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// ChokeFit
namespace
{

/// Number of points of the hull to try; far fewer already give the nearest one to 1 %.
constexpr int Steps = 200;

}

double ShortestGirth(const ShapeFeature& feature)
{
  return 2.0 * Pi * std::max(0.0, feature.Radius() - ComputeUncertainty(feature));
}

bool IsSurrounded(const Point3& center, double reach, const std::vector<Point3>& points)
{
  if (points.empty())
  {
    return false;
  }
  Point3 nearest = points.front() - center; // a point of the hull, moved towards the center
  for (int step = 0; step < Steps && Length(nearest) > reach; ++step)
  {
    const auto along = [&](const Point3& p) { return Dot(p - center, nearest); };
    const Point3 support =
      *std::min_element(points.begin(), points.end(),
        [&](const Point3& a, const Point3& b) { return along(a) < along(b); }) -
      center;
    if (Dot(support, nearest) > reach * Length(nearest))
    {
      return false; // a plane separates the hull from the ball
    }
    const Point3 way = support - nearest;
    const double length2 = Dot(way, way);
    if (length2 <= 0.0)
    {
      break;
    }
    nearest = nearest + std::clamp(-Dot(nearest, way) / length2, 0.0, 1.0) * way;
  }
  return Length(nearest) <= reach;
}

double SharpestTurn(const std::vector<Point3>& polygon, double least)
{
  std::vector<Point3> corners;
  for (const Point3& p : polygon)
  {
    if (corners.empty() || Length(p - corners.back()) > least)
    {
      corners.push_back(p);
    }
  }
  while (corners.size() > 1 && Length(corners.front() - corners.back()) <= least)
  {
    corners.pop_back();
  }
  double sharpest = 0.0;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n > 2 && i < n; ++i)
  {
    const Point3 in = corners[i] - corners[(i + n - 1) % n];
    const Point3 out = corners[(i + 1) % n] - corners[i];
    const Point3 c = Cross(in, out);
    sharpest = std::max(sharpest, std::atan2(Length(c), Dot(in, out)));
  }
  return sharpest;
}

// ------------------------------------------------------------------------------------------
// LoopDrawing
namespace
{

/// Triangles between two closed curves, advancing on the curve with the shorter diagonal.
class Zipper
{
public:
  Zipper(LoopFeature& feature, const SurfaceView& samples)
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
  SurfaceView Samples;
};

/// The points of a shortened curve on the samples' triangles or on the fine surface, as new ones.
std::vector<SimplexId> AddCurve(const SurfaceAdjacency& surface, const SurfaceView& samples,
  const SurfaceCurve& curve, LoopFeature& feature)
{
  std::vector<SimplexId> loop;
  for (const SurfaceCurvePoint& c : curve.Crossings)
  {
    const Point3 p = ComputePosition(surface, c);
    // Edges crossed at one point, as around a corner of the surface, make one point of the curve.
    if (!loop.empty() && Distance(feature.Point(loop.back(), samples), p) <= 1e-9 * curve.Length)
    {
      continue;
    }
    loop.push_back(static_cast<SimplexId>(samples.Points.size() + feature.Extra.size()));
    feature.Extra.push_back(p);
  }
  if (loop.size() > 3 &&
    Distance(feature.Point(loop.back(), samples), feature.Point(loop.front(), samples)) <=
      1e-9 * curve.Length)
  {
    loop.pop_back();
  }
  return loop;
}

std::vector<SimplexId> PinsOn(
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins)
{
  std::vector<SimplexId> on;
  std::copy_if(pins.begin(), pins.end(), std::back_inserter(on),
    [&loop](SimplexId p) { return std::find(loop.begin(), loop.end(), p) != loop.end(); });
  return on;
}

/// The nearer ends of the edges that a curve crosses.
std::vector<SimplexId> WalkAlong(const SurfaceAdjacency& surface, const SurfaceCurve& curve)
{
  std::vector<SimplexId> walk;
  for (const SurfaceCurvePoint& c : curve.Crossings)
  {
    const SimplexId p = c.Fraction < 0.5 ? surface.From(c.HalfEdge) : surface.To(c.HalfEdge);
    if (walk.empty() || walk.back() != p)
    {
      walk.push_back(p);
    }
  }
  return walk;
}

/// Replaces a loop by a shortest curve and adapts the membrane.
void Follow(const SurfaceAdjacency& surface, const SurfaceCurve& tight, double cut,
  std::vector<SimplexId>& loop, LoopFeature& feature)
{
  const SurfaceCurve curve = CutCorners(surface, tight, SharpestUncut, cut);
  feature.Walks.back() = WalkAlong(surface, curve);
  const std::vector<SimplexId> shortened = AddCurve(surface, surface.Mesh(), curve, feature);
  Zipper(feature, surface.Mesh()).Close(loop, shortened);
  loop = shortened;
  feature.Converged = feature.Converged && curve.Converged;
  feature.SharpestBend = std::max(feature.SharpestBend, curve.SharpestBend);
}

void Measure(const SurfaceView& samples, LoopFeature& feature)
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
    feature.Area += TriangleArea(
      feature.Point(t[0], samples), feature.Point(t[1], samples), feature.Point(t[2], samples));
  }
}

}

std::vector<SurfaceCurve> ShortenedLoops(const SurfaceAdjacency& surface, const Membrane& membrane,
  int rounds, const std::vector<SimplexId>& pins, const ProgressCallback& progress)
{
  std::vector<SurfaceCurve> tight;
  LoopShorteningParameters parameters;
  parameters.MaximumRounds = rounds;
  const auto count = static_cast<double>(membrane.Loops.size());
  for (std::size_t i = 0; rounds > 0 && i < membrane.Loops.size(); ++i)
  {
    const std::vector<SimplexId>& loop = membrane.Loops[i];
    const std::vector<SimplexId> held = PinsOn(loop, pins);
    const auto part =
      Between(progress, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
    tight.push_back(held.empty() ? ShortenLoop(surface, loop, parameters, part)
                                 : ShortenPinned(surface, loop, held, parameters, part));
  }
  return tight;
}

LoopFeature Drawn(const SurfaceAdjacency& surface, const Membrane& membrane,
  const std::vector<SurfaceCurve>& tight, double cut)
{
  LoopFeature feature;
  feature.Membrane = membrane.Triangles;
  feature.Extra = membrane.Extra;
  const std::size_t count = membrane.Loops.size();
  const auto holds = [&tight](std::size_t i) { return tight.empty() || !tight[i].Contractible; };
  std::size_t longest = 0; // of those that are contractible, which are returned unchanged
  bool anyHolds = false;
  for (std::size_t i = 0; i < count; ++i)
  {
    anyHolds = anyHolds || holds(i);
    longest = !tight.empty() && tight[i].Length > tight[longest].Length ? i : longest;
  }
  feature.Collapsed = count > 0 && !anyHolds;
  for (std::size_t i = 0; i < count; ++i)
  {
    std::vector<SimplexId> loop = membrane.Loops[i];
    if (!holds(i) && (anyHolds || i != longest))
    {
      AddFan(loop, feature.Membrane); // one of several borders, contractible on M: filled
      continue;
    }
    feature.Walks.push_back(loop);
    if (holds(i) && !tight.empty())
    {
      Follow(surface, tight[i], cut, loop, feature);
    }
    feature.Loops.push_back(std::move(loop));
    feature.Anchors.push_back(membrane.Loops[i].front());
  }
  Measure(surface.Mesh(), feature);
  return feature;
}

// ------------------------------------------------------------------------------------------
// LoopFeature
double LoopFeature::LongestLength() const
{
  return this->Lengths.empty() ? 0.0
                               : *std::max_element(this->Lengths.begin(), this->Lengths.end());
}

namespace
{

/// Other loops are tried for those longer than the shortest circumference by this factor.
constexpr double Roomy = 1.5;

/// Factor of ShortestGirth(): the amount by which discretisation may shorten a loop.
constexpr double Slack = 0.98;

std::vector<Point3> LoopPoints(
  const ChokingLoops& loops, const LoopFeature& feature, const std::vector<SimplexId>& loop)
{
  std::vector<Point3> points;
  points.reserve(loop.size());
  for (const SimplexId p : loop)
  {
    points.push_back(feature.Point(p, loops.Samples()));
  }
  return points;
}

}

bool BelongsToChokePoint(const ChokingLoops& loops, std::size_t index, const LoopFeature& feature,
  const LoopTolerances& tolerances)
{
  const ShapeFeature& f = loops.Diagram().Features[index];
  std::vector<Point3> points;
  for (const auto& loop : feature.Loops)
  {
    const std::vector<Point3> polygon = LoopPoints(loops, feature, loop);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return !feature.Collapsed && feature.LongestLength() >= Slack * ShortestGirth(f) &&
    IsSurrounded(loops.ChokePoint(index), tolerances.Nearness * f.Radius(), points);
}

namespace
{

/// A loop that is not tight on the surface may be longer by this factor than one that is.
constexpr double Freedom = 1.05;

/// Maximum length of the encircling loops searched, in circumferences of the ball; their number.
constexpr double MaxEncirclingLength = 3.0;
constexpr std::size_t MaxEncirclingLoops = 6;

/// Paths along edges are longer than geodesics by this factor.
constexpr double AlongEdges = 1.15;

std::vector<SimplexId> ContactsOn(const Membrane& membrane, const std::vector<SimplexId>& contacts)
{
  std::vector<SimplexId> on;
  std::copy_if(contacts.begin(), contacts.end(), std::back_inserter(on),
    [&membrane](SimplexId p)
    {
      return std::any_of(membrane.Loops.begin(), membrane.Loops.end(),
        [p](const auto& loop) { return std::find(loop.begin(), loop.end(), p) != loop.end(); });
    });
  return on;
}

/// Of loops tried one after another, the tightest of those that fit best.
class TightestFit
{
public:
  TightestFit(
    ChokingLoops& loops, std::size_t feature, int rounds, const LoopTolerances& tolerances)
    : Loops(loops)
    , Index(feature)
    , Rounds(rounds)
    , Tolerances(tolerances)
    , Girth(ShortestGirth(loops.Diagram().Features[feature]))
    , Contacts(loops.GetContacts(feature))
  {
  }

  /// Drawn as tight as possible on M.
  void TryFree(const Membrane& membrane, bool isEncircling, const ProgressCallback& progress = {});

  /// Fixed at some of the points where the ball touches M; first, at all of them.
  void TryHeld(const Membrane& membrane, bool isEncircling);

  bool BelongsToChokePoint() const { return this->BestGrade >= Grade::Jagged; }
  bool IsLongEnough() const { return this->BestGrade >= Grade::Hairpin; }
  bool Fits() const { return this->BestGrade == Grade::Fits; }
  double Length() const { return this->Best.LongestLength(); }
  double ShortestLength() const { return this->Girth; }
  LoopFeature Take() { return std::move(this->Best); }

private:
  enum class Grade
  {
    None,
    Collapsed,
    Short,   ///< there is no room for the ball in it
    Hairpin, ///< belongs to the choke point, but retraces itself
    Strays,  ///< tight, but elsewhere
    Jagged,  ///< belongs to the choke point, but is fixed at a sharp turn
    Fits
  };

  Grade ComputeGrade(const LoopFeature& candidate) const;
  double EstimateCost(const LoopFeature& candidate, Grade grade) const;
  void Try(LoopFeature candidate, bool isEncircling);

  ChokingLoops& Loops;
  std::size_t Index;
  int Rounds;
  LoopTolerances Tolerances;
  double Girth;
  std::vector<SimplexId> Contacts;
  LoopFeature Best;
  Grade BestGrade = Grade::None;
  double BestCost = 0.0;
};

TightestFit::Grade TightestFit::ComputeGrade(const LoopFeature& candidate) const
{
  if (!isthmus::BelongsToChokePoint(this->Loops, this->Index, candidate, this->Tolerances))
  {
    const bool isShort = candidate.LongestLength() < Slack * this->Girth;
    return candidate.Collapsed    ? Grade::Collapsed
      : isShort || candidate.Held ? Grade::Short
                                  : Grade::Strays;
  }
  return candidate.SharpestBend >= this->Tolerances.SharpestLoop ? Grade::Hairpin
    : candidate.SharpestBend >= this->Tolerances.SharpestHeld    ? Grade::Jagged
                                                                 : Grade::Fits;
}

double TightestFit::EstimateCost(const LoopFeature& candidate, Grade grade) const
{
  switch (grade)
  {
    case Grade::Fits:
      return (candidate.Held ? Freedom : 1.0) * candidate.LongestLength();
    case Grade::Strays:
      return candidate.LongestLength();
    case Grade::Jagged:
    case Grade::Hairpin:
      return candidate.SharpestBend;
    default:
      return std::max(0.0, this->Girth - candidate.LongestLength());
  }
}

void TightestFit::Try(LoopFeature candidate, bool isEncircling)
{
  const Grade grade = this->ComputeGrade(candidate);
  const double cost = this->EstimateCost(candidate, grade);
  if (grade > this->BestGrade || (grade == this->BestGrade && cost < this->BestCost))
  {
    candidate.Encircling = isEncircling;
    this->Best = std::move(candidate);
    this->BestGrade = grade;
    this->BestCost = cost;
  }
}

void TightestFit::TryFree(
  const Membrane& membrane, bool isEncircling, const ProgressCallback& progress)
{
  const SurfaceAdjacency& surface = this->Loops.Adjacency();
  LoopFeature candidate =
    Drawn(surface, membrane, ShortenedLoops(surface, membrane, this->Rounds, {}, progress));
  for (const auto& loop : candidate.Loops)
  {
    if (isEncircling && !candidate.Converged)
    {
      candidate.SharpestBend = std::max(candidate.SharpestBend,
        SharpestTurn(LoopPoints(this->Loops, candidate, loop), 1e-6 * candidate.LongestLength()));
    }
  }
  this->Try(std::move(candidate), isEncircling);
}

void TightestFit::TryHeld(const Membrane& membrane, bool isEncircling)
{
  const SurfaceAdjacency& surface = this->Loops.Adjacency();
  const double radius = this->Loops.Diagram().Features[this->Index].Radius();
  const std::vector<SimplexId> touched = ContactsOn(membrane, this->Contacts);
  for (unsigned choice = (1U << touched.size()) - 1U; choice > 0; --choice)
  {
    std::vector<SimplexId> pins;
    for (std::size_t k = 0; k < touched.size(); ++k)
    {
      if (choice >> k & 1U)
      {
        pins.push_back(touched[k]);
      }
    }
    const std::vector<SurfaceCurve> tight = ShortenedLoops(surface, membrane, this->Rounds, pins);
    LoopFeature held = Drawn(surface, membrane, tight);
    held.Held = true;
    const bool isCut = held.SharpestBend > SharpestUncut;
    this->Try(std::move(held), isEncircling);
    for (std::size_t i = 0; isCut && i < this->Tolerances.CornerCuts.size(); ++i)
    {
      held = Drawn(surface, membrane, tight, this->Tolerances.CornerCuts[i] * radius);
      held.Held = true;
      this->Try(std::move(held), isEncircling);
    }
  }
}

}

namespace
{

/// The feature by one method alone; nothing if the method yields no membrane.
std::optional<LoopFeature> DrawnBy(MembraneMethod method, ChokingLoops& loops, std::size_t index,
  int rounds, const ProgressCallback& progress)
{
  if (method == MembraneMethod::Automatic || !loops.Diagram().Features[index].Choke.Exists())
  {
    return std::nullopt;
  }
  std::optional<Membrane> membrane;
  if (method == MembraneMethod::Greedy)
  {
    membrane = loops.ComputeGreedyMembrane(index);
  }
  else if (const Membrane* cut =
             loops.GetMinimumCutMembrane(index, Between(progress, 0.0, 0.5), true))
  {
    membrane = *cut;
  }
  if (!membrane)
  {
    return std::nullopt;
  }
  LoopFeature feature = Drawn(loops.Adjacency(), *membrane,
    ShortenedLoops(loops.Adjacency(), *membrane, rounds, {}, Between(progress, 0.5, 1.0)));
  feature.Method = method;
  feature.GrowthCost = membrane->GrowthCost;
  return feature;
}

}

namespace
{

LoopFeature DrawnOnSamples(ChokingLoops& loops, std::size_t index, int rounds,
  const ProgressCallback& progress, const LoopTolerances& tolerances, MembraneMethod method)
{
  if (std::optional<LoopFeature> asked = DrawnBy(method, loops, index, rounds, progress))
  {
    return std::move(*asked);
  }
  const ShapeFeature& f = loops.Diagram().Features[index];
  const Membrane& pushed = loops.GetMembrane(index);
  TightestFit fit(loops, index, rounds, tolerances);
  fit.TryFree(pushed, false, Between(progress, 0.0, 0.4));
  if (rounds == 0 || !f.Trusted || !f.Choke.Exists() ||
    (fit.BelongsToChokePoint() && fit.Length() < Roomy * fit.ShortestLength()))
  {
    return fit.Take();
  }
  const Membrane* tight = loops.GetMinimumCutMembrane(index, Between(progress, 0.4, 0.6));
  if (tight)
  {
    fit.TryFree(*tight, false, Between(progress, 0.6, 0.7));
  }
  if (fit.BelongsToChokePoint())
  {
    return fit.Take();
  }
  for (const Membrane* membrane : { tight, &pushed })
  {
    if (membrane && !fit.Fits())
    {
      fit.TryHeld(*membrane, false);
    }
  }
  Report(progress, 0.8);
  const double longest = std::min(
    fit.Fits() ? Freedom * fit.Length() : HUGE_VAL, MaxEncirclingLength * 2.0 * Pi * f.Radius());
  for (const Membrane& round :
    loops.ComputeEncirclingMembranes(index, AlongEdges * longest, MaxEncirclingLoops))
  {
    fit.TryFree(round, true);
    if (!fit.Fits())
    {
      fit.TryHeld(round, true);
    }
  }
  const auto last =
    fit.IsLongEnough() ? std::nullopt : loops.ComputeContactMembrane(index, longest);
  if (last)
  {
    fit.TryHeld(*last, true);
  }
  return fit.Take();
}

/// A closed walk without steps that return at once.
std::vector<SimplexId> WithoutSpikes(const std::vector<SimplexId>& walk)
{
  std::vector<SimplexId> kept;
  for (const SimplexId p : walk)
  {
    if (!kept.empty() && kept.back() == p)
    {
      continue;
    }
    if (kept.size() > 1 && kept[kept.size() - 2] == p)
    {
      kept.pop_back();
      continue;
    }
    kept.push_back(p);
  }
  std::size_t first = 0;
  while (kept.size() - first > 2 &&
    (kept.back() == kept[first] || kept.back() == kept[first + 1] ||
      kept[kept.size() - 2] == kept[first]))
  {
    if (kept.back() == kept[first + 1])
    {
      ++first;
    }
    kept.pop_back();
  }
  return { kept.begin() + static_cast<std::ptrdiff_t>(first), kept.end() };
}

/// Paths on the surface are longer than edges between samples by at most the first factor, or,
/// where it is very rough, by the last.
constexpr std::array<double, 3> DetoursOnFine{ 2.0, 8.0, 64.0 };

/// The closed walk on the fine surface through these samples; empty if there is none.
std::vector<SimplexId> WalkOnFine(const ChokingLoops& loops, const std::vector<SimplexId>& samples)
{
  const SurfaceAdjacency& surface = loops.Fine()->Adjacency();
  const auto& points = surface.Mesh().Points;
  std::vector<SimplexId> walk;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const SimplexId from = loops.PointOfFine(samples[i]);
    const SimplexId to = loops.PointOfFine(samples[(i + 1) % samples.size()]);
    const double straight = Distance(points[At(from)], points[At(to)]);
    std::vector<SimplexId> back;
    for (std::size_t k = 0; k < DetoursOnFine.size() && from != to && back.empty(); ++k)
    {
      const SurfacePaths paths(surface, from, DetoursOnFine[k] * straight, to);
      for (SimplexId p = to; paths.Has(to) && p != from; p = surface.From(paths.Last(p)))
      {
        back.push_back(p);
      }
    }
    if (from != to && back.empty())
    {
      return {};
    }
    walk.push_back(from);
    walk.insert(walk.end(), back.rbegin(), back.rend());
  }
  return WithoutSpikes(walk);
}

/// The point next to `center` in each of `count` equal parts of a walk.
std::vector<SimplexId> NearestOfParts(const View<Point3>& points, const Point3& center,
  const std::vector<SimplexId>& walk, std::size_t count)
{
  std::vector<SimplexId> nearest;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto from = walk.begin() + static_cast<std::ptrdiff_t>(i * walk.size() / count);
    const auto to = walk.begin() + static_cast<std::ptrdiff_t>((i + 1) * walk.size() / count);
    if (from != to)
    {
      nearest.push_back(*std::min_element(from, to,
        [&](SimplexId a, SimplexId b)
        { return Distance(points[At(a)], center) < Distance(points[At(b)], center); }));
    }
  }
  nearest.erase(std::unique(nearest.begin(), nearest.end()), nearest.end());
  return nearest;
}

/// Numbers of points at which a loop is fixed that would slide off otherwise: the fewer, the
/// straighter it is.
constexpr std::array<std::size_t, 3> Fixed{ 3, 6, 12 };

/// The feature with its loops on the fine surface, each fixed there at `pins` points.
LoopFeature MovedToFine(const ChokingLoops& loops, const LoopFeature& coarse,
  const std::vector<std::vector<SimplexId>>& walks, int rounds, std::size_t pins,
  const Point3& center, const ProgressCallback& progress)
{
  const SurfaceAdjacency& surface = loops.Fine()->Adjacency();
  LoopFeature feature = coarse;
  feature.Lengths.clear();
  feature.Area = 0.0;
  LoopShorteningParameters parameters;
  parameters.MaximumRounds = rounds;
  for (std::size_t i = 0; i < walks.size(); ++i)
  {
    SurfaceCurve curve;
    if (rounds > 0)
    {
      curve = pins > 0
        ? ShortenPinned(surface, walks[i],
            NearestOfParts(surface.Mesh().Points, center, walks[i], pins), parameters, progress)
        : ShortenLoop(surface, walks[i], parameters, progress);
    }
    std::vector<SimplexId> loop;
    if (rounds > 0 && !curve.Contractible)
    {
      feature.Converged = feature.Converged && curve.Converged;
      loop = AddCurve(surface, loops.Samples(), curve, feature);
    }
    else
    {
      feature.Collapsed = feature.Collapsed || rounds > 0;
      for (const SimplexId p : walks[i])
      {
        loop.push_back(
          static_cast<SimplexId>(loops.Samples().Points.size() + feature.Extra.size()));
        feature.Extra.push_back(surface.Mesh().Points[At(p)]);
      }
    }
    Zipper(feature, loops.Samples()).Close(feature.Loops[i], loop);
    feature.Loops[i] = std::move(loop);
  }
  Measure(loops.Samples(), feature);
  return feature;
}

/// A feature drawn on the samples becomes one on the surface. A loop that does not stay at the
/// choke point is fixed at some points.
LoopFeature DrawnOnFine(const ChokingLoops& loops, std::size_t index, const LoopFeature& coarse,
  int rounds, const ProgressCallback& progress)
{
  std::vector<std::vector<SimplexId>> walks;
  for (const std::vector<SimplexId>& samples : coarse.Walks)
  {
    walks.push_back(WalkOnFine(loops, samples));
    if (walks.back().size() < 3)
    {
      return coarse;
    }
  }
  const Point3 center = loops.ChokePoint(index);
  const bool belongs = BelongsToChokePoint(loops, index, coarse);
  if (!coarse.Held && !coarse.Collapsed)
  {
    LoopFeature feature = MovedToFine(loops, coarse, walks, rounds, 0, center, progress);
    if (!feature.Collapsed && (BelongsToChokePoint(loops, index, feature) || !belongs))
    {
      return feature;
    }
  }
  LoopFeature feature;
  for (const std::size_t pins : Fixed)
  {
    feature =
      MovedToFine(loops, coarse, walks, coarse.Collapsed ? 0 : rounds, pins, center, progress);
    if (coarse.Collapsed || !belongs || BelongsToChokePoint(loops, index, feature))
    {
      break;
    }
  }
  return feature;
}

}

LoopFeature MakeLoopFeature(ChokingLoops& loops, std::size_t index, int rounds,
  const ProgressCallback& progress, const LoopTolerances& tolerances, MembraneMethod method)
{
  LoopFeature feature =
    DrawnOnSamples(loops, index, rounds, Between(progress, 0.0, 0.8), tolerances, method);
  return loops.Fine() && !feature.Loops.empty()
    ? DrawnOnFine(loops, index, feature, rounds, Between(progress, 0.8, 1.0))
    : feature;
}

// ------------------------------------------------------------------------------------------
// FeatureDrawing
namespace
{

/// Tasks of very different lengths, each run by the first thread that is free: with fixed shares,
/// all would wait for the one that has the longest task.
class TaskRun
{
public:
  /// Does task i; throws Cancelled when the callback returns false.
  using Task = std::function<void(std::size_t i, const ProgressCallback& progress)>;

  TaskRun(std::size_t count, Task task)
    : Count(count)
    , Do(std::move(task))
  {
  }

  /// Tasks in their order on the calling thread.
  void Alone(const ProgressCallback& progress);

  /// The same on as many threads; `progress` is called on the calling thread.
  void On(std::size_t threads, const ProgressCallback& progress);

private:
  void Work();
  void Watch(const ProgressCallback& progress);
  void Stop()
  {
    this->IsStopped = true;
    this->Next = this->Count;
  }

  /// Interval of the callbacks; also the time that an abort takes to reach the threads.
  static constexpr std::chrono::milliseconds Beat{ 50 };

  std::size_t Count;
  Task Do;
  std::atomic<std::size_t> Next{ 0 };
  std::atomic<bool> IsStopped{ false };
  std::mutex Mutex; ///< of the members below
  std::condition_variable Changed;
  std::size_t Done = 0;
  std::exception_ptr Failure;
};

void TaskRun::Alone(const ProgressCallback& progress)
{
  const auto part = [this](std::size_t i)
  { return static_cast<double>(i) / static_cast<double>(this->Count); };
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const auto own = Between(progress, part(i), part(i + 1));
    Report(own, 0.0);
    this->Do(i, own);
  }
}

void TaskRun::Work()
{
  const auto goOn = [this](double) { return !this->IsStopped; };
  for (std::size_t i = this->Next++; i < this->Count && !this->IsStopped; i = this->Next++)
  {
    std::exception_ptr failure;
    try
    {
      this->Do(i, goOn);
    }
    catch (...)
    {
      failure = std::current_exception();
      this->Stop();
    }
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Failure = this->Failure ? this->Failure : failure;
    ++this->Done;
    this->Changed.notify_one();
  }
}

void TaskRun::Watch(const ProgressCallback& progress)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (!this->IsStopped && this->Done < this->Count)
  {
    this->Changed.wait_for(lock, Beat);
    const std::size_t done = this->Done;
    lock.unlock();
    Report(progress, static_cast<double>(done) / static_cast<double>(this->Count));
    lock.lock();
  }
}

void TaskRun::On(std::size_t threads, const ProgressCallback& progress)
{
  std::vector<std::thread> running;
  std::exception_ptr stopped;
  try
  {
    for (std::size_t i = 0; i < threads; ++i)
    {
      running.emplace_back([this] { this->Work(); });
    }
    this->Watch(progress);
  }
  catch (...)
  {
    stopped = std::current_exception();
    this->Stop();
  }
  std::for_each(running.begin(), running.end(), [](std::thread& thread) { thread.join(); });
  if (stopped || this->Failure)
  {
    std::rethrow_exception(stopped ? stopped : this->Failure);
  }
}

}

void DrawFeatures(ChokingLoops& loops, const std::vector<std::size_t>& features, int rounds,
  DrawnFeatures& drawn, const ProgressCallback& progress, MembraneMethod method)
{
  Report(progress, 0.0); // even if nothing is missing: an abort may have been requested already
  std::vector<std::size_t> missing;
  std::copy_if(features.begin(), features.end(), std::back_inserter(missing),
    [&](std::size_t feature) {
      return drawn.count({ feature, rounds }) == 0;
    });
  std::vector<std::optional<LoopFeature>> made(missing.size());
  const auto keep = [&]
  {
    for (std::size_t i = 0; i < made.size(); ++i)
    {
      if (made[i])
      {
        drawn.emplace(std::make_pair(missing[i], rounds), std::move(*made[i]));
      }
    }
  };
  TaskRun run(missing.size(),
    [&](std::size_t i, const ProgressCallback& part)
    { made[i] = MakeLoopFeature(loops, missing[i], rounds, part, {}, method); });
  const std::size_t threads =
    std::min(missing.size(), static_cast<std::size_t>(std::max(1, ParallelThreads())));
  try
  {
    threads < 2 ? run.Alone(progress) : run.On(threads, progress);
  }
  catch (const Cancelled&)
  {
    keep(); // finished features need not be drawn again
    throw;
  }
  keep();
}

}
