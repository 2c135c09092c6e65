#include "ChokingLoops/SharedLoops.h"

#include "ChokingLoops/ChokeFit.h"
#include "Core/Bounds3.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr double SimilarLength = 0.02; ///< relative
constexpr double SamePlace = 0.1;      ///< in radii
constexpr double NearMembrane = 0.3;   ///< in radii

using Polygon = std::vector<Point3>;

/// A feature's loops as polygons, and what quickly tells two of them apart.
struct Outline
{
  SpaceSide Side;
  double Radius;
  double Length;
  Bounds3 Box;
  std::vector<Polygon> Loops;
};

Outline OutlineOf(const ChokingLoops& loops, const ShownFeature& shown)
{
  const ShapeFeature& f = loops.Diagram().Features[shown.Index];
  const LoopFeature& geometry = *shown.Geometry;
  Outline outline{ f.Side, f.Distance(),
    std::accumulate(geometry.Lengths.begin(), geometry.Lengths.end(), 0.0), {}, {} };
  for (const auto& loop : geometry.Loops)
  {
    outline.Loops.emplace_back();
    for (const SimplexId p : loop)
    {
      const Point3& place = geometry.Point(p, loops.Samples());
      outline.Loops.back().push_back(place);
      outline.Box.Min = outline.Box.Max = place;
    }
  }
  for (const Polygon& polygon : outline.Loops)
  {
    std::for_each(
      polygon.begin(), polygon.end(), [&](const Point3& place) { outline.Box.Add(place); });
  }
  return outline;
}

/// True when each point of `a` is within `reach` of some loop of `b`.
bool LiesAlong(const Outline& a, const Outline& b, double reach)
{
  const auto isNear = [&](const Point3& p)
  {
    return std::any_of(b.Loops.begin(), b.Loops.end(),
      [&](const Polygon& loop)
      {
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
          if (SquaredDistanceToSegment(p, loop[i], loop[(i + 1) % loop.size()]) <= reach * reach)
          {
            return true;
          }
        }
        return false;
      });
  };
  return std::all_of(a.Loops.begin(), a.Loops.end(),
    [&](const Polygon& loop) { return std::all_of(loop.begin(), loop.end(), isNear); });
}

bool Coincide(const Outline& a, const Outline& b)
{
  const double reach = SamePlace * std::min(a.Radius, b.Radius);
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (std::abs(a.Box.Min[k] - b.Box.Min[k]) > reach ||
      std::abs(a.Box.Max[k] - b.Box.Max[k]) > reach)
    {
      return false;
    }
  }
  return a.Side == b.Side && a.Loops.size() == b.Loops.size() &&
    std::abs(a.Length - b.Length) <= SimilarLength * std::max(a.Length, b.Length) &&
    LiesAlong(a, b, reach) && LiesAlong(b, a, reach);
}

/// True when some triangle of the membrane is that near.
bool PassesNear(
  const ChokingLoops& loops, const LoopFeature& geometry, const Point3& centre, double reach)
{
  return std::any_of(geometry.Membrane.begin(), geometry.Membrane.end(),
    [&](const auto& t)
    {
      std::vector<Point3> corners;
      corners.reserve(t.size());
      for (const SimplexId p : t)
      {
        corners.push_back(geometry.Point(p, loops.Samples()));
      }
      return IsSurrounded(centre, reach, corners);
    });
}

double Longest(const LoopFeature& geometry)
{
  return geometry.Lengths.empty()
    ? 0.0
    : *std::max_element(geometry.Lengths.begin(), geometry.Lengths.end());
}

/// What a feature that holds no loop of its own can share, or null. One with an encircling loop
/// shares only what is before it and no longer.
const ShownFeature* LoopsFor(const ChokingLoops& loops, const std::vector<ShownFeature>& features,
  const std::vector<char>& isFree, const ShownFeature& needy)
{
  const bool isEncircled = !needy.Geometry->Held && !needy.Geometry->Collapsed;
  const auto end =
    isEncircled ? static_cast<std::size_t>(&needy - features.data()) : features.size();
  const double longest = isEncircled ? (1.0 + SimilarLength) * Longest(*needy.Geometry) : HUGE_VAL;
  const auto& all = loops.Diagram().Features;
  const ShapeFeature& f = all[needy.Index];
  const Point3 centre = loops.ChokePoint(needy.Index);
  const ShownFeature* best = nullptr;
  for (std::size_t i = 0; i < end; ++i)
  {
    const LoopFeature& other = *features[i].Geometry;
    if (!isFree[i] && features[i].SharedWith < 0 && Longest(other) <= longest &&
      all[features[i].Index].Side == f.Side &&
      (!best || Longest(other) < Longest(*best->Geometry)) && Belongs(loops, needy.Index, other) &&
      PassesNear(loops, other, centre, NearMembrane * f.Distance()))
    {
      best = &features[i];
    }
  }
  return best;
}

}

void FindShared(const ChokingLoops& loops, std::vector<ShownFeature>& features)
{
  std::vector<char> isFree; // nothing holds its own loop
  isFree.reserve(features.size());
  for (const ShownFeature& shown : features)
  {
    isFree.push_back(shown.Geometry->Held || shown.Geometry->Collapsed);
  }
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    const ShownFeature* other = isFree[i] || features[i].Geometry->Encircling
      ? LoopsFor(loops, features, isFree, features[i])
      : nullptr;
    if (other)
    {
      features[i].SharedWith = static_cast<std::ptrdiff_t>(other->Index);
      features[i].Geometry = other->Geometry;
    }
  }
  std::vector<Outline> outlines;
  for (ShownFeature& shown : features)
  {
    outlines.push_back(OutlineOf(loops, shown));
    for (std::size_t i = 0; i + 1 < outlines.size() && !outlines.back().Loops.empty(); ++i)
    {
      if (shown.SharedWith < 0 && features[i].SharedWith < 0 &&
        Coincide(outlines[i], outlines.back()))
      {
        shown.SharedWith = static_cast<std::ptrdiff_t>(features[i].Index);
        shown.Geometry = features[i].Geometry;
      }
    }
  }
}

}
