#include "Curvature/ScalarRegions.h"
#include "SharedData.h"
#include "SurfaceModels.h"
#include "vtkScalarRegions.h"

#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace isthmus::testing;
using namespace isthmus;

namespace
{

/// Two scalars whose level lines do not follow edges of triangles.
ThresholdedScalar Wave(const Model& mesh, double frequency, std::vector<double> thresholds)
{
  ThresholdedScalar scalar;
  scalar.Thresholds = std::move(thresholds);
  Vector low = mesh.Points[0], high = mesh.Points[0];
  for (const Vector& p : mesh.Points)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  for (const Vector& p : mesh.Points)
  {
    double value = 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double x = (p[a] - low[a]) / (high[a] - low[a]);
      value += std::sin((frequency + static_cast<double>(a)) * x) / 3.0;
    }
    scalar.Values.push_back(value);
  }
  return scalar;
}

double Sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Area below `threshold` by Fig. 4.1, written as in the thesis.
double AreaBelow(const Model& mesh, const std::vector<double>& values, double threshold)
{
  double total = 0.0;
  for (const auto& t : mesh.Triangles)
  {
    double f[3];
    int negative = 0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      f[i] = values[static_cast<std::size_t>(t[i])] - threshold;
      negative += f[i] < 0.0;
    }
    const TriangleMesh one{ { mesh.Points[static_cast<std::size_t>(t[0])],
                              mesh.Points[static_cast<std::size_t>(t[1])],
                              mesh.Points[static_cast<std::size_t>(t[2])] },
      { { 0, 1, 2 } } };
    const ThresholdedScalar nothing{ { 0, 0, 0 }, {} };
    const double area = RegionAreas(one, nothing, nothing, AreaRule::WholeTriangles)[0];
    double part = negative == 3 ? 1.0 : 0.0;
    for (std::size_t k = 0; k < 3 && (negative == 1 || negative == 2); ++k)
    {
      if ((f[k] < 0.0) == (negative == 1))
      {
        const double s = std::abs(f[k]) / (std::abs(f[k]) + std::abs(f[(k + 1) % 3]));
        const double u = std::abs(f[k]) / (std::abs(f[k]) + std::abs(f[(k + 2) % 3]));
        part = negative == 1 ? s * u : 1.0 - s * u;
      }
    }
    total += part * area;
  }
  return total;
}

}

TEST(ScalarRegions, OneTriangleByHand)
{
  // Area 1/2; the scalar is x, so x < 1/4 is 1/2 - (3/4)^2 / 2.
  const TriangleMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const ThresholdedScalar x{ { 0, 1, 0 }, { 0.25, 0.5 } };
  const ThresholdedScalar y{ { 0, 0, 1 }, { 0.5 } };
  const auto areas = RegionAreas(mesh, x, y, AreaRule::Fractional);
  const double expected[6] = { 0.125, 0.09375, 0.125, 0.03125, 0.125, 0.0 };
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(areas[i], expected[i], 1e-16) << i;
  }
  const auto whole = RegionAreas(mesh, x, y, AreaRule::WholeTriangles);
  EXPECT_EQ(whole, (std::vector<double>{ 0.5, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(MiddleRegion(2, 0, 1), 1u);
  EXPECT_EQ(MiddleRegion(2, 0, 2), 2u);
}

namespace
{

/// Regions of two scalars make up the surface, and their joint table has the single ones as
/// margins.
void CheckPartitions(const Model& mesh)
{
  const auto a = Wave(mesh, 9.0, { -0.4, -0.1, 0.0, 0.3 });
  const auto b = Wave(mesh, 14.0, { -0.2, 0.1, 0.11 });
  const ThresholdedScalar one{ a.Values, {} };
  const double total = RegionAreas(mesh.View(), one, one, AreaRule::WholeTriangles)[0];
  for (const AreaRule rule : { AreaRule::Fractional, AreaRule::WholeTriangles })
  {
    const auto singleA = RegionAreas(mesh.View(), a, one, rule);
    const auto singleB = RegionAreas(mesh.View(), b, one, rule);
    const auto joint = RegionAreas(mesh.View(), a, b, rule);
    EXPECT_NEAR(Sum(singleA) / total, 1.0, 1e-12);
    EXPECT_NEAR(Sum(joint) / total, 1.0, 1e-12);
    for (std::size_t i = 0; i < a.Regions(); ++i)
    {
      double row = 0.0;
      for (std::size_t j = 0; j < b.Regions(); ++j)
      {
        EXPECT_GE(joint[i * b.Regions() + j], -1e-12 * total);
        row += joint[i * b.Regions() + j];
      }
      EXPECT_NEAR(row, singleA[i], 1e-12 * total);
    }
    for (std::size_t j = 0; j < b.Regions(); ++j)
    {
      double column = 0.0;
      for (std::size_t i = 0; i < a.Regions(); ++i)
      {
        column += joint[i * b.Regions() + j];
      }
      EXPECT_NEAR(column, singleB[j], 1e-12 * total);
    }
  }
  double below = 0.0;
  const auto single = RegionAreas(mesh.View(), a, one, AreaRule::Fractional);
  for (std::size_t i = 0; i < a.Thresholds.size(); ++i)
  {
    below += single[i];
    EXPECT_NEAR(below / AreaBelow(mesh, a.Values, a.Thresholds[i]), 1.0, 1e-10);
  }
}

}

TEST(ScalarRegions, PartitionsAndMargins)
{
  CheckPartitions(Torus(60, 40, 2.0, 0.8));
  CheckPartitions(Icosphere(20, 7.0));
}

TEST(ScalarRegions, PartitionsAndMarginsOfAScannedSurface)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  CheckPartitions(ReadOFF((SharedDataFolder() / "surfaces/fertility.off").string()));
}

TEST(ScalarRegions, FractionalAreasConvergeToTheExactOnes)
{
  // The zone of the unit sphere with |z| < 1/3 has a third of its area.
  const Model sphere = Icosphere(40, 1.0);
  ThresholdedScalar z{ {}, { -1.0 / 3.0, 1.0 / 3.0 } };
  for (const Vector& p : sphere.Points)
  {
    z.Values.push_back(p[2]);
  }
  const auto areas = RegionAreas(sphere.View(), z, { z.Values, {} }, AreaRule::Fractional);
  EXPECT_NEAR(areas[1] / Sum(areas), 1.0 / 3.0, 2e-4);
  EXPECT_NEAR(areas[0], areas[2], 1e-12);
}

TEST(ScalarRegions, BadThresholdsAndValues)
{
  const Model mesh = Icosphere(2, 1.0);
  const std::vector<double> values(mesh.Points.size(), 0.0);
  const ThresholdedScalar one{ values, {} };
  EXPECT_THROW(RegionAreas(mesh.View(), { values, { 1.0, 0.0 } }, one, AreaRule::Fractional),
    std::invalid_argument);
  EXPECT_THROW(RegionAreas(mesh.View(), { values, { 1.0, 1.0 } }, one, AreaRule::Fractional),
    std::invalid_argument);
  std::vector<double> broken = values;
  broken[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(
    RegionAreas(mesh.View(), { broken, {} }, one, AreaRule::Fractional), std::invalid_argument);
  EXPECT_EQ(RegionAreas(Model{}.View(), { {}, { 0.0 } }, { {}, {} }, AreaRule::Fractional),
    (std::vector<double>{ 0.0, 0.0 }));
}

namespace
{

vtkSmartPointer<vtkPolyData> TorusWithScalars()
{
  const Model mesh = Torus(60, 40, 2.0, 0.8);
  auto surface = ToPolyData(mesh);
  for (const auto& [name, frequency] : { std::pair("Kappa", 9.0), std::pair("Phi", 14.0) })
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double value : Wave(mesh, frequency, {}).Values)
    {
      array->InsertNextValue(value);
    }
    surface->GetPointData()->AddArray(array);
  }
  surface->GetPointData()->SetActiveScalars("Kappa");
  return surface;
}

double Cell(vtkTable* table, vtkIdType row, const char* column)
{
  EXPECT_TRUE(table->GetColumnByName(column)) << column;
  return table->GetValueByName(row, column).ToDouble();
}

}

TEST(vtkScalarRegions, TablesLabelsAndColors)
{
  vtkNew<vtkScalarRegions> filter;
  filter->SetInputData(TorusWithScalars());
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Phi");
  filter->UseSecondScalarOn();
  filter->SetSecondThreshold(0, -0.2);
  filter->SetSecondThreshold(1, 0.3);
  filter->SetSweepSteps(4);
  filter->SetHistogramBins(10);
  filter->Update();

  vtkTable* regions = filter->GetRegionTable();
  ASSERT_EQ(regions->GetNumberOfRows(), 3);
  EXPECT_EQ(Cell(regions, 0, "From"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(Cell(regions, 1, "To"), 0.1);
  double total = 0.0;
  for (vtkIdType row = 0; row < 3; ++row)
  {
    const double area = Cell(regions, row, "Area");
    const double parts = Cell(regions, row, "Phi below -0.2") +
      Cell(regions, row, "Phi -0.2 to 0.3") + Cell(regions, row, "Phi from 0.3");
    EXPECT_NEAR(parts / area, 1.0, 1e-12);
    total += area;
  }

  vtkTable* sweep = filter->GetSweepTable();
  ASSERT_EQ(sweep->GetNumberOfRows(), 9);
  for (vtkIdType row = 0; row < 9; ++row)
  {
    const double sum =
      Cell(sweep, row, "Below") + Cell(sweep, row, "Between") + Cell(sweep, row, "Above");
    EXPECT_NEAR(sum / total, 1.0, 1e-12);
  }
  EXPECT_NEAR(Cell(sweep, 0, "Below"), Cell(regions, 0, "Area"), 1e-12 * total);
  EXPECT_EQ(Cell(sweep, 4, "Minimum"), 0.0);
  EXPECT_EQ(Cell(sweep, 4, "Maximum"), 0.1);
  EXPECT_EQ(Cell(sweep, 8, "Between"), 0.0);

  vtkTable* histogram = filter->GetHistogram();
  ASSERT_EQ(histogram->GetNumberOfRows(), 10);
  const Model torus = Torus(60, 40, 2.0, 0.8);
  const std::vector<double> kappa = Wave(torus, 9.0, {}).Values;
  const auto [lowest, highest] = std::minmax_element(kappa.begin(), kappa.end());
  const double width = (*highest - *lowest) / 10.0;
  double fractions = 0.0;
  for (vtkIdType row = 0; row < 10; ++row)
  {
    // The area of a bin is the area below its upper end minus that below its lower end (Fig. 4.1
    // twice).
    const double from = *lowest + width * static_cast<double>(row);
    const double below = row == 9 ? total : AreaBelow(torus, kappa, from + width);
    const double area = below - AreaBelow(torus, kappa, from);
    EXPECT_NEAR(Cell(histogram, row, "Value"), from + 0.5 * width, 1e-12);
    EXPECT_NEAR(Cell(histogram, row, "Area"), area, 1e-9 * total) << "bin " << row;
    EXPECT_NEAR(Cell(histogram, row, "Fraction"), area / total, 1e-9) << "bin " << row;
    fractions += Cell(histogram, row, "Fraction");
  }
  EXPECT_NEAR(fractions, 1.0, 1e-12);

  vtkPointData* points = filter->GetOutput()->GetPointData();
  vtkCellData* cells = filter->GetOutput()->GetCellData();
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double value = points->GetArray("Kappa")->GetComponent(i, 0);
    const double region = value < -0.1 ? 0 : value < 0.1 ? 1 : 2;
    EXPECT_EQ(points->GetArray("Region")->GetComponent(i, 0), region);
    EXPECT_EQ(points->GetArray("JointRegion")->GetComponent(i, 0),
      3 * region + points->GetArray("SecondRegion")->GetComponent(i, 0));
    EXPECT_EQ(points->GetArray("ToonColor")->GetComponent(i, 0) > 200, region == 0);
  }
  EXPECT_EQ(cells->GetArray("Region")->GetNumberOfTuples(), 4800);
  EXPECT_TRUE(cells->HasArray("JointRegion"));
}

TEST(vtkScalarRegions, ReportsBadInput)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkScalarRegions> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  const auto message = [&]()
  {
    observer->Clear();
    filter->Update();
    return observer->GetErrorMessage();
  };
  filter->SetInputData(ToPolyData(Icosphere(2, 1.0)));
  EXPECT_NE(message().find("no array for the first scalar"), std::string::npos);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  filter->SetInputData(TorusWithScalars());
  filter->SetThreshold(0, 5.0);
  EXPECT_NE(message().find("Threshold 1 is 0.1"), std::string::npos);
  EXPECT_EQ(filter->GetRegionTable()->GetNumberOfRows(), 0);
  filter->SetThreshold(0, 0.05);
  filter->SetSweepSteps(3);
  EXPECT_NE(message().find("SweepTarget is 0"), std::string::npos);
  EXPECT_EQ(filter->GetRegionTable()->GetNumberOfRows(), 0);
  filter->SetSweepSteps(1001);
  EXPECT_NE(message().find("SweepSteps is 1001, but it must be from 0 to 1000"), std::string::npos);
  filter->SetSweepSteps(0);
  filter->SetHistogramBins(0);
  EXPECT_EQ(filter->GetHistogramBins(), 0);
  EXPECT_NE(message().find("HistogramBins is 0, but it must be from 1"), std::string::npos);
  filter->SetHistogramBins(32);
  filter->SetAreaRule(2);
  EXPECT_NE(message().find("AreaRule is 2, but it must be from 0 to 1"), std::string::npos);
  filter->SetAreaRule(vtkScalarRegions::Fractional);
  EXPECT_EQ(message(), "");
  filter->SetNumberOfThresholds(0);
  EXPECT_EQ(message(), "");
  EXPECT_EQ(filter->GetRegionTable()->GetNumberOfRows(), 1);
  filter->SetInputData(vtkNew<vtkPolyData>());
  EXPECT_EQ(message(), "");
  EXPECT_EQ(filter->GetThreshold(99), 0.0);
}
