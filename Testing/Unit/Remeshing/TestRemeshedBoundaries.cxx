#include "Core/PolyDataTriangles.h"
#include "Remeshing/DelaunayRemesh.h"
#include "Remeshing/SurfaceRemesh.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "vtkSurfaceRemesh.h"

#include <vtkNew.h>
#include <vtkPlaneSource.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;

namespace
{

/// Unit squares of a lattice where `isThere`, each as two triangles, moved by `place`.
TriangleMesh Plate(int count, const std::function<bool(int, int)>& isThere,
  const std::function<Point3(double, double)>& place)
{
  TriangleMesh mesh;
  std::map<std::pair<int, int>, std::int64_t> ids;
  const auto point = [&](int x, int y)
  {
    const auto [at, isNew] = ids.emplace(std::pair(x, y), mesh.Points.size());
    if (isNew)
    {
      mesh.Points.push_back(place(x, y));
    }
    return at->second;
  };
  for (int y = 0; y < count; ++y)
  {
    for (int x = 0; x < count; ++x)
    {
      if (isThere(x, y))
      {
        const std::array<std::int64_t, 4> c{ point(x, y), point(x + 1, y), point(x + 1, y + 1),
          point(x, y + 1) };
        mesh.Triangles.push_back({ c[0], c[1], c[2] });
        mesh.Triangles.push_back({ c[0], c[2], c[3] });
      }
    }
  }
  return mesh;
}

/// A regular polygon, as triangles around its centre.
TriangleMesh Polygon(int corners)
{
  TriangleMesh mesh;
  mesh.Points.push_back({ 1.0, 2.0, 3.0 });
  for (std::int64_t i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / corners;
    mesh.Points.push_back({ 1.0 + 5.0 * std::cos(angle), 2.0 + 5.0 * std::sin(angle), 3.0 });
    mesh.Triangles.push_back({ 0, i + 1, (i + 1) % corners + 1 });
  }
  return mesh;
}

/// A box of unit cubes with one side, the last, left open or not.
TriangleMesh Box(int count, bool isOpen)
{
  TriangleMesh mesh;
  std::map<std::array<int, 3>, std::int64_t> ids;
  const auto point = [&](const std::array<int, 3>& p)
  {
    const auto [at, isNew] = ids.emplace(p, mesh.Points.size());
    if (isNew)
    {
      mesh.Points.push_back({ 1.0 * p[0], 1.0 * p[1], 1.0 * p[2] });
    }
    return at->second;
  };
  for (int side = 0; side < (isOpen ? 5 : 6); ++side)
  {
    const auto u = static_cast<std::size_t>(side / 2), v = (u + 1) % 3, w = (u + 2) % 3;
    for (int k = 0; k < count * count; ++k)
    {
      const auto corner = [&](int i, int j)
      {
        std::array<int, 3> p{};
        p[u] = side % 2 * count;
        p[v] = k % count + i;
        p[w] = k / count + j;
        return point(p);
      };
      std::array<std::int64_t, 4> c{ corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) };
      if (side % 2 == 0)
      {
        std::swap(c[1], c[3]);
      }
      mesh.Triangles.push_back({ c[0], c[1], c[2] });
      mesh.Triangles.push_back({ c[0], c[2], c[3] });
    }
  }
  return mesh;
}

/// Without symmetry, so that no coordinate is a whole number.
TriangleMesh Rotated(TriangleMesh mesh)
{
  const std::array<Point3, 3> axes{ { { 2.0 / 3, -1.0 / 3, 2.0 / 3 },
    { 2.0 / 3, 2.0 / 3, -1.0 / 3 }, { -1.0 / 3, 2.0 / 3, 2.0 / 3 } } };
  for (Point3& p : mesh.Points)
  {
    p = Point3{ 5.3, -3.7, 2.1 } + p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
  }
  return mesh;
}

double BoundaryLength(const TriangleMesh& mesh)
{
  std::map<std::pair<std::int64_t, std::int64_t>, int> uses;
  for (const Triangle& t : mesh.Triangles)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      ++uses[std::minmax(t[c], t[(c + 1) % 3])];
    }
  }
  double length = 0.0;
  for (const auto& [edge, count] : uses)
  {
    const auto at = [&mesh](std::int64_t p) { return mesh.Points[static_cast<std::size_t>(p)]; };
    length += count == 1 ? Length(at(edge.first) - at(edge.second)) : 0.0;
  }
  return length;
}

struct NamedShape
{
  std::string Name;
  TriangleMesh Mesh;
};

/// Corners of 90, 270, 60, 120, 150 and 170 degrees, holes, creases, coarse and fine triangles.
std::vector<NamedShape> FlatShapes()
{
  const auto everywhere = [](int, int) { return true; };
  const auto flat = [](double x, double y) { return Point3{ x, y, 0.0 }; };
  const auto skewed = [](double x, double y) { return Point3{ x + y / std::sqrt(3.0), y, 0.0 }; };
  std::vector<NamedShape> shapes;
  shapes.push_back({ "plate", Plate(10, everywhere, flat) });
  shapes.push_back({ "L",
    Plate(
      10, [](int x, int y) { return x < 5 || y < 5; }, flat) });
  shapes.push_back({ "hole",
    Plate(
      10, [](int x, int y) { return x < 3 || x > 6 || y < 3 || y > 6; }, flat) });
  shapes.push_back({ "corners of 60 and 120 degrees", Plate(10, everywhere, skewed) });
  shapes.push_back({ "two triangles", Plate(1, everywhere, skewed) });
  shapes.push_back({ "triangle", Polygon(3) });
  shapes.push_back({ "hexagon", Polygon(6) });
  shapes.push_back({ "corners of 150 degrees", Polygon(12) });
  shapes.push_back({ "corners of 170 degrees", Polygon(36) });
  return shapes;
}

std::vector<NamedShape> BentShapes()
{
  const auto everywhere = [](int, int) { return true; };
  std::vector<NamedShape> shapes;
  shapes.push_back({ "angle",
    Plate(10, everywhere,
      [](double x, double y) {
        return Point3{ std::min(x, 5.0), y, std::max(x - 5.0, 0.0) };
      }) });
  // The crease turns by 60 degrees in the middle.
  shapes.push_back({ "turning crease",
    Plate(10, everywhere,
      [](double x, double y)
      {
        const double shift = std::abs(y - 5.0) / std::sqrt(3.0);
        return Point3{ std::min(x, 5.0) + shift, y, 2.0 * std::max(x - 5.0, 0.0) };
      }) });
  shapes.push_back({ "cube", Box(6, false) });
  shapes.push_back({ "open box", Box(6, true) });
  shapes.push_back({ "coarse box", Box(1, true) });
  return shapes;
}

void ExpectKept(const NamedShape& shape, const TriangleMesh& made, const std::string& how)
{
  SCOPED_TRACE(shape.Name + ", " + how);
  ASSERT_FALSE(made.Triangles.empty());
  const double area = SurfaceArea(shape.Mesh);
  EXPECT_NEAR(SurfaceArea(made), area, 1e-9 * area);
  const double length = BoundaryLength(shape.Mesh);
  EXPECT_NEAR(BoundaryLength(made), length, 1e-9 * length);
  EXPECT_EQ(EulerCharacteristic(made), EulerCharacteristic(shape.Mesh));
}

}

TEST(RemeshedBoundaries, PlateOfTheFilter)
{
  vtkNew<vtkPlaneSource> plate;
  plate->SetOrigin(0.0, 0.0, 0.0);
  plate->SetPoint1(10.0, 0.0, 0.0);
  plate->SetPoint2(0.0, 10.0, 0.0);
  plate->SetResolution(20, 20);
  vtkNew<vtkSurfaceRemesh> remesh;
  remesh->SetInputConnection(plate->GetOutputPort());
  for (const double relative : { 0.5, 1.0, 2.0, 5.0, 40.0 })
  {
    remesh->SetRelativeEdgeLength(relative);
    for (const int method : { vtkSurfaceRemesh::Isotropic, vtkSurfaceRemesh::Delaunay })
    {
      remesh->SetMethod(method);
      remesh->Update();
      const TriangleMesh made = ToTriangleMesh(remesh->GetOutput());
      EXPECT_NEAR(SurfaceArea(made), 100.0, 1e-4) << relative; // points are floats
      EXPECT_NEAR(BoundaryLength(made), 40.0, 1e-5) << relative;
    }
  }
}

TEST(RemeshedBoundaries, IsotropicKeepsCorners)
{
  for (const auto& shapes : { FlatShapes(), BentShapes() })
  {
    for (NamedShape shape : shapes)
    {
      shape.Mesh = Rotated(std::move(shape.Mesh));
      for (const double relative : { 0.4, 1.0, 2.0, 3.7, 30.0 })
      {
        SurfaceRemeshParameters parameters;
        parameters.EdgeLength = relative * MeanEdgeLength(shape.Mesh);
        ExpectKept(
          shape, RemeshSurface(shape.Mesh, parameters).Mesh, "length " + std::to_string(relative));
      }
    }
  }
}

TEST(RemeshedBoundaries, DelaunayKeepsCorners)
{
  for (const auto& shapes : { FlatShapes(), BentShapes() })
  {
    for (NamedShape shape : shapes)
    {
      shape.Mesh = Rotated(std::move(shape.Mesh));
      for (const double relative : { 0.4, 1.0, 2.0, 3.7 })
      {
        SurfaceRemeshParameters parameters;
        parameters.EdgeLength = relative * MeanEdgeLength(shape.Mesh);
        ExpectKept(
          shape, DelaunayRemesh(shape.Mesh, parameters).Mesh, "length " + std::to_string(relative));
      }
    }
  }
}

TEST(RemeshedBoundaries, SimplificationKeepsCorners)
{
  for (const auto& shapes : { FlatShapes(), BentShapes() })
  {
    for (NamedShape shape : shapes)
    {
      shape.Mesh = Rotated(std::move(shape.Mesh));
      const auto count = static_cast<std::int64_t>(shape.Mesh.Triangles.size());
      for (const std::int64_t target : { count / 2, count / 5, std::int64_t{ 12 } })
      {
        const TriangleMesh made =
          SimplifySurface(shape.Mesh, std::max<std::int64_t>(target, 12)).Mesh;
        ExpectKept(shape, made, "to " + std::to_string(target));
      }
    }
  }
  // Flat parts can be simplified as far as the corners allow; others lose their shape, but not the
  // boundary.
  for (const NamedShape& shape : FlatShapes())
  {
    ExpectKept(shape, SimplifySurface(shape.Mesh, 1).Mesh, "as far as possible");
  }
  const TriangleMesh made = SimplifySurface(FlatShapes()[0].Mesh, 1).Mesh;
  EXPECT_LE(made.Triangles.size(), 10U);
  for (const NamedShape& shape : BentShapes())
  {
    EXPECT_NEAR(BoundaryLength(SimplifySurface(shape.Mesh, 1).Mesh), BoundaryLength(shape.Mesh),
      1e-9 * BoundaryLength(shape.Mesh));
  }
}

/// A fine round boundary is kept to the point, while the triangles away from it become larger.
TEST(RemeshedBoundaries, RoundBoundaryIsKept)
{
  const TriangleMesh bowl = Plate(
    60, [](int, int) { return true; },
    [](double x, double y)
    {
      // The border of the square becomes a circle.
      const double u = (x - 30.0) / 30.0, v = (y - 30.0) / 30.0;
      const double radius = std::max(std::abs(u), std::abs(v));
      const double scale = radius > 0.0 ? radius / std::hypot(u, v) : 0.0;
      return Point3{ u * scale, v * scale, 0.5 * radius * radius };
    });
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 4.0 * MeanEdgeLength(bowl);
  const std::vector<TriangleMesh> results{ RemeshSurface(bowl, parameters).Mesh,
    SimplifySurface(bowl, 600).Mesh };
  for (const TriangleMesh& made : results)
  {
    EXPECT_NEAR(BoundaryLength(made), BoundaryLength(bowl), 1e-9);
    EXPECT_NEAR(SurfaceArea(made), SurfaceArea(bowl), 0.01 * SurfaceArea(bowl));
    EXPECT_LT(made.Triangles.size(), 1500U);
    EXPECT_TRUE(FindDefects(made).NonManifoldTriangles.empty());
  }
  // Delaunay: within its tolerance, a tenth of the edge length.
  EXPECT_NEAR(BoundaryLength(DelaunayRemesh(bowl, parameters).Mesh), BoundaryLength(bowl), 0.05);
}
