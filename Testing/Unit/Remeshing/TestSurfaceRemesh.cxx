#include "Remeshing/SurfaceRemesh.h"

#include "Core/PolyDataTriangles.h"
#include "Remeshing/SurfaceRepair.h"
#include "SharedData.h"
#include "SurfaceFiles.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/MeshQuality.h"
#include "vtkSurfaceRemesh.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace isthmus;

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

QualitySummary Quality(const TriangleMesh& mesh)
{
  std::vector<CellAngles> cells;
  return MeasureQuality(mesh, 18, cells);
}

}

TEST(SurfaceRemesh, EvensOutASphere)
{
  const TriangleMesh sphere = MeshOf(Sphere());
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = 0.1;
  const RemeshedSurface result = RemeshSurface(sphere, parameters);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_EQ(EulerCharacteristic(result.Mesh), 2);
  EXPECT_NEAR(MeanEdgeLength(result.Mesh), 0.1, 0.01);
  EXPECT_GT(Quality(result.Mesh).SmallestAngle, 20.0);
  EXPECT_LT(Quality(sphere).SmallestAngle, 6.0);
  // Points lie on the old surface, where the old one says they do.
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
    // A linear field is carried exactly to points on the old triangles, and nearly beside them.
    const double tolerance = target == vtkSurfaceRemesh::ByNumberOfTriangles ? 0.02 : 1e-9;
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(carried->GetValue(i), result->GetPoint(i)[2], tolerance);
    }
  }
}

TEST(SurfaceRemesh, SimplifiesToACount)
{
  const TriangleMesh sphere = MeshOf(Sphere());
  const RemeshedSurface result = SimplifySurface(sphere, 500);
  EXPECT_NEAR(static_cast<double>(result.Mesh.Triangles.size()), 500.0, 2.0);
  EXPECT_TRUE(FindDefects(result.Mesh).None());
  EXPECT_NEAR(SignedVolume(result.Mesh), SignedVolume(sphere), 0.02);
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

TEST(SurfaceRemesh, BadInputEndsInASentenceAndStoppingInCancelled)
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
  parameters.EdgeLength = 0.02;
  EXPECT_THROW(RemeshSurface(cube, parameters, [](double f) { return f < 0.1; }), Cancelled);
}

TEST(SurfaceRemesh, FertilityKeepsItsGenus)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const TriangleMesh mesh = MeshOf(
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

TEST(SurfaceRepair, ATriangleThatIsThereTwiceLeavesTheRestAsItIs)
{
  TriangleMesh cube = isthmus::testing::Cube({ 0, 0, 0 }, 1.0);
  cube.Triangles.push_back(cube.Triangles[3]);
  const RepairedSurface repaired = RepairSurface(cube);
  EXPECT_EQ(repaired.Mesh.Points.size(), 8u);
  EXPECT_EQ(repaired.Mesh.Triangles.size(), 12u);
  EXPECT_TRUE(FindDefects(repaired.Mesh).None());
  EXPECT_NEAR(SignedVolume(repaired.Mesh), 1.0, 1e-12);
}
