#include "LoopFeature.h"

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

}

LoopFeature MakeLoopFeature(
  ChokingLoops& loops, std::size_t index, int rounds, const ProgressCallback& progress)
{
  const Membrane& membrane = loops.MembraneOf(index);
  const TriangleMesh& samples = loops.Samples();
  LoopFeature feature;
  feature.Loops = membrane.Loops;
  feature.Membrane = membrane.Triangles;
  feature.Extra = membrane.Extra;
  if (rounds > 0)
  {
    LoopShorteningParameters parameters;
    parameters.MaximumRounds = rounds;
    const auto count = static_cast<double>(feature.Loops.size());
    for (std::size_t i = 0; i < feature.Loops.size(); ++i)
    {
      auto& loop = feature.Loops[i];
      const auto part =
        Between(progress, static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
      const SurfaceCurve curve = ShortenLoop(loops.Adjacency(), loop, parameters, part);
      if (curve.Contractible)
      {
        continue;
      }
      const std::vector<SimplexId> shortened = AddCurve(loops.Adjacency(), curve, feature);
      Zipper(feature, samples).Close(loop, shortened);
      loop = shortened;
    }
  }
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
  return feature;
}

}
