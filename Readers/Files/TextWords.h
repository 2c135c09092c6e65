/**
 * @file TextWords.h
 * @brief Words, numbers and raw bytes of a text file, read from front to back.
 */
#ifndef isthmus_TextWords_h
#define isthmus_TextWords_h

#include "Files/ByteSource.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/**
 * White space and commas separate words. Text in double quotes is one word, without its quotes. A
 * comment extends from # to the end of the line.
 *
 * A decimal comma, as programs write it under some locales, would make two numbers of one:
 * `1,5 0 0`. Where a line has blanks between words, too, a comma without blanks between two digits
 * is an error, unless it belongs to a list of three or more: `0 1,2,3`.
 *
 * Memory: a buffer of 1 MiB, regardless of the size of the file. All functions throw ReaderError
 * with the path and the line for text that cannot be read.
 */
class TextWords
{
public:
  explicit TextWords(ByteSource& source);

  /// The next word, empty at the end of the file; it is valid until the next call of any kind.
  std::string_view Word();

  /// The next word as a number. The error message if it is not a number calls it `what`.
  std::int64_t Whole(const char* what);
  double Number(const char* what);

  /// Reads the next `count` numbers into `values`; T is float or double, and each number is rounded
  /// to the nearest value of T.
  template <typename T>
  void Numbers(T* values, std::int64_t count);

  /// The rest of this line, without its comment and line end; reading continues at the next line.
  std::string RestOfLine();

  /// Skips the rest of this line, which must be blank, and then reads `count` raw bytes into `to`.
  void EndLine();
  void Bytes(unsigned char* to, std::size_t count);

  /// Up to 100 comments so far, without their # and blanks around them.
  const std::vector<std::string>& Comments() const { return this->Notes; }

  /// @throws ReaderError (Truncated): the file ends before `what`, with its path and line.
  [[noreturn]] void RejectEnd(const char* what) const;

  /// @throws ReaderError (Damaged): path, line, `sentence`.
  [[noreturn]] void Reject(const std::string& sentence) const;

private:
  bool Refill();
  bool IsDecimalComma(); ///< at Next
  void CheckComma();
  bool SkipToWord();
  std::string_view RequireWord(const char* what);
  void SkipComment();
  template <typename T>
  T SlowNumber(const char* what);

  ByteSource& Source;
  std::vector<char> Buffer;
  const char* Next = nullptr;
  const char* End = nullptr;
  std::uint64_t Position = 0; ///< of End in the content
  std::int64_t Line = 1;
  std::string Quoted;
  std::vector<std::string> Notes;
};

}

#endif
