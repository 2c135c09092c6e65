// Planes of curved faces: they meet on the faces' edge, whatever its curvature; planes and single
// faces are left alone; and the edges that dual contouring keeps when its data are exact.

#include "Contouring/QuadricError.h"

#include "Contouring/DualContouring.h"
#include "Core/Index.h"
#include "EdgedSolids.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <tuple>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Threshold = 0.07;
const Bounds3 Around{ { -2, -2, -2 }, { 2, 2, 2 } };

/// Tangent planes of a sphere of radius `radius` that passes through the origin, where its normal
/// is (0, sin 60, cos 60), at random places in the unit cell around it.
std::vector<TangentPlane> OfSphere(double radius, int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  const Point3 up{ 0.0, std::sqrt(0.75), 0.5 }, center = (-radius) * up;
  std::vector<TangentPlane> planes;
  for (int i = 0; i < count; ++i)
  {
    const Point3 d = Point3{ uniform(random), uniform(random), uniform(random) } - center;
    const Point3 n = (1.0 / Length(d)) * d;
    planes.push_back({ center + radius * n, n });
  }
  return planes;
}

std::vector<TangentPlane> OfFloor(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  std::vector<TangentPlane> planes;
  for (int i = 0; i < count; ++i)
  {
    planes.push_back({ { uniform(random), uniform(random), 0.0 }, { 0.0, 0.0, -1.0 } });
  }
  return planes;
}

/// The distance of `x` from the circle in which that sphere meets the plane z = 0.
double OffCircle(const Point3& x, double radius)
{
  const Point3 toSphere = x + radius * Point3{ 0.0, std::sqrt(0.75), 0.5 };
  return std::max(std::abs(Length(toSphere) - radius), std::abs(x[2]));
}

double Least(const QuadricError& planes, double radius)
{
  return OffCircle(planes.Least(Around, Threshold), radius);
}

QuadricError Tangent(const std::vector<TangentPlane>& planes)
{
  QuadricError errors;
  for (const TangentPlane& plane : planes)
  {
    errors.Add(plane.Place, plane.Normal);
  }
  return errors;
}

/// Crossings of the solid f < 0 with the lines of n^3 nodes from -1 to 1 by bisection, with its
/// gradient there: nothing is interpolated.
template <typename Function>
HermiteGrid ExactGrid(int n, Function&& f)
{
  const double h = 2.0 / (n - 1);
  HermiteGrid grid;
  grid.Shape = { { n, n, n }, { h, h, h } };
  const std::array<std::int64_t, 3> stride{ 1, n, std::int64_t{ n } * n };
  const auto at = [&](std::int64_t node)
  {
    Point3 p;
    for (std::size_t a = 0; a < 3; ++a)
    {
      p[a] = -1.0 + h * static_cast<double>(node / stride[a] % n);
    }
    return p;
  };
  for (std::int64_t node = 0; node < grid.Shape.Size(); ++node)
  {
    grid.Inside.push_back(f(at(node)) < 0.0 ? 1 : 0);
  }
  for (std::int64_t node = 0; node < grid.Shape.Size(); ++node)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (node / stride[a] % n + 1 == n ||
        grid.Inside[At(node)] == grid.Inside[At(node + stride[a])])
      {
        continue;
      }
      const auto there = [&](double t)
      {
        Point3 p = at(node);
        p[a] += t * h;
        return p;
      };
      double low = 0.0, high = 1.0;
      for (int halving = 0; halving < 50; ++halving)
      {
        const double middle = 0.5 * (low + high);
        ((f(there(middle)) < 0.0) == (grid.Inside[At(node)] != 0) ? low : high) = middle;
      }
      Point3 gradient;
      for (std::size_t b = 0; b < 3; ++b)
      {
        Point3 step{};
        step[b] = 1e-7;
        gradient[b] = f(there(low) + step) - f(there(low) - step);
      }
      grid.Crossings.push_back(
        { node, static_cast<int>(a), low, (1.0 / Length(gradient)) * gradient });
    }
  }
  return grid;
}

/// In the frame of the solid.
TriangleMesh ExactContour(int n, const Value& value, const Rotation& turn)
{
  const DualContour contour =
    DualContouring(ExactGrid(n, [&](const Point3& p) { return value(turn(p)); }), {});
  TriangleMesh mesh;
  for (const Point3& p : contour.Points)
  {
    mesh.Points.push_back(turn(p - Point3{ 1, 1, 1 }));
  }
  for (const auto& corners : contour.Polygons)
  {
    mesh.Triangles.push_back({ corners[0], corners[1], corners[2] });
  }
  return mesh;
}

}

/// A sphere of 2 to 50 cells' sides and a plane at 60 degrees to it.
TEST(QuadricError, OfASphereAndAPlaneMeetOnTheirCircle)
{
  std::mt19937 random(3);
  for (const double radius : { 2.0, 5.0, 12.8, 50.0 })
  {
    double worst = 0.0, worstTangent = 0.0;
    for (int trial = 0; trial < 200; ++trial)
    {
      auto planes = OfSphere(radius, 4, random);
      const auto floor = OfFloor(3, random);
      planes.insert(planes.end(), floor.begin(), floor.end());
      worst = std::max(worst, Least(FitQuadricError(planes, Around, Threshold), radius));
      worstTangent = std::max(worstTangent, Least(Tangent(planes), radius));
    }
    std::printf("radius %g: off by %.2e, tangent planes by %.2e\n", radius, worst, worstTangent);
    EXPECT_LT(worst, 0.02 * worstTangent) << radius;
  }
}

TEST(QuadricError, OfPlanesAndOfOneFaceAreTheTangentOnes)
{
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial)
  {
    auto planes = OfFloor(3, random);
    for (TangentPlane& plane : OfFloor(3, random))
    {
      planes.push_back({ { 0.1, plane.Place[0], plane.Place[1] }, { 1.0, 0.0, 0.0 } });
    }
    const Point3 x = Tangent(planes).Least(Around, Threshold);
    EXPECT_LT(
      Length(FitQuadricError(planes, Around, Threshold).Least(Around, Threshold) - x), 1e-12);
    const auto sphere = OfSphere(10.0, 5, random);
    EXPECT_EQ(FitQuadricError(sphere, Around, Threshold).Least(Around, Threshold),
      Tangent(sphere).Least(Around, Threshold));
  }
}

/// Random normals: a point in the box, no worse than that of the tangent planes.
TEST(QuadricError, OfNoiseIsNoWorse)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1000; ++trial)
  {
    std::vector<TangentPlane> planes = OfFloor(1 + trial % 12, random);
    for (TangentPlane& plane : planes)
    {
      const Point3 n{ normal(random), normal(random), normal(random) };
      plane.Normal = (1.0 / Length(n)) * n;
    }
    const auto least = [](const QuadricError& errors)
    { return errors.At(errors.Least(Around, Threshold)); };
    const double value = least(FitQuadricError(planes, Around, Threshold));
    EXPECT_TRUE(value <= least(Tangent(planes))) << value;
  }
}

TEST(SharpFeatureGrid, MiddlesStayATenthFromFaces)
{
  SharpEdges sharp;
  sharp.Segments = { { { { 0.5, 0.5, 0.5 }, { 2.5, 0.5, 0.5 } } } };
  sharp.Corners = { { 0.25, 0.5, 0.5 }, { 0.75, 0.5, 0.5 }, { 1.5, 0.5, 0.5 } };
  const SharpFeatureGrid features(sharp, { { 5, 2, 2 }, { 1.0, 1.0, 1.0 } });
  const auto any = [](const Point3&) { return true; };
  const Point3 left{ -9.0, 0.5, 0.5 }, right{ 9.0, 0.5, 0.5 };
  const auto onEdge = [&](std::int64_t cell, const Point3& x, SharpFeatureGrid::Part part) {
    return features.NearestOnEdge(cell, x, part, any).value_or(Point3{ -1, -1, -1 })[0];
  };
  for (const auto& [cell, from, to] : { std::tuple(0, 0.5, 1.0), { 1, 1.0, 2.0 }, { 2, 2.0, 2.5 } })
  {
    const double beside = 0.1 * (to - from);
    EXPECT_NEAR(onEdge(cell, left, SharpFeatureGrid::Part::Whole), from, 1e-12);
    EXPECT_NEAR(onEdge(cell, right, SharpFeatureGrid::Part::Whole), to, 1e-12);
    EXPECT_NEAR(
      onEdge(cell, left, SharpFeatureGrid::Part::Middle), cell > 0 ? from + beside : from, 1e-12);
    EXPECT_NEAR(
      onEdge(cell, right, SharpFeatureGrid::Part::Middle), cell < 2 ? to - beside : to, 1e-12);
  }
  EXPECT_EQ(onEdge(3, right, SharpFeatureGrid::Part::Whole), -1.0);
  EXPECT_EQ(features.NearestCorner(0, left, any), sharp.Corners[0]);
  EXPECT_EQ(features.NearestCorner(0, right, any), sharp.Corners[1]);
  EXPECT_EQ(
    features.NearestCorner(0, left, [](const Point3& p) { return p[0] > 0.5; }), sharp.Corners[1]);
  EXPECT_EQ(features.NearestCorner(1, left, any), sharp.Corners[2]);
  EXPECT_FALSE(features.NearestCorner(2, left, any).has_value());
}

/// The planes of cell 1 meet on an edge of a cell beside it, the first one as well.
TEST(VertexPlacement, MovesToTheEdgeInANeighbouringCell)
{
  for (const double x : { 0.8, 2.2 })
  {
    const double side = x < 1.5 ? 1.0 : -1.0;
    HermiteGrid grid;
    grid.Shape = { { 4, 2, 2 }, { 1.0, 1.0, 1.0 } };
    grid.Inside.assign(16, 0);
    grid.Inside[1] = grid.Inside[2] = 1;
    grid.Sharp.Segments = { { { { x, 0.1, 0.5 }, { x, 0.9, 0.5 } } } };
    QuadricError planes;
    for (const double y : { 0.2, 0.8 })
    {
      for (const double z : { 0.2, 0.8 })
      {
        planes.Add({ x + side * 0.3, y, z },
          { side * std::sqrt(0.5), 0.0, z < 0.5 ? std::sqrt(0.5) : -std::sqrt(0.5) });
      }
    }
    const DualCells cells(grid);
    const DualContouringParameters parameters;
    const PlacedVertex vertex = VertexPlacement(grid, cells, parameters).Place(1, &planes, 1, 0);
    EXPECT_TRUE(vertex.IsSharp) << x;
    EXPECT_LT(Length(vertex.At - Point3{ x, 0.5, 0.5 }), 1e-9) << x;
  }
}

/// Acceptance 2, with nothing lost to sampling: round edges as well as straight ones.
TEST(QuadricError, EdgesOfExactSolidsAreKept)
{
  struct Case
  {
    const char* Name;
    Value Solid;
    TriangleMesh Edges;
  };
  constexpr int n = 65;
  constexpr double h = 2.0 / (n - 1);
  for (const Case& c : { Case{ "cube", Box, BoxEdges(0, false) },
         { "octahedron", OctahedronValue, OctahedronEdges(0) },
         { "box without ball", BoxWithoutBall, BoxEdges(0, true) },
         { "box and ball", BoxAndBall, BoxEdges(0, true) } })
  {
    double kept = 0.0;
    constexpr unsigned turns = 3;
    for (unsigned seed = 1; seed <= turns; ++seed)
    {
      kept += ShareWithin(c.Edges, ExactContour(n, c.Solid, Rotation(seed)), 0.05 * h) / turns;
    }
    std::printf("%s: %.2f %% of the edges within 0.05 h\n", c.Name, 100.0 * kept);
    EXPECT_GT(kept, 0.998) << c.Name;
  }
}
