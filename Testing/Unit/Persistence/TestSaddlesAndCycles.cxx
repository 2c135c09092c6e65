// The points and cycles of vtkScalarPersistence: their positions, and the classes of the cycles.

#include "vtkScalarPersistence.h"

#include "ScalarImages.h"

#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkPolyData.h>

#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

TEST(ScalarPersistence, PointsAreWhereTheValuesAre)
{
  const auto image = Image<vtkFloatArray>(24, Ripple);
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
      value, Ripple(points->GetPoint(i)[0], points->GetPoint(i)[1], points->GetPoint(i)[2]), 1e-6);
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
  const auto image = Image<vtkFloatArray>(24, Ripple);
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
