// The VTK filter: tables, simplification, thresholds, ranges, errors.

#include "vtkScalarPersistence.h"

#include "AddressSpaceLimit.h"
#include "ScalarImages.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkPolyData.h>
#include <vtkShortArray.h>
#include <vtkTestErrorObserver.h>

#include <random>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

TEST(ScalarPersistence, DiagramMatchesTheAlgorithm)
{
  const auto image = Image<vtkFloatArray>(28, Ripple);
  for (const bool superlevel : { false, true })
  {
    vtkNew<vtkScalarPersistence> filter;
    filter->SetInputData(image);
    filter->SetSuperlevel(superlevel);
    filter->Update();
    const Bars expected = CollectBars(MakeView(image), superlevel);
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
  const auto image = Image<vtkFloatArray>(28, Ripple);
  for (const bool superlevel : { false, true })
  {
    vtkNew<vtkScalarPersistence> filter;
    filter->SetInputData(image);
    filter->SetSuperlevel(superlevel);
    filter->SetMinimumPersistence(0.4);
    filter->SetNumberOfLevels(101);
    filter->Update();
    vtkTable* curves = filter->GetBettiCurves();
    const Bars bars = CollectBars(MakeView(image), superlevel);
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

TEST(ScalarPersistence, SimplifiedHasTheExtremaThatWereKept)
{
  for (const bool superlevel : { false, true })
  {
    const auto image = Image<vtkFloatArray>(28,
      [](double x, double y, double z)
      { return Ripple(x, y, z) + 0.2 * std::sin(37.0 * x + 11.0 * y) * std::cos(29.0 * z); });
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
    const Bars all = CollectBars(MakeView(image), superlevel);
    const Bars after = CollectBars(MakeView(simplified), superlevel);
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
  filter->SetRange(5.0, 15.0);
  EXPECT_FALSE(filter->GetAutomaticRange());
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
  const auto image = Image<vtkFloatArray>(16, Ripple);
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

TEST(ScalarPersistence, ReportsBadInput)
{
  vtkNew<vtkScalarPersistence> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto image = Image<vtkFloatArray>(10, Ripple);
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
  for (const double bad : { -1.0, std::nan(""), Infinity })
  {
    filter->SetRange(0.0, bad);
    EXPECT_NE(said().find("Range goes from"), std::string::npos);
  }
  filter->AutomaticRangeOn();
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

TEST(ScalarPersistence, AbortLeavesAnEmptyOutput)
{
  vtkNew<vtkScalarPersistence> filter;
  filter->SetInputData(Image<vtkFloatArray>(60, Ripple));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 0);
  EXPECT_EQ(filter->GetBettiCurves()->GetNumberOfRows(), 0);
}

TEST(ScalarPersistence, RefusesWhatDoesNotFitIntoMemory)
{
  std::mt19937 random(7);
  std::normal_distribution<double> noise;
  const auto noisy =
    Image<vtkFloatArray>(160, [&](double, double, double) { return noise(random); });
  vtkNew<vtkScalarPersistence> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(noisy);
  {
    const AddressSpaceLimit limit(128);
    filter->Update();
  }
  const std::string said = observer->GetErrorMessage();
  EXPECT_NE(said.find("The persistence of 160 x 160 x 160 values needs about 3"), std::string::npos)
    << said;
  for (const char* words : { " MiB are available: ", "crop", "SampleRate" })
  {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  EXPECT_EQ(filter->GetDiagram()->GetNumberOfRows(), 0);
  // A smooth volume of the same size has few critical cells, and fits.
  observer->Clear();
  const auto smooth = Image<vtkFloatArray>(160, Ripple);
  filter->SetInputData(smooth);
  {
    const AddressSpaceLimit limit(256);
    filter->Update();
  }
  EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  EXPECT_GT(filter->GetDiagram()->GetNumberOfRows(), 10);
}
