#include "Files/FileCalls.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <io.h>
#include <process.h>
#include <sys/stat.h>

namespace isthmus
{

int ProcessNumber()
{
  return ::_getpid();
}

int CheckWritable(const std::string& path)
{
  constexpr int writable = 2;
  return ::_waccess(std::filesystem::u8path(path).c_str(), writable) == 0 ? 0 : errno;
}

int MakeNewFile(const std::string& path)
{
  const int descriptor = ::_wopen(std::filesystem::u8path(path).c_str(),
    _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY, _S_IREAD | _S_IWRITE);
  if (descriptor < 0)
  {
    return errno;
  }
  ::_close(descriptor);
  return 0;
}

int FlushToDisk(const std::string& path)
{
  const int descriptor = ::_wopen(std::filesystem::u8path(path).c_str(), _O_WRONLY | _O_BINARY);
  if (descriptor < 0)
  {
    return errno;
  }
  const int error = ::_commit(descriptor) == 0 ? 0 : errno;
  ::_close(descriptor);
  return error;
}

int MoveFileTo(const std::string& path, const std::string& target)
{
  std::error_code error;
  std::filesystem::rename(std::filesystem::u8path(path), std::filesystem::u8path(target), error);
  return error.default_error_condition().value();
}

}
