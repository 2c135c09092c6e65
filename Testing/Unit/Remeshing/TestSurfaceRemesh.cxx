#include "Remeshing/SurfaceRemesh.h"

#include "Core/PolyDataTriangles.h"
#include "Remeshing/DelaunayRemesh.h"
#include "Remeshing/SurfaceRepair.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "TriangleAngles.h"
#include "vtkSurfaceRemesh.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using isthmus::testing::TriangleAngles;

namespace
{

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  return sphere->GetOutput();
}

}

TEST(SurfaceRemesh, EvensOutASphere)
{
  const TriangleMesh sphere = ToTriangleMesh(Sphere());
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.1;
  const RemeshedSurface result = RemeshSurface(sphere, parameters);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(result.Mesh), 2);
  EXPECT_NEAR(MeanEdgeLength(result.Mesh), 0.1, 0.01);
  EXPECT_GT(TriangleAngles(result.Mesh).Smallest, 20.0);
  EXPECT_LT(TriangleAngles(sphere).Smallest, 6.0);
  // Points lie on the old surface, in the triangles recorded for them.
  for (std::size_t i = 0; i < result.Mesh.Points.size(); ++i)
  {
    const SurfaceLocation& where = result.Locations[i];
    Point3 p{ 0, 0, 0 };
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto id = sphere.Triangles[static_cast<std::size_t>(where.Triangle)][c];
      p = p + where.Weights[c] * sphere.Points[static_cast<std::size_t>(id)];
    }
    const Point3 d = p - result.Mesh.Points[i];
    ASSERT_LT(std::sqrt(Dot(d, d)), 1e-9);
  }
}

TEST(SurfaceRemesh, SurfacesFarFromTheOriginAreRemeshedAlike)
{
  TriangleMesh near = ToTriangleMesh(Sphere());
  for (Point3& p : near.Points)
  {
    for (double& x : p)
    {
      x = std::round(x * 0x1p20) * 0x1p-20; // so that moving it rounds nothing
    }
  }
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.2;
  parameters.MaximumPoints = 100000;
  for (const Point3& shift : { Point3{ 1e7, -2e7, 0.0 }, Point3{ 1e9, 1e9, 1e9 } })
  {
    TriangleMesh far = near;
    for (Point3& p : far.Points)
    {
      p = p + shift;
    }
    for (const auto& remesh :
      std::vector<std::function<RemeshedSurface(const SurfaceView&)>>{ [&](const SurfaceView& mesh)
        { return RemeshSurface(mesh, parameters); },
        [&](const SurfaceView& mesh) { return DelaunayRemesh(mesh, parameters); },
        [](const SurfaceView& mesh) { return SimplifySurface(mesh, 500); } })
    {
      const TriangleMesh expected = remesh(near).Mesh;
      const TriangleMesh made = remesh(far).Mesh;
      EXPECT_TRUE(FindDefects(made).None());
      EXPECT_NEAR(SurfaceArea(made), SurfaceArea(expected), 0.01 * SurfaceArea(expected));
      EXPECT_NEAR(SignedVolume(made), SignedVolume(expected), 0.01 * SignedVolume(expected));
      EXPECT_LT(Length(ComputeBounds(made).Max - ComputeBounds(far).Max), 0.05);
    }
  }
}

TEST(SurfaceRemesh, KeepsTheEdgesOfACube)
{
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.1;
  const RemeshedSurface result =
    RemeshSurface(isthmus::testing::Cube({ 0, 0, 0 }, 1.0), parameters);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_NEAR(SignedVolume(result.Mesh), 1.0, 1e-9);
  EXPECT_GT(result.Mesh.Triangles.size(), 800u);
}

TEST(SurfaceRemesh, PointDataAreCarriedOver)
{
  const auto sphere = Sphere();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(sphere->GetPoint(i)[2]);
  }
  sphere->GetPointData()->SetScalars(height);
  vtkNew<vtkSurfaceRemesh> remesh;
  remesh->SetInputData(sphere);
  for (const int target :
    { vtkSurfaceRemesh::ByRelativeEdgeLength, vtkSurfaceRemesh::ByNumberOfTriangles })
  {
    remesh->SetTarget(target);
    remesh->SetNumberOfTriangles(1000);
    remesh->Update();
    vtkPolyData* result = remesh->GetOutput();
    auto* carried = vtkDoubleArray::SafeDownCast(result->GetPointData()->GetScalars());
    ASSERT_NE(carried, nullptr);
    // A linear field is carried exactly to points on the old triangles, and approximately to points
    // beside them.
    const double tolerance = target == vtkSurfaceRemesh::ByNumberOfTriangles ? 0.02 : 1e-9;
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(carried->GetValue(i), result->GetPoint(i)[2], tolerance);
    }
  }
}

TEST(SurfaceRemesh, SimplifiesToACount)
{
  const TriangleMesh sphere = ToTriangleMesh(Sphere());
  const RemeshedSurface result = SimplifySurface(sphere, 500);
  EXPECT_NEAR(static_cast<double>(result.Mesh.Triangles.size()), 500.0, 2.0);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_NEAR(SignedVolume(result.Mesh), SignedVolume(sphere), 0.02);
}

/// Collapses at a point of many triangles are slow.
TEST(SurfaceRemesh, SimplifyingFansReportsAndStopsOften)
{
  constexpr std::int64_t sides = 200;
  TriangleMesh drum; // a cylinder closed by two fans
  drum.Points = { { 0, 0, 0 }, { 0, 0, 3 } };
  for (std::int64_t i = 0; i < sides; ++i)
  {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / sides;
    const std::int64_t here = 2 + 2 * i, next = 2 + 2 * ((i + 1) % sides);
    drum.Points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    drum.Points.push_back({ std::cos(angle), std::sin(angle), 3.0 });
    drum.Triangles.push_back({ 0, next, here });
    drum.Triangles.push_back({ 1, here + 1, next + 1 });
    drum.Triangles.push_back({ here, next, next + 1 });
    drum.Triangles.push_back({ here, next + 1, here + 1 });
  }
  int calls = 0;
  const auto count = [&](double)
  {
    ++calls;
    return true;
  };
  const RemeshedSurface result = SimplifySurface(drum, 200, count);
  EXPECT_NEAR(static_cast<double>(result.Mesh.Triangles.size()), 200.0, 2.0);
  EXPECT_GE(calls, (3 * 800 - 3 * 200) / 2 / 3 / 16); // each collapse removes three edges
  EXPECT_THROW(SimplifySurface(drum, 200, [](double done) { return done < 0.1; }), Cancelled);
}

TEST(SurfaceRemesh, ATargetOfOneTriangleKeepsAClosedSurface)
{
  const RemeshedSurface result = SimplifySurface(ToTriangleMesh(Sphere()), 1);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(result.Mesh), 2);
  EXPECT_LT(result.Mesh.Triangles.size(), 50U);
}

// The area of a needle is lost in rounding, and any of its corners may lie between the others.
TEST(SurfaceRemesh, PointsOfANeedleAreLocatedAlongIt)
{
  const Point3 along{ 0.6, -0.7, 0.3 };
  for (const std::array<double, 3>& x : { std::array{ 0.0, 3.0, -1.0 },
         std::array{ -1.0, 0.0, 3.0 }, std::array{ 3.0, -1.0, 0.0 }, std::array{ 0.1, 1.0, -1.0 } })
  {
    TriangleMesh needle;
    needle.Points = { x[0] * along + Point3{ 0, 0, 1e-11 }, x[1] * along, x[2] * along };
    needle.Triangles = { { 0, 1, 2 } };
    std::vector<Point3> points = needle.Points;
    points.push_back(-0.27 * along);
    points.push_back(0.77 * along);
    const std::vector<SurfaceLocation> locations = LocateOn(needle, points);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto& w = locations[i].Weights;
      EXPECT_NEAR(w[0] + w[1] + w[2], 1.0, 1e-12);
      const Point3 p = w[0] * needle.Points[0] + w[1] * needle.Points[1] + w[2] * needle.Points[2];
      EXPECT_LT(Length(p - points[i]), 1e-9) << i;
      if (i < 3)
      {
        EXPECT_NEAR(w[i], 1.0, 1e-9) << "a corner has its own data";
      }
    }
  }
}

TEST(SurfaceRemesh, BoundariesAreFine)
{
  TriangleMesh open = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  open.Triangles.resize(10);
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.2;
  const RemeshedSurface result = RemeshSurface(open, parameters);
  EXPECT_GT(result.Mesh.Triangles.size(), 100u);
  EXPECT_EQ(FindDefects(result.Mesh).NonManifoldTriangles.size(), 0u);
}

TEST(SurfaceRemesh, BadInputThrowsAndStoppingCancels)
{
  TriangleMesh twice = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  twice.Triangles.push_back(twice.Triangles[3]);
  EXPECT_THROW(RemeshSurface(twice, {}), std::invalid_argument);
  EXPECT_THROW(SimplifySurface(twice, 4), std::invalid_argument);
  const TriangleMesh cube = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  SurfaceRemeshParameters parameters;
  for (const double length : { 0.0, -1.0, 1e-5, std::numeric_limits<double>::quiet_NaN() })
  {
    parameters.EdgeLength = length;
    EXPECT_THROW(RemeshSurface(cube, parameters), std::invalid_argument) << length;
  }
  EXPECT_THROW(SimplifySurface(cube, 0), std::invalid_argument);
  parameters.EdgeLength = 0.06;
  EXPECT_THROW(RemeshSurface(cube, parameters, [](double f) { return f < 0.1; }), Cancelled);
}

TEST(SurfaceRemesh, FertilityKeepsItsGenus)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const TriangleMesh mesh = ToTriangleMesh(
    isthmus::testing::ReadSurface(isthmus::testing::SharedDataFolder() / "surfaces/fertility.off"));
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = MeanEdgeLength(mesh);
  const RemeshedSurface result = RemeshSurface(mesh, parameters);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(result.Mesh), -6);
  EXPECT_NEAR(SignedVolume(result.Mesh) / SignedVolume(mesh), 1.0, 1e-2);
}

TEST(SurfaceRemesh, SimplifiesAnOpenSurfaceToACount)
{
  // A tube whose two long rims stay: half a triangle fewer for each of their edges.
  constexpr int around = 200, along = 6;
  TriangleMesh tube;
  for (int j = 0; j <= along; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * 3.14159265358979 * i / around;
      const double radius = 1.0 + 0.05 * std::cos(50.0 * angle);
      tube.Points.push_back({ radius * std::cos(angle), radius * std::sin(angle), 0.04 * j });
      const std::int64_t a = j * around + i, b = j * around + (i + 1) % around;
      if (j < along)
      {
        tube.Triangles.push_back({ a, b, a + around });
        tube.Triangles.push_back({ b, b + around, a + around });
      }
    }
  }
  const RemeshedSurface result = SimplifySurface(tube, 800);
  EXPECT_NEAR(static_cast<double>(result.Mesh.Triangles.size()), 800.0, 60.0);
}

TEST(SurfaceRepair, ADuplicateTriangleLeavesTheRestUnchanged)
{
  TriangleMesh cube = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  cube.Triangles.push_back(cube.Triangles[3]);
  const RepairedSurface repaired = RepairSurface(cube);
  EXPECT_EQ(repaired.Mesh.Points.size(), 8u);
  EXPECT_EQ(repaired.Mesh.Triangles.size(), 12u);
  EXPECT_TRUE(FindDefects(repaired.Mesh).None());
  EXPECT_NEAR(SignedVolume(repaired.Mesh), 1.0, 1e-12);
}

namespace
{

/// Least angle and largest radius of a circumscribed circle, of triangles without a point at which
/// `isFeature`.
template <typename IsFeature>
std::array<double, 2> LeastAngleAndLargestCircle(const TriangleMesh& mesh, IsFeature&& isFeature)
{
  double least = 180.0, largest = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c % 3])]; };
    for (std::size_t c = 0; c < 3; ++c)
    {
      const Point3 a = at(c + 1) - at(c), b = at(c + 2) - at(c);
      const double sine = Length(Cross(a, b)) / (Length(a) * Length(b));
      const double angle = std::atan2(sine, Dot(a, b) / (Length(a) * Length(b)));
      largest = std::max(largest, 0.5 * Length(at(c + 1) - at(c + 2)) / sine);
      if (!isFeature(at(0)) && !isFeature(at(1)) && !isFeature(at(2)))
      {
        least = std::min(least, angle * 180.0 / M_PI);
      }
    }
  }
  return { least, largest };
}

}

TEST(SurfaceRemesh, DelaunayKeepsItsBounds)
{
  TriangleMesh spheres = ToTriangleMesh(Sphere());
  const TriangleMesh second = spheres; // next to the first, small
  const auto shift = static_cast<std::int64_t>(spheres.Points.size());
  for (const Point3& p : second.Points)
  {
    spheres.Points.push_back(0.2 * p + Point3{ 3.0, 0.0, 0.0 });
  }
  for (const Triangle& t : second.Triangles)
  {
    spheres.Triangles.push_back({ t[0] + shift, t[1] + shift, t[2] + shift });
  }
  for (const double angle : { 20.0, 28.0 })
  {
    SurfaceRemeshParameters parameters;
    parameters.EdgeLength = 0.15;
    parameters.MinimumAngle = angle;
    parameters.MaximumDistance = 0.002;
    const RemeshedSurface result = DelaunayRemesh(spheres, parameters);
    EXPECT_TRUE(FindDefects(result.Mesh).None());
    EXPECT_EQ(EulerCharacteristic(result.Mesh), 4) << "both parts are there";
    const auto [least, largest] =
      LeastAngleAndLargestCircle(result.Mesh, [](const Point3&) { return false; });
    EXPECT_GE(least, angle - 1e-9);
    EXPECT_LE(largest, 0.15 / std::sqrt(3.0) * (1.0 + 1e-6));
    EXPECT_NEAR(SignedVolume(result.Mesh), SignedVolume(spheres), 0.002 * SurfaceArea(spheres));
    EXPECT_GT(SignedVolume(result.Mesh), 0.0) << "faces as the old surface does";
    ASSERT_EQ(result.Locations.size(), result.Mesh.Points.size());
    for (const Point3& p : result.Mesh.Points)
    {
      const double out =
        std::min(std::abs(Length(p) - 1.0), std::abs(Length(p - Point3{ 3.0, 0.0, 0.0 }) - 0.2));
      ASSERT_LT(out, 0.003); // the old sphere is a polyhedron
    }
  }
}

TEST(SurfaceRemesh, DelaunayKeepsSharpEdgesAndBoundaries)
{
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.2;
  TriangleMesh cube = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  const RemeshedSurface result = DelaunayRemesh(cube, parameters);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(result.Mesh), 2);
  EXPECT_NEAR(SignedVolume(result.Mesh), 1.0, 1e-9);
  EXPECT_GT(result.Mesh.Triangles.size(), 200u);
  cube.Triangles.resize(10); // two triangles less: one side is open
  const RemeshedSurface open = DelaunayRemesh(cube, parameters);
  EXPECT_EQ(EulerCharacteristic(open.Mesh), EulerCharacteristic(cube));
  EXPECT_NEAR(SurfaceArea(open.Mesh), SurfaceArea(cube), 1e-9);
  EXPECT_FALSE(FindDefects(open.Mesh).BoundaryTriangles.empty());
}

namespace
{

/// Squares of length 1 in the plane z = 0 at the places where `isThere`, each as two triangles.
template <typename IsThere>
TriangleMesh Squares(std::int64_t count, IsThere&& isThere)
{
  TriangleMesh mesh;
  std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> ids;
  const auto point = [&](std::int64_t x, std::int64_t y)
  {
    const auto [at, isNew] = ids.emplace(std::pair(x, y), mesh.Points.size());
    if (isNew)
    {
      mesh.Points.push_back({ static_cast<double>(x), static_cast<double>(y), 0.0 });
    }
    return at->second;
  };
  for (std::int64_t y = 0; y < count; ++y)
  {
    for (std::int64_t x = 0; x < count; ++x)
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

/// Turned about all axes and moved.
TriangleMesh Rotate(TriangleMesh mesh)
{
  const std::array<Point3, 3> axes{ { { 2.0 / 3, -1.0 / 3, 2.0 / 3 },
    { 2.0 / 3, 2.0 / 3, -1.0 / 3 }, { -1.0 / 3, 2.0 / 3, 2.0 / 3 } } };
  for (Point3& p : mesh.Points)
  {
    p = Point3{ 5.0, -3.0, 2.0 } + p[0] * axes[0] + p[1] * axes[1] + p[2] * axes[2];
  }
  return mesh;
}

}

/// They have no tetrahedra to refine: CGAL's Mesh_3 did not terminate, or failed.
TEST(SurfaceRemesh, DelaunayOfPartsInAPlane)
{
  const std::vector<TriangleMesh> sheets{ Squares(1, [](auto, auto) { return true; }),
    Squares(6, [](auto, auto) { return true; }),
    Squares(7, [](auto x, auto y) { return x % 4 != 2 || y % 4 != 2; }), // four holes
    Squares(5, [](auto x, auto y) { return x == 0 || y == 4; }) };
  for (const TriangleMesh& flat : sheets)
  {
    for (const TriangleMesh& sheet : { flat, Rotate(flat) })
    {
      for (const double length : { 3.0, 0.4 })
      {
        SurfaceRemeshParameters parameters;
        parameters.EdgeLength = length;
        const RemeshedSurface made = DelaunayRemesh(sheet, parameters);
        EXPECT_NEAR(SurfaceArea(made.Mesh), SurfaceArea(sheet), 1e-9 * SurfaceArea(sheet));
        EXPECT_EQ(EulerCharacteristic(made.Mesh), EulerCharacteristic(sheet));
        const auto [least, largest] =
          LeastAngleAndLargestCircle(made.Mesh, [](const Point3&) { return false; });
        EXPECT_GE(least, parameters.MinimumAngle - 1e-9)
          << sheet.Triangles.size() << " triangles, " << length;
        EXPECT_LE(largest, length / std::sqrt(3.0) * (1.0 + 1e-6));
        const auto facing = [](const TriangleMesh& mesh)
        {
          const Triangle& t = mesh.Triangles[0];
          return Cross(mesh.Points[static_cast<std::size_t>(t[1])] -
              mesh.Points[static_cast<std::size_t>(t[0])],
            mesh.Points[static_cast<std::size_t>(t[2])] -
              mesh.Points[static_cast<std::size_t>(t[0])]);
        };
        EXPECT_GT(Dot(facing(made.Mesh), facing(sheet)), 0.0);
      }
    }
  }
}

TEST(SurfaceRemesh, DelaunayRefusesFoldedPartsAndStopsInAPlane)
{
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.05;
  const TriangleMesh sheet = Squares(6, [](auto, auto) { return true; });
  EXPECT_THROW(
    DelaunayRemesh(sheet, parameters, [](double done) { return done < 0.5; }), Cancelled);
  parameters.EdgeLength = 0.1;
  // Both sides of a square, closed; a square folded along its diagonal; a strip across itself.
  const TriangleMesh coin{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 }, { 2, 1, 3 }, { 1, 0, 3 } } };
  const TriangleMesh folded{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0.9, 0.1, 0 } },
    { { 0, 1, 2 }, { 0, 2, 3 } } };
  TriangleMesh across = Squares(4, [](auto x, auto y) { return x == 0 || y == 3 || x == 3; });
  for (Point3& p : across.Points)
  {
    p = p[1] < 2.5 && p[0] > 2.5 ? Point3{ p[0] - 4.0 * (3.0 - p[1]) / 3.0, p[1], 0.0 } : p;
  }
  for (const TriangleMesh& mesh : { coin, folded, across })
  {
    try
    {
      DelaunayRemesh(mesh, parameters);
      ADD_FAILURE() << mesh.Points.size();
    }
    catch (const std::exception& error)
    {
      EXPECT_NE(std::string(error.what()).find("covers itself"), std::string::npos) << error.what();
    }
  }
}

TEST(SurfaceRemesh, DelaunayByTheFilterInterpolatesAndStops)
{
  vtkNew<vtkSurfaceRemesh> filter;
  const auto sphere = Sphere();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(sphere->GetPoint(i)[2]);
  }
  sphere->GetPointData()->AddArray(height);
  filter->SetInputData(sphere);
  filter->SetMethod(vtkSurfaceRemesh::Delaunay);
  filter->SetTarget(vtkSurfaceRemesh::ByEdgeLength);
  filter->SetEdgeLength(0.2);
  filter->Update();
  vtkPolyData* made = filter->GetOutput();
  ASSERT_GT(made->GetNumberOfPoints(), 200);
  vtkDataArray* heights = made->GetPointData()->GetArray("Height");
  ASSERT_NE(heights, nullptr);
  for (vtkIdType i = 0; i < made->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(heights->GetTuple1(i), made->GetPoint(i)[2], 1e-5);
  }
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.06;
  EXPECT_THROW(
    DelaunayRemesh(ToTriangleMesh(sphere), parameters, [](double done) { return done < 0.3; }),
    Cancelled);
  parameters.MaximumPoints = 1000;
  EXPECT_THROW(DelaunayRemesh(ToTriangleMesh(sphere), parameters), std::invalid_argument);
  parameters.EdgeLength = 0.0;
  EXPECT_THROW(DelaunayRemesh(ToTriangleMesh(sphere), parameters), std::invalid_argument);
}

TEST(SurfaceRemesh, ReportsValuesOutOfRange)
{
  const std::pair<const char*, std::function<void(vtkSurfaceRemesh*)>> cases[] = {
    { "Target is 3, but it must be from 0 to 2", [](auto* f) { f->SetTarget(3); } },
    { "Method is -1, but it must be from 0 to 1", [](auto* f) { f->SetMethod(-1); } },
    { "RelativeEdgeLength is 0", [](auto* f) { f->SetRelativeEdgeLength(0.0); } },
    { "EdgeLength is -1", [](auto* f) { f->SetEdgeLength(-1.0); } },
    { "NumberOfTriangles is 0", [](auto* f) { f->SetNumberOfTriangles(0); } },
    { "MinimumAngle is 31, but it must be from 0 to 30",
      [](auto* f) { f->SetMinimumAngle(31.0); } },
    { "MaximumDistance is -1", [](auto* f) { f->SetMaximumDistance(-1.0); } },
    { "NumberOfIterations is 0", [](auto* f) { f->SetNumberOfIterations(0); } },
    { "FeatureAngle is 181", [](auto* f) { f->SetFeatureAngle(181.0); } },
  };
  for (const auto& [words, spoil] : cases)
  {
    vtkNew<vtkSurfaceRemesh> filter;
    vtkNew<vtkTest::ErrorObserver> errors;
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->SetInputData(Sphere());
    spoil(filter);
    filter->Update();
    EXPECT_NE(errors->GetErrorMessage().find(words), std::string::npos)
      << words << ": " << errors->GetErrorMessage();
  }
}

namespace
{

/// Remeshed to a target and method; `mesh` gets the array Height, the third coordinate.
vtkSmartPointer<vtkPolyData> Remesh(const TriangleMesh& mesh, int target, int method)
{
  vtkNew<vtkPolyData> surface;
  SetMesh(mesh, surface);
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (const Point3& p : mesh.Points)
  {
    height->InsertNextValue(p[2]);
  }
  surface->GetPointData()->AddArray(height);
  vtkNew<vtkSurfaceRemesh> remesh;
  remesh->SetInputData(surface);
  remesh->SetTarget(target);
  remesh->SetMethod(method);
  remesh->SetRelativeEdgeLength(3.0);
  remesh->SetNumberOfTriangles(1000);
  remesh->Update();
  return remesh->GetOutput();
}

}

// Before and after the others, so that the points between them get new numbers.
TEST(SurfaceRemesh, PointsThatNoTriangleUsesAreDropped)
{
  const TriangleMesh sphere = ToTriangleMesh(Sphere());
  for (const auto& [target, method] :
    { std::pair<int, int>{ vtkSurfaceRemesh::ByRelativeEdgeLength, vtkSurfaceRemesh::Isotropic },
      { vtkSurfaceRemesh::ByNumberOfTriangles, vtkSurfaceRemesh::Isotropic },
      { vtkSurfaceRemesh::ByRelativeEdgeLength, vtkSurfaceRemesh::Delaunay } })
  {
    const auto expected = Remesh(sphere, target, method);
    ASSERT_GT(expected->GetNumberOfPoints(), 100);
    for (const double place : { 1e5, std::nan("") })
    {
      SCOPED_TRACE(std::to_string(place) + ", target " + std::to_string(target) + ", method " +
        std::to_string(method));
      TriangleMesh more = sphere;
      more.Points.insert(more.Points.begin(), { place, 0.0, place });
      more.Points.push_back({ 0.0, place, -place });
      for (Triangle& t : more.Triangles)
      {
        t = { t[0] + 1, t[1] + 1, t[2] + 1 };
      }
      const auto result = Remesh(more, target, method);
      EXPECT_EQ(result->GetNumberOfPoints(), expected->GetNumberOfPoints());
      EXPECT_LT(result->GetLength(), 4.0);
      EXPECT_TRUE(FindDefects(ToTriangleMesh(result)).None());
      EXPECT_NEAR(
        SignedVolume(ToTriangleMesh(result)), SignedVolume(ToTriangleMesh(expected)), 0.05);
      vtkDataArray* const height = result->GetPointData()->GetArray("Height");
      ASSERT_NE(height, nullptr);
      ASSERT_EQ(height->GetNumberOfTuples(), result->GetNumberOfPoints());
      for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
      {
        ASSERT_NEAR(height->GetTuple1(i), result->GetPoint(i)[2], 0.02);
      }
    }
  }
}

TEST(SurfaceRemesh, WarnsIfVolumeOrAreaChanges)
{
  const auto says = [](const TriangleMesh& mesh, auto&& set)
  {
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    vtkNew<vtkSurfaceRemesh> filter;
    filter->SetInputData(surface);
    set(filter.Get());
    vtkNew<vtkTest::ErrorObserver> said;
    filter->AddObserver(vtkCommand::WarningEvent, said);
    filter->Update();
    const TriangleMesh made = ToTriangleMesh(filter->GetOutput());
    const bool isClosed = FindDefects(mesh).BoundaryTriangles.empty();
    const double change = isClosed ? SignedVolume(made) / SignedVolume(mesh) - 1.0
                                   : SurfaceArea(made) / SurfaceArea(mesh) - 1.0;
    const std::string message = said->GetWarningMessage();
    EXPECT_EQ(said->GetWarning(), std::abs(change) > 0.01) << change << message;
    EXPECT_EQ(
      message.find(isClosed ? "changed the volume" : "changed the area") != std::string::npos,
      said->GetWarning())
      << message;
    return said->GetWarning();
  };
  const auto nothing = [](vtkSurfaceRemesh*) {};
  const TriangleMesh sphere = ToTriangleMesh(Sphere());
  TriangleMesh needle = sphere, half = sphere;
  for (Point3& p : needle.Points)
  {
    p[2] *= 1000.0;
  }
  half.Triangles.erase(std::remove_if(half.Triangles.begin(), half.Triangles.end(),
                         [&](const Triangle& t) { return half.Points[At(t[0])][2] < 0.1; }),
    half.Triangles.end());
  EXPECT_FALSE(says(sphere, nothing));
  EXPECT_TRUE(says(needle, nothing));
  EXPECT_TRUE(says(sphere, [](auto* f) { f->SetRelativeEdgeLength(8.0); }));
  EXPECT_TRUE(says(half, [](auto* f) { f->SetRelativeEdgeLength(8.0); }));
  EXPECT_FALSE(says(sphere,
    [](auto* f)
    {
      f->SetTarget(vtkSurfaceRemesh::ByNumberOfTriangles);
      f->SetNumberOfTriangles(40); // keeps the volume
    }));
}
