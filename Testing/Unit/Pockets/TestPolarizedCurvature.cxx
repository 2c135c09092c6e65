// Potential times curvature: a sphere in a dipole's potential and an ellipsoid, compared with
// formulas.

#include "Pockets/PolarizedCurvature.h"
#include "PolarizedTrial.h"
#include "vtkScalarRegions.h"
#include "vtkSurfaceCurvature.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTriangle.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace isthmus::testing;

namespace
{

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
  EXPECT_GT(gap, 0.3); // on a sphere, the test would not distinguish kappa_1 from kappa_2
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
