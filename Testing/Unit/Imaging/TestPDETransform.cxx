#include "PDETransform.h"

#include "DiffusionFilterTest.h"
#include "DiffusionTestTools.h"
#include "vtkPDETransform.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;
using Filter = Listened<vtkPDETransform>;

TEST(PDETransform, TheModesAddUpToTheInput)
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    const auto image = BumpImage(type);
    Filter filter(image);
    filter->SetNumberOfModes(5);
    vtkPointData* const arrays = filter.Update()->GetPointData();
    std::vector<double> sum = Values(arrays->GetArray("Residue"));
    for (int k = 1; k <= 5; ++k)
    {
      vtkDataArray* const mode = arrays->GetArray(("Mode" + std::to_string(k)).c_str());
      ASSERT_TRUE(mode);
      EXPECT_EQ(mode->GetDataType(), type);
      const std::vector<double> values = Values(mode);
      std::transform(sum.begin(), sum.end(), values.begin(), sum.begin(), std::plus<double>());
      EXPECT_NEAR(Mean(values), 0.0, 1e-4) << "a mode has no mean";
    }
    const double rounding = type == VTK_FLOAT ? 2e-5 : 4e-14; // values are up to 100
    const std::vector<double> input = Values(image->GetPointData()->GetScalars());
    for (std::size_t n = 0; n < sum.size(); ++n)
    {
      EXPECT_NEAR(sum[n], input[n], rounding);
    }
  }
}

TEST(PDETransform, EachWaveGoesToTheModeOfItsWavelength)
{
  const auto grid = Grid<double>(96, 1, 1);
  PDETransformParameters parameters;
  const double edges[] = { 4.0, 8.0, 16.0, 32.0 };
  for (int wave = 0; wave < 5; ++wave)
  {
    // Wavelengths well inside the bands; mirrored waves, as the boundary wants them.
    const double wavelength[] = { 3.0, 5.4, 10.8, 21.4, 192.0 };
    std::vector<double> values;
    for (int i = 0; i < 96; ++i)
    {
      values.push_back(std::cos(2 * std::acos(-1.0) * (i + 0.5) / wavelength[wave]));
    }
    double most = 0.0;
    int strongest = -1;
    auto consider = [&](int k, double size)
    {
      if (size > most)
      {
        most = size;
        strongest = k;
      }
    };
    TransformByPDE<double>(grid, parameters, values.data(),
      [&](int k, const double* before, const double* after)
      {
        double sum = 0.0;
        for (int i = 0; i < 96; ++i)
        {
          sum += (before[i] - after[i]) * (before[i] - after[i]);
        }
        consider(k, std::sqrt(sum / 96));
      });
    consider(4, Deviation(values));
    EXPECT_EQ(strongest, wave) << "wavelength " << wavelength[wave];
    EXPECT_TRUE(wave == 4 || wavelength[wave] < edges[wave]);
  }
}

TEST(PDETransform, HalvesTheWavelengthItIsToldTo)
{
  for (int k = 0; k < 4; ++k)
  {
    const DiffusionParameters lowPass = LowPass(PDETransformParameters(), k);
    EXPECT_EQ(lowPass.Order, 3 - k);
    const double wave = 2 * std::acos(-1.0) / (4.0 * std::pow(2.0, k));
    EXPECT_NEAR(std::exp(-std::pow(wave, 2 * lowPass.Order + 2) * lowPass.Time), 0.5, 1e-12);
  }
}

TEST(PDETransform, RefusesInASentence)
{
  Filter filter(BumpImage());
  filter->SetNumberOfModes(0);
  EXPECT_NE(filter.Complaint().find("NumberOfModes"), std::string::npos);
  filter->SetNumberOfModes(2);
  filter->SetFirstOrder(4);
  EXPECT_NE(filter.Complaint().find("Orders must fall"), std::string::npos);
  filter->SetFirstOrder(2);
  filter->SetWavelengthRatio(1.0);
  EXPECT_NE(filter.Complaint().find("WavelengthRatio"), std::string::npos);
  vtkNew<vtkImageData> nothing;
  EXPECT_EQ(Filter(nothing).Complaint(), "");
}

TEST(PDETransform, TakesASliceAndNamesInvalidValues)
{
  const auto slice = BumpImage(VTK_FLOAT, 14, 12, 1);
  Filter filter(slice);
  const std::vector<double> values = Values(filter.Result());
  EXPECT_EQ(values.size(), 168u);
  EXPECT_TRUE(
    std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); }));
  slice->SetScalarComponentFromDouble(5, 1, 0, 0, std::nan(""));
  EXPECT_NE(Filter(slice).Complaint().find("node (5, 1, 0)"), std::string::npos);
}
