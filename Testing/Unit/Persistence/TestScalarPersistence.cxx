// The VTK filter: tables, points, cycles, simplification, thresholds, ranges, errors.

#include "vtkScalarPersistence.h"

#include "CubicalPeer.h"
#include "CubicalPersistence.h"
#include "ScalarFeatures.h"
#include "ScalarSimplification.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;

/// An image of n^3 nodes with spacing (0.5, 0.5, 0.5) round the origin, holding f(x, y, z).
template <typename Array, typename Function>
vtkSmartPointer<vtkImageData> Image(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, n + 2, -5, n - 6, 0, n - 1);
  image->SetSpacing(0.5, 0.5, 0.5);
  image->SetOrigin(-0.25 * n - 1.25, -0.25 * n + 2.75, -0.25 * n + 0.25);
  vtkNew<Array> values;
  values->SetName("Field");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->SetComponent(i, 0, f(p[0], p[1], p[2]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double Wave(double x, double y, double z)
{
  return std::sin(1.3 * x) * std::cos(0.9 * y) + std::sin(0.8 * y + 1.0) * std::cos(1.2 * z) +
    std::sin(z) * std::cos(0.8 * x + 0.5);
}

/// Distance from a circle of radius 4 in the plane z = 0.
double FromCircle(double x, double y, double z)
{
  return std::hypot(std::hypot(x, y) - 4.0, z);
}

VolumeView ViewOf(vtkImageData* image)
{
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int* n = image->GetDimensions();
  return VolumeView(values->GetPointer(0), { n[0], n[1], n[2] });
}

double At(vtkTable* table, const char* column, vtkIdType row)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  EXPECT_NE(array, nullptr) << column;
  return array ? array->GetComponent(row, 0) : std::nan("");
}

Bars BarsOfTable(vtkTable* table)
{
  Bars bars;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    bars.push_back(
      { At(table, "Dimension", row), At(table, "Birth", row), At(table, "Death", row) });
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

}

TEST(ScalarPersistence, DiagramIsThatOfTheAlgorithm)
{
  const auto image = Image<vtkFloatArray>(28, Wave);
  for (const bool superlevel : { false, true })
  {
    vtkNew<vtkScalarPersistence> filter;
    filter->SetInputData(image);
    filter->SetSuperlevel(superlevel);
    filter->Update();
    const Bars expected = BarsOf(ViewOf(image), superlevel);
    EXPECT_EQ(BarsOfTable(filter->GetDiagram()), expected);
    EXPECT_EQ(filter->GetDiagram(), filter->GetOutputDataObject(1));
    // The longest first, and the row is the FeatureId.
    for (vtkIdType row = 0; row < filter->GetDiagram()->GetNumberOfRows(); ++row)
    {
      EXPECT_EQ(At(filter->GetDiagram(), "FeatureId", row), static_cast<double>(row));
      EXPECT_TRUE(row == 0 ||
        At(filter->GetDiagram(), "Persistence", row) <=
          At(filter->GetDiagram(), "Persistence", row - 1));
      EXPECT_TRUE(std::isfinite(At(filter->GetDiagram(), "DeathShown", row)));
    }
    // A threshold: what reaches it stays, with its number.
    const double threshold = 0.5;
    filter->SetMinimumPersistence(threshold);
    filter->Update();
    Bars longer;
    for (const Bar& bar : expected)
    {
      if (std::abs(bar[2] - bar[1]) >= threshold)
      {
        longer.push_back(bar);
      }
    }
    EXPECT_EQ(BarsOfTable(filter->GetDiagram()), longer);
    EXPECT_LT(longer.size(), expected.size());
    EXPECT_EQ(At(filter->GetDiagram(), "FeatureId", 0), 0.0);
  }
}

TEST(ScalarPersistence, CurvesCountTheBarsAndIntegrateThem)
{
  const auto image = Image<vtkFloatArray>(28, Wave);
  for (const bool superlevel : { false, true })
  {
    vtkNew<vtkScalarPersistence> filter;
    filter->SetInputData(image);
    filter->SetSuperlevel(superlevel);
    filter->SetMinimumPersistence(0.4);
    filter->SetNumberOfLevels(101);
    filter->Update();
    vtkTable* curves = filter->GetBettiCurves();
    const Bars bars = BarsOf(ViewOf(image), superlevel);
    ASSERT_EQ(curves->GetNumberOfRows(), 101);
    double range[2];
    image->GetPointData()->GetScalars()->GetRange(range);
    EXPECT_EQ(At(curves, "Level", 0), range[0]);
    EXPECT_EQ(At(curves, "Level", 100), range[1]);
    for (vtkIdType row = 0; row < 101; ++row)
    {
      const double level = At(curves, "Level", row);
      double euler = 0.0;
      for (int d = 0; d < 3; ++d)
      {
        double all = 0.0;
        double filtered = 0.0;
        double integral = 0.0;
        for (const Bar& bar : bars)
        {
          const double s = superlevel ? -1.0 : 1.0;
          const bool alive = s * bar[1] <= s * level && s * level < s * bar[2];
          if (bar[0] == d)
          {
            all += alive;
            filtered += alive && std::abs(bar[2] - bar[1]) >= 0.4;
            integral += std::max(0.0, std::min(s * level, s * bar[2]) - s * bar[1]);
          }
        }
        const std::string name = "Beta" + std::to_string(d);
        EXPECT_EQ(At(curves, name.c_str(), row), all);
        EXPECT_EQ(At(curves, ("Filtered" + name).c_str(), row), filtered);
        EXPECT_NEAR(At(curves, ("Integral" + name).c_str(), row), integral, 1e-10);
        euler += (d == 1 ? -1.0 : 1.0) * all;
      }
      EXPECT_EQ(At(curves, "EulerNumber", row), euler);
    }
  }
}

TEST(ScalarPersistence, PointsAreWhereTheValuesAre)
{
  const auto image = Image<vtkFloatArray>(24, Wave);
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(image);
  filter->SuperlevelOn();
  filter->SetMinimumPersistence(0.1);
  filter->Update();
  vtkPolyData* points = filter->GetSaddles();
  vtkTable* diagram = filter->GetDiagram();
  const auto array = [&](const char* name) { return points->GetPointData()->GetArray(name); };
  const vtkIdType rows = diagram->GetNumberOfRows();
  ASSERT_GT(rows, 10);
  ASSERT_EQ(points->GetNumberOfPoints(), 2 * rows - 1);
  EXPECT_EQ(points->GetNumberOfVerts(), points->GetNumberOfPoints());
  std::vector<int> joined(static_cast<std::size_t>(rows), 0);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double value = array("Value")->GetComponent(i, 0);
    EXPECT_NEAR(
      value, Wave(points->GetPoint(i)[0], points->GetPoint(i)[1], points->GetPoint(i)[2]), 1e-6);
    const bool isBirth = value == array("Birth")->GetComponent(i, 0);
    EXPECT_TRUE(isBirth || value == array("Death")->GetComponent(i, 0));
    const double dimension = array("Dimension")->GetComponent(i, 0);
    EXPECT_EQ(array("CriticalIndex")->GetComponent(i, 0), dimension + (isBirth ? 0.0 : 1.0));
    if (i < rows)
    {
      // Point i is the saddle of row i.
      EXPECT_EQ(array("FeatureId")->GetComponent(i, 0), static_cast<double>(i));
      const double index = array("CriticalIndex")->GetComponent(i, 0);
      EXPECT_TRUE(index == 1.0 || index == 2.0 || std::isinf(At(diagram, "Death", i)));
    }
  }
  // Components end in an elder, which lives longer and so has a lower number.
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const double joins = At(diagram, "Joins", row);
    EXPECT_LT(joins, static_cast<double>(row));
    const bool isComponent = At(diagram, "Dimension", row) == 0.0;
    EXPECT_TRUE(!isComponent || joins >= 0.0 || std::isinf(At(diagram, "Death", row)));
  }
}

TEST(ScalarPersistence, CycleRoundARing)
{
  const auto image = Image<vtkFloatArray>(28, FromCircle);
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(image);
  filter->SetMinimumPersistence(1.0);
  filter->CyclesOn();
  filter->Update();
  vtkPolyData* lines = filter->GetCycleLines();
  ASSERT_EQ(lines->GetNumberOfCells(), 1);
  vtkNew<vtkIdList> ids;
  lines->GetCellPoints(0, ids);
  ASSERT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1));
  double turns = 0.0;
  for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
  {
    double p[3];
    double q[3];
    lines->GetPoint(ids->GetId(i), p);
    lines->GetPoint(ids->GetId(i + 1), q);
    EXPECT_LE(FromCircle(p[0], p[1], p[2]),
      lines->GetCellData()->GetArray("Birth")->GetComponent(0, 0) + 1e-6);
    turns += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]) / (2.0 * Pi);
  }
  EXPECT_NEAR(std::abs(turns), 1.0, 1e-9);
  const double length = lines->GetCellData()->GetArray("Length")->GetComponent(0, 0);
  EXPECT_GT(length, 0.9 * 8.0 * Pi);
  EXPECT_LT(length, 1.25 * 8.0 * Pi); // along the grid it would be 4 / Pi, and the ring is thin
}

TEST(ScalarPersistence, EveryCycleIsOneOfItsClass)
{
  // Every cycle runs below the birth of its class, reaches it, and closes.
  const auto image = Image<vtkFloatArray>(24, Wave);
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(image);
  filter->CyclesOn();
  filter->SetMaximumNumberOfCycles(1000);
  filter->Update();
  vtkPolyData* lines = filter->GetCycleLines();
  ASSERT_GT(lines->GetNumberOfCells(), 10);
  std::vector<double> highest(
    static_cast<std::size_t>(filter->GetDiagram()->GetNumberOfRows()), -Infinity);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < lines->GetNumberOfCells(); ++cell)
  {
    lines->GetCellPoints(cell, ids);
    ASSERT_GE(ids->GetNumberOfIds(), 5);
    const auto feature =
      static_cast<std::size_t>(lines->GetCellData()->GetArray("FeatureId")->GetComponent(cell, 0));
    EXPECT_EQ(lines->GetCellData()->GetArray("Dimension")->GetComponent(cell, 0), 1.0);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      double p[3];
      double q[3];
      lines->GetPoint(ids->GetId(i), p);
      lines->GetPoint(ids->GetId(i + 1), q);
      for (int a = 0; a < 3; ++a)
      {
        EXPECT_LE(std::abs(p[a] - q[a]), 0.5 + 1e-9);
      }
      const auto node = image->FindPoint(p);
      highest[feature] =
        std::max(highest[feature], image->GetPointData()->GetScalars()->GetComponent(node, 0));
    }
  }
  std::size_t seen = 0;
  for (std::size_t i = 0; i < highest.size(); ++i)
  {
    if (At(filter->GetDiagram(), "Dimension", static_cast<vtkIdType>(i)) == 1.0)
    {
      EXPECT_EQ(highest[i], At(filter->GetDiagram(), "Birth", static_cast<vtkIdType>(i)));
      ++seen;
    }
  }
  EXPECT_GT(seen, 10u);
}

TEST(ScalarPersistence, SimplifiedHasTheExtremaThatWereKept)
{
  for (const bool superlevel : { false, true })
  {
    const auto image = Image<vtkFloatArray>(28,
      [](double x, double y, double z)
      { return Wave(x, y, z) + 0.2 * std::sin(37.0 * x + 11.0 * y) * std::cos(29.0 * z); });
    vtkNew<vtkScalarPersistence> filter;
    filter->SetInputData(image);
    filter->SetSuperlevel(superlevel);
    filter->SetMinimumPersistence(0.5);
    filter->SimplifyOn();
    filter->Update();
    vtkImageData* simplified = filter->GetSimplified();
    ASSERT_EQ(simplified->GetNumberOfPoints(), image->GetNumberOfPoints());
    EXPECT_EQ(simplified->GetOrigin()[1], image->GetOrigin()[1]);
    double worst = 0.0;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst,
        std::abs(simplified->GetPointData()->GetScalars()->GetComponent(i, 0) -
          image->GetPointData()->GetScalars()->GetComponent(i, 0)));
    }
    EXPECT_GT(worst, 0.0);
    EXPECT_LT(worst, 0.5);
    const auto count = [](const Bars& bars, double dimension)
    {
      return std::count_if(
        bars.begin(), bars.end(), [&](const Bar& bar) { return bar[0] == dimension; });
    };
    const Bars before = BarsOfTable(filter->GetDiagram());
    const Bars all = BarsOf(ViewOf(image), superlevel);
    const Bars after = BarsOf(ViewOf(simplified), superlevel);
    EXPECT_EQ(count(after, 0.0), count(before, 0.0));
    EXPECT_EQ(count(after, 2.0), count(before, 2.0));
    EXPECT_GT(count(all, 0.0), 2 * count(before, 0.0));
  }
}

TEST(ScalarPersistence, RangeUnitsAndTheLargestGap)
{
  // Three pits of depth 10, 6 and 1 in a plain of 20.
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 1, 1);
  vtkNew<vtkShortArray> values;
  for (const int v : { 10, 20, 14, 20, 19, 20, 20, 20, 20 })
  {
    values->InsertNextValue(static_cast<short>(v));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(image);
  filter->Update();
  EXPECT_EQ(
    BarsOfTable(filter->GetDiagram()), (Bars{ { 0, 10, Infinity }, { 0, 14, 20 }, { 0, 19, 20 } }));
  filter->SetPersistenceUnit(vtkScalarPersistence::LargestGap);
  filter->Update();
  EXPECT_EQ(BarsOfTable(filter->GetDiagram()), (Bars{ { 0, 10, Infinity }, { 0, 14, 20 } }));
  filter->SetPersistenceUnit(vtkScalarPersistence::StandardDeviations);
  filter->SetMinimumPersistence(1.0); // the standard deviation is 3.4
  filter->Update();
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 2);
  filter->SetMinimumPersistence(2.0);
  filter->Update();
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 1);
  filter->SetPersistenceUnit(vtkScalarPersistence::Absolute);
  filter->SetMinimumPersistence(0.0);
  filter->UseRangeOn();
  filter->SetRange(5.0, 15.0);
  filter->Update();
  ASSERT_EQ(filter->GetDiagram()->GetNumberOfRows(), 2);
  EXPECT_EQ(At(filter->GetDiagram(), "Persistence", 1), 1.0); // of 14 to 20, what lies below 15
  EXPECT_EQ(At(filter->GetDiagram(), "Death", 1), 20.0);
  EXPECT_EQ(At(filter->GetBettiCurves(), "Level", 0), 5.0);
  EXPECT_EQ(At(filter->GetBettiCurves(), "Beta0", 0), 0.0);
}

TEST(ScalarPersistence, ConstantSingleAndEmptyImages)
{
  vtkNew<vtkScalarPersistence> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SimplifyOn();
  filter->CyclesOn();
  for (const int n : { 1, 4 })
  {
    filter->SetInputData(Image<vtkDoubleArray>(n, [](double, double, double) { return 3.0; }));
    filter->Update();
    EXPECT_EQ(BarsOfTable(filter->GetDiagram()), (Bars{ { 0, 3, Infinity } }));
    ASSERT_EQ(filter->GetBettiCurves()->GetNumberOfRows(), 1);
    EXPECT_EQ(At(filter->GetBettiCurves(), "Beta0", 0), 1.0);
    EXPECT_EQ(At(filter->GetBettiCurves(), "EulerNumber", 0), 1.0);
    EXPECT_EQ(filter->GetSaddles()->GetNumberOfPoints(), 1);
    EXPECT_EQ(filter->GetCycleLines()->GetNumberOfCells(), 0);
    EXPECT_EQ(filter->GetSimplified()->GetNumberOfPoints(), n * n * n);
  }
  filter->SetInputData(vtkNew<vtkImageData>());
  filter->Update();
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 0);
  EXPECT_FALSE(observer->GetError());
}

TEST(ScalarPersistence, KeepsItsInputAndWorksWithoutNames)
{
  const auto image = Image<vtkFloatArray>(16, Wave);
  image->GetPointData()->GetScalars()->SetName(nullptr);
  vtkNew<vtkImageData> copy;
  copy->DeepCopy(image);
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(image);
  filter->SetMinimumPersistence(0.5);
  filter->SimplifyOn();
  filter->Update();
  EXPECT_GT(filter->GetDiagram()->GetNumberOfRows(), 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    ASSERT_EQ(image->GetPointData()->GetScalars()->GetComponent(i, 0),
      copy->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
}

TEST(ScalarPersistence, BadInputIsToldInASentence)
{
  vtkNew<vtkScalarPersistence> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto image = Image<vtkFloatArray>(10, Wave);
  const auto said = [&]()
  {
    observer->Clear();
    filter->Modified();
    filter->Update();
    const bool empty = filter->GetDiagram()->GetNumberOfRows() == 0 &&
      filter->GetBettiCurves()->GetNumberOfRows() == 0 &&
      filter->GetSaddles()->GetNumberOfPoints() == 0;
    EXPECT_EQ(empty, observer->GetError());
    return observer->GetErrorMessage();
  };
  filter->SetInputData(image);
  EXPECT_EQ(said(), "");
  for (const double bad : { -1.0, std::nan(""), Infinity })
  {
    filter->SetMinimumPersistence(bad);
    EXPECT_NE(said().find("MinimumPersistence is"), std::string::npos);
  }
  filter->SetMinimumPersistence(0.0);
  filter->UseRangeOn();
  for (const double bad : { -1.0, std::nan(""), Infinity })
  {
    filter->SetRange(0.0, bad);
    EXPECT_NE(said().find("Range goes from"), std::string::npos);
  }
  filter->UseRangeOff();
  filter->SetNumberOfLevels(1);
  EXPECT_NE(said().find("NumberOfLevels is 1"), std::string::npos);
  filter->SetNumberOfLevels(10);
  filter->SetMaximumNumberOfCycles(0);
  EXPECT_NE(said().find("MaximumNumberOfCycles is 0"), std::string::npos);
  filter->SetMaximumNumberOfCycles(1);
  image->GetPointData()->GetScalars()->SetComponent(123, 0, std::nan(""));
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_NE(said().find("node (3, 2, 1) is not a number"), std::string::npos);
  image->GetPointData()->GetScalars()->SetComponent(123, 0, 0.0);
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_EQ(said(), "");
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "None");
  EXPECT_NE(said().find("no array 'None'"), std::string::npos);
}

TEST(ScalarPersistence, AbortLeavesNothing)
{
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(Image<vtkFloatArray>(60, Wave));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 0);
  EXPECT_EQ(filter->GetBettiCurves()->GetNumberOfRows(), 0);
}
