#include "Contouring/DualContouring.h"

#include "DualContours.h"
#include "SurfaceFiles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh OnGrid(const TriangleMesh& mesh, double spacing, double reach)
{
  return ContourOf(mesh,
    [&](vtkDualContouring* f)
    {
      f->SetSpacing(spacing);
      f->SetReach(reach);
    });
}

/// How far the points of `mesh` are from `surface`.
std::vector<double> DistancesFrom(const TriangleMesh& mesh, const TriangleMesh& surface)
{
  std::vector<double> distances;
  for (const Point3& p : mesh.Points)
  {
    double least = 1e300;
    for (const Triangle& t : surface.Triangles)
    {
      const auto at = [&](std::size_t c) { return surface.Points[static_cast<std::size_t>(t[c])]; };
      least = std::min(least, SquaredDistanceToTriangle(p, { at(0), at(1), at(2) }));
    }
    distances.push_back(std::sqrt(least));
  }
  return distances;
}

}

/// Acceptance 2: all points of the contours of solids with flat faces are on the solid, edges and
/// corners included, and the solid is within 0.05 h of the contours.
TEST(DualContouring, EdgesAndCornersOfPolyhedraAreKept)
{
  for (const TriangleMesh& solid : { Turned(Cube({ -0.5, -0.5, -0.5 }, 1.0)),
         Turned(Octahedron(0.8)), Cube({ -0.5, -0.5, -0.5 }, 1.0) })
  {
    const double h = 0.07;
    for (const double reach : { 0.0, 1.0 })
    {
      const TriangleMesh contour = OnGrid(solid, h, reach);
      EXPECT_TRUE(FindDefects(contour).BoundaryTriangles.empty());
      EXPECT_TRUE(FindDefects(contour).NonManifoldTriangles.empty());
      EXPECT_EQ(EulerCharacteristic(contour), 2);
      std::vector<double> off = DistancesFrom(contour, solid);
      std::sort(off.begin(), off.end());
      const double moved = HausdorffDistance(contour, solid);
      std::printf(
        "reach %g, %zu triangles: points off by %.2g h (95 %%), %.2g h (all); surface moved "
        "by %.5f h\n",
        reach, contour.Triangles.size(), off[off.size() * 95 / 100] / h, off.back() / h, moved / h);
      EXPECT_LT(off.back(), 1e-5 * h);
      EXPECT_LT(moved, 0.05 * h);
      EXPECT_NEAR(SignedVolume(contour) / SignedVolume(solid), 1.0, 1e-3);
    }
  }
}

TEST(DualContouring, SmoothLevelsConvergeWithOrderTwo)
{
  double last = 0.0;
  for (const int n : { 17, 33, 65 })
  {
    const TriangleMesh contour =
      ContourOf(Sampled(n, [](const Point3& p) { return 0.7 - std::sqrt(Dot(p, p) + 1e-12); }));
    double worst = 0.0;
    for (const Point3& p : contour.Points)
    {
      worst = std::max(worst, std::abs(std::sqrt(Dot(p, p)) - 0.7));
    }
    EXPECT_EQ(EulerCharacteristic(contour), 2);
    EXPECT_GT(SignedVolume(contour), 0.0);
    if (last > 0.0)
    {
      std::printf("%d nodes: off by %.2e, order %.2f\n", n, worst, std::log2(last / worst));
      EXPECT_GT(std::log2(last / worst), 1.7);
    }
    last = worst;
  }
}

TEST(DualContouring, BallFromItsTriangles)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.5);
  ball->SetThetaResolution(80);
  ball->SetPhiResolution(80);
  ball->Update();
  const double before = SignedVolume(MeshOf(ball->GetOutput()));
  const TriangleMesh contour = OnGrid(MeshOf(ball->GetOutput()), 0.05, 0.0);
  EXPECT_NEAR(SignedVolume(contour) / before, 1.0, 5e-3);
  EXPECT_LT(HausdorffDistance(contour, MeshOf(ball->GetOutput())), 0.05 * 0.05);
}

TEST(DualContouring, NoiseGivesAManifold)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    const TriangleMesh contour = ContourOf(Sampled(14,
      [&](const Point3& p)
      {
        const bool border = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) > 0.99;
        const double v = value(random);
        return border ? -1.0 : v;
      }));
    const SurfaceDefects defects = FindDefects(contour);
    EXPECT_TRUE(defects.BoundaryTriangles.empty()) << seed;
    EXPECT_TRUE(defects.NonManifoldTriangles.empty())
      << seed << ": " << defects.NonManifoldTriangles.size();
    EXPECT_TRUE(defects.FlippedTriangles.empty()) << seed;
  }
}

TEST(DualContouring, QuadrilateralsMirrorsAndThreads)
{
  const auto image = Sampled(
    25, [](const Point3& p) { return 0.6 - std::abs(p[0]) - std::abs(p[1]) - std::abs(p[2]); });
  vtkNew<vtkDualContouring> filter;
  filter->SetInputData(image);
  filter->QuadrilateralsOn();
  filter->Update();
  const vtkIdType quads = filter->GetOutput()->GetNumberOfCells();
  EXPECT_EQ(filter->GetOutput()->GetMaxCellSize(), 4);
  filter->QuadrilateralsOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2 * quads);
  const TriangleMesh plain = MeshOf(filter->GetOutput());
  EXPECT_GT(SignedVolume(plain), 0.0);

  image->SetDirectionMatrix(1, 0, 0, 0, -1, 0, 0, 0, 1);
  filter->Update();
  EXPECT_NEAR(SignedVolume(MeshOf(filter->GetOutput())), SignedVolume(plain), 1e-9);
  image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope({ threads, threads == 1 ? "Sequential" : "STDThread", false },
      [&] { EXPECT_EQ(ContourOf(image).Points, plain.Points); });
  }
}

TEST(DualContouring, SurfacesThatCrossAreRefusedWithTheirPlace)
{
  TriangleMesh both = Cube({ 10.0, 20.0, 30.0 }, 2.0);
  Append(both, Cube({ 11.0, 21.0, 31.0 }, 2.0));
  vtkNew<vtkPolyData> surface;
  SetMesh(both, surface);
  vtkNew<vtkDualContouring> filter;
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->SetInputData(surface);
  filter->SetSpacing(0.3);
  filter->Update();
  double p[3] = { 0.0, 0.0, 0.0 };
  const std::string message = said->GetErrorMessage();
  const std::size_t start = std::min(message.find("cross at ("), message.size());
  ASSERT_EQ(std::sscanf(message.c_str() + start, "cross at (%lf, %lf, %lf)", p, p + 1, p + 2), 3)
    << message;
  for (int a = 0; a < 3; ++a) // where both cubes are
  {
    EXPECT_GE(p[a], 10.0 * (a + 1) + 1.0) << message;
    EXPECT_LE(p[a], 10.0 * (a + 1) + 2.0) << message;
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(DualContouring, WrongInputAndPropertiesAreRefused)
{
  const auto image = Sampled(9, [](const Point3& p) { return 0.6 - std::abs(p[0]); });
  const auto fails = [](vtkDataObject* input, auto&& change)
  {
    vtkNew<vtkDualContouring> filter;
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->SetInputDataObject(input);
    change(filter.Get());
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
    return observer->GetError();
  };
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetFeatureThreshold(2.0); }));
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetReach(-0.1); }));
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetLevel(std::nan("")); }));
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetTolerance(-1.0); }));
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetTolerance(std::nan("")); }));
  for (const bool quadrilaterals : { false, true })
  {
    EXPECT_TRUE(fails(image,
      [quadrilaterals](vtkDualContouring* f)
      {
        f->FreeOfCrossingsOn();
        f->SetQuadrilaterals(quadrilaterals);
        f->SetReach(quadrilaterals ? 0.0 : 0.5);
      }));
  }
  vtkNew<vtkPolyData> cube;
  SetMesh(Cube({ 0, 0, 0 }, 1.0), cube);
  EXPECT_TRUE(fails(cube, [](vtkDualContouring* f) { f->SetSpacing(-1.0); }));
  EXPECT_TRUE(fails(cube, [](vtkDualContouring* f) { f->SetSpacing(1e-9); }));
  TriangleMesh open = Cube({ 0, 0, 0 }, 1.0);
  open.Triangles.pop_back();
  vtkNew<vtkPolyData> holed;
  SetMesh(open, holed);
  EXPECT_TRUE(fails(holed, [](vtkDualContouring* f) { f->SetSpacing(0.1); }));
  EXPECT_FALSE(fails(vtkSmartPointer<vtkPolyData>::New(), [](vtkDualContouring*) {}));
  EXPECT_FALSE(fails(vtkSmartPointer<vtkImageData>::New(), [](vtkDualContouring*) {}));
}
