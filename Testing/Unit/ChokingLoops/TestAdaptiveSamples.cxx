// Fine surfaces analysed on few of their points (Accuracy): the same features as with all points,
// radii as the analytic ones, loops on the surface itself.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "ChokingSurfaces.h"
#include "Core/Index.h"
#include "Surfaces/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Every point of the surface is a sample.
ChokingLoops AnalyseAll(const TriangleMesh& surface)
{
  ChokingLoopParameters parameters;
  for (const Triangle& t : surface.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      parameters.SampleSpacing = std::max(parameters.SampleSpacing,
        Distance(surface.Points[At(t[k])], surface.Points[At(t[(k + 1) % 3])]));
    }
  }
  return ChokingLoops(surface, parameters);
}

/// Radii of the selected features of a kind, ascending, with their uncertainties.
std::vector<std::pair<double, double>> Radii(
  const ChokingLoops& loops, FeatureKind kind, SpaceSide side)
{
  std::vector<std::pair<double, double>> radii;
  for (const std::size_t i : loops.Select({}))
  {
    const ShapeFeature& f = loops.Diagram().Features[i];
    if (f.Kind == kind && f.Side == side)
    {
      EXPECT_TRUE(f.Trusted);
      radii.emplace_back(f.Radius(), ComputeUncertainty(f));
    }
  }
  return radii;
}

/// The largest distance of the points of all loops from `surface`.
double DistanceOfLoops(ChokingLoops& loops, const TriangleMesh& surface)
{
  const TriangleTree tree(surface);
  double farthest = 0.0;
  for (const std::size_t i : loops.Select({}))
  {
    const LoopFeature feature = MakeLoopFeature(loops, i, 1000);
    EXPECT_FALSE(feature.Loops.empty());
    for (const auto& loop : feature.Loops)
    {
      for (const SimplexId p : loop)
      {
        farthest =
          std::max(farthest, std::sqrt(tree.Find(feature.Point(p, loops.Samples()), -1).Squared));
      }
    }
  }
  return farthest;
}

}

TEST(AdaptiveSamples, RadiusOfANeckIsTheAnalyticOne)
{
  for (const double neck : { 0.08, 0.3 })
  {
    const TriangleMesh surface =
      Revolution([neck](double z) { return DumbbellRadius(z, neck); }, -2.0, 2.0, 160, 500);
    ChokingLoops loops{ TriangleMesh(surface) };
    ASSERT_TRUE(loops.Fine());
    EXPECT_LT(loops.Samples().Points.size(), surface.Points.size() / 2);
    const auto radii = Radii(loops, FeatureKind::Additional, SpaceSide::Inside);
    ASSERT_EQ(radii.size(), 1U);
    // The radius of the polygon of the neck is cos(pi / 160) of that of the circle.
    EXPECT_NEAR(radii[0].first, neck, 0.005 * neck);
    EXPECT_LE(radii[0].first - radii[0].second, neck);
    EXPECT_LT(DistanceOfLoops(loops, surface), 1e-9);
    const LoopFeature drawn = MakeLoopFeature(loops, loops.Select({})[0], 1000);
    EXPECT_NEAR(drawn.LongestLength(), 2.0 * M_PI * neck, 0.02 * neck);
  }
}

TEST(AdaptiveSamples, RingHasItsHandleAndTunnel)
{
  const TriangleMesh surface = Torus(3.0, 1.0, 600, 200);
  ChokingLoops loops{ TriangleMesh(surface) };
  EXPECT_LT(loops.Samples().Points.size(), surface.Points.size() / 4);
  const auto handles = Radii(loops, FeatureKind::Handle, SpaceSide::Inside);
  const auto tunnels = Radii(loops, FeatureKind::Tunnel, SpaceSide::Outside);
  ASSERT_EQ(handles.size(), 1U);
  ASSERT_EQ(tunnels.size(), 1U);
  EXPECT_NEAR(handles[0].first, 1.0, 0.005);
  EXPECT_NEAR(tunnels[0].first, 2.0, 0.01);
  EXPECT_LT(DistanceOfLoops(loops, surface), 1e-9);
}

// The thinnest part of a ring is far below the spacing of the samples where it is thick.
TEST(AdaptiveSamples, ThinHandleOfAThickRingIsTrusted)
{
  constexpr double thin = 0.03;
  TriangleMesh surface = Torus(3.0, 1.0, 600, 200);
  for (Point3& p : surface.Points)
  {
    const double away = std::hypot(p[0], p[1]);
    const Point3 center{ 3.0 * p[0] / away, 3.0 * p[1] / away, 0.0 };
    const double radius = 0.5 * ((1.0 + thin) - (1.0 - thin) * p[0] / away);
    p = center + radius * (p - center);
  }
  const ChokingLoops loops{ TriangleMesh(surface) };
  ASSERT_TRUE(loops.Fine());
  const std::vector<double> errors = SamplingErrors(loops.Samples());
  EXPECT_GT(*std::max_element(errors.begin(), errors.end()), 1.5 * thin);
  const auto handles = Radii(loops, FeatureKind::Handle, SpaceSide::Inside);
  ASSERT_EQ(handles.size(), 1U);
  EXPECT_NEAR(handles[0].first, thin, 0.01 * thin);
  EXPECT_EQ(Radii(loops, FeatureKind::Tunnel, SpaceSide::Outside).size(), 1U);
}

TEST(AdaptiveSamples, SameFeaturesAsWithAllPoints)
{
  const TriangleMesh surface = TangleCube(120);
  ASSERT_GT(surface.Points.size(), MostUsualSamples);
  const ChokingLoops all = AnalyseAll(surface);
  const ChokingLoops few{ TriangleMesh(surface) };
  EXPECT_FALSE(all.Fine());
  ASSERT_TRUE(few.Fine());
  EXPECT_LT(few.Samples().Points.size(), surface.Points.size() / 2);
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    for (const FeatureKind kind :
      { FeatureKind::Handle, FeatureKind::Tunnel, FeatureKind::Additional })
    {
      const auto expected = Radii(all, kind, side);
      const auto found = Radii(few, kind, side);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i].first, expected[i].first, 0.01 * expected[i].first);
      }
    }
  }
}

TEST(AdaptiveSamples, FeaturesAscendByRadius)
{
  const ChokingLoops loops{ TriangleMesh(TangleCube(120)) };
  const std::vector<ShapeFeature>& features = loops.Diagram().Features;
  EXPECT_TRUE(std::is_sorted(features.begin(), features.end(),
    [](const ShapeFeature& a, const ShapeFeature& b) { return a.Radius() < b.Radius(); }));
}
