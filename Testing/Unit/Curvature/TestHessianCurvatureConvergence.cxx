// Curvature at the points of isosurfaces: second order, whereas vtkCurvatures does not converge on
// the same surfaces; fourth order at points off the nodes with Accuracy 4.
#include "FieldImage.h"
#include "FundamentalForms.h"
#include "vtkHessianCurvature.h"

#include <vtkCurvatures.h>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace
{

using namespace isthmus::testing;

/// A smooth density on the box [-1/2, 1/2]^3 that is 1/2 on a known surface.
struct Shape
{
  const char* Name;
  double (*Density)(double x, double y, double z);
  GaussianAndMean (*Curvature)(double x, double y, double z); // on the surface
};

constexpr double sphereRadius = 1.0 / 3.0;
constexpr double torusRadius = 0.25;
constexpr double tubeRadius = 0.1;

const Shape sphere{ "sphere",
  [](double x, double y, double z)
  { return 1.0 / (1.0 + (x * x + y * y + z * z) / (sphereRadius * sphereRadius)); },
  [](double, double, double) {
    return GaussianAndMean{ 1.0 / (sphereRadius * sphereRadius), 1.0 / sphereRadius };
  } };

const Shape torus{ "torus",
  [](double x, double y, double z)
  {
    const double d = std::hypot(std::hypot(x, y) - torusRadius, z) / tubeRadius;
    return 1.0 / (1.0 + d * d);
  },
  [](double x, double y, double z)
  {
    const double across = std::hypot(x, y) - torusRadius;
    const double cosine = across / std::hypot(across, z);
    const double minimum = cosine / (torusRadius + tubeRadius * cosine);
    return GaussianAndMean{ minimum / tubeRadius, 0.5 * (minimum + 1.0 / tubeRadius) };
  } };

vtkSmartPointer<vtkPolyData> Isosurface(vtkImageData* image)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.5);
  contour->Update();
  return contour->GetOutput();
}

/// Rms errors relative to the rms of the exact values.
GaussianAndMean RmsErrors(vtkPolyData* surface, vtkDataArray* gaussian, vtkDataArray* mean,
  const Shape& shape, bool orientationUnknown)
{
  GaussianAndMean error{ 0.0, 0.0 };
  GaussianAndMean size{ 0.0, 0.0 };
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    const double* p = surface->GetPoint(id);
    const GaussianAndMean exact = shape.Curvature(p[0], p[1], p[2]);
    const double h = mean->GetComponent(id, 0);
    error.Gaussian += std::pow(gaussian->GetComponent(id, 0) - exact.Gaussian, 2);
    error.Mean +=
      std::pow(orientationUnknown ? std::abs(h) - std::abs(exact.Mean) : h - exact.Mean, 2);
    size.Gaussian += std::pow(exact.Gaussian, 2);
    size.Mean += std::pow(exact.Mean, 2);
  }
  return { std::sqrt(error.Gaussian / size.Gaussian), std::sqrt(error.Mean / size.Mean) };
}

GaussianAndMean ErrorsOfHessian(
  vtkImageData* image, vtkPolyData* surface, const Shape& shape, int accuracy)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, image);
  filter->SetInputData(1, surface);
  filter->SetAccuracy(accuracy);
  filter->Update();
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_EQ(PointArray(output, "CurvatureValid")->GetRange()[0], 1.0);
  return RmsErrors(surface, PointArray(output, "GaussianCurvature"),
    PointArray(output, "MeanCurvature"), shape, false);
}

GaussianAndMean ErrorsOfVtkCurvatures(vtkPolyData* surface, const Shape& shape)
{
  vtkNew<vtkCurvatures> gaussian;
  gaussian->SetInputData(surface);
  gaussian->SetCurvatureTypeToGaussian();
  gaussian->Update();
  vtkNew<vtkCurvatures> mean;
  mean->SetInputData(surface);
  mean->SetCurvatureTypeToMean();
  mean->Update();
  return RmsErrors(surface, PointArray(gaussian->GetOutput(), "Gauss_Curvature"),
    PointArray(mean->GetOutput(), "Mean_Curvature"), shape, true);
}

void ExpectSecondOrder(const Shape& shape)
{
  constexpr int sizes[3] = { 30, 60, 120 };
  GaussianAndMean second[3];
  GaussianAndMean mesh[3];
  for (int i = 0; i < 3; ++i)
  {
    const auto image = SampledImage(CenteredCube(sizes[i], 0.5), shape.Density);
    const auto surface = Isosurface(image);
    second[i] = ErrorsOfHessian(image, surface, shape, 2);
    const GaussianAndMean fourth = ErrorsOfHessian(image, surface, shape, 4);
    mesh[i] = ErrorsOfVtkCurvatures(surface, shape);
    std::printf(
      "%s %3d: rms error of K, H: Accuracy 2 %.4f %% %.4f %%, Accuracy 4 %.4f %% %.4f %%, "
      "vtkCurvatures %.1f %% %.1f %%\n",
      shape.Name, sizes[i], 100 * second[i].Gaussian, 100 * second[i].Mean, 100 * fourth.Gaussian,
      100 * fourth.Mean, 100 * mesh[i].Gaussian, 100 * mesh[i].Mean);
  }
  const double doublings = std::log2(119.0 / 29.0); // of the number of node distances
  const double gaussianOrder = std::log2(second[0].Gaussian / second[2].Gaussian) / doublings;
  const double meanOrder = std::log2(second[0].Mean / second[2].Mean) / doublings;
  const double fineGaussian =
    std::log2(second[1].Gaussian / second[2].Gaussian) / std::log2(119.0 / 59.0);
  const double fineMean = std::log2(second[1].Mean / second[2].Mean) / std::log2(119.0 / 59.0);
  std::printf("%s: order with Accuracy 2: K %.3f (finer pair %.3f), H %.3f (%.3f)\n", shape.Name,
    gaussianOrder, fineGaussian, meanOrder, fineMean);
  EXPECT_GE(gaussianOrder, 1.9);
  EXPECT_GE(meanOrder, 1.9);
  EXPECT_GE(fineGaussian, 1.9);
  EXPECT_GE(fineMean, 1.9);
  EXPECT_LT(second[2].Gaussian, 0.005);
  EXPECT_LT(second[2].Mean, 0.005);
  EXPECT_GT(mesh[2].Gaussian, 0.5 * mesh[0].Gaussian) << "vtkCurvatures does converge now";
  EXPECT_GT(mesh[2].Mean, 0.5 * mesh[0].Mean) << "vtkCurvatures does converge now";
}

TEST(HessianCurvatureConvergence, Sphere)
{
  ExpectSecondOrder(sphere);
}

TEST(HessianCurvatureConvergence, Torus)
{
  ExpectSecondOrder(torus);
}

/// 1 / (1 + q) with q = (x/a)^2 + (y/b)^2 + (z/c)^2, and the curvature of its level sets.
double Ellipsoids(double x, double y, double z)
{
  return 1.0 / (1.0 + x * x / 0.16 + y * y / 0.09 + z * z / 0.04);
}

GaussianAndMean CurvatureOfEllipsoid(double x, double y, double z)
{
  // Curvature is the same for every function of q, -q among them, which is higher inside.
  return FundamentalForms({ -2.0 * x / 0.16, -2.0 * y / 0.09, -2.0 * z / 0.04, -2.0 / 0.16,
    -2.0 / 0.09, -2.0 / 0.04, 0.0, 0.0, 0.0 });
}

/// Largest relative error at fixed points, none of them near a node or the center.
double ErrorOffNodes(int n, int accuracy)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> inside(-0.35, 0.35);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  while (points->GetNumberOfPoints() < 3000)
  {
    const double p[3] = { inside(random), inside(random), inside(random) };
    if (std::hypot(p[0], p[1], p[2]) > 0.2)
    {
      points->InsertNextPoint(p);
    }
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, SampledImage(CenteredCube(n, 0.5), Ellipsoids));
  filter->SetInputData(1, places);
  filter->SetAccuracy(accuracy);
  filter->Update();
  vtkDataArray* gaussian = PointArray(filter->GetOutput(), "GaussianCurvature");
  vtkDataArray* mean = PointArray(filter->GetOutput(), "MeanCurvature");
  double worst = 0.0;
  for (vtkIdType id = 0; id < points->GetNumberOfPoints(); ++id)
  {
    const double* p = points->GetPoint(id);
    const GaussianAndMean exact = CurvatureOfEllipsoid(p[0], p[1], p[2]);
    worst = std::max(worst, std::abs(gaussian->GetComponent(id, 0) / exact.Gaussian - 1.0));
    worst = std::max(worst, std::abs(mean->GetComponent(id, 0) / exact.Mean - 1.0));
  }
  return worst;
}

TEST(HessianCurvatureConvergence, OrderAtPointsOffTheNodes)
{
  for (const int accuracy : { 2, 4 })
  {
    const double coarse = ErrorOffNodes(101, accuracy);
    const double fine = ErrorOffNodes(201, accuracy);
    std::printf(
      "off the nodes, Accuracy %d: largest relative error %.3e at 101, %.3e at 201: order "
      "%.3f\n",
      accuracy, coarse, fine, std::log2(coarse / fine));
    EXPECT_GE(std::log2(coarse / fine), accuracy - 0.1);
  }
}

}
