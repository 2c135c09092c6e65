// Gauss map, shape operator, fundamental forms, normal curvature and the mean curvature normal, of
// graphs, cylinders and meshes where they are known.

#include "FieldImage.h"
#include "HessianCurvatureFields.h"
#include "SurfaceModels.h"
#include "vtkHessianCurvature.h"
#include "vtkSurfaceCurvature.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace isthmus::testing;

namespace
{

std::array<double, 6> Tuple(vtkAlgorithm* filter, const char* name, vtkIdType id)
{
  std::array<double, 6> values{};
  vtkDataArray* array = PointArray(filter->GetOutputDataObject(0), name);
  if (!array)
  {
    ADD_FAILURE() << name;
    return values;
  }
  array->GetTuple(id, values.data());
  return values;
}

double One(vtkAlgorithm* filter, const char* name, vtkIdType id)
{
  return Tuple(filter, name, id)[0];
}

constexpr const char* Arrays[] = { "GaussMap", "ShapeOperator", "FirstFundamentalForm",
  "SecondFundamentalForm", "AreaElement", "NormalCurvature" };

/// K and H from the two forms (thesis 2.25, 2.26).
std::array<double, 2> FromForms(vtkAlgorithm* filter, vtkIdType id)
{
  const auto [e, f, g, a1, a2, a3] = Tuple(filter, "FirstFundamentalForm", id);
  const auto [l, m, n, b1, b2, b3] = Tuple(filter, "SecondFundamentalForm", id);
  const double area = e * g - f * f;
  return { (l * n - m * m) / area, (e * n - 2.0 * f * m + g * l) / (2.0 * area) };
}

}

// The level sets of f(x, y) - z are graphs; differences of quadratics are exact.
TEST(DifferentialForms, OfAGraphMatchItsDerivatives)
{
  const auto graph = SampledImage(CenteredCube(9, 1.0),
    [](double x, double y, double z)
    { return 0.2 * x * x + 0.3 * x * y - 0.15 * y * y + 0.1 * x - z; });
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(graph);
  filter->AutomaticScaleOff();
  filter->GetOutputArraySelection()->EnableAllArrays();
  filter->SetNormalCurvatureDirection(0.0, 3.0, 0.0);
  filter->Update();
  int checked = 0;
  for (vtkIdType id = 0; id < graph->GetNumberOfPoints(); ++id)
  {
    if (One(filter, "CurvatureValid", id) == 0.0)
    {
      EXPECT_EQ(Tuple(filter, "GaussMap", id), (std::array<double, 6>{}));
      continue;
    }
    const double* p = graph->GetPoint(id);
    const double fx = 0.4 * p[0] + 0.3 * p[1] + 0.1, fy = 0.3 * p[0] - 0.3 * p[1];
    const double w = std::sqrt(1.0 + fx * fx + fy * fy);
    const double l = -0.4 / w, m = -0.3 / w, n = 0.3 / w; // a sphere is positive
    const auto expect = [&](const char* name, const std::array<double, 6>& values)
    {
      for (std::size_t k = 0; k < 6; ++k)
      {
        EXPECT_NEAR(Tuple(filter, name, id)[k], values[k], 1e-12) << name << " " << k;
      }
    };
    expect("GaussMap", { -fx / w, -fy / w, 1.0 / w });
    expect("FirstFundamentalForm", { 1.0 + fx * fx, fx * fy, 1.0 + fy * fy });
    expect("SecondFundamentalForm", { l, m, n });
    expect("AreaElement", { w });
    EXPECT_NEAR(FromForms(filter, id)[0], One(filter, "GaussianCurvature", id), 1e-12);
    EXPECT_NEAR(FromForms(filter, id)[1], One(filter, "MeanCurvature", id), 1e-12);
    const auto shape = Tuple(filter, "ShapeOperator", id);
    EXPECT_NEAR(shape[0] + shape[1] + shape[2], 2.0 * One(filter, "MeanCurvature", id), 1e-12);
    // y without its part along the normal, in terms of x_u and x_v.
    const double a = -fx * fy / (w * w), b = (1.0 + fx * fx) / (w * w);
    EXPECT_NEAR(
      One(filter, "NormalCurvature", id), (l * a * a + 2.0 * m * a * b + n * b * b) / b, 1e-12);
    ++checked;
  }
  EXPECT_EQ(checked, 7 * 7 * 7);
}

TEST(DifferentialForms, NormalCurvatureOfACylinderIsEulers)
{
  const auto cylinder =
    SampledImage(CenteredCube(15, 1.0), [](double x, double y, double) { return x * x + y * y; });
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(cylinder);
  filter->AutomaticScaleOff();
  filter->InsideIsHigherOff();
  filter->GetOutputArraySelection()->EnableArray("NormalCurvature");
  filter->GetOutputArraySelection()->DisableArray("MaximumCurvature");
  double halfway[3] = { 0.5, 0.0, 0.0 };
  const vtkIdType onX = cylinder->FindPoint(halfway);
  const double radius = cylinder->GetPoint(onX)[0];
  const auto along = [&](double x, double y, double z)
  {
    filter->SetNormalCurvatureDirection(x, y, z);
    filter->Update();
    return One(filter, "NormalCurvature", onX);
  };
  EXPECT_NEAR(along(0, 2, 0), 1.0 / radius, 1e-12);
  EXPECT_NEAR(along(0, 0, 1), 0.0, 1e-12);
  EXPECT_EQ(along(1, 0, 0), 0.0) << "normal to the surface";
  EXPECT_NEAR(along(7, 1, 1), 0.5 / radius, 1e-12);
  EXPECT_NEAR(along(0, 1, -std::sqrt(3.0)), 0.25 / radius, 1e-12);
  vtkDataObject* output = filter->GetOutputDataObject(0);
  EXPECT_FALSE(PointArray(output, "MaximumCurvature"));
  EXPECT_FALSE(PointArray(output, "PrincipalDirection1"));
  EXPECT_FALSE(PointArray(output, "GaussMap"));
  EXPECT_TRUE(PointArray(output, "MinimumCurvature"));
}

TEST(DifferentialForms, GaussMapPointsOutwards)
{
  Lattice lattice = Block();
  lattice.Spacing = { 0.1, -0.07, 0.13 };
  lattice.Origin = { 0.3, 1.4, 0.5 };
  const auto image = SampledImage(Rotate(lattice), Spheres);
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(image);
  filter->SetAccuracy(4);
  filter->GetOutputArraySelection()->EnableAllArrays();
  for (const bool higher : { true, false })
  {
    filter->SetInsideIsHigher(higher);
    filter->Update();
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      const double* p = image->GetPoint(id);
      const double r = std::hypot(p[0], p[1], p[2]) * (higher ? 1.0 : -1.0);
      for (std::size_t k = 0; k < 3 && One(filter, "CurvatureValid", id) == 1.0; ++k)
      {
        ASSERT_NEAR(Tuple(filter, "GaussMap", id)[k], p[k] / r, 1e-4);
      }
    }
  }
}

TEST(DifferentialForms, AreMadeOnRequestAlone)
{
  vtkNew<vtkHessianCurvature> filter;
  filter->SetInputData(SampledImage(Block(), Spheres));
  filter->Update();
  vtkNew<vtkSurfaceCurvature> onMesh;
  onMesh->SetInputData(ToPolyData(Icosphere(3, 1.0)));
  onMesh->Update();
  for (const char* name : Arrays)
  {
    EXPECT_FALSE(PointArray(filter->GetOutputDataObject(0), name)) << name;
    EXPECT_FALSE(PointArray(onMesh->GetOutputDataObject(0), name)) << name;
  }
  EXPECT_FALSE(PointArray(onMesh->GetOutputDataObject(0), "MeanCurvatureNormal"));
  onMesh->GetOutputArraySelection()->EnableArray("NormalCurvature");
  onMesh->SetNormalCurvatureDirection(0, 0, 0);
  vtkNew<vtkTest::ErrorObserver> observer;
  onMesh->AddObserver(vtkCommand::ErrorEvent, observer);
  onMesh->Update();
  EXPECT_NE(observer->GetErrorMessage().find("NormalCurvatureDirection"), std::string::npos);
}

TEST(DifferentialForms, OfATorusMesh)
{
  vtkNew<vtkSurfaceCurvature> filter;
  filter->SetInputData(ToPolyData(Torus(60, 30, 2.0, 0.7)));
  filter->SetMethod(vtkSurfaceCurvature::EdgeTensor);
  filter->SetNeighbourhood(vtkSurfaceCurvature::Ball);
  filter->SetRadius(0.4);
  filter->GetOutputArraySelection()->EnableAllArrays();
  filter->SetNormalCurvatureDirection(0, 0, 1);
  filter->Update();
  vtkPolyData* torus = filter->GetOutput();
  for (vtkIdType id = 0; id < torus->GetNumberOfPoints(); ++id)
  {
    ASSERT_NEAR(FromForms(filter, id)[0], One(filter, "GaussianCurvature", id), 1e-9);
    ASSERT_NEAR(FromForms(filter, id)[1], One(filter, "MeanCurvature", id), 1e-9);
    const auto [e, f, g, a1, a2, a3] = Tuple(filter, "FirstFundamentalForm", id);
    ASSERT_NEAR(One(filter, "AreaElement", id), std::sqrt(e * g - f * f), 1e-9);
    // Along the axis a torus has the curvature of its tube.
    const double* p = torus->GetPoint(id);
    const double rise = p[2] / 0.7;
    if (std::abs(rise) < 0.9)
    {
      ASSERT_NEAR(One(filter, "NormalCurvature", id), 1.0 / 0.7, 0.1 / 0.7);
    }
    const double out = std::hypot(p[0], p[1]) - 2.0;
    const auto n = Tuple(filter, "GaussMap", id);
    ASSERT_NEAR(n[2], rise, 0.02);
    ASSERT_NEAR(n[0] * p[0] + n[1] * p[1], out / 0.7 * std::hypot(p[0], p[1]), 0.06);
  }
}

TEST(DifferentialForms, MeanCurvatureNormalIsTheCotangentFormula)
{
  constexpr double radius = 2.0;
  for (const bool turned : { false, true })
  {
    Model sphere = Icosphere(12, radius);
    if (turned)
    {
      TurnInsideOut(sphere);
    }
    for (const int method : { vtkSurfaceCurvature::AngleDefect, vtkSurfaceCurvature::EdgeTensor })
    {
      vtkNew<vtkSurfaceCurvature> filter;
      filter->SetInputData(ToPolyData(sphere));
      filter->SetMethod(method);
      filter->SetOrientation(vtkSurfaceCurvature::AsWound);
      filter->GetOutputArraySelection()->EnableArray("MeanCurvatureNormal");
      filter->Update();
      for (vtkIdType id = 0; id < filter->GetOutput()->GetNumberOfPoints(); ++id)
      {
        const double* p = filter->GetOutput()->GetPoint(id);
        const auto normal = Tuple(filter, "MeanCurvatureNormal", id);
        ASSERT_NEAR(std::hypot(normal[0], normal[1], normal[2]),
          std::abs(One(filter, "MeanCurvature", id)), 1e-12);
        ASSERT_GT(One(filter, "MeanCurvature", id) * (turned ? -1.0 : 1.0), 0.0);
        for (std::size_t k = 0; k < 3; ++k)
        {
          ASSERT_NEAR(normal[k], p[k] / (radius * radius), 0.03) << method;
        }
      }
    }
  }
}
