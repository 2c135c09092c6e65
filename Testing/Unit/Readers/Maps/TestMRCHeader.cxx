// Values of the header, repairs of damaged fields, byte order without a stamp, and CanReadFile.

#include "MRCTestFile.h"
#include "MRCTestReading.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace
{

using namespace isthmus::testing;
using Damage = std::function<void(MRCTestFile&)>;

/// A small float map with consecutive values, whose header is changed by `damage`.
std::string SmallMap(const Damage& damage, bool bigEndian = false)
{
  MRCTestFile map({ 4, 3, 2 }, 2, bigEndian);
  damage(map);
  map.AddVoxels([](int c, int r, int s, int) { return c + 4 * r + 12 * s; });
  return map.Bytes();
}

TEST(MRCHeader, HeaderValuesAreFieldData)
{
  const TemporaryFile file(SmallMap(
    [](MRCTestFile& map)
    {
      map.SetInts(5, { -3, 4, 5 });
      map.SetInts(8, { 8, 6, 4 });
      map.SetFloats(11, { 16.0f, 18.0f, 16.0f });
      map.SetFloat(20, -1.5f);
      map.SetFloat(21, 2.5f);
      map.SetFloat(22, 0.25f);
      map.SetFloat(55, 0.75f);
      map.SetInt(23, 4);
      map.SetText(104, "CCP4");
      map.SetInt(28, 20140);
      map.SetInt(56, 2);
      map.SetText(224, "first label   ");
      map.SetText(304, "second \x01 label");
      map.AddExtendedHeader(80);
    }));
  MRCTestReading reading(file.Path());
  vtkImageData* const image = reading.Update();
  ASSERT_FALSE(reading.HasFailed()) << reading.Error();
  EXPECT_EQ(reading.Warning(), "");
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_DOUBLE_EQ(image->GetSpacing()[i], 2.0 + i);
    EXPECT_DOUBLE_EQ(reading.Number("CellLengths", i), i == 1 ? 18.0 : 16.0);
    EXPECT_DOUBLE_EQ(reading.Number("CellAngles", i), 90.0);
    EXPECT_EQ(reading.Number("FileDimensions", i), 4 - i);
    EXPECT_EQ(reading.Number("AxisOrder", i), i + 1);
    EXPECT_EQ(reading.Number("FileOrigin", i), 0.0);
  }
  EXPECT_EQ(reading.Number("FileStart", 0), -3);
  EXPECT_EQ(reading.Number("CellSampling", 2), 4);
  EXPECT_EQ(reading.Number("Mode"), 2);
  EXPECT_EQ(reading.Number("SpaceGroup"), 4);
  EXPECT_EQ(reading.Number("RecordedMinimum"), -1.5);
  EXPECT_EQ(reading.Number("RecordedMaximum"), 2.5);
  EXPECT_EQ(reading.Number("RecordedMean"), 0.25);
  EXPECT_EQ(reading.Number("RecordedRms"), 0.75);
  EXPECT_EQ(reading.Number("IsStack"), 0);
  EXPECT_EQ(reading.Number("NumberOfVolumes"), 1);
  EXPECT_EQ(reading.Number("ExtendedHeaderBytes"), 80);
  EXPECT_EQ(reading.Number("FormatVersion"), 20140);
  EXPECT_EQ(reading.Text("ExtendedHeaderType"), "CCP4");
  EXPECT_EQ(reading.Text("Compression"), "none");
  EXPECT_EQ(reading.Text("LengthUnit"), "angstrom");
  ASSERT_EQ(reading.Count("Labels"), 2);
  EXPECT_EQ(reading.Text("Labels", 0), "first label");
  EXPECT_EQ(reading.Text("Labels", 1), "second ? label");
}

struct Repair
{
  const char* Name;
  Damage Do;
  const char* Says; ///< part of the only expected message
};

void PrintTo(const Repair& repair, std::ostream* os)
{
  *os << repair.Name;
}

class MRCRepair : public ::testing::TestWithParam<Repair>
{
};

TEST_P(MRCRepair, IsReportedAndStrictRefuses)
{
  for (const bool bigEndian : { false, true })
  {
    const TemporaryFile file(SmallMap(GetParam().Do, bigEndian));
    MRCTestReading reading(file.Path());
    vtkImageData* const image = reading.Update();
    ASSERT_FALSE(reading.HasFailed()) << reading.Error();
    EXPECT_EQ(reading.Count("Repairs"), 1);
    EXPECT_NE(reading.Text("Repairs").find(GetParam().Says), std::string::npos)
      << reading.Text("Repairs");
    EXPECT_NE(reading.Warning().find(reading.Text("Repairs")), std::string::npos);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_DOUBLE_EQ(image->GetSpacing()[i], 1.0);
      EXPECT_DOUBLE_EQ(image->GetOrigin()[i], 0.0);
      EXPECT_EQ(image->GetDimensions()[i], 4 - i);
    }
    EXPECT_EQ(reading.At(3, 2, 1), 23.0);

    reading->StrictOn();
    vtkImageData* const refused = reading.Update();
    EXPECT_TRUE(reading.HasFailed());
    EXPECT_NE(reading.Error().find(GetParam().Says), std::string::npos) << reading.Error();
    EXPECT_EQ(refused->GetNumberOfPoints(), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Fields, MRCRepair,
  ::testing::Values(Repair{ "NoStamp", [](MRCTestFile& m) { m.SetText(212, std::string(4, '\0')); },
                      "The machine stamp (word 54) is 00 00 00 00, which is not valid" },
    Repair{ "HalfStamp", [](MRCTestFile& m) { m.SetText(212, std::string("D\0\0\0", 4)); },
      "The machine stamp (word 54) is 44 00 00 00" },
    Repair{ "BlankStamp", [](MRCTestFile& m) { m.SetText(212, "D   "); },
      "The machine stamp (word 54) is 44 20 20 20" },
    Repair{ "NoMapWord", [](MRCTestFile& m) { m.SetText(208, std::string(4, '\0')); },
      "\"MAP \" (word 53) is missing" },
    Repair{ "AxesZero",
      [](MRCTestFile& m) {
        m.SetInts(17, { 0, 0, 0 });
      },
      "(words 17-19) is 0, 0, 0" },
    Repair{ "AxesTwice",
      [](MRCTestFile& m) {
        m.SetInts(17, { 1, 1, 3 });
      },
      "(words 17-19) is 1, 1, 3" },
    Repair{
      "ZeroSampling", [](MRCTestFile& m) { m.SetInt(9, 0); }, "MY (word 9) is 0: taken as 3" },
    Repair{ "NegativeSampling", [](MRCTestFile& m) { m.SetInt(10, -7); },
      "MZ (word 10) is -7: taken as 2" },
    Repair{ "ZeroCell", [](MRCTestFile& m) { m.SetFloat(11, 0.0f); }, "along x (word 11) is 0" },
    Repair{
      "NegativeCell", [](MRCTestFile& m) { m.SetFloat(12, -40.0f); }, "along y (word 12) is -40" },
    Repair{ "NaNCell", [](MRCTestFile& m) { m.SetFloat(13, std::nanf("")); },
      "along z (word 13) is not a number" },
    Repair{ "NoAngles",
      [](MRCTestFile& m) {
        m.SetFloats(14, { 0.0f, 0.0f, 0.0f });
      },
      "(words 14-16) are 0, 0, 0" },
    Repair{ "ImpossibleAngles",
      [](MRCTestFile& m) {
        m.SetFloats(14, { 150.0f, 120.0f, 100.0f });
      },
      "(words 14-16) are 150, 120, 100" },
    Repair{
      "SpaceGroup", [](MRCTestFile& m) { m.SetInt(23, 1065353216); }, "(word 23) is 1065353216" },
    Repair{ "NegativeExtension", [](MRCTestFile& m) { m.SetInt(24, -80); }, "(word 24) is -80" },
    Repair{ "MissingExtension", [](MRCTestFile& m) { m.SetInt(24, 160); },
      "extended header of 160 bytes" },
    Repair{ "WildStart", [](MRCTestFile& m) { m.SetInt(6, 2000000000); }, "(words 5-7)" },
    Repair{ "WildOrigin", [](MRCTestFile& m) { m.SetFloat(50, 1e30f); }, "(words 50-52)" },
    Repair{ "NaNOrigin", [](MRCTestFile& m) { m.SetFloat(51, std::nanf("")); }, "(words 50-52)" },
    Repair{ "ManyLabels", [](MRCTestFile& m) { m.SetInt(56, 11); }, "(word 56) is 11" },
    Repair{ "NoRotation", [](MRCTestFile& m) { m.SetInt(25, 1); }, "skew transformation" }),
  [](const auto& repair) { return repair.param.Name; });

// Without a sampling the cell is that of the map: the spacing is the cell over the nodes.
TEST(MRCHeader, WithoutASamplingTheCellIsTheMap)
{
  for (const bool turned : { false, true })
  {
    const TemporaryFile file(SmallMap(
      [turned](MRCTestFile& map)
      {
        map.SetInts(8, { 0, -1, 0 });
        map.SetFloats(11, { 6.0f, 12.0f, 24.0f });
        if (turned)
        {
          map.SetInts(17, { 3, 1, 2 }); // columns along z, rows along x, sections along y
        }
      }));
    MRCTestReading reading(file.Path());
    vtkImageData* const image = reading.Update();
    ASSERT_FALSE(reading.HasFailed()) << reading.Error();
    const std::array<int, 3> nodes =
      turned ? std::array<int, 3>{ 3, 2, 4 } : std::array<int, 3>{ 4, 3, 2 };
    const std::array<double, 3> cell{ 6.0, 12.0, 24.0 };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(image->GetDimensions()[axis], nodes[axis]);
      EXPECT_DOUBLE_EQ(image->GetSpacing()[axis], cell[axis] / nodes[axis]);
    }
    EXPECT_EQ(reading.Count("Repairs"), 3);
  }
}

TEST(MRCHeader, WithoutASamplingAsReported)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/k02b_mx0.mrc");
  MRCTestReading reading((SharedDataFolder() / "reports/k02b_mx0.mrc").c_str());
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(reading.Update()->GetSpacing()[axis], 3.0);
  }
}

TEST(MRCHeader, BytesAfterTheMapAreReported)
{
  const TemporaryFile file(SmallMap([](MRCTestFile&) {}) + "1234567");
  MRCTestReading reading(file.Path());
  reading.Update();
  EXPECT_FALSE(reading.HasFailed());
  EXPECT_NE(reading.Text("Repairs").find("7 bytes follow"), std::string::npos);
}

TEST(MRCHeader, AWrongStampIsOverruled)
{
  for (const bool bigEndian : { false, true })
  {
    const TemporaryFile file(
      SmallMap([bigEndian](MRCTestFile& map) { map.SetText(212, bigEndian ? "DA" : "\x11\x11"); },
        bigEndian));
    MRCTestReading reading(file.Path());
    reading.Update();
    ASSERT_FALSE(reading.HasFailed()) << reading.Error();
    EXPECT_EQ(reading.Text("ByteOrder"), bigEndian ? "big endian" : "little endian");
    EXPECT_NE(reading.Text("Repairs").find("contradicts"), std::string::npos);
    EXPECT_EQ(reading.At(3, 2, 1), 23.0);
  }
}

TEST(MRCHeader, WarningsAreNotRepeatedForTheSameFile)
{
  const TemporaryFile file(SmallMap([](MRCTestFile& map) { map.SetInt(9, 0); }));
  MRCTestReading reading(file.Path());
  reading.Update();
  EXPECT_NE(reading.Warning(), "");
  reading->Modified();
  reading.Update();
  EXPECT_EQ(reading.Warning(), "");
}

TEST(MRCHeader, CanReadFileLooksAtTheContent)
{
  MRCTestReading reading;
  const std::string map = SmallMap([](MRCTestFile&) {});
  const auto asFile = [&](const std::string& content, const char* name = "any.name")
  {
    const TemporaryFile file(content, name);
    return reading->CanReadFile(file.Path());
  };
  EXPECT_EQ(asFile(map), 1);
  EXPECT_EQ(asFile(SmallMap([](MRCTestFile&) {}, true)), 1);
  EXPECT_EQ(asFile(Gzip(map)), 1);
  EXPECT_EQ(asFile(Bzip2(map)), 1);
  EXPECT_EQ(asFile(SmallMap([](MRCTestFile& m) { m.SetText(208, "    "); })), 1);
  EXPECT_EQ(asFile(""), 1); // by its name: reading reports that it is empty
  EXPECT_EQ(asFile("short"), 0);
  EXPECT_EQ(asFile(std::string(4096, ' ')), 0);
  EXPECT_EQ(asFile(std::string(4096, '\0')), 0);
  EXPECT_EQ(asFile(Gzip(std::string(4096, 'x'))), 0);
  EXPECT_EQ(asFile("short", "wrong.map"), 1); // by its name: reading reports what is wrong
  EXPECT_EQ(asFile("short", "wrong.MRC.gz"), 1);
  EXPECT_EQ(asFile("RUU CROSS SYSTEM MAP FORMAT", "elevation.map"), 0);
  EXPECT_EQ(asFile("OziExplorer Map Data File", "walk.map"), 0);
  EXPECT_EQ(reading->CanReadFile("/there/is/no/such/file"), 0);
  EXPECT_EQ(reading->CanReadFile("/there/is/no/such/file.map"), 0);
  EXPECT_EQ(reading->CanReadFile("/"), 0);
  EXPECT_EQ(reading->CanReadFile(nullptr), 0);
  EXPECT_FALSE(reading.HasFailed());
}

}
