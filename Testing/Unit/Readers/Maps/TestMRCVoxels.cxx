// Every mode x byte order x axis order x compression, whole, cropped, binned and in pieces.

#include "MRCTestFile.h"
#include "MRCTestReading.h"

#include <vtkDataArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

using namespace isthmus::testing;
using Order = std::array<int, 3>;

/// A value that differs from voxel to voxel and is exact in `mode`.
double Value(int mode, int c, int r, int s, int component)
{
  const int n = c + 7 * r + 53 * s + 400 * component;
  switch (mode)
  {
    case 0:
      return (n * 37) % 256 - 128;
    case 1:
    case 3:
      return (n * 523) % 65536 - 32768;
    case 2:
    case 4:
      return 0.1 * n - 17.3;
    case 6:
      return (n * 523) % 65536;
    case 12:
      return ((n * 91) % 2048 - 1024) / 64.0;
    case 101:
      return (n * 5) % 16;
    default:
      return (n * 37) % 256;
  }
}

int ScalarType(int mode)
{
  switch (mode)
  {
    case 0:
      return VTK_SIGNED_CHAR;
    case 1:
    case 3:
      return VTK_SHORT;
    case 6:
      return VTK_UNSIGNED_SHORT;
    case 16:
    case 101:
      return VTK_UNSIGNED_CHAR;
    default:
      return VTK_FLOAT;
  }
}

MRCTestFile MakeMap(int mode, bool bigEndian, const Order& order, std::array<int, 3> counts)
{
  MRCTestFile file(counts, mode, bigEndian);
  file.SetInts(17, order);
  for (std::size_t f = 0; f < 3; ++f)
  {
    // The cell is given along x, y, z: spacing 1 in any order.
    file.SetInt(7 + static_cast<std::size_t>(order[f]), counts[f]);
    file.SetFloat(10 + static_cast<std::size_t>(order[f]), static_cast<float>(counts[f]));
  }
  file.AddExtendedHeader(160);
  file.AddVoxels([mode](int c, int r, int s, int k) { return Value(mode, c, r, s, k); });
  return file;
}

struct Box
{
  std::array<int, 6> Crop{ 0, -1, 0, -1, 0, -1 };
  std::array<int, 3> Rate{ 1, 1, 1 };
};

/// Whether nodes are means of voxels (otherwise, with a rate, every n-th voxel).
bool AreMeans(int mode, const Box& box)
{
  return mode != 3 && mode != 4 && mode != 16 && box.Rate != std::array<int, 3>{ 1, 1, 1 };
}

/// The mean of the values that the file was given in a box of the size box.Rate, from `first` on
/// along x, y, z.
double Mean(int mode, const Order& order, const Box& box, const int (&first)[3])
{
  double sum = 0.0;
  for (int k = first[2]; k < first[2] + box.Rate[2]; ++k)
  {
    for (int j = first[1]; j < first[1] + box.Rate[1]; ++j)
    {
      for (int i = first[0]; i < first[0] + box.Rate[0]; ++i)
      {
        const int node[3] = { i, j, k };
        sum += Value(mode, node[order[0] - 1], node[order[1] - 1], node[order[2] - 1], 0);
      }
    }
  }
  return sum / (box.Rate[0] * box.Rate[1] * box.Rate[2]);
}

/// Compares every node with the value that the file was given there.
::testing::AssertionResult AllRight(
  MRCTestReading& reading, int mode, const Order& order, const Box& box)
{
  vtkImageData* const image = reading->GetOutput();
  vtkDataArray* const density = image->GetPointData()->GetScalars();
  const int* const extent = image->GetExtent();
  vtkIdType id = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i, ++id)
      {
        const int node[3] = { box.Crop[0] + i * box.Rate[0], box.Crop[2] + j * box.Rate[1],
          box.Crop[4] + k * box.Rate[2] };
        if (AreMeans(mode, box))
        {
          const double expected = Mean(mode, order, box, node),
                       found = density->GetComponent(id, 0);
          if (std::abs(found - expected) > 1e-6 * std::max(1.0, std::abs(expected)))
          {
            return ::testing::AssertionFailure()
              << "node " << i << " " << j << " " << k << " is " << found << ", not " << expected;
          }
          continue;
        }
        for (int component = 0; component < density->GetNumberOfComponents(); ++component)
        {
          const double expected =
            Value(mode, node[order[0] - 1], node[order[1] - 1], node[order[2] - 1], component);
          const double found = density->GetComponent(id, component);
          if (found != (mode == 2 || mode == 4 ? static_cast<float>(expected) : expected))
          {
            return ::testing::AssertionFailure()
              << "node " << i << " " << j << " " << k << " is " << found << ", not " << expected;
          }
        }
      }
    }
  }
  return ::testing::AssertionSuccess();
}

using Case = std::tuple<int, Order>;

/// Calls a check with a reader of each variant of one small map of the mode and axis order.
class MRCVoxels : public ::testing::TestWithParam<Case>
{
protected:
  static constexpr std::array<int, 3> Counts{ 7, 5, 6 };

  template <typename Check>
  void ForEachVariant(Check&& check) const
  {
    const auto& [mode, order] = GetParam();
    for (const bool bigEndian : { false, true })
    {
      const std::string bytes = MakeMap(mode, bigEndian, order, Counts).Bytes();
      for (const std::string& content : { bytes, Gzip(bytes), Bzip2(bytes) })
      {
        SCOPED_TRACE((bigEndian ? "big endian, " : "little endian, ") + content.substr(0, 2));
        const TemporaryFile file(content);
        MRCTestReading reading(file.Path());
        check(reading);
        EXPECT_EQ(reading.Text("ByteOrder"), bigEndian ? "big endian" : "little endian");
        EXPECT_EQ(reading.Count("Repairs"), 0) << reading.Text("Repairs");
      }
    }
  }

  /// Nodes along x, y, z.
  std::array<int, 3> Size() const
  {
    std::array<int, 3> size{};
    for (std::size_t f = 0; f < 3; ++f)
    {
      size[static_cast<std::size_t>(std::get<1>(GetParam())[f] - 1)] = Counts[f];
    }
    return size;
  }
};

TEST_P(MRCVoxels, WholeMap)
{
  this->ForEachVariant(
    [this](MRCTestReading& reading)
    {
      const auto& [mode, order] = GetParam();
      vtkImageData* const image = reading.Update();
      ASSERT_FALSE(reading.HasFailed()) << reading.Error();
      const std::array<int, 3> size = this->Size();
      EXPECT_EQ(image->GetScalarType(), ScalarType(mode));
      EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Density");
      EXPECT_TRUE(std::equal(size.begin(), size.end(), image->GetDimensions()));
      EXPECT_TRUE(AllRight(reading, mode, order, {}));
    });
}

TEST_P(MRCVoxels, CroppedAndBinned)
{
  const Box boxes[] = { { { 1, 3, 0, -1, 2, 4 }, { 1, 1, 1 } },
    { { 1, 2, 1, 2, 1, 2 }, { 1, 1, 1 } }, { { 0, -1, 1, -1, 0, -1 }, { 2, 3, 2 } },
    { { 3, 3, 2, 2, 4, 4 }, { 1, 1, 1 } }, { { 1, -1, 0, 3, 1, 4 }, { 9, 1, 3 } } };
  this->ForEachVariant(
    [&](MRCTestReading& reading)
    {
      const auto& [mode, order] = GetParam();
      for (Box box : boxes)
      {
        reading->SetCropExtent(box.Crop.data());
        reading->SetSampleRate(box.Rate.data());
        const bool means = AreMeans(mode, box);
        EXPECT_EQ(reading.Update()->GetScalarType(), means ? VTK_FLOAT : ScalarType(mode));
        vtkImageData* const image = reading.Update();
        ASSERT_FALSE(reading.HasFailed()) << reading.Error();
        const std::array<int, 3> size = this->Size();
        for (std::size_t a = 0; a < 3; ++a)
        {
          const int last = box.Crop[2 * a + 1] < 0 ? size[a] - 1 : box.Crop[2 * a + 1];
          const int nodes = last - box.Crop[2 * a] + 1;
          const int rate = std::min(box.Rate[a], means ? nodes : size[a]);
          EXPECT_EQ(image->GetDimensions()[a], means ? nodes / rate : (nodes - 1) / rate + 1);
          EXPECT_DOUBLE_EQ(
            image->GetOrigin()[a], box.Crop[2 * a] + (means ? 0.5 * (rate - 1) : 0.0));
          EXPECT_DOUBLE_EQ(image->GetSpacing()[a], rate);
          box.Rate[a] = rate;
        }
        EXPECT_TRUE(AllRight(reading, mode, order, box));
      }
    });
}

TEST_P(MRCVoxels, Pieces)
{
  this->ForEachVariant(
    [](MRCTestReading& reading)
    {
      const auto& [mode, order] = GetParam();
      reading->UpdateInformation();
      int extent[6] = { 1, 2, 2, 3, 1, 4 };
      for (int piece = 0; piece < 3; ++piece, ++extent[1], --extent[2])
      {
        reading->UpdateExtent(extent);
        EXPECT_TRUE(std::equal(extent, extent + 6, reading->GetOutput()->GetExtent()));
        EXPECT_TRUE(AllRight(reading, mode, order, {}));
      }
    });
}

INSTANTIATE_TEST_SUITE_P(All, MRCVoxels,
  ::testing::Combine(::testing::Values(0, 1, 2, 3, 4, 6, 12, 16, 101),
    ::testing::Values(Order{ 1, 2, 3 }, Order{ 1, 3, 2 }, Order{ 2, 1, 3 }, Order{ 2, 3, 1 },
      Order{ 3, 1, 2 }, Order{ 3, 2, 1 })));

/// Large enough for many bricks in every code path, and with sizes that are not multiples of a
/// brick.
TEST(MRCVoxelsLarge, ManyBricks)
{
  for (const int mode : { 1, 2, 12 })
  {
    for (const Order& order : { Order{ 1, 2, 3 }, Order{ 2, 1, 3 }, Order{ 3, 2, 1 } })
    {
      const std::string bytes = MakeMap(mode, mode == 1, order, { 201, 149, 83 }).Bytes();
      for (const bool packed : { false, true })
      {
        const TemporaryFile file(packed ? Gzip(bytes) : bytes);
        MRCTestReading reading(file.Path());
        reading.Update();
        ASSERT_FALSE(reading.HasFailed()) << reading.Error();
        EXPECT_TRUE(AllRight(reading, mode, order, {})) << "mode " << mode << " packed " << packed;
      }
    }
  }
}

/// Many bricks of means, in pieces that must have the bits of the whole.
TEST(MRCVoxelsLarge, MeansInPieces)
{
  Box box;
  box.Rate = { 4, 3, 2 };
  for (const Order& order : { Order{ 1, 2, 3 }, Order{ 3, 1, 2 } })
  {
    const std::string bytes = MakeMap(1, true, order, { 301, 249, 83 }).Bytes();
    for (const bool packed : { false, true })
    {
      const TemporaryFile file(packed ? Gzip(bytes) : bytes);
      MRCTestReading whole(file.Path()), piece(file.Path());
      whole->SetSampleRate(box.Rate.data());
      piece->SetSampleRate(box.Rate.data());
      whole.Update();
      ASSERT_FALSE(whole.HasFailed()) << whole.Error();
      EXPECT_TRUE(AllRight(whole, 1, order, box)) << "packed " << packed;
      int extent[6] = { 3, 17, 2, 20, 5, 9 };
      piece->UpdateExtent(extent);
      EXPECT_TRUE(AllRight(piece, 1, order, box)) << "packed " << packed;
      EXPECT_EQ(piece->GetOutput()->GetScalarComponentAsDouble(5, 7, 8, 0), whole.At(5, 7, 8));
    }
  }
}

TEST(MRCVoxels, MeansAreWithoutValuesThatStandForNoData)
{
  MRCTestFile map({ 40, 40, 20 }, 2);
  map.AddVoxels([](int c, int r, int s, int)
    { return c < 13 ? -9999.0 : 0.01 * c + 0.02 * r + 0.03 * s - 0.5; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  reading->SetSampleRate(4, 4, 4);
  vtkImageData* const image = reading.Update();
  vtkDataArray* const mask = image->GetPointData()->GetArray("NoData");
  ASSERT_NE(mask, nullptr);
  EXPECT_EQ(reading.Number("NoDataValue"), -9999.0);
  for (int i = 0; i < 10; ++i)
  {
    EXPECT_EQ(mask->GetComponent(i, 0), i < 3 ? 1.0 : 0.0);
    // Of the columns 12 to 15, the first has no data.
    const double column = i == 3 ? 14.0 : 4.0 * i + 1.5;
    EXPECT_NEAR(reading.At(i, 0, 0), i < 3 ? 0.0 : 0.01 * column + 0.05 * 1.5 - 0.5, 1e-6);
  }
}

TEST(MRCVoxelsHalf, SpecialValues)
{
  const std::array<std::uint16_t, 8> halves{ 0x0001, 0x03ff, 0x8001, 0x7c00, 0xfc00, 0x7e00, 0x7bff,
    0x8000 };
  MRCTestFile map({ 8, 1, 1 }, 12);
  std::string bytes = map.Bytes();
  bytes.append(reinterpret_cast<const char*>(halves.data()), 16);
  const TemporaryFile file(bytes);
  MRCTestReading reading(file.Path());
  reading.Update();
  ASSERT_FALSE(reading.HasFailed()) << reading.Error();
  EXPECT_EQ(reading.At(0, 0, 0), std::ldexp(1.0, -24));
  EXPECT_EQ(reading.At(1, 0, 0), std::ldexp(1023.0, -24));
  EXPECT_EQ(reading.At(2, 0, 0), -std::ldexp(1.0, -24));
  EXPECT_EQ(reading.At(3, 0, 0), HUGE_VAL);
  EXPECT_EQ(reading.At(4, 0, 0), -HUGE_VAL);
  EXPECT_TRUE(std::isnan(reading.At(5, 0, 0)));
  EXPECT_EQ(reading.At(6, 0, 0), 65504.0);
  EXPECT_TRUE(std::signbit(reading.At(7, 0, 0)));
}

TEST(MRCVoxelsBytes, ImodFlagMakesThemUnsigned)
{
  for (const int flags : { 0, 1 })
  {
    MRCTestFile map({ 2, 1, 1 }, 0);
    map.SetInt(39, 1146047817);
    map.SetInt(40, flags);
    map.AddVoxels([](int c, int, int, int) { return 200 * c; });
    const TemporaryFile file(map.Bytes());
    MRCTestReading reading(file.Path());
    reading.Update();
    EXPECT_EQ(reading->GetOutput()->GetScalarType(), flags ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR);
    EXPECT_EQ(reading.At(1, 0, 0), flags ? -56 : 200);
  }
}

TEST(MRCVoxelsStream, MembersOneAfterTheOther)
{
  const Order order{ 1, 2, 3 };
  const std::string bytes = MakeMap(2, false, order, { 40, 30, 20 }).Bytes();
  const std::string front = bytes.substr(0, 5000);
  const std::string back = bytes.substr(5000);
  for (const std::string& packed :
    { Gzip(front) + Gzip(back), Bzip2(front) + Bzip2(back), Gzip(bytes) + std::string(700, '\0') })
  {
    const TemporaryFile file(packed);
    MRCTestReading reading(file.Path());
    reading.Update();
    ASSERT_FALSE(reading.HasFailed()) << reading.Error();
    EXPECT_TRUE(AllRight(reading, 2, order, {}));
  }
}

}
