/**
 * @file TextFileWriter.h
 * @brief A text file that is written either completely or not at all.
 */
#ifndef isthmus_TextFileWriter_h
#define isthmus_TextFileWriter_h

#include "Files/FileReplacement.h"
#include "Files/NumberTypes.h"

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

struct gzFile_s;

namespace isthmus
{

/**
 * Writes text and numbers to a file, gzip-compressed if the path ends in .gz. Numbers are written
 * with the fewest digits that are read back bit for bit, and a '.' in every locale.
 *
 * An existing file of this name is replaced by Close(); without Close(), or if the disk is full, it
 * is not changed. Memory: 1 MiB.
 * @throws std::runtime_error with the path if it cannot be written.
 */
class TextFileWriter
{
public:
  explicit TextFileWriter(const std::string& path);
  ~TextFileWriter();
  TextFileWriter(const TextFileWriter&) = delete;
  TextFileWriter& operator=(const TextFileWriter&) = delete;

  TextFileWriter& operator<<(std::string_view text);
  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  TextFileWriter& operator<<(T number)
  {
    std::array<char, 64> digits;
    return *this << ToText(number, digits);
  }

  /// When this returns, everything has been written and the file has its final name.
  void Close();

  /// The two halves of Close(), for files that belong together: no file is renamed until all are
  /// complete.
  void Finish();
  void Replace() { this->File.Replace(); }

private:
  void Flush();

  FileReplacement File;
  gzFile_s* Stream;
  std::string Buffer;
};

}

#endif
