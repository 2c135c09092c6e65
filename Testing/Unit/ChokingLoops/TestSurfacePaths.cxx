// Shortest paths along edges against a relaxation that has no queue, and against great circles.

#include "ChokingLoops/SurfacePaths.h"
#include "ChokingSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const Point3& At(const TriangleMesh& mesh, SimplexId p)
{
  return mesh.Points[static_cast<std::size_t>(p)];
}

/// A torus whose points were moved at random: no two paths have the same length.
TriangleMesh RoughTorus(int around, int across)
{
  TriangleMesh mesh = Torus(1.0, 0.3, around, across);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> shift(-0.01, 0.01);
  for (Point3& p : mesh.Points)
  {
    p = p + Point3{ shift(random), shift(random), shift(random) };
  }
  return mesh;
}

/// Lengths of the shortest paths along edges: all edges again and again until nothing gets shorter
/// (R. Bellman, L. R. Ford).
std::vector<double> RelaxedLengths(const TriangleMesh& mesh, SimplexId from)
{
  std::vector<double> lengths(mesh.Points.size(), HUGE_VAL);
  lengths[static_cast<std::size_t>(from)] = 0.0;
  for (bool isShorter = true; isShorter;)
  {
    isShorter = false;
    for (const Triangle& t : mesh.Triangles)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        const auto a = static_cast<std::size_t>(t[k]);
        const auto b = static_cast<std::size_t>(t[(k + 1) % 3]);
        const double there = lengths[a] + Distance(mesh.Points[a], mesh.Points[b]);
        isShorter = isShorter || there < lengths[b];
        lengths[b] = std::min(lengths[b], there);
      }
    }
  }
  return lengths;
}

TEST(SurfacePaths, AreTheShortestAlongEdges)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const SurfaceAdjacency surface(mesh);
  for (const SimplexId from : { 0, 123, 599 })
  {
    const SurfacePaths paths(surface, from, HUGE_VAL);
    const std::vector<double> lengths = RelaxedLengths(mesh, from);
    ASSERT_EQ(paths.Points().size(), mesh.Points.size());
    EXPECT_EQ(paths.Points().front(), from);
    EXPECT_FALSE(paths.Last(from).Exists());
    double before = 0.0;
    for (const SimplexId p : paths.Points())
    {
      EXPECT_NEAR(paths.Length(p), lengths[static_cast<std::size_t>(p)], 1e-12);
      EXPECT_GE(paths.Length(p), before) << "not by length";
      before = paths.Length(p);
    }
  }
}

TEST(SurfacePaths, RunAlongEdgesOfTheStatedLength)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const SurfaceAdjacency surface(mesh);
  const SurfacePaths paths(surface, 77, HUGE_VAL);
  for (const SimplexId end : paths.Points())
  {
    double length = 0.0;
    std::size_t steps = 0;
    SimplexId p = end;
    for (; paths.Last(p).Exists() && steps <= mesh.Points.size(); ++steps)
    {
      const HalfEdgeId h = paths.Last(p);
      ASSERT_EQ(surface.To(h), p);
      length += Distance(At(mesh, surface.From(h)), At(mesh, p));
      p = surface.From(h);
    }
    EXPECT_EQ(p, 77);
    EXPECT_NEAR(length, paths.Length(end), 1e-12);
  }
}

TEST(SurfacePaths, ReachTheRequestedDistance)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const SurfaceAdjacency surface(mesh);
  const std::vector<double> lengths = RelaxedLengths(mesh, 5);
  for (const double reach : { 0.0, 0.05, 0.4, 1.1 })
  {
    const SurfacePaths paths(surface, 5, reach);
    for (std::size_t p = 0; p < lengths.size(); ++p)
    {
      EXPECT_EQ(paths.Has(static_cast<SimplexId>(p)), lengths[p] <= reach) << p;
    }
  }
}

TEST(SurfacePaths, ExtendAsIfComputedAtOnce)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const SurfaceAdjacency surface(mesh);
  SurfacePaths grown(surface, 5, 0.0);
  for (const double reach : { 0.02, 0.3, 0.3, 0.1, 1.1 })
  {
    grown.Grow(reach);
  }
  const SurfacePaths paths(surface, 5, 1.1);
  EXPECT_EQ(grown.Points(), paths.Points());
  for (const SimplexId p : paths.Points())
  {
    EXPECT_EQ(grown.Length(p), paths.Length(p));
    EXPECT_EQ(grown.Last(p), paths.Last(p));
  }
}

TEST(SurfacePaths, EndAtTheRequestedPoint)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const SurfaceAdjacency surface(mesh);
  const std::vector<double> lengths = RelaxedLengths(mesh, 5);
  const SurfacePaths paths(surface, 5, HUGE_VAL, 300);
  EXPECT_EQ(paths.Points().back(), 300);
  EXPECT_NEAR(paths.Length(300), lengths[300], 1e-12);
  // All points within the bound of the straight line were visited, and no others.
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    const double least = lengths[p] + Distance(mesh.Points[p], mesh.Points[300]);
    EXPECT_EQ(paths.Has(static_cast<SimplexId>(p)), least <= lengths[300] * (1.0 + 1e-12)) << p;
  }
  EXPECT_LT(paths.Points().size(), SurfacePaths(surface, 5, lengths[300]).Points().size());
  EXPECT_FALSE(SurfacePaths(surface, 5, 0.5 * lengths[300], 300).Has(300));
  EXPECT_EQ(SurfacePaths(surface, 5, HUGE_VAL, 5).Points().size(), 1U);
}

// Edges of a ball are chords, and a path along them zigzags: at least the chord between
// its ends. Once a path has some edges, it is at most sqrt 2 times the great circle, as along two
// sides of a right angle: the legs of the triangles that a square is cut into.
TEST(SurfacePaths, OnABallLieBetweenChordAndDetour)
{
  const TriangleMesh ball =
    LevelSet([](double x, double y, double z) { return x * x + y * y + z * z - 1.0; }, 1.23, 30);
  const SurfaceAdjacency surface(ball);
  const SurfacePaths paths(surface, 0, HUGE_VAL);
  ASSERT_EQ(paths.Points().size(), ball.Points.size());
  for (const SimplexId p : paths.Points())
  {
    const double chord = Distance(At(ball, 0), At(ball, p));
    EXPECT_GE(paths.Length(p), chord - 1e-12);
    if (chord > 0.5)
    {
      EXPECT_LT(paths.Length(p), std::sqrt(2.0) * 2.0 * std::asin(std::min(1.0, 0.5 * chord)));
    }
  }
}

TEST(SurfacePaths, DoNotDependOnUnitOrNumbering)
{
  const TriangleMesh mesh = RoughTorus(40, 15);
  const std::size_t n = mesh.Points.size();
  TriangleMesh other; // eight times as large, numbered backwards, facing the other way
  for (std::size_t i = 0; i < n; ++i)
  {
    other.Points.push_back(8.0 * mesh.Points[n - 1 - i]);
  }
  const auto renamed = [n](std::int64_t p) { return static_cast<std::int64_t>(n) - 1 - p; };
  for (const Triangle& t : mesh.Triangles)
  {
    other.Triangles.push_back({ renamed(t[1]), renamed(t[0]), renamed(t[2]) });
  }
  const SurfaceAdjacency surface(mesh);
  const SurfaceAdjacency otherSurface(other);
  const SurfacePaths paths(surface, 31, HUGE_VAL);
  const SurfacePaths others(otherSurface, static_cast<SimplexId>(renamed(31)), HUGE_VAL);
  for (const SimplexId p : paths.Points())
  {
    EXPECT_EQ(8.0 * paths.Length(p), others.Length(static_cast<SimplexId>(renamed(p))));
  }
}

TEST(SurfacePaths, StayOnTheirPartAndAvoidUnusedPoints)
{
  TriangleMesh mesh = Torus(1.0, 0.3, 12, 8);
  const auto part = static_cast<SimplexId>(mesh.Points.size());
  const TriangleMesh second = Torus(0.2, 0.1, 12, 8);
  for (const Triangle& t : second.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + part, t[1] + part, t[2] + part });
  }
  mesh.Points.insert(mesh.Points.end(), second.Points.begin(), second.Points.end());
  mesh.Points.push_back({ 1.0, 0.0, 0.0 });
  const auto lonely = static_cast<SimplexId>(mesh.Points.size() - 1);
  const SurfaceAdjacency surface(mesh);
  const SurfacePaths paths(surface, 0, HUGE_VAL, part);
  EXPECT_EQ(paths.Points().size(), static_cast<std::size_t>(part));
  EXPECT_FALSE(paths.Has(part)); // where it should end
  EXPECT_FALSE(paths.Has(lonely));
  const SurfacePaths none(surface, lonely, HUGE_VAL);
  ASSERT_EQ(none.Points().size(), 1U);
  EXPECT_EQ(none.Length(lonely), 0.0);
}

}
