// Potential times curvature: a sphere in a dipole's potential and an ellipsoid, beside formulas.

#include "PolarizedCurvature.h"
#include "vtkHessianCurvature.h"
#include "vtkPolarizedCurvature.h"
#include "vtkScalarRegions.h"
#include "vtkSurfaceCurvature.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangle.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

using Field = std::function<double(const double*)>;

/// A point array of doubles with the values of `f` at the points.
void AddArray(vtkDataSet* data, const char* name, const Field& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(f(data->GetPoint(i)));
  }
  data->GetPointData()->AddArray(array);
}

/// Ellipsoid with these half axes and its exact curvatures: a fine triangulation by latitude.
vtkSmartPointer<vtkPolyData> Ellipsoid(double a, double b, double c, int rings = 240)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const int around = 2 * rings;
  const auto id = [&](int ring, int j) -> vtkIdType
  {
    return ring == 0
      ? 0
      : (ring == rings ? 1 : 2 + static_cast<vtkIdType>(ring - 1) * around + j % around);
  };
  points->InsertNextPoint(0, 0, c);
  points->InsertNextPoint(0, 0, -c);
  for (int ring = 1; ring < rings; ++ring)
  {
    for (int j = 0; j < around; ++j)
    {
      const double theta = M_PI * ring / rings, phi = 2.0 * M_PI * j / around;
      points->InsertNextPoint(a * std::sin(theta) * std::cos(phi),
        b * std::sin(theta) * std::sin(phi), c * std::cos(theta));
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int j = 0; j < around; ++j)
    {
      const vtkIdType low[3] = { id(ring, j), id(ring + 1, j), id(ring + 1, j + 1) };
      const vtkIdType high[3] = { id(ring, j), id(ring + 1, j + 1), id(ring, j + 1) };
      if (ring + 1 < rings)
      {
        triangles->InsertNextCell(3, low);
      }
      if (ring > 0)
      {
        triangles->InsertNextCell(3, high);
      }
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  // Support distance h = 1 / |grad|: K = h^4 / (abc)^2, H from the trace of the shape operator.
  const auto principal = [=](const double* p, int which)
  {
    const double a2 = a * a, b2 = b * b, c2 = c * c;
    const double g = p[0] * p[0] / (a2 * a2) + p[1] * p[1] / (b2 * b2) + p[2] * p[2] / (c2 * c2);
    const double gaussian = 1.0 / (a2 * b2 * c2 * g * g);
    const double mean = (a2 + b2 + c2 - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]) /
      (2.0 * a2 * b2 * c2 * std::pow(g, 1.5));
    const double d = std::sqrt(std::max(0.0, mean * mean - gaussian));
    return which == 1 ? mean + d : mean - d;
  };
  AddArray(surface, "MaximumCurvature", [=](const double* p) { return principal(p, 1); });
  AddArray(surface, "MinimumCurvature", [=](const double* p) { return principal(p, 2); });
  return surface;
}

vtkSmartPointer<vtkImageData> Image(double half, int nodes, const Field& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-3, nodes - 4, 0, nodes - 1, 5, nodes + 4); // extents need not begin at 0
  const double h = 2.0 * half / (nodes - 1);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-half + 3 * h, -half, -half - 5 * h);
  AddArray(image, "Potential", f);
  image->GetPointData()->SetActiveScalars("Potential");
  return image;
}

/// A filter with its words kept.
struct Trial
{
  Trial(vtkPolyData* surface, vtkImageData* image)
  {
    this->Filter->SetInputData(surface);
    if (image)
    {
      this->Filter->SetPotentialData(image);
    }
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
  }
  vtkPolyData* Update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  std::string Error() const { return this->Observer->GetErrorMessage(); }

  vtkNew<vtkPolarizedCurvature> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> PipelineObserver;
};

double Value(vtkPolyData* surface, const char* name, vtkIdType point)
{
  return surface->GetPointData()->GetArray(name)->GetComponent(point, 0);
}

/// Area of all triangles by the class of most of their corners.
std::array<double, 5> ClassAreas(vtkPolyData* surface)
{
  std::array<double, 5> areas{};
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    auto* triangle = vtkTriangle::SafeDownCast(surface->GetCell(cell));
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto site =
        static_cast<std::size_t>(Value(surface, "SiteClass", triangle->GetPointId(corner)));
      areas[site] += triangle->ComputeArea() / 3.0;
    }
  }
  return areas;
}

/// Potential of a dipole of moment m along z at the origin, Phi = m z / r^3.
double Dipole(const double* p)
{
  const double r2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  return 30.0 * p[2] / std::max(std::pow(r2, 1.5), 1e-3);
}

vtkImageData* DipoleImage()
{
  static const vtkSmartPointer<vtkImageData> image = Image(8.0, 161, Dipole);
  return image;
}

}

TEST(PolarizedCurvature, OnASphereInADipolesPotential)
{
  const double radius = 5.0;
  const auto sphere = Ellipsoid(radius, radius, radius);
  const auto image = DipoleImage();
  Trial run(sphere, image);
  vtkPolyData* output = run.Update();
  EXPECT_EQ(run.Error(), "");
  const double top = 30.0 / (radius * radius * radius); // largest product: Phi at the pole / r
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double phi = Dipole(output->GetPoint(i));
    ASSERT_NEAR(Value(output, "Potential", i), phi, 1e-3 * top * radius);
    const double positive = std::max(phi, 0.0) / radius, negative = std::min(phi, 0.0) / radius;
    ASSERT_NEAR(Value(output, "PositivePotentialKappa1", i), positive, 1e-3 * top);
    ASSERT_NEAR(Value(output, "PositivePotentialKappa2", i), positive, 1e-3 * top);
    ASSERT_NEAR(Value(output, "NegativePotentialKappa1", i), negative, 1e-3 * top);
    ASSERT_NEAR(Value(output, "NegativePotentialKappa2", i), negative, 1e-3 * top);
    ASSERT_NEAR(Value(output, "PolarizedCurvature", i), phi / radius, 1e-3 * top);
    ASSERT_EQ(Value(output, "PotentialValid", i), 1.0);
  }
  // Convex everywhere: the upper half attracts negative proteins, the lower one positive ones.
  const std::array<double, 5> areas = ClassAreas(output);
  const double half = 2.0 * M_PI * radius * radius;
  EXPECT_NEAR(areas[1] + areas[3], 2.0 * half, 1e-3 * half);
  EXPECT_NEAR(areas[1] / (areas[1] + areas[3]), 0.5, 5e-3); // the equator's points are one ring
  EXPECT_EQ(areas[2], 0.0);
  EXPECT_EQ(areas[4], 0.0);
  auto* names =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("SiteClassNames"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(4), "site for a positively charged small ligand");
}

TEST(PolarizedCurvature, AreasBetweenThresholdsOfThePotentialAreAnalytic)
{
  // Phi = m z / r^3 on the sphere is linear in z, so the cap above Phi_0 has area 2 pi r (r - z_0).
  const double radius = 5.0;
  Trial run(Ellipsoid(radius, radius, radius), DipoleImage());
  vtkNew<vtkScalarRegions> regions;
  regions->SetInputData(run.Update());
  regions->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "PolarizedCurvature");
  const double levels[3] = { -0.12, 0.0, 0.06 }; // of Phi / r
  regions->SetNumberOfThresholds(3);
  for (int i = 0; i < 3; ++i)
  {
    regions->SetThreshold(i, levels[i]);
  }
  regions->Update();
  auto* areas = vtkDataArray::SafeDownCast(regions->GetRegionTable()->GetColumnByName("Area"));
  const double sphere = 4.0 * M_PI * radius * radius;
  double below = -radius;
  for (int region = 0; region < 4; ++region)
  {
    const double level = region < 3 ? levels[region] * std::pow(radius, 4) / 30.0 : radius;
    EXPECT_NEAR(
      areas->GetComponent(region, 0), 2.0 * M_PI * radius * (level - below), 1e-3 * sphere);
    below = level;
  }
}

TEST(PolarizedCurvature, OnAnEllipsoidTheTwoCurvaturesDiffer)
{
  const auto ellipsoid = Ellipsoid(6.0, 5.0, 3.0, 120);
  const Field linear = [](const double* p) { return 0.5 * p[0] - 0.25 * p[1] + p[2] + 0.3; };
  Trial run(ellipsoid, Image(7.0, 30, linear)); // trilinear interpolation keeps linear fields
  vtkPolyData* output = run.Update();
  double gap = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double phi = linear(output->GetPoint(i));
    const double k1 = Value(ellipsoid, "MaximumCurvature", i);
    const double k2 = Value(ellipsoid, "MinimumCurvature", i);
    ASSERT_NEAR(Value(output, "Potential", i), phi, 1e-12);
    ASSERT_NEAR(Value(output, "PositivePotentialKappa1", i), phi > 0 ? phi * k1 : 0.0, 1e-12);
    ASSERT_NEAR(Value(output, "NegativePotentialKappa2", i), phi < 0 ? phi * k2 : 0.0, 1e-12);
    ASSERT_NEAR(Value(output, "PolarizedCurvature", i), phi * k2, 1e-12);
    gap = std::max(gap, k1 - k2);
  }
  EXPECT_GT(gap, 0.3); // the test would not tell kappa_1 from kappa_2 on a sphere
}

TEST(PolarizedCurvature, WithCurvaturesOfOurFilters)
{
  // The whole pipeline on the ellipsoid: curvature by angle defect, potential of a dipole.
  const auto exact = Ellipsoid(6.0, 5.0, 4.0);
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(exact->GetPoints());
  bare->SetPolys(exact->GetPolys());
  vtkNew<vtkSurfaceCurvature> curvature;
  curvature->SetInputData(bare);
  curvature->SetDualArea(vtkSurfaceCurvature::Mixed);
  curvature->Update();
  Trial measured(curvature->GetOutput(), DipoleImage());
  Trial analytic(exact, DipoleImage());
  vtkPolyData* a = measured.Update();
  vtkPolyData* b = analytic.Update();
  double error = 0.0, size = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    // Away from the poles of the parameters, whose triangles are needles.
    if (std::abs(a->GetPoint(i)[2]) < 3.5)
    {
      const double d = Value(a, "PolarizedCurvature", i) - Value(b, "PolarizedCurvature", i);
      error += d * d;
      size += std::pow(Value(b, "PolarizedCurvature", i), 2);
    }
  }
  EXPECT_LT(std::sqrt(error / size), 1e-3);
  const std::array<double, 5> areas = ClassAreas(a), others = ClassAreas(b);
  const double total = others[1] + others[3] + others[0];
  for (std::size_t site = 0; site < 5; ++site)
  {
    EXPECT_NEAR(areas[site], others[site], 1e-3 * total);
  }
}

TEST(PolarizedCurvature, ClassesAreInTheOrderOfTheTable)
{
  using isthmus::Polarize;
  using isthmus::SiteClass;
  EXPECT_EQ(Polarize(2.0, 0.5, 0.1, 0.0).Site, SiteClass::NegativeProtein);
  EXPECT_EQ(Polarize(2.0, -0.1, -0.5, 0.0).Site, SiteClass::NegativeLigand);
  EXPECT_EQ(Polarize(-2.0, 0.5, 0.1, 0.0).Site, SiteClass::PositiveProtein);
  EXPECT_EQ(Polarize(-2.0, -0.1, -0.5, 0.0).Site, SiteClass::PositiveLigand);
  EXPECT_EQ(Polarize(2.0, 0.5, -0.4, 0.0).Site, SiteClass::NegativeProtein); // saddles
  EXPECT_EQ(Polarize(2.0, 0.4, -0.5, 0.0).Site, SiteClass::NegativeLigand);
  EXPECT_EQ(Polarize(-2.0, 0.5, -0.5, 0.0).Site, SiteClass::PositiveLigand);
  EXPECT_EQ(Polarize(0.0, 0.5, -0.5, 0.0).Site, SiteClass::None);
  EXPECT_EQ(Polarize(2.0, 0.0, 0.0, 0.0).Site, SiteClass::None);
  EXPECT_EQ(Polarize(2.0, 0.5, 0.1, 1.0).Site, SiteClass::None); // not above the threshold
  EXPECT_EQ(Polarize(2.0, 0.5, -0.49, 0.99).Site, SiteClass::NegativeProtein);
  const auto nothing = Polarize(std::nan(""), 0.5, -0.5, 0.0);
  EXPECT_EQ(nothing.Site, SiteClass::None);
  EXPECT_TRUE(std::isnan(nothing.PositiveKappa1) && std::isnan(nothing.NegativeKappa2));
}

TEST(PolarizedCurvature, PointsOffTheGridAreMarkedNotZero)
{
  const auto sphere = Ellipsoid(5.0, 5.0, 5.0, 30);
  Trial run(sphere, Image(4.0, 20, [](const double*) { return 1.0; }));
  vtkPolyData* output = run.Update();
  EXPECT_NE(run.Observer->GetWarningMessage().find("lie off the grid"), std::string::npos);
  vtkIdType off = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    const bool inside = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) }) <= 4.0 + 1e-9;
    EXPECT_EQ(Value(output, "PotentialValid", i), inside ? 1.0 : 0.0);
    EXPECT_EQ(std::isnan(Value(output, "Potential", i)), !inside);
    EXPECT_EQ(std::isnan(Value(output, "PolarizedCurvature", i)), !inside);
    EXPECT_EQ(Value(output, "SiteClass", i), inside ? 1.0 : 0.0);
    off += inside ? 0 : 1;
  }
  EXPECT_GT(off, 0);
  EXPECT_LT(off, output->GetNumberOfPoints());
}

TEST(PolarizedCurvature, ThePotentialMayBeAnArrayOfTheSurfaceAndOfAnyType)
{
  auto sphere = Ellipsoid(5.0, 5.0, 5.0, 20);
  vtkNew<vtkFloatArray> phi;
  phi->SetName("Potential");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    phi->InsertNextValue(i % 2 ? -2.0f : std::nanf(""));
  }
  sphere->GetPointData()->AddArray(phi);
  Trial run(sphere, nullptr);
  vtkPolyData* output = run.Update();
  EXPECT_EQ(run.Error(), "");
  EXPECT_NEAR(Value(output, "PolarizedCurvature", 41), -0.4, 1e-6);
  EXPECT_EQ(Value(output, "PotentialValid", 2), 0.0);
  // The input's own array is left as it was.
  EXPECT_EQ(sphere->GetPointData()->GetArray("Potential"), phi);
  EXPECT_EQ(sphere->GetPointData()->GetArray("PolarizedCurvature"), nullptr);
}

TEST(PolarizedCurvature, WhatIsMissingIsASentence)
{
  const auto image = Image(8.0, 10, [](const double*) { return 1.0; });
  const auto sphere = Ellipsoid(5.0, 5.0, 5.0, 10);
  {
    Trial run(sphere, nullptr);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("as an image on the second input"), std::string::npos)
      << run.Error();
  }
  {
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(sphere->GetPoints());
    bare->SetPolys(sphere->GetPolys());
    Trial run(bare, image);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("MaximumCurvature: run Surface Curvature"), std::string::npos)
      << run.Error();
  }
  {
    const auto far = Image(8.0, 10, [](const double*) { return 1.0; });
    far->SetOrigin(100.0, 0.0, 0.0);
    Trial run(sphere, far);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("misses the surface"), std::string::npos) << run.Error();
  }
  {
    vtkNew<vtkImageData> bare;
    bare->SetDimensions(3, 3, 3);
    Trial run(sphere, bare);
    EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
    EXPECT_NE(run.Error().find("image's point arrays"), std::string::npos) << run.Error();
  }
  vtkNew<vtkPolyData> empty;
  Trial run(empty, image);
  EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Error(), "");
}

TEST(PolarizedCurvature, AStopLeavesNothing)
{
  Trial run(Ellipsoid(5.0, 5.0, 5.0, 40), DipoleImage());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(run.Update()->GetNumberOfPoints(), 0);
  EXPECT_EQ(run.Error(), "");
}

TEST(PolarizedCurvature, SameBitsOnAnyNumberOfThreadsAndFromWholeNumbers)
{
  // A potential of whole numbers, and the same as double: the same products.
  const auto sphere = Ellipsoid(5.0, 4.0, 3.0, 60);
  const auto image = Image(6.0, 25, [](const double* p) { return std::round(3.0 * p[0] - p[2]); });
  const auto products = [&](vtkImageData* potential, int threads)
  {
    vtkNew<vtkDoubleArray> result;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, std::string("STDThread"), false },
      [&]()
      {
        Trial run(sphere, potential);
        result->DeepCopy(run.Update()->GetPointData()->GetArray("PolarizedCurvature"));
      });
    return std::vector<double>(
      result->GetPointer(0), result->GetPointer(0) + result->GetNumberOfValues());
  };
  vtkNew<vtkImageData> whole;
  whole->CopyStructure(image);
  vtkNew<vtkIntArray> values;
  values->DeepCopy(image->GetPointData()->GetScalars());
  values->SetName("AnyName");
  whole->GetPointData()->SetScalars(values);
  const std::vector<double> expected = products(image, 1);
  EXPECT_EQ(products(image, 4), expected);
  EXPECT_EQ(products(whole, 2), expected);
}

TEST(PolarizedCurvature, AConstantPotentialOfZeroHasNoClass)
{
  Trial run(Ellipsoid(5.0, 4.0, 3.0, 20), Image(8.0, 10, [](const double*) { return 0.0; }));
  vtkPolyData* output = run.Update();
  EXPECT_EQ(run.Error(), "");
  double range[2];
  output->GetPointData()->GetArray("SiteClass")->GetRange(range);
  EXPECT_EQ(range[1], 0.0);
}
