// Where the lines of a grid cross a surface, and which nodes it encloses.

#include "GridChecks.h"
#include "SurfaceModels.h"
#include "Surfaces/SurfaceCrossings.h"
#include "Surfaces/SurfaceMeasures.h"

#include <vtkMath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

Vector ComputePosition(const GridCrossing& crossing, const GridShape& grid)
{
  const std::int64_t row = crossing.Node / grid.Dimensions[0];
  Vector index{ static_cast<double>(crossing.Node % grid.Dimensions[0]),
    static_cast<double>(row % grid.Dimensions[1]), static_cast<double>(row / grid.Dimensions[1]) };
  index[static_cast<std::size_t>(crossing.Axis)] += crossing.Fraction;
  for (std::size_t a = 0; a < 3; ++a)
  {
    index[a] *= grid.Spacing[a];
  }
  return index;
}

}

// Table 5.1: the error is set by the triangles, so its order shows when they are refined with h.
TEST(SurfaceCrossings, Table51)
{
  const struct
  {
    int Frequency;
    double Spacing;
    double Error;
  } rows[] = { { 22, 0.25, 7.802e-4 }, { 44, 0.125, 1.924e-4 }, { 88, 0.0625, 4.77e-5 } };
  double last = 0.0;
  for (const auto& row : rows)
  {
    // The grid begins 1 before the sphere, as for the errors expected, which a script with another
    // rule for duplicates gives (merging equal points).
    Model sphere = Icosphere(row.Frequency, 2.0);
    double low = 0.0;
    for (const Vector& p : sphere.Points)
    {
      low = std::min(low, p[0]);
    }
    const double center = 1.0 - low;
    sphere = Translate(sphere, center, center, center);
    const auto nodes = static_cast<std::int64_t>(std::lround(6.0 / row.Spacing)) + 1;
    const GridShape grid{ { nodes, nodes, nodes }, { row.Spacing, row.Spacing, row.Spacing } };
    const auto crossings = SurfaceCrossings(sphere.View(), grid, CrossingNormal::Points);
    double error = 0.0;
    for (const GridCrossing& crossing : crossings)
    {
      const Vector p = ComputePosition(crossing, grid);
      const Vector r{ p[0] - center, p[1] - center, p[2] - center };
      error += std::abs(2.0 - vtkMath::Norm(r.data()));
      EXPECT_NEAR(vtkMath::Dot(r.data(), crossing.Normal.data()) / 2.0, 1.0, 2e-3);
    }
    error /= static_cast<double>(crossings.size());
    std::printf("h = %-7g %6zu crossings, mean error %.4e, order %.2f\n", row.Spacing,
      crossings.size(), error, last > 0.0 ? std::log2(last / error) : 0.0);
    EXPECT_NEAR(error / row.Error, 1.0, 0.01);
    EXPECT_TRUE(last == 0.0 || std::log2(last / error) > 1.9);
    last = error;
  }
}

TEST(SurfaceCrossings, OrderedAndOnTheSurface)
{
  const Model torus = Translate(Torus(60, 40, 2.0, 0.8), 3.01, 3.02, 1.03);
  const GridShape grid{ { 40, 31, 25 }, { 0.17, 0.2, 0.1 } };
  const auto crossings = SurfaceCrossings(torus.View(), grid, CrossingNormal::Triangles);
  double area = 0.0;
  const double cell = 0.17 * 0.2 * 0.1;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    EXPECT_TRUE(i % 50 != 0 || BruteForce(torus, ComputePosition(crossings[i], grid)) < 1e-6);
    EXPECT_TRUE(crossings[i].Fraction >= 0.0 && crossings[i].Fraction <= 1.0);
    EXPECT_TRUE(i == 0 || crossings[i - 1].Node <= crossings[i].Node);
    const auto axis = static_cast<std::size_t>(crossings[i].Axis);
    area += std::abs(crossings[i].Normal[axis]) * cell / grid.Spacing[axis];
  }
  // The crossings' normals give the area, as 5.26 does for levels.
  EXPECT_NEAR(area / MeasureSurface(torus.View()).Whole.Area, 1.0, 0.01);
}

// Lines through corners and along edges and faces: a box whose faces lie on nodes, cut in every
// way.
TEST(SurfaceCrossings, ParityHoldsWhereLinesMeetCornersAndEdges)
{
  Model box;
  for (int i = 0; i < 8; ++i)
  {
    box.AddPoint(2.0 + 4.0 * (i & 1), 2.0 + 4.0 * (i >> 1 & 1), 2.0 + 4.0 * (i >> 2));
  }
  box.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  const GridShape grid = Cube(9, 8.0);
  const auto inside = NodesInside(box.View(), grid);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::int64_t index[3] = { node % 9, node / 9 % 9, node / 81 };
    const auto all = [&](std::int64_t low, std::int64_t high) {
      return std::all_of(index, index + 3, [&](std::int64_t i) { return i >= low && i <= high; });
    };
    EXPECT_TRUE(!all(3, 5) || inside[static_cast<std::size_t>(node)] == 1);
    EXPECT_TRUE(all(2, 6) || inside[static_cast<std::size_t>(node)] == 0);
  }
  // Octahedra with their corners on nodes, as silhouettes through nodes in all directions.
  Model octahedron;
  octahedron.Points = { { 1, 4, 4 }, { 7, 4, 4 }, { 4, 1, 4 }, { 4, 7, 4 }, { 4, 4, 1 },
    { 4, 4, 7 } };
  octahedron.Triangles = { { 0, 4, 3 }, { 3, 4, 1 }, { 1, 4, 2 }, { 2, 4, 0 }, { 0, 3, 5 },
    { 3, 1, 5 }, { 1, 2, 5 }, { 2, 0, 5 } };
  const auto flags = NodesInside(octahedron.View(), grid);
  for (std::int64_t node = 0; node < grid.Size(); ++node)
  {
    const std::int64_t sum =
      std::abs(node % 9 - 4) + std::abs(node / 9 % 9 - 4) + std::abs(node / 81 - 4);
    EXPECT_TRUE(sum == 3 || flags[static_cast<std::size_t>(node)] == (sum < 3));
  }
}

TEST(SurfaceCrossings, InsideAgreesWithSolidAngles)
{
  Model model = Translate(Torus(24, 14, 2.0, 0.8), 3.0, 3.0, 1.5);
  Model cavity = Translate(Icosphere(2, 0.4), 5.0, 3.0, 1.5);
  TurnInsideOut(cavity);
  Append(model, cavity, { 0, 0, 0 });
  const GridShape grid{ { 30, 25, 15 }, { 0.2, 0.25, 0.2 } };
  const auto inside = NodesInside(model.View(), grid);
  const auto irregular = IrregularNodes(inside, grid);
  for (std::int64_t node = 0; node < grid.Size(); node += 3)
  {
    const Vector x{ static_cast<double>(node % 30) * 0.2,
      static_cast<double>(node / 30 % 25) * 0.25, static_cast<double>(node / 750) * 0.2 };
    EXPECT_NEAR(WindingNumber(model, x), inside[static_cast<std::size_t>(node)], 1e-6) << node;
  }
  EXPECT_GT(std::count(irregular.begin(), irregular.end(), 1), 100);

  model.Triangles.erase(model.Triangles.begin(), model.Triangles.begin() + 28);
  EXPECT_THROW(NodesInside(model.View(), grid), std::invalid_argument);
  EXPECT_THROW(
    SurfaceCrossings(Translate(model, 1e9, 0, 0).View(), grid, CrossingNormal::Triangles),
    std::invalid_argument);
}
