// The vtk class on lattices of any spacing and direction, its directions, and its Gaussian scale.

#include "FieldImage.h"
#include "HessianCurvatureFields.h"
#include "vtkHessianCurvature.h"

#include <vtkFlyingEdges3D.h>
#include <vtkImageGaussianSmooth.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

using namespace isthmus::testing;

namespace
{

/// Mean and Gaussian curvature and directions of Ellipsoids at nodes of any lattice; checks all.
void ExpectEllipsoids(const Lattice& lattice)
{
  const auto image = SampledImage(lattice, Ellipsoids);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->SetAccuracy(4);
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection1");
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection2");
  filter->Update();
  vtkIdType checked = 0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    if (Value(filter, "CurvatureValid", id) == 0.0)
    {
      continue;
    }
    const double* p = image->GetPoint(id);
    const double g[3] = { p[0] / 16.0, p[1] / 9.0, p[2] / 4.0 }; // outward
    const double size = std::hypot(g[0], g[1], g[2]);
    const double second[3] = { 1.0 / 16.0, 1.0 / 9.0, 1.0 / 4.0 };
    double d[2][3];
    PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple(id, d[0]);
    PointArray(filter->GetOutput(), "PrincipalDirection2")->GetTuple(id, d[1]);
    double length[2] = {}, along[2] = {}, bend[2] = {}, across = 0.0, twist = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 2; ++i)
      {
        length[i] += d[i][axis] * d[i][axis];
        along[i] += d[i][axis] * g[axis] / size;
        bend[i] += d[i][axis] * d[i][axis] * second[axis] / size;
      }
      across += d[0][axis] * d[1][axis];
      twist += d[0][axis] * d[1][axis] * second[axis] / size;
    }
    constexpr double tolerance = 1e-4; // fourth-order differences at this spacing
    ASSERT_NEAR(length[0], 1.0, 1e-12);
    ASSERT_NEAR(length[1], 1.0, 1e-12);
    ASSERT_NEAR(across, 0.0, 1e-12);
    ASSERT_NEAR(along[0], 0.0, tolerance) << "directions are tangent";
    ASSERT_NEAR(along[1], 0.0, tolerance);
    ASSERT_NEAR(bend[0], Value(filter, "MaximumCurvature", id), tolerance);
    ASSERT_NEAR(bend[1], Value(filter, "MinimumCurvature", id), tolerance);
    ASSERT_NEAR(twist, 0.0, tolerance) << "and conjugate";
    ++checked;
  }
  EXPECT_GT(checked, 500);
}

}

TEST(HessianCurvatureFilter, AnisotropicSpacing)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, 0.07, 0.13 };
  ExpectEllipsoids(lattice);
}

TEST(HessianCurvatureFilter, DirectionMatrix)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, 0.07, 0.13 };
  ExpectEllipsoids(Rotate(lattice));
}

TEST(HessianCurvatureFilter, NegativeSpacing)
{
  Lattice lattice = Block();
  lattice.Origin = { 2.0, 0.4, 2.0 };
  lattice.Spacing = { -0.1, 0.07, -0.09 };
  ExpectEllipsoids(lattice);
  ExpectEllipsoids(Rotate(lattice));
}

TEST(HessianCurvatureFilter, PointsOfATurnedImage)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, -0.07, 0.13 };
  lattice.Origin = { 0.3, 1.4, 0.5 };
  const auto image = SampledImage(Rotate(lattice), Spheres);
  vtkNew<vtkPoints> points;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double* p = image->GetPoint(id);
    points->InsertNextPoint(p[0], p[1], p[2]); // float
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkHessianCurvature> atNodes;
  atNodes->SetInputData(image);
  atNodes->Update();
  vtkNew<vtkHessianCurvature> atPoints;
  atPoints->SetInputData(0, image);
  atPoints->SetInputData(1, places);
  atPoints->Update();
  ASSERT_NE(atPoints->GetPolyDataOutput(), nullptr);
  for (const std::string& name : { std::string("CurvatureValid"), std::string("MeanCurvature") })
  {
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      ASSERT_NEAR(Value(atPoints, name.c_str(), id), Value(atNodes, name.c_str(), id), 1e-5);
    }
  }
}

TEST(HessianCurvatureFilter, CylinderDirectionsAndUmbilics)
{
  const auto cylinder =
    SampledImage(CenteredCube(15, 1.0), [](double x, double y, double) { return -x * x - y * y; });
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(cylinder);
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection1");
  filter->GetOutputArraySelection()->EnableArray("PrincipalDirection2");
  filter->GetOutputArraySelection()->EnableArray("SurfaceType");
  filter->Update();
  double place[3] = { 4.0 / 7.0, 3.0 / 7.0, 0.0 }; // VTK 9.3 hides the overload of three numbers
  const vtkIdType id = cylinder->FindPoint(place);
  const double* p = cylinder->GetPoint(id);
  const double r = std::hypot(p[0], p[1]);
  const double* around = PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple3(id);
  EXPECT_NEAR(std::abs(around[0] * p[1] - around[1] * p[0]), r, 1e-12);
  EXPECT_NEAR(around[2], 0.0, 1e-12);
  const double* axis = PointArray(filter->GetOutput(), "PrincipalDirection2")->GetTuple3(id);
  EXPECT_NEAR(std::abs(axis[2]), 1.0, 1e-12);
  EXPECT_NEAR(Value(filter, "MaximumCurvature", id), 1.0 / r, 1e-12);
  EXPECT_NEAR(Value(filter, "MinimumCurvature", id), 0.0, 1e-12);
  EXPECT_EQ(Value(filter, "SurfaceType", id), 7.0);
  EXPECT_NEAR(Value(filter, "ShapeIndex", id), -0.5, 1e-12);
  filter->SetShapeIndexConvention(vtkHessianCurvature::Koenderink);
  filter->InsideIsHigherOff();
  filter->Update();
  EXPECT_NEAR(Value(filter, "ShapeIndex", id), -0.5, 1e-12);
  EXPECT_NEAR(Value(filter, "MinimumCurvature", id), -1.0 / r, 1e-12);
  EXPECT_EQ(Value(filter, "SurfaceType", id), 2.0);

  filter->SetInputData(SampledImage(CenteredCube(15, 1.0), Spheres));
  filter->Update();
  const double* u = PointArray(filter->GetOutput(), "PrincipalDirection1")->GetTuple3(id);
  EXPECT_NEAR(std::hypot(u[0], u[1], u[2]), 1.0, 1e-12);
}

TEST(HessianCurvatureFilter, ScaleReducesNoise)
{
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 0.01);
  const auto image = SampledImage(
    CenteredCube(41, 20.0),
    [&](double x, double y, double z)
    { return std::exp(-(x * x + y * y + z * z) / 200.0) + noise(random); },
    VTK_FLOAT);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(SampledImage(CenteredCube(41, 20.0),
    [](double x, double y, double z) { return std::exp(-(x * x + y * y + z * z) / 200.0); }));
  contour->SetValue(0, std::exp(-0.5));
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, image);
  filter->SetInputConnection(1, contour->GetOutputPort());
  const auto worst = [&]()
  {
    filter->Update();
    double largest = 0.0;
    for (vtkIdType id = 0; id < filter->GetOutput()->GetNumberOfPoints(); ++id)
    {
      largest = std::max(largest, std::abs(Value(filter, "MeanCurvature", id) - 0.1));
    }
    return largest;
  };
  const double automatic = worst();
  filter->SetScale(0.0);
  const double rough = worst();
  filter->SetScale(3.0);
  const double smooth = worst();
  EXPECT_LT(automatic, 0.02);
  EXPECT_GT(rough, 0.2);
  EXPECT_LT(smooth, 0.02);
  EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 1) << "the input is left as it was";
}

TEST(HessianCurvatureFilter, ScaleIsVtksGaussian)
{
  const auto image = SampledImage(Block(), Ellipsoids);
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  const double h = image->GetSpacing()[0];
  smooth->SetStandardDeviations(0.2 / h, 0.2 / h, 0.2 / h);
  smooth->SetRadiusFactor(4.0);
  vtkNew<vtkHessianCurvature> byHand;
  byHand->SetInputConnection(smooth->GetOutputPort());
  byHand->Update();
  vtkNew<vtkHessianCurvature> byScale;
  byScale->SetInputData(image);
  byScale->SetScale(0.2);
  byScale->Update();
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    ASSERT_EQ(Value(byHand, "MeanCurvature", id), Value(byScale, "MeanCurvature", id));
  }
}

// A rounded cube: the curvedness marks edges and corners (thesis, after 5.45) and nothing else.
TEST(HessianCurvatureFilter, CurvednessMarksEdgesAndCorners)
{
  const auto power = [](double v) { return std::pow(v, 8); };
  const auto cube = SampledImage(CenteredCube(81, 1.3),
    [&](double x, double y, double z) { return power(x) + power(y) + power(z); });
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(cube);
  contour->SetValue(0, 1.0);
  contour->Update();
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, cube);
  filter->SetInputConnection(1, contour->GetOutputPort());
  filter->AutomaticScaleOff();
  filter->SetAccuracy(4);
  filter->InsideIsHigherOff();
  filter->Update();
  vtkPolyData* surface = filter->GetPolyDataOutput();
  std::array<double, 3> least{ 1e9, 1e9, 1e9 }, largest{}; // flat sides, edges, corners
  std::array<int, 3> count{};
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    // The number of coordinates as large as those of the cube's edges: two at edges, all at
    // corners; near the centers of sides the other two are small.
    std::array<double, 3> p;
    surface->GetPoint(id, p.data());
    std::for_each(p.begin(), p.end(), [](double& v) { v = std::abs(v); });
    std::sort(p.begin(), p.end());
    const std::size_t kind = p[1] < 0.4 ? 0 : (p[0] < 0.4 && p[2] - p[1] < 0.05) ? 1 : 2;
    if (kind == 2 && p[2] - p[0] > 0.05)
    {
      continue; // between these
    }
    const double curvedness = Value(filter, "Curvedness", id);
    least[kind] = std::min(least[kind], curvedness);
    largest[kind] = std::max(largest[kind], curvedness);
    ++count[kind];
  }
  EXPECT_GT(*std::min_element(count.begin(), count.end()), 8);
  EXPECT_GT(least[1], 20.0 * largest[0]) << "edges against sides";
  EXPECT_GT(least[2], 20.0 * largest[0]) << "corners against sides";
}
