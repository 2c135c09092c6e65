#include "Tetrahedra/MeshQuality.h"

#include "vtkMeshQualityReport.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkMath.h>
#include <vtkMeshQuality.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;

namespace
{

vtkSmartPointer<vtkUnstructuredGrid> RandomTetrahedra(int count)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  for (vtkIdType i = 0; i < 4 * count; ++i)
  {
    points->InsertNextPoint(uniform(random), uniform(random), uniform(random));
  }
  grid->SetPoints(points);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType ids[] = { 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 };
    grid->InsertNextCell(VTK_TETRA, 4, ids);
  }
  return grid;
}

using Measure = vtkMeshQuality::QualityMeasureTypes;
constexpr Measure MinAngle = Measure::MIN_ANGLE;
constexpr Measure MaxAngle = Measure::MAX_ANGLE;

/// The measure of VTK's own filter, cell by cell.
vtkSmartPointer<vtkDataArray> FromVTK(vtkDataSet* mesh, Measure triangle, Measure tetrahedron)
{
  vtkNew<vtkMeshQuality> quality;
  quality->SetInputData(mesh);
  quality->SetTriangleQualityMeasure(triangle);
  quality->SetTetQualityMeasure(tetrahedron);
  quality->Update();
  return quality->GetOutput()->GetCellData()->GetArray("Quality");
}

}

TEST(MeshQuality, RegularCellsHaveTheIdealMeasures)
{
  const CellAngles triangle =
    MeasureTriangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 });
  EXPECT_NEAR(triangle.Smallest, 60.0, 1e-12);
  EXPECT_NEAR(triangle.Largest, 60.0, 1e-12);
  EXPECT_NEAR(triangle.RadiusEdge, 1.0 / std::sqrt(3.0), 1e-14);
  const CellAngles regular =
    MeasureTetrahedron({ 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 });
  EXPECT_NEAR(regular.RadiusEdge, std::sqrt(6.0) / 4.0, 1e-14);
  EXPECT_NEAR(regular.Smallest, std::acos(1.0 / 3.0) * 180.0 / 3.14159265358979, 1e-10);
  EXPECT_NEAR(std::abs(regular.Size), 8.0 / 3.0, 1e-14);
}

TEST(MeshQuality, ASliverHasAGoodRatioAndBadAngles)
{
  const double e = 0.01;
  const CellAngles sliver =
    MeasureTetrahedron({ 1, 0, e }, { -1, 0, e }, { 0, 1, -e }, { 0, -1, -e });
  EXPECT_LT(sliver.RadiusEdge, 0.75);
  EXPECT_LT(sliver.Smallest, 5.0);
  EXPECT_GT(sliver.Largest, 170.0);
  const CellAngles flat = MeasureTriangle({ 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 });
  EXPECT_EQ(flat.Smallest, 0.0);
  EXPECT_TRUE(std::isinf(flat.RadiusEdge));
}

TEST(MeshQuality, TetrahedraAgreeWithGradientsAndWithVTKsRadiusRatio)
{
  const auto grid = RandomTetrahedra(500);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->Update();
  auto* cells = vtkDataSet::SafeDownCast(report->GetOutputDataObject(0))->GetCellData();
  const auto radiusRatio = FromVTK(grid, MinAngle, Measure::RADIUS_RATIO);
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    std::array<Point3, 4> p;
    for (std::size_t c = 0; c < 4; ++c)
    {
      grid->GetPoint(4 * i + static_cast<vtkIdType>(c), p[c].data());
    }
    // Area vectors of the faces, pointing outward: the angle between two of them is 180 degrees
    // less the dihedral angle.
    std::array<Point3, 4> area{ Cross(p[2] - p[1], p[3] - p[1]), Cross(p[3] - p[0], p[2] - p[0]),
      Cross(p[1] - p[0], p[3] - p[0]), Cross(p[2] - p[0], p[1] - p[0]) };
    double smallest = 180.0, areas = 0.0, shortest = 10.0;
    for (std::size_t a = 0; a < 4; ++a)
    {
      areas += 0.5 * std::sqrt(Dot(area[a], area[a]));
      for (std::size_t b = 0; b < a; ++b)
      {
        const double cosine =
          -Dot(area[a], area[b]) / std::sqrt(Dot(area[a], area[a]) * Dot(area[b], area[b]));
        smallest = std::min(smallest, std::acos(cosine) * 180.0 / 3.14159265358979323846);
        shortest = std::min(shortest, std::sqrt(Dot(p[a] - p[b], p[a] - p[b])));
      }
    }
    ASSERT_NEAR(cells->GetArray("SmallestAngle")->GetComponent(i, 0), smallest, 1e-5);
    const double volume = std::abs(Dot(Cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0])) / 6.0;
    const double circumradius = radiusRatio->GetComponent(i, 0) * 9.0 * volume / areas;
    const double ratio = cells->GetArray("RadiusEdgeRatio")->GetComponent(i, 0);
    ASSERT_NEAR(ratio / (circumradius / shortest), 1.0, 1e-6);
  }
}

TEST(MeshQuality, TrianglesAgreeWithVTK)
{
  vtkNew<vtkMeshQualityReport> report;
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  report->SetInputData(sphere->GetOutput());
  report->Update();
  auto* cells = vtkDataSet::SafeDownCast(report->GetOutputDataObject(0))->GetCellData();
  const auto smallest = FromVTK(sphere->GetOutput(), MinAngle, MinAngle);
  const auto largest = FromVTK(sphere->GetOutput(), MaxAngle, MinAngle);
  for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfCells(); ++i)
  {
    ASSERT_NEAR(
      cells->GetArray("SmallestAngle")->GetComponent(i, 0), smallest->GetComponent(i, 0), 1e-4);
    ASSERT_NEAR(
      cells->GetArray("LargestAngle")->GetComponent(i, 0), largest->GetComponent(i, 0), 1e-4);
  }
}

namespace
{

/// The six dihedral angles of each tetrahedron between the normals of its faces, by vtkMath alone.
std::vector<double> DihedralHistogram(vtkUnstructuredGrid* grid, int bins)
{
  std::vector<double> counts(static_cast<std::size_t>(bins), 0.0);
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    double at[4][3];
    for (int k = 0; k < 4; ++k)
    {
      grid->GetCell(c)->GetPoints()->GetPoint(k, at[k]);
    }
    for (int a = 0; a < 4; ++a)
    {
      for (int b = a + 1; b < 4; ++b)
      {
        // Seen along the edge from a to b, the angle between the directions to the other two
        // points.
        double edge[3], side[2][3];
        vtkMath::Subtract(at[b], at[a], edge);
        vtkMath::Normalize(edge);
        for (int k = 0, s = 0; k < 4; ++k)
        {
          if (k != a && k != b)
          {
            vtkMath::Subtract(at[k], at[a], side[s]);
            const double along = vtkMath::Dot(side[s], edge);
            for (int i = 0; i < 3; ++i)
            {
              side[s][i] -= along * edge[i];
            }
            ++s;
          }
        }
        const double degrees =
          vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(side[0], side[1]));
        ++counts[static_cast<std::size_t>(
          std::min(bins - 1, static_cast<int>(degrees * bins / 180.0)))];
      }
    }
  }
  return counts;
}

}

TEST(MeshQuality, HistogramCountsEveryAngleOnce)
{
  const auto grid = RandomTetrahedra(200);
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(grid);
  report->SetNumberOfBins(18);
  report->Update();
  auto* table = vtkTable::SafeDownCast(report->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 18);
  const std::vector<double> expected = DihedralHistogram(grid, 18);
  double count = 0.0;
  double fraction = 0.0;
  for (vtkIdType i = 0; i < 18; ++i)
  {
    EXPECT_DOUBLE_EQ(
      table->GetValueByName(i, "Angle").ToDouble(), 10.0 * static_cast<double>(i) + 5.0);
    EXPECT_EQ(table->GetValueByName(i, "Count").ToDouble(), expected[static_cast<std::size_t>(i)]);
    EXPECT_DOUBLE_EQ(table->GetValueByName(i, "Fraction").ToDouble(),
      expected[static_cast<std::size_t>(i)] / 1200.0);
    count += table->GetValueByName(i, "Count").ToDouble();
    fraction += table->GetValueByName(i, "Fraction").ToDouble();
  }
  EXPECT_EQ(count, 1200.0);
  EXPECT_NEAR(fraction, 1.0, 1e-12);
  EXPECT_EQ(report->GetSummary().rfind("200 tetrahedra, volume ", 0), 0u) << report->GetSummary();
}

TEST(MeshQuality, NoBinsAreRefused)
{
  vtkNew<vtkMeshQualityReport> report;
  vtkNew<vtkTest::ErrorObserver> observer;
  report->AddObserver(vtkCommand::ErrorEvent, observer);
  vtkNew<vtkSphereSource> sphere;
  report->SetInputConnection(sphere->GetOutputPort());
  report->SetNumberOfBins(0);
  report->Update();
  EXPECT_NE(
    observer->GetErrorMessage().find("NumberOfBins is 0, but it must be from 1"), std::string::npos)
    << observer->GetErrorMessage();
}

TEST(MeshQuality, EmptyInputGivesEmptyOutput)
{
  vtkNew<vtkMeshQualityReport> report;
  report->SetInputData(vtkNew<vtkPolyData>());
  report->Update();
  EXPECT_EQ(report->GetSummary(), "");
  EXPECT_EQ(vtkTable::SafeDownCast(report->GetOutputDataObject(1))->GetNumberOfRows(), 0);
}

TEST(MeshQuality, SizesMatchTheCells)
{
  for (const double side : { 0.003, 1.0, 700.0, 1e90 })
  {
    const CellAngles triangle = MeasureTriangle({ 0, 0, 0 }, { side, 0, 0 }, { 0, side, 0 });
    EXPECT_NEAR(triangle.Size / (side * side), 0.5, 1e-12) << side;
    const CellAngles corner =
      MeasureTetrahedron({ 0, 0, 0 }, { side, 0, 0 }, { 0, side, 0 }, { 0, 0, side });
    EXPECT_NEAR(corner.Size / (side * side * side), 1.0 / 6.0, 1e-12) << side;
  }
}

namespace
{

/// A cube of 2 x 2 x 2 boxes, each cut into six tetrahedra that are ordered alike, whose middle
/// point lies at (x, 1, 1): it tangles where x > 2.
vtkSmartPointer<vtkUnstructuredGrid> CubeWithMiddleAt(double x, bool reversed)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 27; ++i)
  {
    points->InsertNextPoint(i == 13 ? x : i % 3, i / 3 % 3, i / 9);
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  constexpr std::array<std::array<int, 3>, 6> orders{ { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
    { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } } };
  constexpr std::array<vtkIdType, 3> steps{ 1, 3, 9 };
  for (int box = 0; box < 8; ++box)
  {
    const vtkIdType corner = box % 2 + 3 * (box / 2 % 2) + 9 * (box / 4);
    for (std::size_t o = 0; o < orders.size(); ++o)
    {
      std::array<vtkIdType, 4> ids{ corner };
      for (std::size_t k = 0; k < 3; ++k)
      {
        ids[k + 1] = ids[k] + steps[static_cast<std::size_t>(orders[o][k])];
      }
      if ((o >= 3) != reversed) // even permutations are positive
      {
        std::swap(ids[2], ids[3]);
      }
      grid->InsertNextCell(VTK_TETRA, 4, ids.data());
    }
  }
  return grid;
}

}

// Volumes are signed: a mesh that overlaps itself has the volume of its outside, which is reported.
TEST(MeshQuality, InvertedTetrahedraAreCountedAndNamed)
{
  for (const bool reversed : { false, true })
  {
    for (const double x : { 1.0, 2.6, -3.0 })
    {
      vtkNew<vtkMeshQualityReport> report;
      vtkNew<vtkTest::ErrorObserver> observer;
      report->AddObserver(vtkCommand::WarningEvent, observer);
      report->SetInputData(CubeWithMiddleAt(x, reversed));
      report->Update();
      auto* mesh = vtkDataSet::SafeDownCast(report->GetOutputDataObject(0));
      vtkDataArray* volumes = mesh->GetCellData()->GetArray("Volume");
      int negative = 0;
      double sum = 0.0;
      for (vtkIdType cell = 0; cell < volumes->GetNumberOfTuples(); ++cell)
      {
        const double volume = volumes->GetComponent(cell, 0) * (reversed ? -1.0 : 1.0);
        negative += volume < 0.0 ? 1 : 0;
        sum += volume;
      }
      EXPECT_NEAR(sum, 8.0, 1e-12);
      EXPECT_EQ(negative > 0, x != 1.0);
      EXPECT_NE(report->GetSummary().find("volume 8,"), std::string::npos) << report->GetSummary();
      EXPECT_NE(
        report->GetSummary().find(", " + std::to_string(negative) + " inverted"), std::string::npos)
        << report->GetSummary();
      EXPECT_EQ(mesh->GetFieldData()->GetArray("QualityMeasures")->GetComponent(0, 4), negative);
      EXPECT_EQ(observer->GetWarning(), x != 1.0);
      if (x != 1.0)
      {
        EXPECT_NE(observer->GetWarningMessage().find(std::to_string(negative) + " of 48 cells"),
          std::string::npos)
          << observer->GetWarningMessage();
      }
    }
  }
}
