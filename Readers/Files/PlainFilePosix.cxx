#include "Files/PlainFile.h"

#include "Core/NumberText.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

namespace isthmus
{
namespace
{

/// Opens without waiting, since opening a pipe would wait for its writer.
int OpenForReading(const std::string& path)
{
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor >= 0)
  {
    return descriptor;
  }
  if (errno == ENOENT || errno == ENOTDIR)
  {
    throw ReaderError(ReaderFailure::NoSuchFile, path + ": there is no such file. Check its name.");
  }
  throw ReaderError(ReaderFailure::CannotRead,
    path + ": the file can't be opened (" + std::strerror(errno) + "). Check its permissions.");
}

}

PlainFile::PlainFile(const std::string& path)
  : Name(path)
{
  const int descriptor = OpenForReading(path);
  struct stat status = {};
  const char* wrong = nullptr;
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
  {
    wrong = S_ISDIR(status.st_mode) ? ": this is a folder. Choose a file in it."
                                    : ": this is not a regular file. Copy it to one first.";
  }
  else if (status.st_size == 0)
  {
    wrong = ": the file is empty (0 bytes). Fetch or write it again.";
  }
  if (wrong)
  {
    ::close(descriptor);
    const bool empty = S_ISREG(status.st_mode);
    throw ReaderError(empty ? ReaderFailure::Truncated : ReaderFailure::CannotRead, path + wrong);
  }
  this->Descriptor = descriptor;
  this->Bytes = static_cast<std::uint64_t>(status.st_size);
#ifdef __APPLE__
  const timespec& changed = status.st_mtimespec;
#else
  const timespec& changed = status.st_mtim;
#endif
  this->Version = JoinText(path, ' ', status.st_dev, ' ', status.st_ino, ' ', status.st_size, ' ',
    changed.tv_sec, ' ', changed.tv_nsec);
}

PlainFile::PlainFile(PlainFile&& other) noexcept
  : Name(std::move(other.Name))
  , Version(std::move(other.Version))
  , Descriptor(std::exchange(other.Descriptor, -1))
  , Bytes(other.Bytes)
{
}

PlainFile::~PlainFile()
{
  if (this->Descriptor >= 0)
  {
    ::close(static_cast<int>(this->Descriptor));
  }
}

std::size_t PlainFile::Read(std::uint64_t offset, void* to, std::size_t size) const
{
  // Linux transfers at most 2 GiB less a page at once.
  constexpr std::size_t most = std::size_t{ 1 } << 30;
  std::size_t done = 0;
  while (done < size)
  {
    const ssize_t got = ::pread(static_cast<int>(this->Descriptor), static_cast<char*>(to) + done,
      std::min(size - done, most), static_cast<off_t>(offset + done));
    if (got < 0 && errno != EINTR)
    {
      throw ReaderError(ReaderFailure::CannotRead,
        this->Name + ": reading failed at byte " + std::to_string(offset + done) + " (" +
          std::strerror(errno) + ").");
    }
    if (got == 0)
    {
      break;
    }
    done += got > 0 ? static_cast<std::size_t>(got) : 0;
  }
  return done;
}

}
