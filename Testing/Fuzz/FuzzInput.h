/**
 * @file FuzzInput.h
 * @brief Common to fuzz targets: files in memory, one thread, no messages.
 *
 * An input takes a few microseconds; disk access, starting threads or printing a message would
 * dominate the time.
 */
#ifndef isthmus_FuzzInput_h
#define isthmus_FuzzInput_h

#include <vtkObject.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace isthmus::testing
{

/// For LLVMFuzzerInitialize: no threads, and no messages, since errors are expected.
inline void OneThreadAndSilence()
{
  setenv("VTK_SMP_BACKEND_IN_USE", "Sequential", 1);
  vtkObject::GlobalWarningDisplayOff();
}

/// A folder of this process, in memory if /dev/shm exists; removed when the process ends.
class MemoryFolder
{
public:
  MemoryFolder()
  {
    std::error_code none;
    const std::filesystem::path memory("/dev/shm");
    const auto parent =
      std::filesystem::is_directory(memory, none) ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "isthmus-fuzz-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
    {
      std::abort();
    }
    this->Path = pattern;
  }
  ~MemoryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Path, ignored);
  }
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;

  /// Writes [begin, end) as the file `name`, and returns its path.
  std::string Write(const std::string& name, const char* begin, const char* end) const
  {
    const std::string path = this->Path + '/' + name;
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0 || ::write(file, begin, static_cast<std::size_t>(end - begin)) != end - begin)
    {
      std::abort();
    }
    ::close(file);
    return path;
  }

private:
  std::string Path;
};

/// The one of this process.
inline const MemoryFolder& Folder()
{
  static const MemoryFolder folder;
  return folder;
}

}

#endif
