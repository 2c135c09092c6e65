/**
 * @file FileReplacement.h
 * @brief A file that replaces another one when it is whole; the old one survives every failure.
 */
#ifndef isthmus_FileReplacement_h
#define isthmus_FileReplacement_h

#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <string>

namespace isthmus
{

/**
 * Of a new file beside the target, which is written in any way and closed before Finish(). Without
 * Replace() it is removed, and the target is what it was. A link is followed to what it points to,
 * and the permissions of a target that is there are kept. Where the target is no regular file (a
 * device, a pipe), it is written itself.
 */
class VTKISTHMUSREADERSFILES_EXPORT FileReplacement
{
public:
  /// Makes the new file, empty.
  /// @throws std::runtime_error where the target or its folder can't be written.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  /// Where to write.
  const std::string& Written() const { return this->New; }

  /// Flushes what was written to the disk: after it, Replace() needs no more space.
  /// @throws std::runtime_error where the disk does not take it.
  void Finish();

  /// The new file has the target's name when this returns. Finishes first where that was not done.
  /// @throws std::runtime_error.
  void Replace();

  /// @throws std::runtime_error with the target and, for an errno, its reason.
  [[noreturn]] void Fail(int error = 0) const;

private:
  std::string Path;   ///< as it was given
  std::string Target; ///< what it leads to
  std::string New;    ///< the same as Target for what is no regular file
  bool IsFinished = false;
};

}

#endif
