#include "Core/ChildProcess.h"
#include "Maps/RecommendedLevel.h"
#include "SharedData.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

const EntryMap Primary{ "5043", "map", 0 };

std::optional<double> ReadLevelFromHeader(const std::string& xml, const EntryMap& map = Primary)
{
  return HeaderLevel(xml, map);
}

/// A folder of the test's own with an empty folder "map".
struct Folder
{
  Folder() { std::filesystem::create_directories(this->Path / "map"); }

  void Write(const std::string& name, const std::string& text) const
  {
    std::filesystem::create_directories((this->Path / name).parent_path());
    std::ofstream(this->Path / name) << text;
  }
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }

  TemporaryFolder Own;
  const std::filesystem::path& Path = this->Own.Path();
};

std::string Contour(const std::string& level)
{
  return "<emd><map><contour_list><contour primary=\"true\"><level>" + level +
    "</level><source>AUTHOR</source></contour></contour_list></map></emd>";
}

}

TEST(RecommendedLevel, OfBothFormats)
{
  EXPECT_EQ(ReadLevelFromHeader(Contour("0.0316")), 0.0316);
  EXPECT_EQ(
    ReadLevelFromHeader("<map><contourLevel source=\"author\"> 2.5 </contourLevel></map>"), 2.5);
  EXPECT_EQ(ReadLevelFromHeader(Contour("-1e-3")), -1e-3);
  EXPECT_EQ(ReadLevelFromHeader(Contour("0.5<!-- 0.7 or 911-->")), 0.5);
}

TEST(RecommendedLevel, ThePrimaryOneOfSeveral)
{
  EXPECT_EQ(ReadLevelFromHeader(
              "<map ><contour_list>\n<contour primary=\"false\"><level>1</level></contour>\n"
              "<contour primary=\"true\"><level>2</level></contour></contour_list></map>"),
    2.0);
  EXPECT_EQ(ReadLevelFromHeader("<map><contour_list><contour><level>3</level></contour>"
                                "<contour><level>4</level></contour></contour_list></map>"),
    3.0);
}

TEST(RecommendedLevel, EmptyWithoutAHeader)
{
  for (const char* text : { "", "<emd/>", "<contour>", "<contour", "<contour_list></contour_list>",
         "<contour><level>high</level></contour>", "<contour><level>nan</level></contour>",
         "<contour><level>1 2</level></contour>", "<contour><level/></contour>",
         "<!-- <contour><level>1</level></contour> -->", "<!-- <contour><level>1</level>" })
  {
    EXPECT_FALSE(ReadLevelFromHeader("<map>" + std::string(text) + "</map>")) << text;
  }
}

TEST(RecommendedLevel, BesideTheMapOrInTheArchivesHeaderFolder)
{
  const Folder folder;
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_5043.map"));
  folder.Write("header/emd-5043.xml", Contour("7"));
  EXPECT_EQ(RecommendedLevel(folder / "map/emd_5043.map.gz"), 7.0);
  folder.Write("map/emd-5043.xml", Contour("8"));
  EXPECT_EQ(RecommendedLevel(folder / "map/EMD-5043.ccp4"), 8.0);
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_504.map"));
  EXPECT_FALSE(RecommendedLevel(folder / "map/ribosome.map"));
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_.map"));
  EXPECT_FALSE(RecommendedLevel(""));
}

// A level belongs to one map: other maps of the same entry do not get it.
TEST(RecommendedLevel, OfThisMapOnly)
{
  const auto contour = [](const std::string& level)
  { return "<contour_list><contour><level>" + level + "</level></contour></contour_list>"; };
  const std::string others = "<interpretation><half_map_list><half_map>" + contour("5") +
    "</half_map><half_map><contour_list/></half_map></half_map_list><additional_map_list>"
    "<additional_map>" +
    contour("7") + "</additional_map></additional_map_list></interpretation></emd>";
  const Folder folder;
  folder.Write("map/emd-1.xml", "<emd><map>" + contour("3") + "</map>" + others);
  folder.Write("map/emd-2.xml", "<emd><map><contour_list/></map>" + others);
  EXPECT_EQ(RecommendedLevel(folder / "map/emd_1.map"), 3.0);
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_2.map.gz"));
  for (const char* entry : { "map/emd_1", "map/emd_2" })
  {
    const std::string name = entry;
    EXPECT_EQ(RecommendedLevel(folder / (name + "_half_map_1.map")), 5.0);
    EXPECT_FALSE(RecommendedLevel(folder / (name + "_half_map_2.map")));
    EXPECT_EQ(RecommendedLevel(folder / (name + "_additional_1.map.gz")), 7.0);
    for (const char* other : { "_additional_2.map", "_msk_1.map", "_half_map_3.map", "_bin2.map",
           "_filtered.mrc", ".half1.map" })
    {
      EXPECT_FALSE(RecommendedLevel(folder / (name + other))) << other;
    }
  }
}

// The file name in a description decides where there is one.
TEST(RecommendedLevel, OfTheNamedFile)
{
  const std::string text = "<emd><additional_map_list><additional_map><file format=\"CCP4\">"
                           "emd_9_additional_2.map.gz</file><contour_list><contour><level>2</level>"
                           "</contour></contour_list></additional_map></additional_map_list></emd>";
  EXPECT_FALSE(HeaderLevel(text, { "9", "additional_map", 1 }));
  EXPECT_EQ(HeaderLevel(text, { "9", "additional_map", 2 }), 2.0);
}

TEST(RecommendedLevel, OfTheReportedEntries)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/emdb/emd_90004.map");
  const auto level = [](const char* name)
  { return RecommendedLevel((SharedDataFolder() / "reports/emdb" / name).string()); };
  EXPECT_EQ(level("emd_90001.map"), 3.0);
  EXPECT_FALSE(level("emd_90001_msk_1.map"));
  EXPECT_FALSE(level("emd_90004.map"));
}
