// Programs that end, fail, crash or take too long; their output; their folder.

#include "Core/ChildProcess.h"
#include "Core/Progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace isthmus;

namespace
{

ChildResult Shell(const char* script, const TemporaryFolder& folder, double seconds = 60.0)
{
  ChildLimits limits;
  limits.TimeLimit = seconds;
  return RunChild({ "sh", "-c", script }, limits, folder.Path() / "log", {});
}

}

TEST(ChildProcess, OutputAndErrorsAreInTheLogAndTheResult)
{
  const TemporaryFolder folder;
  const ChildResult result = Shell("echo one; echo two >&2; exit 3", folder);
  EXPECT_EQ(result.End, ChildEnd::Exited);
  EXPECT_EQ(result.Code, 3);
  EXPECT_EQ(result.Output, "one\ntwo\n");
  std::ifstream log(folder.Path() / "log");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(log), std::istreambuf_iterator<char>()),
    "one\ntwo\n");
}

TEST(ChildProcess, OnlyTheEndOfALongOutputIsKept)
{
  const TemporaryFolder folder;
  const ChildResult result = Shell("printf '%05000d' 7", folder);
  EXPECT_EQ(result.Output, std::string(3999, '0') + "7");
}

TEST(ChildProcess, EachEndHasItsName)
{
  const TemporaryFolder folder;
  EXPECT_EQ(Shell("exit 0", folder).Code, 0);
  const ChildResult killed = Shell("kill -9 $$", folder);
  EXPECT_EQ(killed.End, ChildEnd::Crashed);
  EXPECT_EQ(killed.Code, 9);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(Shell("exec sleep 50", folder, 0.05).End, ChildEnd::TimedOut);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
  const std::filesystem::path log = folder.Path() / "log";
  EXPECT_EQ(RunChild({ "isthmus-no-such-program" }, {}, log, {}).End, ChildEnd::NotFound);
  EXPECT_EQ(RunChild({ folder.Path().string() }, {}, log, {}).End, ChildEnd::NotRun);
}

TEST(ChildProcess, StopsOnRequest)
{
  const TemporaryFolder folder;
  EXPECT_THROW(RunChild({ "sleep", "50" }, {}, folder.Path() / "log",
                 [](double fraction) { return fraction < 0.0; }),
    Cancelled);
}

TEST(ChildProcess, ATemporaryFolderIsRemovedWithItsContents)
{
  std::filesystem::path path;
  {
    const TemporaryFolder folder, other;
    path = folder.Path();
    EXPECT_NE(path, other.Path());
    EXPECT_TRUE(std::filesystem::is_empty(path));
    std::filesystem::create_directory(path / "inner");
    std::ofstream(path / "inner" / "file") << "text";
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}
