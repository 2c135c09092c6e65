#include "Core/ChildProcess.h"

#include "Core/StartedProgram.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace isthmus
{
namespace
{

std::string ReadTail(const std::filesystem::path& log)
{
  constexpr std::streamoff most = 4000;
  std::ifstream file(log, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : 0;
  std::string text(static_cast<std::size_t>(std::min(size, most)), '\0');
  file.seekg(size - static_cast<std::streamoff>(text.size()));
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

}

TemporaryFolder::TemporaryFolder()
{
  std::error_code missing;
  const std::filesystem::path place = std::filesystem::temp_directory_path(missing);
  if (missing)
  {
    const char* named = std::getenv("TMPDIR");
    throw std::runtime_error("The folder for temporary files, " +
      std::string(named ? named : "/tmp") + ", does not exist (" + missing.message() +
      "): create it, or set TMPDIR to an existing folder.");
  }
  this->Folder = NewFolderIn(place);
  if (this->Folder.empty())
  {
    throw std::runtime_error("No temporary folder could be created in " + place.string() + " (" +
      std::strerror(errno) + "): free some space or set TMPDIR.");
  }
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code ignored;
  std::filesystem::remove_all(this->Folder, ignored);
}

ChildResult RunChild(const std::vector<std::string>& command, const ChildLimits& limits,
  const std::filesystem::path& log, const ProgressCallback& progress)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  StartedProgram program(command, limits, log);
  const auto elapsed = [&start]()
  { return std::chrono::duration<double>(Clock::now() - start).count(); };
  auto pause = std::chrono::milliseconds(1); // poll short programs often, long ones rarely
  while (!program.HasEnded())
  {
    const double seconds = elapsed();
    if (seconds > limits.TimeLimit)
    {
      return { ChildEnd::TimedOut, 0, ReadTail(log) };
    }
    Report(progress, seconds / limits.TimeLimit);
    std::this_thread::sleep_for(pause);
    pause = std::min(2 * pause, std::chrono::milliseconds(50));
  }
  const auto [end, code] = program.HowItEnded(elapsed());
  return { end, code, ReadTail(log) };
}

}
