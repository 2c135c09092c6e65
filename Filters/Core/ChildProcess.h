/**
 * @file ChildProcess.h
 * @brief Runs another program with limits, isolated from this process.
 */
#ifndef isthmus_ChildProcess_h
#define isthmus_ChildProcess_h

#include "Core/ChildLimits.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isthmus
{

/// A new, empty folder in the system's folder for temporary files, removed with its contents by the
/// destructor.
class VTKISTHMUSFILTERSCORE_EXPORT TemporaryFolder
{
public:
  /// @throws std::runtime_error when it can't be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& Path() const { return this->Folder; }

private:
  std::filesystem::path Folder;
};

struct ChildResult
{
  ChildEnd End = ChildEnd::Exited;
  int Code = 0;
  std::string Output; ///< the last 4,000 characters of what it wrote to stdout and stderr
};

/**
 * Runs `command` (a program, found on PATH, and its arguments) until it ends; its output goes to
 * the file `log`. `progress` is called about twenty times a second with the fraction of the time
 * limit used; if it returns false, the program is killed and Cancelled is thrown. When this
 * function returns or throws, the program has ended; if this process is killed meanwhile, the
 * program is killed, too, and the folder of `log` is removed.
 * @throws std::runtime_error when no process can be started.
 */
VTKISTHMUSFILTERSCORE_EXPORT ChildResult RunChild(const std::vector<std::string>& command,
  const ChildLimits& limits, const std::filesystem::path& log, const ProgressCallback& progress);

}

#endif
