#include "ChokingLoops/ChokingSamples.h"

#include "Core/Index.h"
#include "Core/RangeGuard.h"
#include "Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Samples that automatic spacing spreads over a surface, however few points it has.
constexpr double UsualSamples = 20000.0;

/// More would take some 30 GB.
constexpr std::size_t MostSamples = 20'000'000;

/// Of the spacing: what three rounds that are finer by 0.6 would still tell, and half of it.
constexpr double Telling = 0.1;

/// Points that refinement may add, beside doubling what there are.
constexpr std::size_t MorePoints = 100000;

/// Twice the volume by the area of a closed surface: how thick a plate is, how wide half a rod.
double ThicknessOf(const SurfaceView& surface)
{
  return 2.0 * std::abs(SignedVolume(surface)) / SurfaceArea(surface);
}

/// Sum of the lengths of all edges of a closed surface.
double LengthOfEdges(const SurfaceView& surface)
{
  double edges = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      edges += 0.5 * Distance(surface.Points[At(t[c])], surface.Points[At(t[(c + 1) % 3])]);
    }
  }
  return edges;
}

}

TriangleMesh Refined(const SurfaceView& mesh, const std::vector<Refinement>& wanted, double spacing,
  double finest, const ProgressCallback& progress)
{
  const bool isMany = wanted.size() > ManyPlaces;
  const auto settled = static_cast<std::size_t>(std::count_if(wanted.begin(), wanted.end(),
    [finest](const Refinement& r) { return r.EdgeLength >= finest; }));
  if (isMany && 2 * settled < wanted.size())
  {
    return {};
  }
  const double everywhere = isMany ? 0.6 * spacing : HUGE_VAL;
  return SplitLongEdges(
    CopyOf(mesh),
    [&wanted, everywhere](const Point3& a, const Point3& b)
    {
      double limit = everywhere;
      if (std::isfinite(everywhere))
      {
        return limit;
      }
      const Point3 middle = 0.5 * (a + b);
      const double half2 = 0.25 * Dot(b - a, b - a);
      for (const Refinement& r : wanted)
      {
        const Point3 d = middle - r.Centre;
        const double reach = r.Radius + std::sqrt(half2);
        limit = Dot(d, d) < reach * reach ? std::min(limit, r.EdgeLength) : limit;
      }
      return limit;
    },
    MorePoints + 2 * mesh.Points.size(), progress);
}

TriangleMesh FirstSamples(
  const SurfaceView& surface, double& spacing, const ProgressCallback& progress)
{
  const auto split = [&surface, &spacing](std::size_t most, const ProgressCallback& part)
  {
    return SplitLongEdges(
      CopyOf(surface), [&spacing](const Point3&, const Point3&) { return spacing; }, most, part);
  };
  const double edges = LengthOfEdges(surface);
  DemandRange("SampleSpacing", spacing, 0.0, LargestLength, "It is a length; 0 chooses one.");
  if (spacing > 0.0 && edges / spacing > 2.0 * static_cast<double>(MostSamples))
  {
    throw std::invalid_argument("A SampleSpacing of " + Shown(spacing) + " takes some " +
      Shown(edges / spacing) + " points along the edges alone, and the most is " +
      Shown(static_cast<double>(MostSamples)) + ": raise it.");
  }
  // Triangles with edges of that length, equilateral ones at the most, and half as many points.
  const double fewest =
    spacing > 0.0 ? SurfaceArea(surface) / (0.5 * std::sqrt(3.0) * spacing * spacing) : 0.0;
  if (fewest > static_cast<double>(MostSamples))
  {
    throw std::invalid_argument("A SampleSpacing of " + Shown(spacing) + " takes " + Shown(fewest) +
      " points at least, and the most is " + Shown(static_cast<double>(MostSamples)) +
      ": raise it.");
  }
  if (spacing > 0.0)
  {
    TriangleMesh samples = split(MostSamples, progress);
    if (samples.Points.empty())
    {
      throw std::runtime_error("Sampling the surface so finely takes more than " +
        std::to_string(MostSamples) + " points: raise the sample spacing.");
    }
    return samples;
  }
  // Edges of a good mesh scatter round their mean: those up to 1.7 times it stay whole.
  spacing = 1.7 * EdgeLengthFor(surface, UsualSamples);
  // Needles take far more points than their area suggests.
  // Where all is thinner than refined samples could tell, they would be for nothing.
  const double share = ThicknessOf(surface) < Telling * spacing ? 1.0 : 5.0;
  const std::size_t most =
    4 * surface.Points.size() + static_cast<std::size_t>(share * UsualSamples);
  // Edges are split to it, whatever the area: needles have next to none.
  spacing = std::max(spacing, edges / (4.0 * static_cast<double>(most)));
  const auto still = Between(progress, 0.0, 0.0); // quick, but may have to be repeated
  TriangleMesh samples = split(most, still);
  for (; samples.Points.empty(); samples = split(most, still))
  {
    spacing *= 1.5;
  }
  return samples;
}

}
