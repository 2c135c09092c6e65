// Statistics of volumes whose values are known, of every type, and of values at the limits of
// double; the position of a value that is not a number.

#include "Persistence/PersistenceCache.h"
#include "Persistence/ScalarFeatures.h"
#include "Persistence/VolumeView.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkSOADataArrayTemplate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isthmus;

namespace
{

template <typename T>
VolumeStatistics Of(const std::vector<T>& values)
{
  return MeasureVolume(
    VolumeView(values.data(), { 1, static_cast<std::int64_t>(values.size()), 1 }));
}

template <typename T>
void ExpectKnown()
{
  const std::vector<T> values{ 7, 1, 3, 1, 8 };
  const VolumeStatistics statistics = Of(values);
  EXPECT_EQ(statistics.Minimum, 1.0);
  EXPECT_EQ(statistics.Maximum, 8.0);
  EXPECT_DOUBLE_EQ(statistics.Mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics.StandardDeviation, std::sqrt(44.0 / 5.0));
  const VolumeView view(values.data(), { 5, 1, 1 });
  EXPECT_EQ(view.Value(0), 7.0);
  EXPECT_EQ(view.Value(4), 8.0);
}

}

TEST(VolumeView, StatisticsOfEveryType)
{
  ExpectKnown<float>();
  ExpectKnown<double>();
  ExpectKnown<std::int8_t>();
  ExpectKnown<std::uint8_t>();
  ExpectKnown<std::int16_t>();
  ExpectKnown<std::uint16_t>();
  ExpectKnown<std::int32_t>();
  ExpectKnown<std::uint32_t>();
  ExpectKnown<std::int64_t>();
  ExpectKnown<std::uint64_t>();
  EXPECT_EQ(Of<std::int16_t>({ -300, 300 }).Minimum, -300.0);
  EXPECT_EQ(Of<std::uint16_t>({ 0, 65535 }).Maximum, 65535.0);
}

/// One buffer for each component is another layout of the same values.
TEST(VolumeView, OfEveryLayout)
{
  vtkNew<vtkSOADataArrayTemplate<float>> values;
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 1, 1);
  for (const float value : { 7.0F, 1.0F, 3.0F, 1.0F, 8.0F })
  {
    values->InsertNextTypedTuple(&value);
  }
  const VolumeView view = MakeVolumeView(values, image);
  EXPECT_EQ(view.Value(0), 7.0);
  EXPECT_EQ(view.Value(4), 8.0);
}

TEST(VolumeView, NothingOverflowsOrCancels)
{
  constexpr double most = std::numeric_limits<double>::max();
  const VolumeStatistics wide = Of<double>({ -most, most, most, most });
  EXPECT_NEAR(wide.Mean / most, 0.5, 1e-15);
  EXPECT_NEAR(wide.StandardDeviation / most, std::sqrt(0.75), 1e-15);
  const VolumeStatistics narrow = Of<double>({ 1e9, 1e9 + 1.0, 1e9 + 2.0 });
  EXPECT_EQ(narrow.Mean, 1e9 + 1.0);
  EXPECT_NEAR(narrow.StandardDeviation, std::sqrt(2.0 / 3.0), 1e-12);
}

TEST(VolumeView, ConstantsInfinitiesAndNaN)
{
  const VolumeStatistics constant = Of<float>({ 2.5F, 2.5F, 2.5F });
  EXPECT_EQ(constant.Mean, 2.5);
  EXPECT_EQ(constant.StandardDeviation, 0.0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Of<double>({ -infinity, 1.0, 2.0, infinity }).Mean, 1.5);
  const VolumeStatistics none = Of<double>({ infinity, -infinity });
  EXPECT_GT(none.Minimum, none.Maximum);
  std::vector<float> values(2 * 3 * 4, 1.0F);
  values[1 + 2 * (2 + 3 * 3)] = std::nanf("");
  try
  {
    RejectNaN(VolumeView(values.data(), { 2, 3, 4 }));
    ADD_FAILURE() << "not refused";
  }
  catch (const std::invalid_argument& refusal)
  {
    EXPECT_NE(std::string(refusal.what()).find("node (1, 2, 3)"), std::string::npos)
      << refusal.what();
  }
}

TEST(ScalarFeatures, EvenLevelsGoFromEndToEnd)
{
  EXPECT_EQ(EvenLevels(1.0, 3.0, 5), (std::vector<double>{ 1.0, 1.5, 2.0, 2.5, 3.0 }));
  EXPECT_EQ(EvenLevels(-1.0, 1.0, 2), (std::vector<double>{ -1.0, 1.0 }));
  EXPECT_EQ(EvenLevels(1.0, 3.0, 1), (std::vector<double>{ 1.0 }));
  EXPECT_EQ(EvenLevels(2.0, 2.0, 9), (std::vector<double>{ 2.0 }));
}
