// vtkDenoiseMap: its outputs, warnings and refusals. The choice is tested in TestDenoiseMap.cxx.

#include "DiffusionFilterTest.h"
#include "DiffusionTestTools.h"
#include "PeakMemory.h"
#include "vtkDenoiseMap.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

using namespace isthmus::testing;

namespace
{

using Denoising = Listened<vtkDenoiseMap>;

/// A ball of density 1 with a smooth border in 40^3 nodes, and noise of standard deviation `noise`
/// within `mask` nodes of the center.
vtkSmartPointer<vtkImageData> Ball(double noise, double mask = 100.0)
{
  constexpr int n = 40;
  const std::vector<double> white = Noise(Grid<double>(n, n, n));
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (int i = 0; i < n * n * n; ++i)
  {
    const double r = std::hypot(i % n - 19.5, i / n % n - 19.5, i / (n * n) - 19.5);
    values->InsertNextValue(r > mask
        ? 0.0
        : 0.5 - 0.5 * std::tanh((r - 10.0) / 2.0) + noise * white[static_cast<std::size_t>(i)]);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The warning of the filter; the image must not be changed.
std::string WarningWithoutChange(vtkImageData* image)
{
  Denoising filter(image);
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  EXPECT_EQ(Values(filter.Result()), Values(image->GetPointData()->GetScalars()));
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("UsedTime")->GetTuple1(0), 0.0);
  return observer->GetWarningMessage();
}

}

TEST(DenoiseMapFilter, StatesTheChoiceInFieldData)
{
  const auto image = BumpImage();
  Denoising filter(image);
  vtkImageData* const output = filter.Update();
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Density");
  EXPECT_LT(
    Deviation(Values(filter.Result())), Deviation(Values(image->GetPointData()->GetScalars())));
  vtkFieldData* const field = output->GetFieldData();
  for (const char* name : { "UsedOrder", "UsedEdgeStopping", "UsedSigma", "UsedPreSmoothing",
         "RiskTime", "RiskValue", "EstimatedGainError" })
  {
    EXPECT_TRUE(field->GetArray(name)) << name;
  }
  EXPECT_TRUE(field->GetAbstractArray("Choice"));
  for (const char* name :
    { "StepTime", "StepChange", "StepResidual", "NoiseLevel", "UsedTime", "EstimatedGain" })
  {
    ASSERT_TRUE(field->GetArray(name)) << name;
    EXPECT_GT(field->GetArray(name)->GetTuple1(0), 0.0) << name;
  }
}

TEST(DenoiseMapFilter, NeedsOneVolumeBesideInputAndOutput)
{
  constexpr int n = 256;
  vtkNew<vtkImageData> image;
  image->SetDimensions(n, n, n);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  const std::vector<float> noise = Noise(Grid<float>(n, n, n), 0.2);
  int i = 0;
  std::generate_n(values->GetPointer(0), noise.size(),
    [&]
    {
      const double r = std::hypot(i % n - 90.0, i / n % n - 90.0, i / (n * n) - 90.0);
      const auto ball = static_cast<float>(0.5 - 0.5 * std::tanh((r - 50.0) / 2.0));
      return ball + noise[static_cast<std::size_t>(i++)];
    });
  image->GetPointData()->SetScalars(values);
  Denoising filter(image);
  ResetPeakMemory();
  const double before = PeakMemory();
  if (before <= 0.0)
  {
    GTEST_SKIP() << "The kernel does not report the peak of a process.";
  }
  filter.Update();
  const double volumes = (PeakMemory() - before) / (4.0 * n * n * n);
  // The output and one to spare; rows between the terms of the series take a part of one at this
  // size, and so does the sample, which is freed before, but which the C library keeps.
  EXPECT_GT(volumes, 1.9);
  EXPECT_LT(volumes, 3.5);
}

TEST(DenoiseMapFilter, MoreStrengthSmoothsMore)
{
  double last = std::numeric_limits<double>::max();
  for (const double strength : { 0.0, 0.5, 1.0 })
  {
    Denoising filter(BumpImage());
    filter->SetStrength(strength);
    const double deviation = Deviation(Values(filter.Result()));
    EXPECT_LT(deviation, last);
    last = deviation;
  }
}

TEST(DenoiseMapFilter, TakesNoiseFromASecondArray)
{
  const auto image = Ball(0.2);
  vtkNew<vtkDoubleArray> noise;
  noise->SetName("Noise");
  const std::vector<double> white = Noise(Grid<double>(40, 40, 40), 0.5, 2);
  for (const double value : white)
  {
    noise->InsertNextValue(value);
  }
  image->GetPointData()->AddArray(noise);
  Denoising filter(image);
  filter->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Noise");
  const double level = filter.Update()->GetFieldData()->GetArray("NoiseLevel")->GetTuple1(0);
  EXPECT_NEAR(level, 0.5, 0.01);
}

TEST(DenoiseMapFilter, AcceptsSlicesRowsPointsAndNothing)
{
  const int sizes[][3] = { { 14, 12, 1 }, { 1, 12, 10 }, { 14, 1, 1 }, { 1, 1, 1 } };
  for (const auto& size : sizes)
  {
    for (const int goal : { vtkDenoiseMap::Surfaces, vtkDenoiseMap::Volumes })
    {
      Denoising filter(BumpImage(VTK_FLOAT, size[0], size[1], size[2]));
      filter->SetGoal(goal);
      EXPECT_EQ(filter.Update()->GetNumberOfPoints(), size[0] * size[1] * size[2]);
      const std::vector<double> values = Values(filter.Result());
      EXPECT_TRUE(std::all_of(
        values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
    }
  }
  vtkNew<vtkImageData> nothing;
  EXPECT_EQ(Denoising(nothing).Update()->GetNumberOfPoints(), 0);
  ExpectTakesASliceAndNamesInvalidValues<Denoising>();
}

TEST(DenoiseMapFilter, WarnsAboutMasksConstantsAndWhatHasNoNoise)
{
  const auto mask = Ball(0.0);
  vtkDataArray* const values = mask->GetPointData()->GetScalars();
  for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
  {
    values->SetComponent(n, 0, values->GetComponent(n, 0) > 0.5 ? 1.0 : 0.0);
  }
  const std::string warning = WarningWithoutChange(mask);
  EXPECT_NE(warning.find("a mask, labels"), std::string::npos);
  EXPECT_NE(warning.find("use High-Order Diffusion"), std::string::npos);
  values->Fill(3.0);
  EXPECT_NE(WarningWithoutChange(mask).find("a constant"), std::string::npos);
}

TEST(DenoiseMapFilter, DoesNotWarnWhereAMaskedMapIsDenoised)
{
  const auto map = Ball(0.3, 14.0);
  Denoising filter(map);
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  const std::vector<double> result = Values(filter.Result());
  EXPECT_EQ(observer->GetWarningMessage(), "");
  const std::vector<double> truth = Values(Ball(0.0, 14.0)->GetPointData()->GetScalars());
  EXPECT_LT(
    Distance(result, truth), 0.7 * Distance(Values(map->GetPointData()->GetScalars()), truth));
}

TEST(DenoiseMapFilter, RefusesValuesOutOfRange)
{
  const std::pair<const char*, std::function<void(vtkDenoiseMap*)>> cases[] = {
    { "Strength is 1.5, but it must be from 0 to 1", [](auto* f) { f->SetStrength(1.5); } },
    { "Strength is not a number", [](auto* f) { f->SetStrength(std::nan("")); } },
    { "Goal is 2, but it must be from 0 to 1", [](auto* f) { f->SetGoal(2); } },
    { "KnownNoise is -1", [](auto* f) { f->SetKnownNoise(-1.0); } },
  };
  for (const auto& [words, spoil] : cases)
  {
    Denoising filter(BumpImage());
    spoil(filter.operator->());
    const std::string complaint = filter.Complaint();
    EXPECT_NE(complaint.find(words), std::string::npos) << words << ": " << complaint;
  }
}
