#include "Contouring/DualContouring.h"

#include "DualContours.h"
#include "SurfaceFiles.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"

#include <vtkAppendPolyData.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <utility>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh OnGrid(const TriangleMesh& mesh, double spacing, double reach)
{
  return ComputeContour(mesh,
    [&](vtkDualContouring* f)
    {
      f->SetSpacing(spacing);
      f->SetReach(reach);
    });
}

/// The distances of the points of `mesh` from `surface`.
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
  for (const TriangleMesh& solid : { Rotate(Cube({ -0.5, -0.5, -0.5 }, 1.0)),
         Rotate(Octahedron(0.8)), Cube({ -0.5, -0.5, -0.5 }, 1.0) })
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
    const TriangleMesh contour = ComputeContour(
      SampleImage(n, [](const Point3& p) { return 0.7 - std::sqrt(Dot(p, p) + 1e-12); }));
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
  const double before = SignedVolume(ToTriangleMesh(ball->GetOutput()));
  const TriangleMesh contour = OnGrid(ToTriangleMesh(ball->GetOutput()), 0.05, 0.0);
  EXPECT_NEAR(SignedVolume(contour) / before, 1.0, 5e-3);
  EXPECT_LT(HausdorffDistance(contour, ToTriangleMesh(ball->GetOutput())), 0.05 * 0.05);
}

TEST(DualContouring, NoiseGivesAManifold)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1.0, 1.0);
    const TriangleMesh contour = ComputeContour(SampleImage(14,
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

TEST(DualContouring, WallsThinnerThanTheSpacingAreWarnedAbout)
{
  for (const auto& [thickness, isThin] :
    { std::pair(0.02, true), std::pair(0.09, true), std::pair(0.4, false), std::pair(0.0, false) })
  {
    vtkNew<vtkAppendPolyData> shells;
    const std::vector<double> radii =
      thickness > 0.0 ? std::vector<double>{ 1.0, 1.0 - thickness } : std::vector<double>{ 1.0 };
    for (const double radius : radii)
    {
      vtkNew<vtkSphereSource> ball;
      ball->SetRadius(radius);
      ball->SetThetaResolution(40);
      ball->SetPhiResolution(40);
      ball->Update();
      shells->AddInputData(ball->GetOutput());
    }
    vtkNew<vtkTest::ErrorObserver> observer;
    vtkNew<vtkDualContouring> filter;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputConnection(shells->GetOutputPort());
    filter->SetSpacing(0.1);
    filter->Update();
    EXPECT_EQ(
      observer->GetWarningMessage().find("Walls thinner than the Spacing") != std::string::npos,
      isThin)
      << thickness;
  }
}

TEST(DualContouring, QuadrilateralsMirrorsAndThreads)
{
  const auto image = SampleImage(
    25, [](const Point3& p) { return 0.6 - std::abs(p[0]) - std::abs(p[1]) - std::abs(p[2]); });
  vtkNew<vtkDualContouring> filter;
  filter->SetInputData(image);
  filter->QuadrilateralsOn();
  filter->SetLevel(0.0);
  filter->Update();
  const vtkIdType quads = filter->GetOutput()->GetNumberOfCells();
  EXPECT_EQ(filter->GetOutput()->GetMaxCellSize(), 4);
  filter->QuadrilateralsOff();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2 * quads);
  const TriangleMesh plain = ToTriangleMesh(filter->GetOutput());
  EXPECT_GT(SignedVolume(plain), 0.0);

  image->SetDirectionMatrix(1, 0, 0, 0, -1, 0, 0, 0, 1);
  filter->Update();
  EXPECT_NEAR(SignedVolume(ToTriangleMesh(filter->GetOutput())), SignedVolume(plain), 1e-9);
  image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  for (const int threads : { 1, 3 })
  {
    vtkSMPTools::LocalScope({ threads, threads == 1 ? "Sequential" : "STDThread", false },
      [&] { EXPECT_EQ(ComputeContour(image).Points, plain.Points); });
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
  for (int a = 0; a < 3; ++a) // where the two cubes are
  {
    EXPECT_GE(p[a], 10.0 * (a + 1) + 1.0) << message;
    EXPECT_LE(p[a], 10.0 * (a + 1) + 2.0) << message;
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST(DualContouring, WrongInputAndPropertiesAreRefused)
{
  const auto image = SampleImage(9, [](const Point3& p) { return 0.6 - std::abs(p[0]); });
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

namespace
{

/// A ring about the z axis.
TriangleMesh Ring(double large, double small, int around, int across)
{
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * Pi * i / around, v = 2.0 * Pi * j / across;
      const double r = large + small * std::cos(v);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), small * std::sin(v) });
      const auto id = [&](int a, int b)
      { return static_cast<vtkIdType>(a % around * across + b % across); };
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return mesh;
}

/// Closed, of genus 1, points and area within the discretisation error: tangent planes at crossings
/// leave the torus by at most the square of a cell's diagonal over twice the tube's radius.
void ExpectTorus(const TriangleMesh& contour, double large, double small, double h, double facets)
{
  const SurfaceDefects defects = FindDefects(contour);
  EXPECT_TRUE(defects.BoundaryTriangles.empty());
  EXPECT_TRUE(defects.NonManifoldTriangles.empty());
  EXPECT_TRUE(defects.FlippedTriangles.empty());
  EXPECT_EQ(EulerCharacteristic(contour), 0);
  const double error = 1.5 * h * h / small;
  const double area = 4.0 * Pi * Pi * large * small;
  EXPECT_NEAR(SurfaceArea(contour) / area, 1.0, error / small + facets);
  EXPECT_NEAR(
    SignedVolume(contour) / (0.5 * area * small), 1.0, 2.0 * error / small + 2.0 * facets);
}

}

TEST(DualContouring, ToriAtSeveralSpacingsAndPoses)
{
  const double large = 0.6, small = 0.25;
  const TriangleMesh ring = Ring(large, small, 160, 80);
  // Area of the facets is less by this part at most.
  const double facets = std::pow(2.0 * Pi / 80, 2) / 4.0;
  for (const int n : { 21, 41, 101 })
  {
    const double h = 2.0 / (n - 1);
    TriangleMesh surface = ring;
    for (int pose = 0; pose < 3; ++pose)
    {
      SCOPED_TRACE(::testing::Message() << "spacing " << h << ", pose " << pose);
      ExpectTorus(OnGrid(surface, h, 0.0), large, small, h, facets);
      TriangleMesh axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, {} };
      for (int turn = 0; turn < pose; ++turn)
      {
        axes = Rotate(std::move(axes));
      }
      const auto depth = [&](const Point3& p)
      {
        const double away = std::hypot(Dot(p, axes.Points[0]), Dot(p, axes.Points[1])) - large;
        return small - std::hypot(away, Dot(p, axes.Points[2]));
      };
      ExpectTorus(ComputeContour(SampleImage(n, depth)), large, small, h, 0.0);
      surface = Rotate(std::move(surface));
    }
  }
}

/// The tilted ring fills little of its grid: 13 million nodes, but only 27 thousand of their edges
/// cross it. That fits 400 MiB.
TEST(DualContouring, SlimSurfacesOnFineGridsNeedLittleMemory)
{
  vtkNew<vtkPolyData> ring;
  SetMesh(Rotate(Rotate(Ring(10.0, 0.3, 400, 24))), ring);
  vtkNew<vtkDualContouring> filter;
  filter->SetInputData(ring);
  filter->SetSpacing(0.08);
  const pid_t child = fork(); // whose address space limit ends with it
  if (child == 0)
  {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit limit{ pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) +
        (std::size_t{ 400 } << 20),
      RLIM_INFINITY };
    setrlimit(RLIMIT_AS, &limit);
    vtkSMPTools::LocalScope({ 1, "Sequential", false }, [&] { filter->Update(); });
    const TriangleMesh contour = ToTriangleMesh(filter->GetOutput());
    _exit(contour.Triangles.empty() ? 1 : EulerCharacteristic(contour) == 0 ? 0 : 2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}
