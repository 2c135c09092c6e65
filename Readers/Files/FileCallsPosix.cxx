#include "Files/FileCalls.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isthmus
{

int ProcessNumber()
{
  return static_cast<int>(::getpid());
}

int CheckWritable(const std::string& path)
{
  return ::access(path.c_str(), W_OK) == 0 ? 0 : errno;
}

int MakeNewFile(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
    S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH); // less those of umask
  if (descriptor < 0)
  {
    return errno;
  }
  ::close(descriptor);
  return 0;
}

int FlushToDisk(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0)
  {
    return errno;
  }
  const int error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return error == EINVAL ? 0 : error; // the file system has no fsync
}

int MoveFileTo(const std::string& path, const std::string& target)
{
  return ::rename(path.c_str(), target.c_str()) == 0 ? 0 : errno;
}

}
