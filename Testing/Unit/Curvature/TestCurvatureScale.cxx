// The automatic scale: its kernels, the measured noise, the chosen scale, and the stated errors.

#include "Curvature/CurvatureScale.h"
#include "Curvature/FiniteDifference.h"
#include "Curvature/GaussianSmoothing.h"
#include "FieldImage.h"
#include "SurfaceModels.h"
#include "vtkHessianCurvature.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

GridPart<float> MakeGridPart(vtkImageData* image)
{
  GridPart<float> part;
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  part.Values.Data = values->GetPointer(0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto index = static_cast<std::size_t>(axis);
    part.Whole[index] = part.Values.Dimensions[index] = image->GetDimensions()[axis];
    part.Values.Spacing[index] = image->GetSpacing()[axis];
  }
  return part;
}

constexpr double radius = 11.0;

double Squared(double x)
{
  return x * x;
}

/// A ball with an edge of two nodes, in nodes.
double Ball(double x, double y, double z)
{
  return std::tanh((radius - std::sqrt(x * x + y * y + z * z)) / 2.0);
}

/// The ball on 48^3 nodes, with normal noise, smoothed by a Gaussian of `correlation` nodes.
vtkSmartPointer<vtkImageData> NoisyBall(double deviation, double correlation, double spacing = 1.0)
{
  constexpr int size = 48;
  const auto unit = CenteredCube(size, 0.5 * (size - 1));
  auto image = SampledImage(unit, Ball, VTK_FLOAT);
  const auto noise = SampledImage(unit, Ball, VTK_FLOAT);
  auto* values = vtkFloatArray::SafeDownCast(noise->GetPointData()->GetScalars());
  std::mt19937 random(7);
  std::normal_distribution<float> normal;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, normal(random));
  }
  vtkSmartPointer<vtkDataArray> smooth = values;
  if (correlation > 0.0)
  {
    smooth = SmoothAtScale(noise, values, correlation, {});
  }
  double square = 0.0;
  for (vtkIdType i = 0; i < smooth->GetNumberOfTuples(); ++i)
  {
    square += std::pow(smooth->GetComponent(i, 0), 2);
  }
  const double factor =
    deviation / std::sqrt(square / static_cast<double>(smooth->GetNumberOfTuples()));
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetComponent(i, 0, scalars->GetComponent(i, 0) + factor * smooth->GetComponent(i, 0));
  }
  image->SetSpacing(spacing, spacing, spacing);
  image->SetOrigin(0.0, 0.0, 0.0);
  return image;
}

double Wave(double x, double y, double z)
{
  return std::sin(0.4 * x + 0.2) * std::cos(0.3 * y) + std::sin(0.5 * z + 0.05 * x * y);
}

}

TEST(CurvatureScale, DerivativesAtANodeMatchTheSmoothedGrid)
{
  Lattice lattice = CenteredCube(20, 10.0);
  lattice.Spacing = { 1.0, 0.8, 1.3 };
  const auto image = SampledImage(lattice, Wave, VTK_FLOAT);
  for (const double scale : { 0.0, 0.9, 1.7 })
  {
    for (const int accuracy : { 2, 4 })
    {
      vtkSmartPointer<vtkDataArray> smooth = image->GetPointData()->GetScalars();
      if (scale > 0.0)
      {
        smooth = SmoothAtScale(image, smooth, scale, {});
      }
      GridView<const float> grid = MakeGridPart(image).Values;
      grid.Data = vtkFloatArray::SafeDownCast(smooth)->GetPointer(0);
      for (const std::int64_t i : { 3, 4, 9, 16 }) // 3 and 16: the kernel is cut at the border
      {
        DerivativeRows rows;
        DifferentiateAtNodes(grid, { i, 10, 16 }, 1, accuracy, rows);
        NodeDerivatives filter, reference;
        ASSERT_TRUE(DifferentiateSmoothed(
          MakeGridPart(image), { i, 10, 16 }, scale, accuracy, filter, reference));
        constexpr double rounding = 2e-6; // of the smoothed floats
        EXPECT_NEAR(filter.Value, rows.Value[0], rounding);
        EXPECT_NEAR(filter.Gradient[0], rows.X[0], rounding);
        EXPECT_NEAR(filter.Gradient[1], rows.Y[0], rounding);
        EXPECT_NEAR(filter.Gradient[2], rows.Z[0], rounding);
        EXPECT_NEAR(filter.Hessian[0], rows.XX[0], rounding);
        EXPECT_NEAR(filter.Hessian[1], rows.YY[0], rounding);
        EXPECT_NEAR(filter.Hessian[2], rows.ZZ[0], rounding);
        EXPECT_NEAR(filter.Hessian[3], rows.XY[0], rounding);
        EXPECT_NEAR(filter.Hessian[4], rows.XZ[0], rounding);
        EXPECT_NEAR(filter.Hessian[5], rows.YZ[0], rounding);
        EXPECT_GT(std::abs(reference.Hessian[0] - filter.Hessian[0]), 0.0);
      }
    }
  }
}

TEST(CurvatureScale, PartOfAGridGivesTheSameDerivatives)
{
  const auto image = SampledImage(CenteredCube(30, 15.0), Wave, VTK_FLOAT);
  const GridPart<float> all = MakeGridPart(image);
  GridPart<float> upper = all; // without the lowest 6 layers
  upper.First = { 0, 0, 6 };
  upper.Values.Dimensions[2] -= 6;
  upper.Values.Data += 6 * all.Values.Dimensions[0] * all.Values.Dimensions[1];
  NodeDerivatives a, b, reference;
  ASSERT_TRUE(DifferentiateSmoothed(all, { 12, 7, 20 }, 1.5, 2, a, reference));
  ASSERT_TRUE(DifferentiateSmoothed(upper, { 12, 7, 20 }, 1.5, 2, b, reference));
  EXPECT_EQ(a.Hessian, b.Hessian);
  EXPECT_EQ(a.Gradient, b.Gradient);
  EXPECT_FALSE(DifferentiateSmoothed(upper, { 12, 7, 12 }, 1.5, 2, b, reference));
}

TEST(CurvatureScale, CovariancesOfNoise)
{
  const std::array<double, 3> spacing{ 1.0, 1.0, 1.0 };
  const NoiseCovariance raw =
    CovarianceOfDerivatives({ 2.0, 0.0 }, { 0.0, 2 }, { 0.0, 2 }, spacing);
  EXPECT_NEAR(raw.Laplacian, 4.0 * 20.0, 1e-12); // 4 neighbours and -4 in the middle
  EXPECT_NEAR(raw.Gradient, 4.0 * 0.5, 1e-12);
  // For widths far above the grid's spacing, the values of Gaussians: sigma^2 c^3 / (c^2 +
  // s^2)^(3/2) and so on.
  const double c = 2.0, s = 3.0, q = c * c + s * s;
  const NoiseCovariance smooth = CovarianceOfDerivatives({ 1.0, c }, { s, 4 }, { s, 4 }, spacing);
  const double value = std::pow(c * c / q, 1.5);
  EXPECT_NEAR(smooth.Gradient, value / (2.0 * q), 0.01 * value / (2.0 * q));
  EXPECT_NEAR(smooth.Laplacian, value * 2.0 / (q * q), 0.02 * value * 2.0 / (q * q));
}

TEST(CurvatureScale, NoiseIsMeasuredAndDecidesTheScale)
{
  double before = 0.0;
  for (const double deviation : { 0.01, 0.1, 0.4 })
  {
    const CurvatureScale choice = ChooseCurvatureScale(MakeGridPart(NoisyBall(deviation, 0.0)), 2);
    EXPECT_NEAR(choice.Noise, deviation, 0.15 * deviation);
    EXPECT_LT(choice.Correlation, 0.5);
    EXPECT_GE(choice.Scale, before);
    before = choice.Scale;
  }
  EXPECT_GE(before, 2.8);
  for (const double correlation : { 1.0, 2.0 })
  {
    const CurvatureScale choice =
      ChooseCurvatureScale(MakeGridPart(NoisyBall(0.1, correlation)), 2);
    EXPECT_NEAR(choice.Correlation, correlation, 0.2 * correlation);
    EXPECT_NEAR(choice.Noise, 0.1, 0.03);
  }
}

TEST(CurvatureScale, DoesNotDependOnUnits)
{
  const auto image = NoisyBall(0.1, 0.0);
  const auto scaled = NoisyBall(0.1, 0.0, 1e-3);
  const CurvatureScale one = ChooseCurvatureScale(MakeGridPart(image), 2);
  const CurvatureScale other = ChooseCurvatureScale(MakeGridPart(scaled), 2);
  EXPECT_NEAR(other.Scale, 1e-3 * one.Scale, 1e-9); // scales are rounded to floats
  EXPECT_NEAR(other.Error(0.1 * 1e3, 0.01 * 1e3, 0.3 * 1e3), 1e3 * one.Error(0.1, 0.01, 0.3), 1e-6);
}

TEST(CurvatureScale, SmoothDataWithoutNoiseAreUnchanged)
{
  const auto density = [](double x, double y, double z)
  { return 1.0 / (1.0 + (x * x + 1.2 * y * y + 0.8 * z * z) / 100.0); };
  const auto image = SampledImage(CenteredCube(50, 24.5), density, VTK_FLOAT);
  EXPECT_EQ(ChooseCurvatureScale(MakeGridPart(image), 2).Scale, 0.0);
  EXPECT_EQ(ChooseCurvatureScale(MakeGridPart(image), 4).Scale, 0.0);
}

namespace
{

/// An ellipsoid with a smooth edge, a torus of distances, a sum of Gaussians, in a box of length 2.
double EllipsoidWithEdge(double x, double y, double z)
{
  const double q = std::sqrt(x * x / 0.49 + y * y / 0.3 + z * z / 0.2);
  const double slope =
    std::sqrt(x * x / (0.49 * 0.49) + y * y / (0.3 * 0.3) + z * z / (0.2 * 0.2)) / (q + 1e-9);
  return std::tanh((1.0 - q) / (slope + 1e-9) / 0.1);
}

double TorusDistance(double x, double y, double z)
{
  return 0.3 - std::hypot(std::hypot(x, y) - 0.6, z);
}

double Gaussians(double x, double y, double z)
{
  const auto one = [&](double a, double b, double c)
  { return std::exp(-8.0 * (Squared(x - a) + Squared(y - b) + Squared(z - c))); };
  return one(-0.3, 0.1, 0.0) + one(0.3, 0.0, -0.1) + one(0.05, 0.3, 0.2);
}

using Field = double (*)(double, double, double);

/// `field` on n^3 nodes of the box from -1 to 1, after `change` of each value.
vtkSmartPointer<vtkImageData> SampleInBox(
  Field field, int n, const std::function<double(double)>& change = {})
{
  return SampledImage(
    CenteredCube(n, 1.0),
    [&](double x, double y, double z)
    {
      const double value = field(x, y, z);
      return change ? change(value) : value;
    },
    VTK_FLOAT);
}

double ScaleInSpacings(vtkImageData* image, int accuracy = 2)
{
  return ChooseCurvatureScale(MakeGridPart(image), accuracy).Scale / image->GetSpacing()[0];
}

/// Values rounded to `levels` steps between -1 and 1.
std::function<double(double)> RoundTo(double levels)
{
  return [=](double value) { return std::round(0.5 * value * levels) / (0.5 * levels); };
}

/// Normal noise of a deviation.
std::function<double(double)> AddNoise(double deviation)
{
  return [=, random = std::mt19937(5), normal = std::normal_distribution<double>()](
           double value) mutable { return value + deviation * normal(random); };
}

}

// Coarse edges have high frequencies, as noise has; their tails look like noise, too.
TEST(CurvatureScale, NothingIsSmoothedWithoutNoise)
{
  for (const Field field : { EllipsoidWithEdge, TorusDistance, Gaussians })
  {
    for (const int n : { 25, 33, 49, 70 })
    {
      const auto image = SampleInBox(field, n);
      EXPECT_EQ(ScaleInSpacings(image, 2), 0.0) << n;
      EXPECT_EQ(ScaleInSpacings(image, 4), 0.0) << n;
    }
  }
}

// The error of 16 bits is below that of the differences on 33 nodes, but not on 129, as it grows
// with the square of the number of nodes.
TEST(CurvatureScale, RoundingToFewDigitsIsNoise)
{
  for (const Field field : { EllipsoidWithEdge, TorusDistance, Gaussians })
  {
    EXPECT_GE(ScaleInSpacings(SampleInBox(field, 65, RoundTo(255.0))), 0.9);
    EXPECT_EQ(ScaleInSpacings(SampleInBox(field, 33, RoundTo(65535.0))), 0.0);
  }
  EXPECT_GE(ScaleInSpacings(SampleInBox(TorusDistance, 97, RoundTo(65535.0))), 0.4);
  EXPECT_GE(ScaleInSpacings(SampleInBox(EllipsoidWithEdge, 97, RoundTo(4095.0))), 0.4);
}

// Distances have no part without gradient, in which the noise could be measured.
TEST(CurvatureScale, NoiseOfVolumesWithoutBackgroundIsMeasured)
{
  double before = 0.0;
  for (const double deviation : { 0.001, 0.01, 0.05 })
  {
    const auto image = SampleInBox(TorusDistance, 65, AddNoise(deviation));
    const CurvatureScale choice = ChooseCurvatureScale(MakeGridPart(image), 2);
    EXPECT_NEAR(choice.Noise, deviation, 0.15 * deviation);
    EXPECT_GE(choice.Scale, before);
    before = choice.Scale;
  }
  EXPECT_GE(before, 1.9 / 32.0);
  EXPECT_NEAR(
    ChooseCurvatureScale(MakeGridPart(SampleInBox(EllipsoidWithEdge, 65, AddNoise(0.02))), 2).Noise,
    0.02, 0.003);
}

namespace
{

/// Root mean square error of the mean curvature at 500 points of the ellipsoid, relative to its
/// root mean square, with all defaults.
double ErrorOnEllipsoid(int n, const std::function<double(double)>& change = {})
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<double> exact;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const std::array<double, 3> squares{ 0.49, 0.3, 0.2 };
  while (points->GetNumberOfPoints() < 500)
  {
    std::array<double, 3> p{ normal(random), normal(random), normal(random) };
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    double fourth = 0.0, trace = 0.0, across = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      p[i] *= std::sqrt(squares[i]) / length;
      fourth += p[i] * p[i] / (squares[i] * squares[i]);
      trace += 1.0 / squares[i];
      across += p[i] * p[i] / (squares[i] * squares[i] * squares[i]);
    }
    points->InsertNextPoint(p.data());
    exact.push_back(0.5 * (trace - across / fourth) / std::sqrt(fourth));
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(0, SampleInBox(EllipsoidWithEdge, n, change));
  filter->SetInputData(1, places);
  filter->Update();
  vtkDataArray* mean = PointArray(filter->GetOutput(), "MeanCurvature");
  double error = 0.0, all = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    error += Squared(mean->GetComponent(static_cast<vtkIdType>(i), 0) - exact[i]);
    all += Squared(exact[i]);
  }
  return std::sqrt(error / all);
}

}

TEST(CurvatureScale, DefaultsConvergeWithTheOrderOfTheDifferences)
{
  const std::array<double, 3> errors{ ErrorOnEllipsoid(33), ErrorOnEllipsoid(65),
    ErrorOnEllipsoid(129) };
  std::printf("ellipsoid, defaults: relative errors %.2e, %.2e, %.2e at 33, 65, 129 nodes\n",
    errors[0], errors[1], errors[2]);
  EXPECT_GE(std::log2(errors[0] / errors[1]), 1.9);
  EXPECT_GE(std::log2(errors[1] / errors[2]), 1.9);
  // 8 bits, and noise: by two orders better than without smoothing.
  EXPECT_LT(ErrorOnEllipsoid(97, RoundTo(255.0)), 0.02);
  EXPECT_LT(ErrorOnEllipsoid(97, AddNoise(0.01)), 0.02);
}

// Once smoothing has removed the atoms, nothing changes from scale to scale: that is no small bias.
TEST(CurvatureScale, AtomsAreNotSmoothedAway)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-9.0, 9.0);
  std::vector<std::array<double, 3>> atoms(150);
  for (auto& atom : atoms)
  {
    atom = { uniform(random), uniform(random), uniform(random) };
  }
  const auto density = [&](double x, double y, double z)
  {
    double sum = 0.0;
    for (const auto& atom : atoms)
    {
      const double square =
        std::pow(x - atom[0], 2) + std::pow(y - atom[1], 2) + std::pow(z - atom[2], 2);
      sum += std::exp(-square / 5.0);
    }
    return sum;
  };
  const auto image = SampledImage(CenteredCube(40, 19.5), density, VTK_FLOAT);
  EXPECT_LT(ChooseCurvatureScale(MakeGridPart(image), 2).Scale, 0.8);
  EXPECT_LT(ChooseCurvatureScale(MakeGridPart(image), 4).Scale, 0.8);
}

// Nodes beside the step of a mask have no gradient, and do not contribute infinite values to the
// estimate.
TEST(CurvatureScale, MasksAreSmoothed)
{
  const auto mask = [](double x, double y, double z) { return Ball(x, y, z) > 0.0 ? 1.0 : 0.0; };
  const auto image = SampledImage(CenteredCube(48, 23.5), mask, VTK_FLOAT);
  const CurvatureScale choice = ChooseCurvatureScale(MakeGridPart(image), 2);
  EXPECT_GT(choice.Scale, 1.0);
  EXPECT_TRUE(std::isfinite(choice.Error(0.1, 0.01, 0.3)));
}

TEST(CurvatureScale, NothingToEstimate)
{
  const auto constant = [](double, double, double) { return 3.0; };
  for (const int size : { 1, 2, 9, 11, 12, 30 })
  {
    const CurvatureScale choice = ChooseCurvatureScale(
      MakeGridPart(SampledImage(CenteredCube(size, 1.0), constant, VTK_FLOAT)), 2);
    EXPECT_EQ(choice.Scale, 0.0) << size;
    EXPECT_EQ(choice.Samples, 0) << size;
  }
  const auto none = [](double, double, double) { return std::nan(""); };
  EXPECT_EQ(
    ChooseCurvatureScale(MakeGridPart(SampledImage(CenteredCube(30, 1.0), none, VTK_FLOAT)), 2)
      .Samples,
    0);
}

TEST(CurvatureScale, StatedErrorsMatchTheBall)
{
  const auto image = NoisyBall(0.3, 0.0);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  vtkDataArray* mean = PointArray(filter->GetOutput(), "MeanCurvature");
  vtkDataArray* stated = PointArray(filter->GetOutput(), "CurvatureError");
  vtkDataArray* valid = PointArray(filter->GetOutput(), "CurvatureValid");
  double square = 0.0, expected = 0.0;
  int count = 0, within = 0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    double p[3];
    image->GetPoint(id, p);
    const double r = std::hypot(std::hypot(p[0] - 23.5, p[1] - 23.5), p[2] - 23.5);
    if (valid->GetComponent(id, 0) == 0.0)
    {
      EXPECT_EQ(stated->GetComponent(id, 0), 0.0);
    }
    else if (std::abs(r - radius) < 1.0)
    {
      const double error = mean->GetComponent(id, 0) - 1.0 / r;
      ++count;
      square += error * error;
      expected += std::pow(stated->GetComponent(id, 0), 2);
      within += std::abs(error) <= 2.0 * stated->GetComponent(id, 0) ? 1 : 0;
    }
  }
  EXPECT_LT(std::sqrt(square / count), 0.05 / radius);
  EXPECT_GT(std::sqrt(expected / square), 0.5);
  EXPECT_LT(std::sqrt(expected / square), 2.0);
  EXPECT_GT(within, 0.85 * count);
}

TEST(CurvatureScale, ResultMatchesTheChosenScaleOnAnyNumberOfThreads)
{
  const auto image = NoisyBall(0.1, 0.0, 1.5);
  std::vector<std::vector<double>> results;
  for (const int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        vtkNew<vtkHessianCurvature> filter;
        filter->SetInputData(image);
        filter->Update();
        results.emplace_back();
        for (const char* name : { "MeanCurvature", "CurvatureScale", "CurvatureError" })
        {
          vtkDataArray* array = PointArray(filter->GetOutput(), name);
          for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
          {
            results.back().push_back(array->GetComponent(id, 0));
          }
        }
      });
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);

  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->Update();
  const double scale = PointArray(filter->GetOutput(), "CurvatureScale")->GetComponent(0, 0);
  EXPECT_GT(scale, 1.5);
  vtkNew<vtkHessianCurvature> fixed;
  fixed->SetInputData(image);
  fixed->SetScale(scale);
  fixed->Update();
  for (const char* name : { "MeanCurvature", "GaussianCurvature", "CurvatureValid" })
  {
    vtkDataArray* one = PointArray(filter->GetOutput(), name);
    vtkDataArray* other = PointArray(fixed->GetOutput(), name);
    for (vtkIdType id = 0; id < one->GetNumberOfTuples(); ++id)
    {
      ASSERT_NEAR(one->GetComponent(id, 0), other->GetComponent(id, 0),
        1e-6 * std::abs(one->GetComponent(id, 0)));
    }
  }
  EXPECT_EQ(fixed->GetOutput()->GetPointData()->GetArray("CurvatureError"), nullptr);
}

/// They were copied to single precision to measure the noise and for a fixed scale.
TEST(CurvatureScale, WideIntegersAreNotRounded)
{
  const auto noisy = NoisyBall(0.1, 0.0);
  const auto as = [&](int type, double offset)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->CopyStructure(noisy);
    image->AllocateScalars(type, 1);
    vtkDataArray* const from = noisy->GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      image->GetPointData()->GetScalars()->SetComponent(
        id, 0, offset + std::round(1000.0 * from->GetComponent(id, 0)));
    }
    return image;
  };
  for (const double offset : { 1e9, 1e14 })
  {
    for (const double scale : { 0.0, 1.5 }) // 0: chosen from the noise
    {
      const auto curvature = [&](int type)
      {
        auto filter = vtkSmartPointer<vtkHessianCurvature>::New();
        filter->SetInputData(as(type, offset));
        if (scale > 0.0)
        {
          filter->SetScale(scale);
        }
        filter->Update();
        return filter;
      };
      const auto expected = curvature(VTK_DOUBLE);
      const auto found = curvature(offset > 2e9 ? VTK_LONG_LONG : VTK_INT);
      for (const char* name : { "MeanCurvature", "CurvatureScale", "CurvatureError" })
      {
        vtkDataArray* const a = PointArray(expected->GetOutput(), name);
        vtkDataArray* const b = PointArray(found->GetOutput(), name);
        ASSERT_EQ(a == nullptr, b == nullptr) << name;
        for (vtkIdType id = 0; a && id < a->GetNumberOfTuples(); ++id)
        {
          const double value = a->GetComponent(id, 0);
          ASSERT_NEAR(b->GetComponent(id, 0), value, 1e-6 * std::abs(value)) << name << offset;
        }
      }
    }
  }
}

TEST(CurvatureScale, SettingAScaleSwitchesItOff)
{
  vtkNew<vtkHessianCurvature> filter;
  EXPECT_TRUE(filter->GetAutomaticScale());
  filter->SetScale(0.0);
  EXPECT_FALSE(filter->GetAutomaticScale());
  filter->AutomaticScaleOn();
  filter->SetScale(2.0);
  EXPECT_FALSE(filter->GetAutomaticScale());
  EXPECT_EQ(filter->GetScale(), 2.0);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetScale(2.0);
  EXPECT_EQ(filter->GetMTime(), before);
  filter->AutomaticScaleOn();
  filter->SetScaleOnly(3.0);
  EXPECT_TRUE(filter->GetAutomaticScale());
}

TEST(CurvatureScale, MeanCurvatureNeedNotBeAnOutput)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(NoisyBall(0.1, 0.0));
  filter->GetOutputArraySelection()->DisableArray("MeanCurvature");
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("MeanCurvature"), nullptr);
  EXPECT_GT(PointArray(filter->GetOutput(), "CurvatureError")->GetRange()[1], 0.0);
}

// In noise ten times as high as the edge, nothing of the ball's curvature is above its error.
TEST(CurvatureScale, UnresolvedCurvatureIsNoted)
{
  Model ball;
  Append(ball, Icosphere(8, radius), { 23.5, 23.5, 23.5 });
  for (const double deviation : { 0.02, 20.0 })
  {
    vtkNew<vtkHessianCurvature> filter;
    filter->SetInputData(0, NoisyBall(deviation, 0.0));
    filter->SetInputData(1, ToPolyData(ball));
    filter->Update();
    auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_EQ(output->GetFieldData()->GetAbstractArray("Notes") != nullptr, deviation > 1.0);
  }
}
