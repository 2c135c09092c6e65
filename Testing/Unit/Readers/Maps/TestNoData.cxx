// Values that stand for "no data": which ones are found, and how the reader replaces them.

#include "MRCTestFile.h"
#include "MRCTestReading.h"
#include "Maps/NoData.h"
#include "SharedData.h"

#include <vtkDataArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

/// Noise of deviation 1 with a blob of height 5, and `other` in the second half of the voxels.
template <typename T>
std::vector<T> HalfMap(double scale, T other)
{
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<T> values(2000, other);
  for (std::size_t i = 0; i < 1000; ++i)
  {
    values[i] = static_cast<T>(scale * (noise(random) + (i > 900 ? 5.0 : 0.0)));
  }
  return values;
}

template <typename T>
std::optional<T> Found(const std::vector<T>& values)
{
  return FindNoDataValue(values.data(), static_cast<std::int64_t>(values.size()));
}

}

TEST(NoData, ValuesFarFromAllOthersAreFound)
{
  for (const float value : { -9999.0f, -999.0f, 1e10f, 1e35f, -1e35f, 99999.0f,
         std::numeric_limits<float>::max(), -std::numeric_limits<float>::max() })
  {
    EXPECT_EQ(Found(HalfMap<float>(1.0, value)), value);
    EXPECT_EQ(Found(HalfMap<float>(0.01, value)), value);
  }
  EXPECT_EQ(Found(HalfMap<short>(100.0, -32768)), -32768);
  EXPECT_EQ(Found(HalfMap<unsigned short>(100.0, 65535)),
    std::nullopt); // the noise overflows: all values occur
}

TEST(NoData, OrdinaryMapsHaveNone)
{
  EXPECT_EQ(Found(HalfMap<float>(1.0, 0.0f)), std::nullopt) << "zero outside a mask";
  EXPECT_EQ(Found(HalfMap<float>(1.0, -30.0f)), std::nullopt) << "a lower solvent";
  std::vector<float> mask(2000);
  std::fill(mask.begin() + 900, mask.end(), 1.0f);
  EXPECT_EQ(Found(mask), std::nullopt) << "a binary mask";
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    mask[i] = i % 7 == 6 ? 500.0f : static_cast<float>(i % 7);
  }
  EXPECT_EQ(Found(mask), std::nullopt) << "labels";
  auto hot = HalfMap<float>(1.0, 0.5f);
  hot[3] = 1e6f;
  EXPECT_EQ(Found(hot), std::nullopt) << "one hot voxel";
  // A uniform object of height 1 whose values differ by little, with 0 around it.
  auto phantom = HalfMap<float>(1e-5, 0.0f);
  for (std::size_t i = 0; i < 1000; ++i)
  {
    phantom[i] += 1.0f;
  }
  EXPECT_EQ(Found(phantom), std::nullopt) << "a uniform object";
  EXPECT_EQ(Found(std::vector<float>(10, std::nanf(""))), std::nullopt);
  EXPECT_EQ(Found(std::vector<float>()), std::nullopt);
}

TEST(NoData, IsReplacedAndMarked)
{
  auto values = HalfMap<float>(1.0, -9999.0f);
  const std::vector<float> before = values;
  std::vector<unsigned char> mask(values.size());
  const NoDataReplacement done = ReplaceNoData(values.data(), 2000, -9999.0f, mask.data());
  EXPECT_EQ(done.Voxels, 1000);
  EXPECT_EQ(done.By, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_EQ(values[i], i < 1000 ? before[i] : 0.0f);
    EXPECT_EQ(mask[i], i < 1000 ? 0 : 1);
  }
  std::vector<float> bright{ 7.0f, 5.0f, 1e30f, 1e30f };
  EXPECT_EQ(ReplaceNoData(bright.data(), 4, 1e30f, mask.data()).By, 5.0);
  EXPECT_EQ(bright, (std::vector<float>{ 7.0f, 5.0f, 5.0f, 5.0f }));
}

TEST(NoData, OfTheReportedMaps)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/k06_sentinel_1e35.mrc");
  for (const char* name : { "k06_sentinel_1e35.mrc", "k06_sentinel_m9999.mrc" })
  {
    MRCTestReading reading((SharedDataFolder() / "reports" / name).c_str());
    vtkImageData* const map = reading.Update();
    EXPECT_EQ(reading.Warning(), "");
    vtkDataArray* const mask = map->GetPointData()->GetArray("NoData");
    ASSERT_NE(mask, nullptr) << name;
    int marked = 0;
    for (vtkIdType i = 0; i < mask->GetNumberOfTuples(); ++i)
    {
      marked += mask->GetComponent(i, 0) == 1.0 ? 1 : 0;
    }
    EXPECT_EQ(marked, 3215);
    EXPECT_LT(map->GetScalarRange()[1], 1.0);
    EXPECT_GT(map->GetScalarRange()[0], -0.1);
    EXPECT_NE(reading.Text("Notes").find("3215 of 5760 voxels"), std::string::npos)
      << reading.Text("Notes");
  }
}
