// Quantiles by area against Archimedes: on a sphere, height is spread evenly over the area.

#include "Core/PolyDataTriangles.h"
#include "Surfaces/AreaQuantiles.h"
#include "vtkAreaQuantiles.h"

#include <vtkCellCenters.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using isthmus::WeightedQuantile;

namespace
{

constexpr double radius = 5.0;

/// A sphere of uneven triangles with its height as point array `Height`.
vtkSmartPointer<vtkPolyData> Sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(2 * resolution);
  source->SetPhiResolution(resolution); // crowded at the poles
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    height->InsertNextValue(sphere->GetPoint(i)[2]);
  }
  sphere->GetPointData()->AddArray(height);
  return sphere;
}

struct Trial
{
  explicit Trial(vtkPolyData* data, int association = vtkDataObject::FIELD_ASSOCIATION_POINTS,
    const char* array = "Height")
  {
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->SetInputData(data);
    this->Filter->SetInputArrayToProcess(0, 0, 0, association, array);
  }

  double operator()(double lower, double upper, vtkIdType row)
  {
    this->Filter->SetLower(lower);
    this->Filter->SetUpper(upper);
    this->Filter->Update();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfRows(), 2);
    return this->Filter->GetOutput()->GetValueByName(row, "Range").ToDouble();
  }

  vtkNew<vtkAreaQuantiles> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
};

double Exact(double fraction)
{
  return radius * (2.0 * fraction - 1.0);
}

}

TEST(AreaQuantiles, OfWeightsByHand)
{
  const std::vector<isthmus::WeightedValue> values{ { 1.0, 1.0 }, { 2.0, 2.0 }, { 7.0, 1.0 } };
  EXPECT_EQ(WeightedQuantile(values, 0.0), 1.0);
  EXPECT_EQ(WeightedQuantile(values, 0.25), 1.0);
  EXPECT_EQ(WeightedQuantile(values, 0.26), 2.0);
  EXPECT_EQ(WeightedQuantile(values, 0.75), 2.0);
  EXPECT_EQ(WeightedQuantile(values, 0.76), 7.0);
  EXPECT_EQ(WeightedQuantile(values, 1.0), 7.0);
  for (const double wrong : { -0.1, 1.1, vtkMath::Nan() })
  {
    EXPECT_THROW(WeightedQuantile(values, wrong), std::invalid_argument) << wrong;
  }
  EXPECT_THROW(WeightedQuantile({}, 0.5), std::invalid_argument);
  EXPECT_THROW(WeightedQuantile({ { 1.0, 0.0 } }, 0.5), std::invalid_argument);
}

TEST(AreaQuantiles, PointsShareTheAreaOfTheirTriangles)
{
  const auto sphere = Sphere(40);
  const isthmus::PolyDataTriangles triangles(sphere);
  const std::vector<double> areas = isthmus::PointAreas(triangles.View());
  double all = 0.0;
  for (vtkIdType t = 0; t < triangles.View().NumberOfTriangles(); ++t)
  {
    all += isthmus::TriangleArea(triangles.View(), t);
  }
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), all, 1e-10 * all);
  EXPECT_NEAR(all / (4.0 * vtkMath::Pi() * radius * radius), 1.0, 5e-3);
}

TEST(AreaQuantiles, HeightOnASphereIsSpreadEvenly)
{
  for (const int resolution : { 25, 50, 100, 200 })
  {
    Trial trial(Sphere(resolution));
    double worst = 0.0;
    for (const double fraction : { 0.02, 0.1, 0.37, 0.8, 0.98 })
    {
      worst = std::max(worst, std::abs(trial(fraction, 1.0, 0) - Exact(fraction)));
      worst = std::max(worst, std::abs(trial(0.0, fraction, 1) - Exact(fraction)));
    }
    // A quantile is one of the values, which are at most pi r / resolution apart.
    EXPECT_LT(worst, 1.1 * vtkMath::Pi() * radius / resolution) << resolution;
    EXPECT_FALSE(trial.Observer->GetError());
  }
}

TEST(AreaQuantiles, AnArrayOfCellsCountsByTheirOwnArea)
{
  const auto sphere = Sphere(100);
  vtkNew<vtkCellCenters> centers;
  centers->SetInputData(sphere);
  centers->Update();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (vtkIdType i = 0; i < sphere->GetNumberOfCells(); ++i)
  {
    height->InsertNextValue(centers->GetOutput()->GetPoint(i)[2]);
  }
  sphere->GetCellData()->AddArray(height);
  Trial trial(sphere, vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_NEAR(trial(0.1, 0.9, 0), Exact(0.1), 0.1);
  EXPECT_NEAR(trial(0.1, 0.9, 1), Exact(0.9), 0.1);
}

TEST(AreaQuantiles, NaNAndInvalidValuesDoNotCount)
{
  const auto sphere = Sphere(100);
  auto* height = vtkDoubleArray::SafeDownCast(sphere->GetPointData()->GetArray("Height"));
  vtkNew<vtkUnsignedCharArray> valid;
  valid->SetName("CurvatureValid");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const bool north = height->GetValue(i) > 0.0;
    valid->InsertNextValue(height->GetValue(i) > -0.5 * radius ? 1 : 0);
    height->SetValue(i, north ? vtkMath::Nan() : height->GetValue(i));
  }
  Trial withNaN(sphere);
  EXPECT_NEAR(withNaN(0.1, 0.9, 0), -0.9 * radius, 0.15); // of the southern half
  sphere->GetPointData()->AddArray(valid);
  Trial both(sphere);
  EXPECT_NEAR(both(0.1, 0.9, 0), -0.45 * radius, 0.15); // of the zone from -r/2 to 0
}

TEST(AreaQuantiles, OfPointsAloneEachCountsAlike)
{
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  for (int i = 0; i < 100; ++i)
  {
    places->InsertNextPoint(i, 0.0, 0.0);
    height->InsertNextValue((37 * i) % 100 + 1.0);
  }
  points->SetPoints(places);
  points->GetPointData()->AddArray(height);
  Trial trial(points);
  EXPECT_EQ(trial(0.02, 0.98, 0), 2.0);
  EXPECT_EQ(trial(0.02, 0.98, 1), 98.0);
}

TEST(AreaQuantiles, EmptyInputGivesNoRowsAndNoMessage)
{
  Trial empty(vtkNew<vtkPolyData>{});
  empty.Filter->Update();
  EXPECT_EQ(empty.Filter->GetOutput()->GetNumberOfRows(), 0);
  const auto sphere = Sphere(10);
  vtkDoubleArray::SafeDownCast(sphere->GetPointData()->GetArray("Height"))
    ->FillComponent(0, vtkMath::Nan());
  Trial noNumbers(sphere);
  noNumbers.Filter->Update();
  EXPECT_EQ(noNumbers.Filter->GetOutput()->GetNumberOfRows(), 0);
  EXPECT_FALSE(empty.Observer->GetError() || noNumbers.Observer->GetError());
}

TEST(AreaQuantiles, WrongFractionsAndArraysAreReported)
{
  Trial fraction(Sphere(10));
  fraction.Filter->SetUpper(1.5);
  fraction.Filter->Update();
  EXPECT_NE(fraction.Observer->GetErrorMessage().find("Upper is 1.5, but it must be from 0 to 1"),
    std::string::npos)
    << fraction.Observer->GetErrorMessage();
  EXPECT_EQ(fraction.Filter->GetOutput()->GetNumberOfRows(), 0);
  Trial array(Sphere(10), vtkDataObject::FIELD_ASSOCIATION_POINTS, "NoSuchArray");
  array.Filter->Update();
  EXPECT_NE(array.Observer->GetErrorMessage().find("no array of one component"), std::string::npos)
    << array.Observer->GetErrorMessage();
}
