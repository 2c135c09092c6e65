/**
 * @file TextFileWriter.h
 * @brief A text file that is written whole or not at all.
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
 * Text and numbers on their way to a file, gzip-compressed where the path ends in .gz. Numbers have
 * the fewest digits that are read back bit for bit, and a '.' in every locale.
 *
 * The file of this name, if any, is replaced by Close(); without it, or where the disk is full, it
 * stays as it was. Memory: 1 MiB.
 * @throws std::runtime_error with the path when it can't be written.
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

  /// Everything is in the file when this returns, and the file has its name.
  void Close();

  /// The two halves of it, for files that belong together: no name is changed until all are whole.
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
