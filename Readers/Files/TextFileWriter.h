/**
 * @file TextFileWriter.h
 * @brief A text file that is written whole or not at all.
 */
#ifndef isthmus_TextFileWriter_h
#define isthmus_TextFileWriter_h

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
 * the fewest digits from which the same bits are read, and a '.' in every locale.
 *
 * Without Close() the file is removed again. Memory: 1 MiB.
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

  /// Everything is in the file when this returns.
  void Close();

private:
  void Flush();
  [[noreturn]] void Fail() const;

  std::string Path;
  gzFile_s* File;
  std::string Buffer;
};

}

#endif
