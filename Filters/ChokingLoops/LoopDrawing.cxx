#include "LoopDrawing.h"

#include "CornerCutting.h"
#include "PinnedShortening.h"

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

/// Shortens one loop of a feature and lets its membrane follow; false: it can be drawn together on
/// M.
bool Tighten(const SurfaceAdjacency& surface, const LoopDrawing& drawing,
  std::vector<SimplexId>& loop, LoopFeature& feature, const ProgressCallback& progress)
{
  LoopShorteningParameters parameters;
  parameters.MaximumRounds = drawing.Rounds;
  const std::vector<SimplexId> held = PinsOn(loop, drawing.Pins);
  SurfaceCurve curve = held.empty() ? ShortenLoop(surface, loop, parameters, progress)
                                    : ShortenPinned(surface, loop, held, parameters, progress);
  curve = CutCorners(surface, std::move(curve), SharpestKept, drawing.Cut);
  if (!curve.Contractible)
  {
    const std::vector<SimplexId> shortened = AddCurve(surface, curve, feature);
    Zipper(feature, surface.Mesh()).Close(loop, shortened);
    loop = shortened;
    feature.Converged = feature.Converged && curve.Converged;
    feature.SharpestBend = std::max(feature.SharpestBend, curve.SharpestBend);
  }
  return !curve.Contractible;
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

LoopFeature Drawn(const SurfaceAdjacency& surface, const Membrane& membrane,
  const LoopDrawing& drawing, const ProgressCallback& progress)
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
    const bool holds = drawing.Rounds == 0 || Tighten(surface, drawing, loop, feature, part);
    if (!holds && i > 0)
    {
      AddFan(loop, feature.Membrane); // beside others, a border that M itself closes is none
      continue;
    }
    feature.Collapsed = feature.Collapsed || !holds;
    feature.Loops.push_back(std::move(loop));
    feature.Anchors.push_back(membrane.Loops[i].front());
  }
  Measure(surface.Mesh(), feature);
  return feature;
}

}
