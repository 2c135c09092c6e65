// Patches on a sphere with known areas, ranks, merging, depth below the hull, and refused input.

#include "Core/PolyDataTriangles.h"
#include "Pockets/BindingSites.h"
#include "Pockets/HullDepth.h"
#include "vtkBindingSites.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

constexpr double radius = 10.0;

/// Height over the axis through `axis` by which a cap is chosen.
double Along(const double* p, std::array<double, 3> axis)
{
  return p[0] * axis[0] + p[1] * axis[1] + p[2] * axis[2];
}

/**
 * A sphere with three caps: about +x (class 2, amplitude 3, height 2), about -x (class 4, amplitude
 * -2, height 4), about +y (class 1, amplitude 9, height 1). A cap of height h has the area 2 pi r
 * h.
 */
vtkSmartPointer<vtkPolyData> Caps(int resolution = 100)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(2 * resolution);
  source->SetPhiResolution(resolution + 1);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkDoubleArray> value;
  value->SetName("PolarizedCurvature");
  vtkNew<vtkUnsignedCharArray> site;
  site->SetName("SiteClass");
  vtkNew<vtkFloatArray> potential;
  potential->SetName("Potential");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double* p = sphere->GetPoint(i);
    const bool first = Along(p, { 1, 0, 0 }) > radius - 2.0;
    const bool second = Along(p, { -1, 0, 0 }) > radius - 4.0;
    const bool third = Along(p, { 0, 1, 0 }) > radius - 1.0;
    value->InsertNextValue(first ? 3.0 : second ? -2.0 : third ? 9.0 : 0.1);
    site->InsertNextValue(first ? 2 : second ? 4 : third ? 1 : 0);
    potential->InsertNextValue(first ? -1.5f : second ? 0.5f : 0.0f);
  }
  sphere->GetPointData()->AddArray(value);
  sphere->GetPointData()->AddArray(site);
  sphere->GetPointData()->AddArray(potential);
  return sphere;
}

struct Trial
{
  explicit Trial(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->SetThreshold(1.0);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
  }
  vtkTable* Update()
  {
    this->Filter->Update();
    return this->Filter->GetSiteTable();
  }
  std::string Error() const { return this->Observer->GetErrorMessage(); }
  std::string Warning() const { return this->Observer->GetWarningMessage(); }

  vtkNew<vtkBindingSites> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> PipelineObserver;
};

double Entry(vtkTable* table, const char* column, vtkIdType row)
{
  return table->GetValueByName(row, column).ToDouble();
}

double CapArea(double height)
{
  return 2.0 * M_PI * radius * height;
}

}

TEST(BindingSites, CapsHaveTheirAreasScoresAndMeans)
{
  Trial trial(Caps(200));
  vtkTable* table = trial.Update();
  EXPECT_EQ(trial.Error() + trial.Warning(), "");
  ASSERT_EQ(table->GetNumberOfRows(), 2); // the third cap has the class of a protein
  const double tolerance = 0.03;          // the rim is a ring of triangles of side 0.16
  EXPECT_NEAR(Entry(table, "Area", 0) / CapArea(4.0), 1.0, tolerance);
  EXPECT_NEAR(Entry(table, "Score", 0) / CapArea(4.0), 2.0, 2.0 * tolerance);
  EXPECT_EQ(Entry(table, "SiteClass", 0), 4.0);
  EXPECT_NEAR(Entry(table, "MeanPotential", 0), 0.5, 1e-6);
  EXPECT_NEAR(Entry(table, "CenterX", 0), -(radius - 2.0), 0.05); // the middle of the height
  EXPECT_NEAR(Entry(table, "CenterY", 0), 0.0, 0.05);
  EXPECT_NEAR(Entry(table, "CenterZ", 0), 0.0, 0.05);
  EXPECT_NEAR(Entry(table, "Area", 1) / CapArea(2.0), 1.0, tolerance);
  EXPECT_NEAR(Entry(table, "Score", 1) / CapArea(2.0), 3.0, 3.0 * tolerance);
  EXPECT_EQ(Entry(table, "SiteClass", 1), 2.0);
  EXPECT_LT(Entry(table, "MeanDepth", 0), 0.0025 * radius); // convex: no point is deep
  vtkDataArray* label = trial.Filter->GetOutput()->GetPointData()->GetArray("BindingSite");
  vtkIdType counts[3] = { 0, 0, 0 };
  for (vtkIdType i = 0; i < label->GetNumberOfTuples(); ++i)
  {
    const auto site = static_cast<int>(label->GetTuple1(i));
    ++counts[site];
    const double x = trial.Filter->GetOutput()->GetPoint(i)[0];
    EXPECT_EQ(site, x > radius - 2.0 ? 2 : -x > radius - 4.0 ? 1 : 0);
  }
  EXPECT_EQ(counts[1], Entry(table, "Points", 0));
  EXPECT_EQ(counts[2], Entry(table, "Points", 1));
}

TEST(BindingSites, RankingClassesAndAmplitudeChoose)
{
  Trial trial(Caps());
  trial.Filter->SetRankBy(vtkBindingSites::ByMeanPotential);
  EXPECT_EQ(Entry(trial.Update(), "SiteClass", 0), 2.0); // |-1.5| > 0.5
  trial.Filter->SetRankBy(vtkBindingSites::ByArea);
  EXPECT_EQ(Entry(trial.Update(), "SiteClass", 0), 4.0);
  trial.Filter->SetClasses(vtkBindingSites::Proteins);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 1);
  trial.Filter->SetClasses(vtkBindingSites::AllClasses);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 3);
  trial.Filter->SetClasses(vtkBindingSites::AllPoints);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 3);
  trial.Filter->SetAmplitude(vtkBindingSites::NegativePart);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 1);
  EXPECT_NEAR(Entry(trial.Update(), "CenterX", 0), -8.0, 0.05);
  trial.Filter->SetAmplitude(vtkBindingSites::PositivePart);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 2);
  trial.Filter->SetMinimumArea(CapArea(1.5));
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 1);
}

TEST(BindingSites, TheQuantileIsOneOfArea)
{
  Trial trial(Caps());
  trial.Filter->SetClasses(vtkBindingSites::Ligands);
  trial.Filter->SetAutomaticThreshold(true);
  trial.Filter->SetQuantile(0.8); // 10 % of the area has amplitude 3, the next 20 % 2, the rest 0
  vtkTable* table = trial.Update();
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(
    vtkDataArray::SafeDownCast(table->GetFieldData()->GetArray("Threshold"))->GetTuple1(0), 2.0);
  EXPECT_EQ(Entry(table, "SiteClass", 0), 2.0);
  trial.Filter->SetQuantile(0.69);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 2);
}

TEST(BindingSites, NeighboursOfOneClassMerge)
{
  // Two caps of height 0.5 about the directions +-angle from +x: their rims are `gap` apart.
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(240);
  source->SetPhiResolution(121);
  source->Update();
  vtkPolyData* sphere = source->GetOutput();
  const double capAngle = std::acos((radius - 0.5) / radius);
  const double half = capAngle + 0.1; // rims 0.2 radians apart: 2 along the chord, nearly
  const auto make = [&](unsigned char secondClass)
  {
    vtkNew<vtkDoubleArray> value;
    value->SetName("PolarizedCurvature");
    vtkNew<vtkUnsignedCharArray> site;
    site->SetName("SiteClass");
    for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
    {
      const double* p = sphere->GetPoint(i);
      const bool a = Along(p, { std::cos(half), std::sin(half), 0 }) > radius - 0.5;
      const bool b = Along(p, { std::cos(half), -std::sin(half), 0 }) > radius - 0.5;
      value->InsertNextValue(a || b ? 2.0 : 0.0);
      site->InsertNextValue(a ? 2 : b ? secondClass : 0);
    }
    sphere->GetPointData()->AddArray(value);
    sphere->GetPointData()->AddArray(site);
  };
  make(2);
  Trial trial(sphere);
  trial.Filter->SetMergeDistance(1.8);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 2);
  trial.Filter->SetMergeDistance(2.4);
  vtkTable* merged = trial.Update();
  ASSERT_EQ(merged->GetNumberOfRows(), 1);
  EXPECT_NEAR(Entry(merged, "CenterY", 0), 0.0, 0.05);
  EXPECT_NEAR(Entry(merged, "Area", 0) / (2.0 * CapArea(0.5)), 1.0, 0.1);
  make(4);
  Trial others(sphere);
  others.Filter->SetMergeDistance(2.4);
  EXPECT_EQ(others.Update()->GetNumberOfRows(), 2); // other classes stay apart
}

TEST(BindingSites, DepthIsTheDistanceToTheHull)
{
  // A cube of side 20 with points within: the distance to the nearest face.
  vtkNew<vtkPoints> points;
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint(corner & 1 ? 10 : -10, corner & 2 ? 10 : -10, corner & 4 ? 10 : -10);
  }
  points->InsertNextPoint(1e6, 0, 0); // used by no triangle
  vtkNew<vtkCellArray> cells;
  for (vtkIdType a = 0; a < 6; ++a)
  {
    const vtkIdType triangle[3] = { a, a + 1, a + 2 };
    cells->InsertNextCell(3, triangle);
  }
  vtkNew<vtkPolyData> cube;
  cube->SetPoints(points);
  cube->SetPolys(cells);
  const isthmus::PolyDataTriangles triangles(cube);
  const isthmus::HullDepth depth(triangles.View(), {});
  double worst = 0.0;
  for (int i = -9; i <= 9; i += 3)
  {
    for (int j = -9; j <= 9; j += 3)
    {
      for (int k = -9; k <= 9; k += 3)
      {
        const double p[3] = { double(i), double(j), double(k) };
        const double exact = 10.0 - std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
        EXPECT_GE(depth(p), exact - 1e-12);
        worst = std::max(worst, depth(p) - exact);
      }
    }
  }
  EXPECT_LT(worst, 0.07 * std::sqrt(200.0)); // the farthest place of a face from its corners
  const double outside[3] = { 12, 0, 0 };
  EXPECT_LT(depth(outside), 0.0);
}

TEST(BindingSites, TheBottomOfACleftIsDeep)
{
  // A sphere pushed in about +x to a depth of 4.
  const auto sphere = Caps();
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    if (p[0] > radius - 2.0)
    {
      p[0] = 4.0; // a flat floor, below the rim at 8
      sphere->GetPoints()->SetPoint(i, p);
    }
  }
  Trial trial(sphere);
  vtkTable* table = trial.Update();
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  const vtkIdType floor = Entry(table, "SiteClass", 0) == 2.0 ? 0 : 1;
  EXPECT_EQ(Entry(table, "SiteClass", floor), 2.0);
  EXPECT_NEAR(Entry(table, "CenterX", floor), 4.0, 1e-6);
  // The hull closes with the disc x = 8: 4 away at the middle, 10 - |p| = 2.79 sideways at the rim.
  EXPECT_GT(Entry(table, "MeanDepth", floor), 10.0 - std::sqrt(52.0));
  EXPECT_LT(Entry(table, "MeanDepth", floor), 4.0);
  const isthmus::PolyDataTriangles triangles(sphere);
  const double middle[3] = { 4, 0, 0 };
  EXPECT_NEAR(isthmus::HullDepth(triangles.View(), {})(middle), 4.0, 0.07 * 6.0);
}

TEST(BindingSites, IdenticalOnAnyNumberOfThreads)
{
  const auto sphere = Caps();
  const auto run = [&](int threads)
  {
    double sum = 0.0;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, std::string("STDThread"), false },
      [&]()
      {
        Trial trial(sphere);
        sum = Entry(trial.Update(), "MeanDepth", 1) + Entry(trial.Update(), "Score", 0);
      });
    return sum;
  };
  EXPECT_EQ(run(1), run(4));
}

TEST(BindingSites, ReportsMissingAndWrongInput)
{
  const auto expect =
    [](vtkPolyData* surface, const std::function<void(vtkBindingSites*)>& change, const char* words)
  {
    Trial trial(surface);
    change(trial.Filter);
    EXPECT_EQ(trial.Update()->GetNumberOfRows(), 0);
    EXPECT_NE(trial.Error().find(words), std::string::npos) << trial.Error();
    EXPECT_EQ(trial.Filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  const auto keep = [](vtkBindingSites*) {};
  vtkNew<vtkSphereSource> bare;
  bare->Update();
  expect(bare->GetOutput(), keep, "no point array PolarizedCurvature: run Polarized Curvature");
  const auto caps = Caps();
  vtkNew<vtkPolyData> unclassed;
  unclassed->ShallowCopy(caps);
  unclassed->GetPointData()->RemoveArray("SiteClass");
  expect(unclassed, keep, "no point array SiteClass");
  expect(
    caps,
    [](vtkBindingSites* filter)
    {
      filter->SetAutomaticThreshold(true);
      filter->SetQuantile(1.0);
    },
    "Quantile is 1,");
  expect(
    caps, [](vtkBindingSites* filter) { filter->SetThreshold(-1.0); }, "Threshold is -1,");
  expect(
    caps, [](vtkBindingSites* filter) { filter->SetMergeDistance(std::nan("")); }, "MergeDistance");
  expect(
    caps, [](vtkBindingSites* filter) { filter->SetMinimumArea(-2.0); }, "MinimumArea");
}

TEST(BindingSites, NothingToFindIsAWarningNotAnError)
{
  const auto sphere = Caps();
  vtkDataArray* values = sphere->GetPointData()->GetArray("PolarizedCurvature");
  values->Fill(0.4);
  sphere->GetPointData()->GetArray("SiteClass")->Fill(2.0);
  Trial constant(sphere);
  constant.Filter->SetAutomaticThreshold(true);
  EXPECT_EQ(constant.Update()->GetNumberOfRows(), 0);
  EXPECT_EQ(constant.Error(), "");
  EXPECT_NE(constant.Warning().find("Is the array constant"), std::string::npos);
  EXPECT_EQ(constant.Filter->GetOutput()->GetNumberOfPoints(), sphere->GetNumberOfPoints());

  values->Fill(std::nan("")); // a surface outside of the potential
  Trial missed(sphere);
  EXPECT_EQ(missed.Update()->GetNumberOfRows(), 0);
  EXPECT_NE(missed.Warning(), "");

  vtkNew<vtkPolyData> empty;
  Trial nothing(empty);
  EXPECT_EQ(nothing.Update()->GetNumberOfRows(), 0);
  EXPECT_EQ(nothing.Error() + nothing.Warning(), "");
}

TEST(BindingSites, AnAbortLeavesAnEmptyOutput)
{
  Trial trial(Caps());
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  trial.Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(trial.Update()->GetNumberOfRows(), 0);
  EXPECT_EQ(trial.Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(trial.Error(), "");
}
