// Radii and lengths of choking loops on surfaces whose narrow places are known by formula.

#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr int UntilGeodesic = 1000;

/// Relative error of radius and of length after shortening.
struct Errors
{
  double Distance;
  double Length;
};

Errors RecordErrors(ChokingLoops& loops, std::size_t feature, double radius)
{
  const LoopFeature shown = MakeLoopFeature(loops, feature, UntilGeodesic);
  EXPECT_EQ(shown.Lengths.size(), 1U);
  EXPECT_TRUE(loops.Diagram().Features[feature].Trusted);
  return { std::abs(loops.Diagram().Features[feature].Radius() / radius - 1.0),
    std::abs(shown.Lengths[0] / (2.0 * M_PI * radius) - 1.0) };
}

/// The hyperboloid r^2 = a^2 + z^2 for |z| < 1, closed by a half ellipsoid at either end.
double HyperboloidRadius(double z, double neck)
{
  const double end = std::min(std::abs(z), 1.0);
  const double u = std::max(0.0, std::abs(z) - 1.0);
  return std::sqrt(neck * neck + end * end) * std::sqrt(std::max(0.0, 1.0 - u * u));
}

Errors HyperboloidErrors(int around)
{
  const double neck = 0.4;
  // An odd number of bands: no ring of points lies on the narrowest circle itself.
  ChokingLoops loops(Revolution(
    [neck](double z) { return HyperboloidRadius(z, neck); }, -2.0, 2.0, around, 2 * around + 1));
  FeatureSelection selection;
  selection.MinimumPersistence = 10.0;
  const std::vector<std::size_t> chosen = loops.Select(selection);
  EXPECT_EQ(chosen.size(), 1U);
  return chosen.empty() ? Errors{ HUGE_VAL, HUGE_VAL } : RecordErrors(loops, chosen[0], neck);
}

TEST(ChokingGeometry, NeckOfAHyperboloid)
{
  const Errors coarse = HyperboloidErrors(20);
  const Errors usual = HyperboloidErrors(40);
  const Errors fine = HyperboloidErrors(80);
  EXPECT_LT(usual.Distance, 0.01);
  EXPECT_LT(usual.Length, 0.01);
  EXPECT_LT(usual.Distance, coarse.Distance);
  EXPECT_LT(fine.Distance, usual.Distance);
  EXPECT_LT(usual.Length, coarse.Length);
  EXPECT_LT(fine.Length, usual.Length);
  std::cout << "hyperboloid, 20, 40, 80 round: distance " << coarse.Distance << ", "
            << usual.Distance << ", " << fine.Distance << "; length " << coarse.Length << ", "
            << usual.Length << ", " << fine.Length << "\n";
}

// A ball of the tube's radius passes the tube; a ball of the inner equator's radius passes the
// hole.
TEST(ChokingGeometry, TubeAndHoleOfATorus)
{
  ChokingLoops loops(Torus(1.0, 0.3, 120, 40));
  int found = 0;
  for (std::size_t i = 0; i < loops.Diagram().Features.size(); ++i)
  {
    const FeatureKind kind = loops.Diagram().Features[i].Kind;
    if (kind == FeatureKind::Handle || kind == FeatureKind::Tunnel)
    {
      const Errors errors = RecordErrors(loops, i, kind == FeatureKind::Handle ? 0.3 : 0.7);
      EXPECT_LT(errors.Distance, 0.01);
      EXPECT_LT(errors.Length, 0.01);
      std::cout << "torus: distance " << errors.Distance << ", length " << errors.Length << "\n";
      ++found;
    }
  }
  EXPECT_EQ(found, 2);
}

/// Edges of the truncated icosahedron, all 2 long.
std::vector<std::array<Point3, 2>> BuckyballEdges()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  std::vector<Point3> corners;
  for (const Point3& p :
    { Point3{ 0, 1, 3 * g }, Point3{ 1, 2 + g, 2 * g }, Point3{ g, 2, 2 * g + 1 } })
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      for (std::size_t turn = 0; turn < 3; ++turn)
      {
        Point3 q;
        for (std::size_t a = 0; a < 3; ++a)
        {
          q[(a + turn) % 3] = signs >> a & 1 ? -p[a] : p[a];
        }
        corners.push_back(q);
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end(),
                  [](const Point3& a, const Point3& b) { return Dot(a - b, a - b) < 1e-12; }),
    corners.end());
  std::vector<std::array<Point3, 2>> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (std::size_t j = i + 1; j < corners.size(); ++j)
    {
      const Point3 d = corners[j] - corners[i];
      if (std::abs(Dot(d, d) - 4.0) < 1e-9)
      {
        edges.push_back({ corners[i], corners[j] });
      }
    }
  }
  return edges;
}

// Ninety round struts of one radius, 40 samples round each, between wider balls: 31 handles and 59
// additional loops.
TEST(ChokingGeometry, StrutsOfABuckyball)
{
  const double radius = 0.5;
  const auto edges = BuckyballEdges();
  ASSERT_EQ(edges.size(), 90U);
  const double ball = 0.7;
  const auto level = [&](double x, double y, double z)
  {
    const Point3 p{ x, y, z };
    double strut = HUGE_VAL;
    double end = HUGE_VAL;
    for (const auto& [a, b] : edges)
    {
      const double u = std::clamp(0.25 * Dot(p - a, b - a), 0.0, 1.0);
      const Point3 d = p - a - u * (b - a);
      strut = std::min(strut, Dot(d, d));
      end = std::min({ end, Dot(p - a, p - a), Dot(p - b, p - b) });
    }
    return std::min(std::sqrt(strut) - radius, std::sqrt(end) - ball);
  };
  const double size = 3.0 * 0.5 * (1.0 + std::sqrt(5.0)) + 1.0;
  const double samples = 40.0;
  const int cells = static_cast<int>(std::ceil(2.0 * size / (2.0 * M_PI * radius / samples)));
  ChokingLoops loops(LevelSet(level, size, cells));
  FeatureSelection selection;
  selection.Side = SideSelection::Inside;
  const std::vector<std::size_t> chosen = loops.Select(selection);
  const std::array<int, 4> counts = CountFeatures(loops, selection);
  EXPECT_EQ(counts[0], 31);
  EXPECT_EQ(counts[2], 59);
  double worstDistance = 0.0;
  double worstLength = 0.0;
  for (const std::size_t i : chosen)
  {
    const Errors errors = RecordErrors(loops, i, radius);
    worstDistance = std::max(worstDistance, errors.Distance);
    worstLength = std::max(worstLength, errors.Length);
  }
  EXPECT_LT(worstDistance, 0.01);
  EXPECT_LT(worstLength, 0.01);
  std::cout << "buckyball: worst distance " << worstDistance << ", worst length " << worstLength
            << "\n";
}

}
