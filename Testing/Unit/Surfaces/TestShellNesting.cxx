// The nesting of closed shells, compared with boxes at known positions.

#include "SurfaceFiles.h"
#include "Surfaces/ShellNesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The number of cubes [low, low + side]^3 with `p` in their interior.
int CubesAround(const Point3& p, const std::vector<std::pair<Point3, double>>& cubes)
{
  return static_cast<int>(std::count_if(cubes.begin(), cubes.end(),
    [&p](const auto& cube)
    {
      bool isIn = true;
      for (std::size_t a = 0; a < 3; ++a)
      {
        isIn = isIn && p[a] > cube.first[a] && p[a] < cube.first[a] + cube.second;
      }
      return isIn;
    }));
}

}

TEST(ShellNesting, PointsLieInTheirOwnRegionOnly)
{
  // A solid with two cavities, a solid in the first of them with a cavity of its own, one beside.
  const std::vector<std::pair<Point3, double>> cubes{ { { 0, 0, 0 }, 10 }, { { 1, 1, 1 }, 5 },
    { { 7, 7, 7 }, 2 }, { { 2, 2, 2 }, 3 }, { { 3, 3, 3 }, 1 }, { { 20, 0, 0 }, 4 } };
  const std::vector<int> depth{ 1, 2, 2, 3, 4, 1 };
  const std::vector<int> ids{ 1, -1, -2, 2, -3, 3 };
  const std::vector<int> outer{ 0, 1, 1, -1, 2, 0 };
  const std::vector<double> volumes{ 1000 - 125 - 8, 125 - 27, 8, 27 - 1, 1, 64 };
  // The order of the shells must not matter.
  std::vector<std::size_t> order{ 0, 1, 2, 3, 4, 5 };
  for (int turn = 0; turn < 6; ++turn)
  {
    std::rotate(order.begin(), order.begin() + 1, order.end());
    TriangleMesh mesh;
    for (const std::size_t i : order)
    {
      Append(mesh, Cube(cubes[i].first, cubes[i].second));
    }
    const ShellNesting nesting = FindNesting(mesh);
    ASSERT_EQ(nesting.Shells.size(), cubes.size());
    for (std::size_t s = 0; s < order.size(); ++s)
    {
      const SpaceRegion& region = nesting.InnerRegions[s];
      EXPECT_EQ(CubesAround(region.Seed, cubes), depth[order[s]]) << s;
      EXPECT_EQ(CubesAround(region.Seed, { cubes[order[s]] }), 1) << s;
      EXPECT_NEAR(region.Volume, volumes[order[s]], 1e-9) << s;
      if (order.front() == 0)
      {
        EXPECT_EQ(region.Id, ids[s]);
        EXPECT_EQ(nesting.OuterRegionIds[s], outer[s]);
      }
    }
  }
}

TEST(ShellNesting, ThousandsOfShellsReportProgressAndStop)
{
  TriangleMesh dust;
  for (int i = 0; i < 3000; ++i)
  {
    Append(dust, Cube({ 2.0 * (i % 15), 2.0 * (i / 15 % 15), 2.0 * (i / 225) }, 1.0));
  }
  const ShellNesting nesting = FindNesting(dust);
  EXPECT_EQ(nesting.Shells.size(), 3000u);
  EXPECT_EQ(nesting.InnerRegions.back().Id, 3000);
  double last = 0.0;
  int calls = 0;
  EXPECT_THROW(FindNesting(dust,
                 [&](double done)
                 {
                   EXPECT_GE(done, last);
                   last = done;
                   return ++calls < 4000;
                 }),
    Cancelled);
  EXPECT_EQ(calls, 4000);
  EXPECT_GT(last, 0.5);
}
