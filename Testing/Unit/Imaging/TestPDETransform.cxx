#include "Imaging/PDETransform.h"

#include "DiffusionFilterTest.h"
#include "DiffusionTestTools.h"
#include "vtkPDETransform.h"

#include <gtest/gtest.h>

using namespace isthmus;
using namespace isthmus::testing;
using Filter = Listened<vtkPDETransform>;

namespace
{

/// The modes of `values`, which become the residue.
template <typename T>
std::vector<std::vector<T>> Modes(
  const DiffusionGrid<T>& grid, const PDETransformParameters& parameters, std::vector<T>& values)
{
  std::vector<std::vector<T>> modes(
    static_cast<std::size_t>(parameters.NumberOfModes), std::vector<T>(values.size()));
  std::vector<T*> pointers;
  for (auto& mode : modes)
  {
    pointers.push_back(mode.data());
  }
  TransformByPDE<T>(grid, parameters, values.data(), pointers);
  return modes;
}

}

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
    // Wavelengths well inside the bands; mirrored waves, as the boundary condition requires.
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
    const auto modes = Modes(grid, parameters, values);
    for (int k = 0; k < 4; ++k)
    {
      consider(k, Distance(modes[static_cast<std::size_t>(k)], std::vector<double>(96, 0.0)));
    }
    consider(4, Deviation(values));
    EXPECT_EQ(strongest, wave) << "wavelength " << wavelength[wave];
    EXPECT_TRUE(wave == 4 || wavelength[wave] < edges[wave]);
  }
}

TEST(PDETransform, HalvesTheRequestedWavelength)
{
  for (int k = 0; k < 4; ++k)
  {
    const DiffusionParameters lowPass = LowPass(PDETransformParameters(), k);
    EXPECT_EQ(lowPass.Order, 3 - k);
    const double wave = 2 * std::acos(-1.0) / (4.0 * std::pow(2.0, k));
    EXPECT_NEAR(std::exp(-std::pow(wave, 2 * lowPass.Order + 2) * lowPass.Time), 0.5, 1e-12);
  }
}

// Neumann's waves are eigenvectors of the discrete Laplacian, so that their damping by each
// low-pass is known in closed form: no time stepping, no other implementation.
TEST(PDETransform, LowPassesAreExactExponentials)
{
  auto grid = Grid<double>(18, 15, 12);
  grid.Spacing = { 1.0, 1.2, 0.9 };
  PDETransformParameters parameters;
  parameters.NumberOfModes = 6;
  for (const auto& wave :
    std::vector<std::array<int, 3>>{ { 0, 1, 0 }, { 3, 2, 1 }, { 17, 14, 11 } })
  {
    std::vector<double> values(static_cast<std::size_t>(grid.Size()), 1.0);
    double symbol = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto n = grid.Dimensions;
      const double angle = std::acos(-1.0) * wave[axis] / static_cast<double>(n[axis]);
      symbol += (2 - 2 * std::cos(angle)) / (grid.Spacing[axis] * grid.Spacing[axis]);
      for (std::int64_t node = 0; node < grid.Size(); ++node)
      {
        const std::array<std::int64_t, 3> at{ node % n[0], node / n[0] % n[1], node / n[0] / n[1] };
        values[static_cast<std::size_t>(node)] *=
          std::cos(angle * (static_cast<double>(at[axis]) + 0.5));
      }
    }
    const std::vector<double> input = values;
    const auto modes = Modes(grid, parameters, values);
    double before = 1.0;
    for (int k = 0; k < parameters.NumberOfModes; ++k)
    {
      const DiffusionParameters lowPass = LowPass(parameters, k);
      const double after = before * std::exp(-lowPass.Time * std::pow(symbol, lowPass.Order + 1));
      for (std::size_t n = 0; n < input.size(); ++n)
      {
        ASSERT_NEAR(modes[static_cast<std::size_t>(k)][n], (before - after) * input[n], 2e-12);
      }
      before = after;
    }
    for (std::size_t n = 0; n < input.size(); ++n)
    {
      ASSERT_NEAR(values[n], before * input[n], 2e-12);
    }
  }
}

TEST(PDETransform, ConstantsHaveNoModes)
{
  const auto grid = Grid<float>(20, 9, 7);
  std::vector<float> values(static_cast<std::size_t>(grid.Size()), 1000.1f);
  const std::vector<float> input = values;
  for (const auto& mode : Modes(grid, PDETransformParameters(), values))
  {
    EXPECT_EQ(mode, std::vector<float>(input.size(), 0.0f));
  }
  EXPECT_EQ(values, input);
}

TEST(PDETransform, AFloatIsAsGoodAsADouble)
{
  const auto single = Grid<float>(40, 36, 30);
  std::vector<float> values = Noise(single);
  std::vector<double> twice(values.begin(), values.end());
  const auto modes = Modes(single, PDETransformParameters(), values);
  const auto exact = Modes(Grid<double>(40, 36, 30), PDETransformParameters(), twice);
  for (std::size_t k = 0; k < modes.size(); ++k)
  {
    EXPECT_LT(Distance(modes[k], exact[k]), 2e-6) << "of noise with deviation 1";
  }
  EXPECT_LT(Distance(values, twice), 2e-6);
}

TEST(PDETransform, LongWavesAreWithinReachAndTheLongestRefused)
{
  const auto grid = Grid<double>(3000, 1, 1);
  PDETransformParameters parameters;
  parameters.NumberOfModes = 8; // up to 512 nodes
  std::vector<double> values;
  for (int i = 0; i < 3000; ++i)
  {
    values.push_back(std::cos(std::acos(-1.0) * 2 * (i + 0.5) / 3000));
  }
  const double before = Deviation(values);
  Modes(grid, parameters, values);
  double exponent = 0.0;
  const double symbol = 2 - 2 * std::cos(std::acos(-1.0) * 2 / 3000);
  for (int k = 0; k < parameters.NumberOfModes; ++k)
  {
    const DiffusionParameters lowPass = LowPass(parameters, k);
    exponent += lowPass.Time * std::pow(symbol, lowPass.Order + 1);
  }
  EXPECT_NEAR(Deviation(values) / before, std::exp(-exponent), 1e-9);
  parameters.NumberOfModes = 16;
  parameters.WavelengthRatio = 4.0;
  EXPECT_THROW(Modes(grid, parameters, values), std::invalid_argument);
}

TEST(PDETransform, RefusesWithAMessage)
{
  Filter filter(BumpImage());
  filter->SetNumberOfModes(0);
  EXPECT_NE(filter.Complaint().find("NumberOfModes"), std::string::npos);
  filter->SetNumberOfModes(2);
  filter->SetFirstOrder(4);
  EXPECT_NE(
    filter.Complaint().find("FirstOrder is 4, but it must be from 0 to 3"), std::string::npos);
  filter->SetFirstOrder(2);
  filter->SetLastOrder(3);
  EXPECT_NE(
    filter.Complaint().find("LastOrder is 3, but it must be from 0 to 2"), std::string::npos);
  filter->SetLastOrder(0);
  filter->SetWavelengthRatio(1.0);
  EXPECT_NE(filter.Complaint().find("WavelengthRatio"), std::string::npos);
  vtkNew<vtkImageData> nothing;
  EXPECT_EQ(Filter(nothing).Complaint(), "");
}

TEST(PDETransform, TakesASliceAndNamesInvalidValues)
{
  ExpectTakesASliceAndNamesInvalidValues<Filter>();
}
