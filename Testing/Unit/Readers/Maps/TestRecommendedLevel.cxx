#include "Core/ChildProcess.h"
#include "Maps/RecommendedLevel.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace isthmus;

namespace
{

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
  EXPECT_EQ(LevelOfHeader(Contour("0.0316")), 0.0316);
  EXPECT_EQ(LevelOfHeader("<map><contourLevel source=\"author\"> 2.5 </contourLevel></map>"), 2.5);
  EXPECT_EQ(LevelOfHeader(Contour("-1e-3")), -1e-3);
  EXPECT_EQ(LevelOfHeader(Contour("0.5<!-- 0.7 or 911-->")), 0.5);
}

TEST(RecommendedLevel, ThePrimaryOneOfSeveral)
{
  EXPECT_EQ(LevelOfHeader("<contour_list>\n<contour primary=\"false\"><level>1</level></contour>\n"
                          "<contour primary=\"true\"><level>2</level></contour></contour_list>"),
    2.0);
  EXPECT_EQ(LevelOfHeader("<contour_list><contour><level>3</level></contour>"
                          "<contour><level>4</level></contour></contour_list>"),
    3.0);
}

TEST(RecommendedLevel, NothingWhereThereIsNone)
{
  for (const char* text : { "", "<emd/>", "<contour>", "<contour", "<contour_list></contour_list>",
         "<contour><level>high</level></contour>", "<contour><level>nan</level></contour>",
         "<contour><level>1 2</level></contour>", "<contour><level/></contour>",
         "<!-- <contour><level>1</level></contour> -->", "<!-- <contour><level>1</level>" })
  {
    EXPECT_FALSE(LevelOfHeader(text)) << text;
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
  EXPECT_EQ(RecommendedLevel(folder / "map/emd_5043_half_map_1.map"), 8.0);
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_504.map"));
  EXPECT_FALSE(RecommendedLevel(folder / "map/ribosome.map"));
  EXPECT_FALSE(RecommendedLevel(folder / "map/emd_.map"));
  EXPECT_FALSE(RecommendedLevel(""));
}
