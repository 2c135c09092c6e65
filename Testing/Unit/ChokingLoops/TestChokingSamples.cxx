// The sampling density of a surface and its local refinement, by the lengths of the edges; regions
// that a uniformly finer sampling does not resolve are not refined again; the memory of the
// analysis.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "ChokingSurfaces.h"
#include "PeakMemory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The longest edge whose midpoint is within the given distance of `center`.
double LongestEdge(const TriangleMesh& mesh, const Point3& center = {}, double reach = HUGE_VAL)
{
  double longest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Point3& a = mesh.Points[static_cast<std::size_t>(t[k])];
      const Point3& b = mesh.Points[static_cast<std::size_t>(t[(k + 1) % 3])];
      const bool isNear = Distance(0.5 * (a + b), center) <= reach;
      longest = std::max(longest, isNear ? Distance(a, b) : 0.0);
    }
  }
  return longest;
}

/// The given number of places around a torus that require edges of `length`.
std::vector<Refinement> Places(std::size_t count, double length)
{
  std::vector<Refinement> places;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    places.push_back({ { std::cos(angle), std::sin(angle), 0.0 }, 0.01, length });
  }
  return places;
}

TriangleMesh SampledTorus(double spacing)
{
  return FirstSamples(Torus(1.0, 0.3, 60, 30), spacing);
}

/// The largest distance from a point of the triangle to its nearest corner, on a lattice.
double FarthestFromCorners(const Point3& a, const Point3& b, const Point3& c)
{
  constexpr int steps = 300;
  double farthest = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; j <= steps - i; ++j)
    {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      const Point3 p = a + u * (b - a) + v * (c - a);
      const double nearest = std::min({ Distance(p, a), Distance(p, b), Distance(p, c) });
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

TEST(ChokingSamples, ErrorsAreTheDistancesFromCornersInAnyUnit)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto point = [&](double size)
  {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return size * Point3{ x, y, z };
  };
  for (int trial = 0; trial < 200; ++trial)
  {
    const double size = std::pow(10.0, 2.0 * coordinate(random));
    TriangleMesh mesh;
    mesh.Points = { point(size), point(size), point(size) };
    mesh.Triangles = { { 0, 1, 2 } };
    const double exact = FarthestFromCorners(mesh.Points[0], mesh.Points[1], mesh.Points[2]);
    for (const double error : SamplingErrors(SurfaceView(mesh.Points, mesh.Triangles)))
    {
      EXPECT_NEAR(error / size, exact / size, 0.01) << trial; // a step of the lattice
    }
  }
}

TEST(ChokingSamples, FewPlacesAreRefinedLocally)
{
  const TriangleMesh samples = SampledTorus(0.08);
  const Point3 place = samples.Points.front();
  const TriangleMesh refined = Refined(samples, { { place, 0.2, 0.02 } }, 0.08, 0.0173);
  EXPECT_LE(LongestEdge(refined, place, 0.2), 0.02);
  EXPECT_LE(LongestEdge(samples), 0.08);
  // Far from there nothing was split.
  const Point3 opposite{ -place[0], -place[1], -place[2] };
  EXPECT_EQ(LongestEdge(refined, opposite, 0.5), LongestEdge(samples, opposite, 0.5));
  EXPECT_LT(refined.Points.size(), 2 * samples.Points.size());
}

TEST(ChokingSamples, ManyPlacesRefineEverywhere)
{
  const TriangleMesh samples = SampledTorus(0.08);
  const double finest = 0.216 * 0.08;
  const TriangleMesh refined = Refined(samples, Places(ManyPlaces + 1, 0.02), 0.08, finest);
  EXPECT_LE(LongestEdge(refined), 0.6 * 0.08);
  EXPECT_GT(LongestEdge(refined), 0.02);
}

TEST(ChokingSamples, ManyUnresolvedPlacesAreLeft)
{
  const TriangleMesh samples = SampledTorus(0.08);
  const double finest = 0.216 * 0.08;
  std::vector<Refinement> places = Places(ManyPlaces + 2, 0.5 * finest);
  EXPECT_TRUE(Refined(samples, places, 0.08, finest).Points.empty());
  // If half of them can be refined, refinement is tried; with one fewer it is not.
  for (std::size_t i = 0; i < places.size() / 2; ++i)
  {
    places[i].EdgeLength = 1.01 * finest;
  }
  EXPECT_FALSE(Refined(samples, places, 0.08, finest).Points.empty());
  places.front().EdgeLength = 0.5 * finest;
  EXPECT_TRUE(Refined(samples, places, 0.08, finest).Points.empty());
  // A few places are refined nevertheless.
  places.resize(1);
  EXPECT_FALSE(Refined(samples, places, 0.08, finest).Points.empty());
}

TEST(ChokingSamples, ThinRodsStartWithFewSamples)
{
  // Far thinner than the spacing, and a hundred times as thick: needles take up to 100,000
  // points.
  const auto rod = [](double radius)
  {
    return Revolution(
      [radius](double z) { return radius * std::sqrt(1.0 - 0.99 * z * z); }, -1.0, 1.0, 24, 200);
  };
  double spacing = 0.0;
  const TriangleMesh thin = FirstSamples(rod(1e-7), spacing);
  const std::size_t own = rod(1e-7).Points.size();
  EXPECT_LE(thin.Points.size(), 4 * own + 20000);
  EXPECT_GT(spacing, 0.0);
}

/// A cube of noise, `n` cells along a side, the outer ones empty.
TriangleMesh Noise(int n)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  return LevelSet(
    [&](double x, double y, double z)
    {
      const double value = normal(random);
      return std::max({ std::abs(x), std::abs(y), std::abs(z) }) > 0.9 ? 1.0 : value;
    },
    1.0, n);
}

/// The number of samples before and after all rounds of refinement.
std::pair<std::size_t, std::size_t> SamplesOfRounds(const TriangleMesh& surface)
{
  double spacing = 0.0;
  const std::size_t first = FirstSamples(CheckedSurface(surface, false), spacing).Points.size();
  return { first, ChokingLoops(surface).Samples().Points.size() };
}

TEST(ChokingSamples, NoiseIsRefinedEverywhereAtOnce)
{
  const auto [first, last] = SamplesOfRounds(Noise(14));
  EXPECT_GT(last, 2 * first) << "edges of 0.6: 1 / 0.36 times as many";
  EXPECT_LT(last, 4 * first);
}

TEST(ChokingSamples, StopsAfterARoundThatResolvesLessThanHalf)
{
  const auto [first, last] = SamplesOfRounds(Noise(10));
  EXPECT_GT(last, first);
  EXPECT_LT(2 * last, 3 * first) << "finer in places, once";
}

// A limit of twice the peak allows the analysis, one of half the peak does not.
TEST(ChokingSamples, MemoryIsEstimatedWithinAFactorOfTwo)
{
  TriangleMesh mesh = Torus(1.0, 0.3, 600, 200); // the heap before it is small in comparison
  for (Point3& p : mesh.Points)
  {
    p = (1.0 + 0.05 * std::sin(5.0 * p[0] + 3.0 * p[1]) * std::cos(4.0 * p[1] - p[2])) * p;
  }
  ChokingLoopParameters parameters;
  parameters.SampleSpacing = LongestEdge(mesh); // all points are samples
  ResetPeakMemory();
  const double before = PeakMemory();
  if (before <= 0.0)
  {
    GTEST_SKIP() << "The kernel does not report the peak memory of a process.";
  }
  {
    const ChokingLoops loops(mesh, parameters);
    EXPECT_EQ(loops.Samples().Points.size(), mesh.Points.size());
  }
  const double peak = (PeakMemory() - before) / (1024.0 * 1024.0);
  parameters.MemoryLimit = static_cast<int>(2.0 * peak);
  EXPECT_NO_THROW(ChokingLoops(mesh, parameters));
  parameters.MemoryLimit = static_cast<int>(0.5 * peak);
  EXPECT_THROW(ChokingLoops(mesh, parameters), std::exception);
}

}
