// Triangles that cross or touch: the same ones as CGAL's Polygon_mesh_processing finds, on smooth,
// flat, crossing and degenerate surfaces.

#include "ChokingSurfaces.h"
#include "Remeshing/CGALSurface.h"
#include "Remeshing/SelfIntersections.h"
#include "Surfaces/SurfaceCleaning.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

std::vector<std::int64_t> ByCGAL(const TriangleMesh& mesh)
{
  const cgal::SurfaceMesh surface = cgal::ToSurfaceMesh(mesh);
  using Face = cgal::SurfaceMesh::Face_index;
  std::vector<std::pair<Face, Face>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surface, std::back_inserter(pairs));
  std::set<std::int64_t> ids;
  for (const auto& [a, b] : pairs)
  {
    ids.insert({ static_cast<std::int64_t>(a.idx()), static_cast<std::int64_t>(b.idx()) });
  }
  return { ids.begin(), ids.end() };
}

/// The number of triangles found by both.
std::size_t ExpectSame(const TriangleMesh& mesh)
{
  const std::vector<std::int64_t> expected = ByCGAL(mesh);
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, std::string("STDThread"), false),
      [&] { EXPECT_EQ(SelfIntersections(mesh), expected); });
  }
  return expected.size();
}

/// A closed box of n x n squares a side, each of two triangles: neighbours lie in one plane.
TriangleMesh FlatBox(int n)
{
  TriangleMesh soup;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const auto corner = [&](int i, int j)
      {
        Point3 p;
        p[static_cast<std::size_t>(axis)] = side;
        p[static_cast<std::size_t>(axis + 1) % 3] = static_cast<double>(i) / n;
        p[static_cast<std::size_t>(axis + 2) % 3] = static_cast<double>(j) / n;
        soup.Points.push_back(p);
        return static_cast<std::int64_t>(soup.Points.size()) - 1;
      };
      for (int k = 0; k < n * n; ++k)
      {
        const int i = k / n, j = k % n;
        const auto a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1);
        const auto d = corner(i, j + 1);
        const Triangle first{ a, b, c }, second{ a, c, d };
        soup.Triangles.push_back(side ? first : Triangle{ c, b, a });
        soup.Triangles.push_back(side ? second : Triangle{ d, c, a });
      }
    }
  }
  return MergePoints(soup);
}

TriangleMesh Shaken(TriangleMesh mesh, double by, unsigned int seed, unsigned int every = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, by);
  for (Point3& p : mesh.Points)
  {
    const Point3 shift{ normal(random), normal(random), normal(random) };
    p = random() % every == 0 ? p + shift : p;
  }
  return mesh;
}

TEST(SelfIntersections, NoneOnCleanSurfaces)
{
  EXPECT_EQ(ExpectSame(FlatBox(12)), 0U);
  EXPECT_EQ(ExpectSame(Torus(1.0, 0.3, 60, 24)), 0U);
  EXPECT_TRUE(SelfIntersections({}).empty());
}

TEST(SelfIntersections, AgreeWithBruteForceOnPerturbedSurfaces)
{
  std::size_t found = 0;
  for (unsigned int seed = 0; seed < 12; ++seed)
  {
    found += ExpectSame(Shaken(Torus(1.0, 0.3, 60, 24), 0.01 * seed, seed));
    found += ExpectSame(Shaken(FlatBox(10), 0.02 * seed, seed, 1 + seed % 3));
    // In the planes of the box, and by very small amounts.
    TriangleMesh flat = FlatBox(8);
    const TriangleMesh moved = Shaken(flat, seed % 2 ? 0.05 : 1e-15, seed, 4);
    for (std::size_t i = 0; i < flat.Points.size(); ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        const bool border = flat.Points[i][a] == 0.0 || flat.Points[i][a] == 1.0;
        flat.Points[i][a] = border ? flat.Points[i][a] : moved.Points[i][a];
      }
    }
    found += ExpectSame(flat);
  }
  EXPECT_GT(found, 1000U);
}

TEST(SelfIntersections, TouchingFoldedAndFlat)
{
  // Points on edges and in triangles of others, corners snapped together, folds: a coarse lattice.
  std::size_t found = 0;
  for (unsigned int seed = 0; seed < 20; ++seed)
  {
    TriangleMesh mesh = Shaken(Torus(1.0, 0.3, 24, 12), 0.08, seed);
    for (Point3& p : mesh.Points)
    {
      for (double& x : p)
      {
        x = std::round(16.0 * x) / 16.0;
      }
    }
    found += ExpectSame(mesh);
  }
  EXPECT_GT(found, 500U);
}

TEST(SelfIntersections, FarAwayTinyAndLarge)
{
  const TriangleMesh torus = Shaken(Torus(1.0, 0.3, 40, 16), 0.1, 5);
  const std::vector<std::int64_t> expected = SelfIntersections(torus);
  EXPECT_FALSE(expected.empty());
  for (const double factor : { 0x1p-300, 0x1p-90, 0x1p90, 0x1p300 })
  {
    TriangleMesh scaled = torus;
    for (Point3& p : scaled.Points)
    {
      p = factor * p;
    }
    EXPECT_EQ(SelfIntersections(scaled), expected) << factor;
  }
  TriangleMesh far = torus;
  for (Point3& p : far.Points)
  {
    p = p + Point3{ 1e6, -2e6, 3e6 };
  }
  ExpectSame(far);
}

TEST(SelfIntersections, SharedSurfaces)
{
  for (const char* name : { "casting.off", "neptune.off", "block.off", "sharp_sphere.off" })
  {
    ISTHMUS_NEEDS_SHARED_DATA(std::string("surfaces/") + name);
    SCOPED_TRACE(name);
    const TriangleMesh mesh = MergePoints(ReadSurface(name));
    if (FindDefects(mesh).None())
    {
      ExpectSame(mesh);
    }
  }
}

}
