// A coarser surface has the topology of the input, points of the input, and the deviation that it
// states.

#include "Surfaces/SurfaceCoarsening.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace isthmus;

namespace
{

/// A ring round z whose cross-section has the radius 1 + 0.3 cos(5 u).
TriangleMesh WavyRing(int around, int across)
{
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * M_PI * i / around, v = 2.0 * M_PI * j / across;
      const double r = 1.0 + 0.3 * std::cos(5.0 * u), x = 3.0 + r * std::cos(v);
      mesh.Points.push_back({ x * std::cos(u), x * std::sin(u), r * std::sin(v) });
    }
  }
  const auto id = [=](int i, int j) -> vtkIdType { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return mesh;
}

double LongestEdge(const TriangleMesh& mesh)
{
  double longest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      longest = std::max(longest, Distance(mesh.Points[At(t[k])], mesh.Points[At(t[(k + 1) % 3])]));
    }
  }
  return longest;
}

CoarseSurface Coarsen(const TriangleMesh& mesh, double size, double tolerance)
{
  return CoarsenSurface(mesh, std::vector<double>(mesh.Points.size(), size),
    std::vector<double>(mesh.Points.size(), tolerance));
}

}

TEST(SurfaceCoarsening, KeepsTopologyAndStaysNear)
{
  const TriangleMesh fine = WavyRing(400, 100);
  for (const double tolerance : { 0.01, 0.05 })
  {
    const CoarseSurface coarse = Coarsen(fine, 0.8, tolerance);
    EXPECT_LT(coarse.Mesh.Points.size(), fine.Points.size() / 8);
    EXPECT_TRUE(FindDefects(coarse.Mesh).None());
    EXPECT_EQ(EulerCharacteristic(coarse.Mesh), 0);
    EXPECT_LE(LongestEdge(coarse.Mesh), 0.8);
    for (std::size_t i = 0; i < coarse.Origin.size(); ++i)
    {
      ASSERT_EQ(coarse.Mesh.Points[i], fine.Points[At(coarse.Origin[i])]);
    }
    const TriangleTree tree(coarse.Mesh);
    for (std::size_t p = 0; p < fine.Points.size(); ++p)
    {
      const double distance = std::sqrt(tree.Find(fine.Points[p], -1).Squared);
      const Triangle& t = coarse.Mesh.Triangles[At(coarse.Nearest[p])];
      ASSERT_LE(distance, tolerance * (1.0 + 1e-9));
      ASSERT_LE(distance, coarse.Deviation[At(t[0])] + 1e-12);
    }
  }
}

TEST(SurfaceCoarsening, ThinPartsKeepTheirHandles)
{
  // Across its thinnest parts, this ring is as wide as one edge that would be allowed.
  const CoarseSurface coarse = Coarsen(WavyRing(400, 100), 20.0, 1.0);
  EXPECT_TRUE(FindDefects(coarse.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(coarse.Mesh), 0);
  EXPECT_LT(coarse.Mesh.Points.size(), 100U);
}

TEST(SurfaceCoarsening, FinePartsOnlyWhereTheyAreWanted)
{
  const TriangleMesh fine = WavyRing(400, 100);
  std::vector<double> size, tolerance;
  for (const Point3& p : fine.Points)
  {
    size.push_back(p[0] > 0.0 ? 0.1 : 0.8);
    tolerance.push_back(0.05 * size.back());
  }
  const CoarseSurface coarse = CoarsenSurface(fine, size, tolerance);
  const auto right = std::count_if(coarse.Mesh.Points.begin(), coarse.Mesh.Points.end(),
    [](const Point3& p) { return p[0] > 0.0; });
  EXPECT_GT(right, 5 * (static_cast<std::ptrdiff_t>(coarse.Mesh.Points.size()) - right));
}

TEST(SurfaceCoarsening, LeavesACoarseSurfaceAsItIs)
{
  const TriangleMesh mesh = WavyRing(60, 20);
  const CoarseSurface coarse = Coarsen(mesh, 0.01, 1.0);
  EXPECT_EQ(coarse.Mesh.Points, mesh.Points);
  EXPECT_EQ(coarse.Mesh.Triangles, mesh.Triangles);
  EXPECT_EQ(*std::max_element(coarse.Deviation.begin(), coarse.Deviation.end()), 0.0);
}
