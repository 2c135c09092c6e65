/**
 * @file FileReplacement.h
 * @brief A file that replaces another one when it is complete; the old file survives every failure.
 */
#ifndef isthmus_FileReplacement_h
#define isthmus_FileReplacement_h

#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <string>

namespace isthmus
{

/**
 * Manages a new file beside the target, which can be written in any way and must be closed before
 * Finish(). Without Replace() it is removed, and the target is unchanged. Links are followed, and
 * the permissions of an existing target are kept. If the target is not a regular file (a device, a
 * pipe), it is written directly.
 */
class VTKISTHMUSREADERSFILES_EXPORT FileReplacement
{
public:
  /// Creates the new file, empty.
  /// @throws std::runtime_error if the target or its folder cannot be written.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  /// Where to write.
  const std::string& Written() const { return this->New; }

  /// Flushes the file to the disk; afterwards, Replace() needs no more space.
  /// @throws std::runtime_error if writing to the disk fails.
  void Finish();

  /// The new file has the target's name when this returns. Calls Finish() first if that was not
  /// done.
  /// @throws std::runtime_error.
  void Replace();

  /// @throws std::runtime_error with the target and, for an errno, its reason.
  [[noreturn]] void Fail(int error = 0) const;

private:
  std::string Path;   ///< as it was given
  std::string Target; ///< its target
  std::string New;    ///< the same as Target if that is not a regular file
  bool IsFinished = false;
};

/**
 * A file that is removed together with the replacement of others: Hide() gives it a temporary name,
 * Remove() removes it. Without Remove(), or if hiding fails, it has its name again afterwards.
 * Links are removed, not their targets.
 */
class VTKISTHMUSREADERSFILES_EXPORT FileRemoval
{
public:
  /// @pre the file exists.
  explicit FileRemoval(const std::string& path);
  ~FileRemoval();
  FileRemoval(const FileRemoval&) = delete;
  FileRemoval& operator=(const FileRemoval&) = delete;

  /// @throws std::runtime_error if the file cannot be renamed.
  void Hide();
  void Remove();

private:
  std::string Path;
  std::string Hidden; ///< empty: it has its name
};

}

#endif
