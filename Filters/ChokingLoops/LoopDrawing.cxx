#include "ChokingLoops/LoopDrawing.h"

#include "ChokingLoops/CornerCutting.h"
#include "ChokingLoops/PinnedShortening.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// Triangles between two closed curves, advancing on whichever has the shorter diagonal.
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

std::vector<SimplexId> PinsOn(
  const std::vector<SimplexId>& loop, const std::vector<SimplexId>& pins)
{
  std::vector<SimplexId> on;
  std::copy_if(pins.begin(), pins.end(), std::back_inserter(on),
    [&loop](SimplexId p) { return std::find(loop.begin(), loop.end(), p) != loop.end(); });
  return on;
}

/// Puts a tight curve in the place of a loop and lets the membrane follow.
void Follow(const SurfaceAdjacency& surface, const SurfaceCurve& tight, double cut,
  std::vector<SimplexId>& loop, LoopFeature& feature)
{
  const SurfaceCurve curve = CutCorners(surface, tight, SharpestKept, cut);
  const std::vector<SimplexId> shortened = AddCurve(surface, curve, feature);
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

std::vector<SurfaceCurve> TightLoops(const SurfaceAdjacency& surface, const Membrane& membrane,
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
  for (std::size_t i = 0; i < membrane.Loops.size(); ++i)
  {
    std::vector<SimplexId> loop = membrane.Loops[i];
    const bool holds = tight.empty() || !tight[i].Contractible;
    if (!holds && i > 0)
    {
      AddFan(loop, feature.Membrane); // beside others, a border that M itself closes is none
      continue;
    }
    if (holds && !tight.empty())
    {
      Follow(surface, tight[i], cut, loop, feature);
    }
    feature.Collapsed = feature.Collapsed || !holds;
    feature.Loops.push_back(std::move(loop));
    feature.Anchors.push_back(membrane.Loops[i].front());
  }
  Measure(surface.Mesh(), feature);
  return feature;
}

}
