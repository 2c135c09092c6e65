#include "Files/FileReplacement.h"

#include "Files/FileCalls.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

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
    (".isthmus-" + std::to_string(ProcessNumber()) + "-" + std::to_string(count++) + "-" +
      std::to_string(attempt) + ".part"))
    .string();
}

}

FileReplacement::FileReplacement(const std::string& path)
  : Path(path)
  , Target(ResolveLinks(path))
{
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status old = fs::status(this->Target, ignored);
  if (fs::is_directory(old))
  {
    this->Fail(EISDIR);
  }
  if (fs::exists(old))
  {
    if (const int error = CheckWritable(this->Target))
    {
      this->Fail(error);
    }
    if (!fs::is_regular_file(old))
    {
      this->New = this->Target;
      return;
    }
  }
  constexpr unsigned int mostAttempts = 100; // files of terminated processes may exist there
  int error = EEXIST;
  for (unsigned int attempt = 0; error == EEXIST && attempt < mostAttempts; ++attempt)
  {
    this->New = NameBeside(this->Target, attempt);
    error = MakeNewFile(this->New);
  }
  if (error != 0)
  {
    this->Fail(error);
  }
  if (fs::exists(old))
  {
    fs::permissions(this->New, old.permissions() & fs::perms::all, ignored);
  }
}

FileReplacement::~FileReplacement()
{
  if (this->New != this->Target)
  {
    std::error_code ignored;
    std::filesystem::remove(this->New, ignored);
  }
}

void FileReplacement::Finish()
{
  if (this->New != this->Target && !this->IsFinished)
  {
    // Some file systems report a full disk only now.
    if (const int error = FlushToDisk(this->New))
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
    if (const int error = MoveFileTo(this->New, this->Target))
    {
      this->Fail(error);
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
    MoveFileTo(this->Hidden, this->Path);
  }
}

void FileRemoval::Hide()
{
  // The name is new: no file is replaced.
  const std::string hidden = NameBeside(this->Path, 0);
  if (const int error = MoveFileTo(this->Path, hidden))
  {
    throw std::runtime_error("The file '" + this->Path + "' can't be removed (" +
      std::strerror(error) + "): check its folder.");
  }
  this->Hidden = hidden;
}

void FileRemoval::Remove()
{
  if (!this->Hidden.empty())
  {
    std::error_code ignored;
    std::filesystem::remove(this->Hidden, ignored);
    this->Hidden.clear();
  }
}

}
