#include "Files/FileReplacement.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isthmus
{
namespace
{

/// The target of `path` through symbolic links, even if the last one is dangling.
std::string ResolveLinks(const std::string& path)
{
  std::filesystem::path target = path;
  std::error_code error;
  constexpr int mostLinks = 40; // as many as Linux follows
  for (int i = 0; i < mostLinks && std::filesystem::is_symlink(target, error); ++i)
  {
    target = target.parent_path() / std::filesystem::read_symlink(target, error);
  }
  return target.string();
}

/// A name in the folder of `target` that no other writer of this or another process uses.
std::string NameBeside(const std::string& target, unsigned int attempt)
{
  static std::atomic<unsigned int> count{ 0 };
  // The target's own name may be as long as names can be.
  return (std::filesystem::path(target).parent_path() /
    (".isthmus-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + "-" +
      std::to_string(attempt) + ".part"))
    .string();
}

}

FileReplacement::FileReplacement(const std::string& path)
  : Path(path)
  , Target(ResolveLinks(path))
{
  struct stat old = {};
  const bool isThere = ::stat(this->Target.c_str(), &old) == 0;
  if (isThere && S_ISDIR(old.st_mode))
  {
    this->Fail(EISDIR);
  }
  if (isThere && ::access(this->Target.c_str(), W_OK) != 0)
  {
    this->Fail(errno);
  }
  if (isThere && !S_ISREG(old.st_mode))
  {
    this->New = this->Target;
    return;
  }
  constexpr unsigned int mostAttempts = 100; // files of terminated processes may exist there
  int descriptor = -1;
  for (unsigned int attempt = 0; descriptor < 0 && attempt < mostAttempts; ++attempt)
  {
    this->New = NameBeside(this->Target, attempt);
    descriptor = ::open(this->New.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
      S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH); // less those of umask
    if (descriptor < 0 && errno != EEXIST)
    {
      break;
    }
  }
  if (descriptor < 0)
  {
    this->Fail(errno);
  }
  if (isThere)
  {
    ::fchmod(descriptor, old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO));
  }
  ::close(descriptor);
}

FileReplacement::~FileReplacement()
{
  if (this->New != this->Target)
  {
    ::unlink(this->New.c_str());
  }
}

void FileReplacement::Finish()
{
  if (this->New != this->Target && !this->IsFinished)
  {
    const int descriptor = ::open(this->New.c_str(), O_WRONLY | O_CLOEXEC);
    // Some file systems report a full disk only now.
    const int flushed = descriptor < 0 ? -1 : ::fsync(descriptor);
    const int error = errno;
    if (descriptor >= 0)
    {
      ::close(descriptor);
    }
    if (flushed != 0 && error != EINVAL) // the file system has no fsync
    {
      this->Fail(error);
    }
  }
  this->IsFinished = true;
}

void FileReplacement::Replace()
{
  this->Finish();
  if (this->New != this->Target)
  {
    if (::rename(this->New.c_str(), this->Target.c_str()) != 0)
    {
      this->Fail(errno);
    }
    this->New = this->Target;
  }
}

void FileReplacement::Fail(int error) const
{
  const std::string reason = error != 0 ? std::string(" (") + std::strerror(error) + ")" : "";
  throw std::runtime_error("The file '" + this->Path + "' can't be written to its end" + reason +
    ": check its folder and the space left.");
}

FileRemoval::FileRemoval(const std::string& path)
  : Path(path)
{
}

FileRemoval::~FileRemoval()
{
  if (!this->Hidden.empty())
  {
    ::rename(this->Hidden.c_str(), this->Path.c_str());
  }
}

void FileRemoval::Hide()
{
  // The name is new: no file is replaced.
  const std::string hidden = NameBeside(this->Path, 0);
  if (::rename(this->Path.c_str(), hidden.c_str()) != 0)
  {
    throw std::runtime_error("The file '" + this->Path + "' can't be removed (" +
      std::strerror(errno) + "): check its folder.");
  }
  this->Hidden = hidden;
}

void FileRemoval::Remove()
{
  if (!this->Hidden.empty())
  {
    ::unlink(this->Hidden.c_str());
    this->Hidden.clear();
  }
}

}
