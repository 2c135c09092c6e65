#include "DualContouring.h"

#include "PolyDataMesh.h"
#include "SurfaceCheck.h"
#include "SurfaceFiles.h"
#include "SurfaceMove.h"
#include "SurfaceTopology.h"
#include "vtkDualContouring.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
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

template <typename Function>
vtkSmartPointer<vtkImageData> Sampled(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  const double h = 2.0 / (n - 1);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-1, -1, -1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    values->InsertNextValue(f(p));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

TriangleMesh ContourOf(vtkDataObject* input, double spacing = 0.0)
{
  vtkNew<vtkDualContouring> filter;
  filter->SetInputDataObject(input);
  filter->SetSpacing(spacing);
  filter->Update();
  return MeshOf(filter->GetOutput());
}

TriangleMesh ContourOf(const TriangleMesh& mesh, double spacing)
{
  vtkNew<vtkPolyData> surface;
  SetMesh(mesh, surface);
  return ContourOf(surface, spacing);
}

TriangleMesh Octahedron(double r)
{
  TriangleMesh mesh;
  mesh.Points = { { r, 0, 0 }, { -r, 0, 0 }, { 0, r, 0 }, { 0, -r, 0 }, { 0, 0, r }, { 0, 0, -r } };
  mesh.Triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  return mesh;
}

/// A turned copy, so that nothing is along the grid.
TriangleMesh Turned(TriangleMesh mesh)
{
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (Point3& p : mesh.Points)
  {
    p = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
    p = { p[0], c * p[1] - s * p[2], s * p[1] + c * p[2] };
  }
  return mesh;
}

}

/// Acceptance 2: of solids with flat faces nothing moves: corners and edges are within 0.05 h.
TEST(DualContouring, EdgesAndCornersOfPolyhedraAreKept)
{
  for (const TriangleMesh& solid : { Turned(Cube({ -0.5, -0.5, -0.5 }, 1.0)),
         Turned(Octahedron(0.8)), Cube({ -0.5, -0.5, -0.5 }, 1.0) })
  {
    const double h = 0.07;
    const TriangleMesh contour = ContourOf(solid, h);
    EXPECT_TRUE(FindDefects(contour).BoundaryTriangles.empty());
    EXPECT_TRUE(FindDefects(contour).NonManifoldTriangles.empty());
    EXPECT_EQ(EulerCharacteristic(contour), 2);
    const double moved = HausdorffDistance(contour, solid);
    std::printf("%zu triangles, moved by %.5f h\n", contour.Triangles.size(), moved / h);
    EXPECT_LT(moved, 0.05 * h);
    EXPECT_NEAR(SignedVolume(contour) / SignedVolume(solid), 1.0, 1e-3);
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
  const TriangleMesh contour = ContourOf(ball->GetOutput(), 0.05);
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
  EXPECT_TRUE(fails(image, [](vtkDualContouring* f) { f->SetLevel(std::nan("")); }));
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
