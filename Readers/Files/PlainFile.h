/**
 * @file PlainFile.h
 * @brief A file that threads read concurrently; one source for each system.
 */
#ifndef isthmus_PlainFile_h
#define isthmus_PlainFile_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace isthmus
{

/// A regular file that many threads can read concurrently.
/// Owns an open file; can be moved, not copied.
class PlainFile
{
public:
  /// @throws ReaderError when `path` is missing, unreadable, empty or not a regular file.
  explicit PlainFile(const std::string& path);
  PlainFile(PlainFile&& other) noexcept;
  PlainFile& operator=(PlainFile&&) = delete;
  ~PlainFile();

  /// Copies up to `size` bytes at `offset`; fewer only at the end.
  /// @throws ReaderError on an I/O error.
  std::size_t Read(std::uint64_t offset, void* to, std::size_t size) const;

  std::uint64_t Size() const { return this->Bytes; }
  const std::string& Path() const { return this->Name; }
  /// Of another content, another text.
  const std::string& Stamp() const { return this->Version; }

private:
  std::string Name, Version;
  std::intptr_t Descriptor = -1; ///< or, on Windows, a handle; -1: none
  std::uint64_t Bytes = 0;
};

}

#endif
