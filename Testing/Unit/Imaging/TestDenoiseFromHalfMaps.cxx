#include "Imaging/HalfMapAgreement.h"
#include "Imaging/LocalResolution.h"
#include "vtkDenoiseFromHalfMaps.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

constexpr int N = 40;

/// A ball of density 1 with a smooth border, and noise of standard deviation `noise` within `mask`
/// nodes of the center.
vtkSmartPointer<vtkImageData> Half(double noise, unsigned int seed, double mask = 100.0)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(N, N, N);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (int n = 0; n < N * N * N; ++n)
  {
    const double r = std::hypot(n % N - 19.5, n / N % N - 19.5, n / (N * N) - 19.5);
    const double white = normal(random);
    values->InsertNextValue(
      r > mask ? 0.0 : 0.5 - 0.5 * std::tanh((r - 10.0) / 2.0) + noise * white);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double Distance(vtkImageData* a, vtkImageData* b)
{
  double sum = 0.0;
  for (vtkIdType n = 0; n < a->GetNumberOfPoints(); ++n)
  {
    const double d = a->GetPointData()->GetScalars()->GetComponent(n, 0) -
      b->GetPointData()->GetScalars()->GetComponent(n, 0);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a->GetNumberOfPoints()));
}

void Refused(vtkImageData* one, vtkImageData* other, double strength, const char* sentence)
{
  vtkNew<vtkDenoiseFromHalfMaps> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(one);
  filter->SetOtherHalfData(other);
  filter->SetStrength(strength);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find(sentence), std::string::npos)
    << observer->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

}

TEST(DenoiseFromHalfMaps, KnowsTheNoiseOfTheMeanAndComesCloserToTheTruth)
{
  const auto truth = Half(0.0, 1);
  for (const double mask : { 100.0, 15.0 })
  {
    vtkNew<vtkDenoiseFromHalfMaps> filter;
    filter->SetInputData(Half(0.4, 2, mask));
    filter->SetOtherHalfData(Half(0.4, 3, mask));
    filter->Update();
    const double noise =
      filter->GetOutput()->GetFieldData()->GetArray("NoiseLevel")->GetComponent(0, 0);
    EXPECT_NEAR(noise, 0.4 / std::sqrt(2.0), 0.01) << mask;
    if (mask > 50.0)
    {
      // The error of the mean itself is its noise.
      EXPECT_LT(Distance(filter->GetOutput(), truth), 0.4 * noise);
    }
  }
}

/// Their mean was of type float.
TEST(DenoiseFromHalfMaps, WideIntegersAreNotRounded)
{
  const auto denoised = [](bool whole)
  {
    const auto half = [&](unsigned int seed)
    {
      auto image = Half(0.4, seed);
      vtkDataArray* const from = image->GetPointData()->GetScalars();
      vtkSmartPointer<vtkDataArray> to;
      to.TakeReference(vtkDataArray::CreateDataArray(whole ? VTK_INT : VTK_DOUBLE));
      to->SetNumberOfTuples(from->GetNumberOfTuples());
      for (vtkIdType n = 0; n < from->GetNumberOfTuples(); ++n)
      {
        to->SetComponent(n, 0, 1e9 + std::round(100.0 * from->GetComponent(n, 0)));
      }
      image->GetPointData()->SetScalars(to);
      return image;
    };
    auto filter = vtkSmartPointer<vtkDenoiseFromHalfMaps>::New();
    filter->SetInputData(half(2));
    filter->SetOtherHalfData(half(3));
    filter->Update();
    return filter;
  };
  EXPECT_EQ(Distance(denoised(true)->GetOutput(), denoised(false)->GetOutput()), 0.0);
}

namespace
{

struct HalvesRun
{
  double Error;
  double Correlation;
  std::string Warning;
};

/// Denoises Half(0.2, 2) with Half(0.2, 3), whose values are changed by factor * value + offset and
/// displaced by `shift` nodes along x.
HalvesRun RunHalves(double factor, double offset, int shift)
{
  const auto changed = Half(0.2, 3);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  values->SetNumberOfTuples(N * N * N);
  for (int n = 0; n < N * N * N; ++n)
  {
    const int from = n - n % N + std::clamp(n % N - shift, 0, N - 1);
    values->SetValue(
      n, factor * changed->GetPointData()->GetScalars()->GetComponent(from, 0) + offset);
  }
  changed->GetPointData()->SetScalars(values);
  vtkNew<vtkDenoiseFromHalfMaps> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(Half(0.2, 2));
  filter->SetOtherHalfData(changed);
  filter->Update();
  auto* output = filter->GetOutput();
  return { Distance(output, Half(0.0, 1)),
    output->GetFieldData()->GetArray("HalfMapCorrelation")->GetComponent(0, 0),
    observer->GetWarning() ? observer->GetWarningMessage() : "" };
}

}

// A linear difference of the halves is found, reported and removed.
TEST(DenoiseFromHalfMaps, HalvesOfOtherScaleOrSignAreBroughtTogether)
{
  const HalvesRun alike = RunHalves(1.0, 0.0, 0);
  EXPECT_EQ(alike.Warning, "");
  EXPECT_GT(alike.Correlation, 0.9);
  struct Case
  {
    double Factor, Offset;
    std::string Says;
  };
  for (const Case& kind : { Case{ 3.0, 0.0, "halves" }, Case{ 0.25, -0.1, "minus 0" },
         Case{ -1.0, 0.0, "inverted contrast" }, Case{ 1.0, 5.0, "plus 5" },
         Case{ -40.0, 1000.0, "inverted contrast" } })
  {
    const HalvesRun run = RunHalves(kind.Factor, kind.Offset, 0);
    EXPECT_NE(run.Warning.find("times those of the first"), std::string::npos) << run.Warning;
    EXPECT_NE(run.Warning.find(kind.Says), std::string::npos) << run.Warning;
    EXPECT_EQ(run.Warning.find("shifted"), std::string::npos) << run.Warning;
    EXPECT_LT(run.Error, 1.1 * alike.Error) << kind.Factor;
    EXPECT_EQ(std::signbit(run.Correlation), kind.Factor < 0.0);
  }
}

TEST(DenoiseFromHalfMaps, ShiftedHalvesAreReported)
{
  for (const int shift : { -7, -3, 4, 8 })
  {
    const HalvesRun run = RunHalves(1.0, 0.0, shift);
    EXPECT_NE(
      run.Warning.find("shifted by " + std::to_string(shift) + ", 0, 0 nodes"), std::string::npos)
      << shift << ": " << run.Warning;
  }
  const HalvesRun both = RunHalves(-2.0, 0.0, 4);
  EXPECT_NE(both.Warning.find("shifted by 4, 0, 0 nodes"), std::string::npos) << both.Warning;
}

TEST(DenoiseFromHalfMaps, HalvesWithNothingInCommonAreReported)
{
  vtkNew<vtkDenoiseFromHalfMaps> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  const auto noise = [](unsigned int seed)
  {
    auto image = Half(0.0, seed, -1.0);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (vtkIdType n = 0; n < N * N * N; ++n)
    {
      image->GetPointData()->GetScalars()->SetComponent(n, 0, normal(random));
    }
    return image;
  };
  filter->SetInputData(noise(4));
  filter->SetOtherHalfData(noise(5));
  filter->Update();
  EXPECT_NE(observer->GetWarningMessage().find("do not share a signal"), std::string::npos)
    << observer->GetWarningMessage();
}

TEST(DenoiseFromHalfMaps, GivesTheLocalResolution)
{
  double last = 4.0; // twice the spacing
  for (const double noise : { 0.02, 0.2, 1.0 })
  {
    vtkNew<vtkDenoiseFromHalfMaps> filter;
    const auto one = Half(noise, 2), other = Half(noise, 3);
    for (const auto& half : { one, other })
    {
      half->SetSpacing(2.0, 2.0, 2.0);
    }
    filter->SetInputData(one);
    filter->SetOtherHalfData(other);
    filter->Update();
    vtkDataArray* const resolution =
      filter->GetOutput()->GetPointData()->GetArray("LocalResolution");
    ASSERT_TRUE(resolution);
    double range[2];
    resolution->GetRange(range);
    EXPECT_GE(range[0], 4.0 - 1e-3);
    EXPECT_LE(range[1], 48.0 + 1e-3); // the window's length
    const double center = resolution->GetComponent(20 + N * (20 + N * 20), 0);
    EXPECT_GT(center, last);
    last = center;
  }
}

// The unit of the density and its zero are the user's choice.
TEST(DenoiseFromHalfMaps, LocalResolutionDoesNotDependOnUnitAndOffset)
{
  const auto resolution = [](double factor, double offset)
  {
    vtkNew<vtkDenoiseFromHalfMaps> filter;
    for (int port = 0; port < 2; ++port)
    {
      const auto half = Half(0.15, 1 + static_cast<unsigned int>(port));
      vtkDataArray* values = half->GetPointData()->GetScalars();
      for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
      {
        values->SetComponent(i, 0, factor * values->GetComponent(i, 0) + offset);
      }
      filter->SetInputDataObject(port, half);
    }
    filter->Update();
    vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray("LocalResolution");
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, 0));
    }
    return values;
  };
  const std::vector<double> expected = resolution(1.0, 0.0);
  ASSERT_EQ(expected.size(), static_cast<std::size_t>(N * N * N));
  const auto expectSame = [&expected](const std::vector<double>& found, const std::string& what)
  {
    ASSERT_EQ(found.size(), expected.size()) << what;
    double off = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      off = std::max(off, std::abs(found[i] - expected[i]));
    }
    EXPECT_LT(off, 1e-3) << what;
  };
  for (const double factor : { 1e-34, 1e-24, 1e20, 1e34, -1.0 })
  {
    expectSame(resolution(factor, 0.0), "factor " + std::to_string(factor));
  }
  for (const double offset : { 1e6, -1e8, 1e9 })
  {
    expectSame(resolution(1.0, offset), "offset " + std::to_string(offset));
  }
}

TEST(LocalResolution, FrequenciesAreLinearBetweenTheWindows)
{
  // Two windows along x, with their centers at 11.5 and 17.5.
  constexpr int n = 30;
  std::mt19937 random(5);
  std::vector<float> one, other;
  for (int node = 0; node < 4 * n; ++node)
  {
    const auto value = static_cast<float>(random() % 1000);
    const auto another = static_cast<float>(random() % 1000);
    one.push_back(value);
    other.push_back(node % n < 18 ? value : another);
  }
  std::vector<float> resolution(one.size());
  isthmus::FindLocalResolution({ n, 2, 2 }, { 2.0, 2.0, 2.0 }, one, other, resolution.data());
  const double first = 1.0 / resolution.front(), last = 1.0 / resolution.back();
  EXPECT_GT(first, 1.2 * last);
  for (int node = 0; node < 4 * n; ++node)
  {
    const double part = std::clamp((node % n - 11.5) / 6.0, 0.0, 1.0);
    EXPECT_NEAR(
      1.0 / resolution[static_cast<std::size_t>(node)], first + part * (last - first), 1e-6);
  }
}

TEST(HalfMapAgreement, MeanAndHalfDifferenceAreOfTheNarrowestType)
{
  constexpr double infinite = std::numeric_limits<double>::infinity();
  vtkNew<vtkFloatArray> one;
  vtkNew<vtkDoubleArray> other;
  one->SetName("Density");
  for (const double value : { 3.0, 1.0, infinite })
  {
    one->InsertNextValue(static_cast<float>(value));
    other->InsertNextValue(value == 3.0 ? 1e300 : value);
  }
  const isthmus::HalfMapMean wide = isthmus::AverageHalfMaps(one, other);
  EXPECT_EQ(wide.Mean->GetDataType(), VTK_DOUBLE);
  EXPECT_STREQ(wide.Mean->GetName(), "Density");
  EXPECT_EQ(wide.Mean->GetComponent(0, 0), 5e299);
  EXPECT_EQ(wide.HalfDifference->GetComponent(0, 0), -5e299);
  EXPECT_EQ(wide.Mean->GetComponent(1, 0), 1.0);
  EXPECT_EQ(wide.HalfDifference->GetComponent(1, 0), 0.0);
  EXPECT_EQ(wide.HalfDifference->GetComponent(2, 0), 0.0); // infinity - infinity

  vtkNew<vtkFloatArray> third;
  third->DeepCopy(one);
  EXPECT_THROW(isthmus::AverageHalfMaps(one, third), std::invalid_argument);
  third->SetValue(0, 2.0F);
  const isthmus::HalfMapMean narrow = isthmus::AverageHalfMaps(one, third);
  EXPECT_EQ(narrow.Mean->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(narrow.HalfDifference->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(narrow.HalfDifference->GetComponent(0, 0), 0.5);
  for (const float constant : { 0.0F, 7.0F })
  {
    third->FillValue(constant);
    EXPECT_THROW(isthmus::AverageHalfMaps(one, third), std::invalid_argument);
    EXPECT_THROW(isthmus::AverageHalfMaps(third, one), std::invalid_argument);
  }
}

TEST(DenoiseFromHalfMaps, RefusesWithASentence)
{
  const auto half = Half(0.4, 2);
  Refused(half, half, 0.5, "are equal");
  Refused(half, Half(0.4, 3), 1.5, "Strength");
  Refused(half, Half(0.4, 3), std::nan(""), "Strength");
  const auto moved = Half(0.4, 3);
  moved->SetOrigin(0, 0, 1);
  Refused(half, moved, 0.5, "same nodes");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(N, N, N);
  Refused(half, bare, 0.5, "second half map");
}
