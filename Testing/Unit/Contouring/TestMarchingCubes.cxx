// The triangles of a level: areas and volumes of balls, manifolds of noise, borders, threads.

#include "Contouring/MarchingCubes.h"
#include "Core/Geometry.h"
#include "SampledGrid.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

}

// The polyhedron is inscribed up to the curvature of the sphere within a cell: second order.
TEST(MarchingCubes, AreaAndVolumeOfABallConvergeWithOrderTwo)
{
  double last[2] = { 0, 0 };
  for (const int n : { 21, 41, 81 })
  {
    const double h = 4.0 / (n - 1);
    const Grid grid = SampleGrid({ n, n, n }, { h, h, h },
      [](double x, double y, double z) {
        return Ball(x, y, z, { 2.03, 1.98, 2.01 }, 1.4);
      });
    const TriangleMesh mesh = At(grid, 0.0);
    EXPECT_EQ(DescribeDefects(mesh), "");
    EXPECT_EQ(EulerCharacteristic(mesh), 2);
    double area = 0.0;
    for (const Triangle& t : mesh.Triangles)
    {
      const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
      const Point3 normal = Cross(at(1) - at(0), at(2) - at(0));
      area += std::sqrt(Dot(normal, normal)) / 2.0;
    }
    const double errors[2] = { std::abs(area / (4 * Pi * 1.96) - 1),
      std::abs(SignedVolume(mesh) / (4 * Pi * 2.744 / 3) - 1) };
    for (int i = 0; i < 2; ++i)
    {
      if (last[i] > 0.0)
      {
        EXPECT_GT(std::log2(last[i] / errors[i]), 1.8) << "n = " << n;
      }
      last[i] = errors[i];
    }
  }
}

// Signs at random meet all 256 cases in all neighbourhoods.
TEST(MarchingCubes, NoiseGivesAClosedManifoldThatFacesOutwards)
{
  std::mt19937 random(7);
  const Grid grid = SampleGrid({ 17, 16, 15 }, { 1, 2, 3 },
    [&](double, double, double) { return static_cast<double>(random() % 5) - 2.0; });
  for (const double level : { -1.5, 0.0, 0.3, 1.0 }) // 0 and 1 are values of nodes
  {
    const TriangleMesh mesh = At(grid, level);
    EXPECT_EQ(DescribeDefects(mesh), "") << level;
    EXPECT_GT(SignedVolume(mesh), 0.0);
    EXPECT_EQ(DescribeDefects(At(grid, level, true, false)), "") << level;
  }
}

TEST(MarchingCubes, ALevelThatLeavesTheGridIsClosedHalfACellBeyondIt)
{
  const Grid grid =
    SampleGrid({ 5, 4, 6 }, { 1, 2, 0.5 }, [](double, double, double) { return 3.0; });
  const TriangleMesh box = At(grid, 1.0);
  EXPECT_EQ(DescribeDefects(box), "");
  EXPECT_EQ(EulerCharacteristic(box), 2);
  Bounds3 bounds{ box.Points[0], box.Points[0] };
  for (const Point3& p : box.Points)
  {
    bounds.Add(p);
  }
  EXPECT_EQ(bounds.Min, (Point3{ -0.5, -1, -0.25 }));
  EXPECT_EQ(bounds.Max, (Point3{ 4.5, 7, 2.75 }));
  EXPECT_TRUE(At(grid, 1.0, false).Triangles.empty());

  const Grid slope =
    SampleGrid({ 6, 6, 6 }, { 1, 1, 1 }, [](double x, double, double) { return x - 2.25; });
  const TriangleMesh open = At(slope, 0.0, false);
  EXPECT_EQ(open.Triangles.size(), 50U); // the plane x = 2.25 through 25 cells
  EXPECT_FALSE(FindDefects(open).BoundaryTriangles.empty());
  for (const Point3& p : open.Points)
  {
    EXPECT_DOUBLE_EQ(p[0], 2.25);
  }
}

TEST(MarchingCubes, NaNIsOutside)
{
  Grid grid = SampleGrid(
    { 8, 8, 8 }, { 1, 1, 1 }, [](double x, double, double) { return x < 3.5 ? Nan : 1.0; });
  grid.Values[511] = std::numeric_limits<double>::infinity();
  grid.Values[255] = -1e300;
  const TriangleMesh mesh = At(grid, 0.5);
  EXPECT_EQ(DescribeDefects(mesh), "");
  EXPECT_EQ(FindDefects(mesh).InvalidPoints.size(), 0U);
  EXPECT_THROW(At(grid, Nan), std::invalid_argument);
}

// Inside is strictly above the level, so that a node at the level encloses nothing.
TEST(MarchingCubes, ANodeAtTheLevelIsOutside)
{
  const Grid grid = SampleGrid({ 5, 5, 5 }, { 1, 1, 1 },
    [](double x, double y, double z) {
      return std::max({ 0.0, 3.0 - x, 3.0 - y, 3.0 - z });
    });
  for (const bool higher : { true, false })
  {
    const double end = higher ? 3.0 : 0.0;
    const double before = higher ? 2.5 : 0.5;
    EXPECT_TRUE(At(grid, end, true, higher).Triangles.empty()) << higher;
    EXPECT_FALSE(At(grid, before, true, higher).Triangles.empty()) << higher;
  }
}

TEST(MarchingCubes, HugeValuesInterpolate)
{
  const Grid grid = SampleGrid(
    { 2, 2, 2 }, { 1, 1, 1 }, [](double x, double, double) { return x < 0.5 ? -1e308 : 1e308; });
  for (const Point3& p : At(grid, 0.0, false).Points)
  {
    EXPECT_DOUBLE_EQ(p[0], 0.5);
  }
}

TEST(MarchingCubes, IdenticalOnOneAndThreeThreads)
{
  std::mt19937 random(3);
  const Grid grid = SampleGrid({ 30, 31, 67 }, { 1, 1, 1 },
    [&](double, double, double) { return static_cast<double>(random() % 1000); });
  TriangleMesh meshes[2];
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
      [&]() { meshes[threads / 3] = At(grid, 700.5); });
  }
  EXPECT_EQ(meshes[0].Points, meshes[1].Points);
  EXPECT_EQ(meshes[0].Triangles, meshes[1].Triangles);
  EXPECT_FALSE(meshes[0].Triangles.empty());
}
