#include "Persistence/MorseValues.h"

#include "ChokingSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Largest difference from the distance to a ring of radii 1 and 0.3, in units of the spacing.
double FindWorst(const DistanceGrid& grid)
{
  double worst = 0.0;
  std::size_t n = 0;
  for (std::int64_t k = 0; k < grid.Dimensions[2]; ++k)
  {
    for (std::int64_t j = 0; j < grid.Dimensions[1]; ++j)
    {
      for (std::int64_t i = 0; i < grid.Dimensions[0]; ++i)
      {
        const auto at = [&](std::size_t a, std::int64_t x)
        { return grid.Origin[a] + grid.Spacing * static_cast<double>(x); };
        const double exact =
          std::abs(std::hypot(std::hypot(at(0, i), at(1, j)) - 1.0, at(2, k)) - 0.3);
        worst = std::max(worst, std::abs(grid.Values[n++] - exact));
      }
    }
  }
  return worst;
}

const Bounds3 Box{ { -1.51, -1.52, -0.71 }, { 1.52, 1.51, 0.72 } };

}

TEST(MorseValues, FastMarchingConvergesAtFirstOrder)
{
  const TriangleMesh ring = Torus(1.0, 0.3, 240, 80);
  std::vector<double> worst;
  for (const std::int64_t cells : { 20, 40, 80 })
  {
    worst.push_back(FindWorst(MarchedDistances(ring, Box, cells)));
  }
  EXPECT_LT(worst[0], 3.03 / 20.0); // a cell
  EXPECT_LT(worst[1], 0.65 * worst[0]);
  EXPECT_LT(worst[2], 0.65 * worst[1]);
}

TEST(MorseValues, MarchedDistancesGrowWithTheSurface)
{
  for (const double factor : { 1e-30, 1e30 })
  {
    const DistanceGrid one = MarchedDistances(Torus(1.0, 0.3, 30, 12), Box, 20);
    const Bounds3 box{ factor * Box.Min, factor * Box.Max };
    TriangleMesh scaled = Torus(1.0, 0.3, 30, 12);
    for (Point3& p : scaled.Points)
    {
      p = factor * p;
    }
    const DistanceGrid other = MarchedDistances(scaled, box, 20);
    ASSERT_EQ(one.Values.size(), other.Values.size());
    for (std::size_t i = 0; i < one.Values.size(); ++i)
    {
      EXPECT_NEAR(other.Values[i] / factor, one.Values[i], 1e-5);
    }
  }
}

TEST(MorseValues, AreZeroOnTheSurfaceAndTheDistanceElsewhere)
{
  const TriangleMesh ring = Torus(1.0, 0.3, 60, 24);
  TetrahedralMesh mesh;
  mesh.Points = ring.Points;
  mesh.Points.push_back({ 0.0, 0.0, 0.0 });
  mesh.Points.push_back({ 1.0, 0.0, 0.0 });
  for (const MorseFunction f :
    { MorseFunction::ClosestPoint, MorseFunction::GridDistance, MorseFunction::FastMarching })
  {
    const std::vector<double> values = MorseValues(ring, mesh, f);
    for (std::size_t i = 0; i < ring.Points.size(); ++i)
    {
      EXPECT_NEAR(values[i], 0.0, 1e-12);
    }
    EXPECT_NEAR(values[values.size() - 2], 0.7, 0.05);
    EXPECT_NEAR(values.back(), 0.3, 0.05);
  }
}
