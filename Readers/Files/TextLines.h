/**
 * @file TextLines.h
 * @brief Lines, words and numbers of a text that is in memory, without copies.
 */
#ifndef isthmus_TextLines_h
#define isthmus_TextLines_h

#include "Core/Progress.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace isthmus
{

/// Iterates over the lines of a text, with progress, and creates messages about the current line.
class TextLines
{
public:
  TextLines(std::string_view text, std::string path, ProgressCallback progress)
    : Text(text)
    , Path(std::move(path))
    , Progress(std::move(progress))
  {
  }

  /// False at the end; `line` does not include its line end.
  bool Next(std::string_view& line)
  {
    if (this->At >= this->Text.size())
    {
      return false;
    }
    const std::size_t end = std::min(this->Text.find('\n', this->At), this->Text.size());
    line = this->Text.substr(this->At, end - this->At);
    if (!line.empty() && line.back() == '\r')
    {
      line.remove_suffix(1);
    }
    this->At = end + 1;
    constexpr std::int64_t linesBetweenReports = 1 << 14;
    if (++this->Number % linesBetweenReports == 0)
    {
      Report(
        this->Progress, static_cast<double>(this->At) / static_cast<double>(this->Text.size()));
    }
    return true;
  }

  /// Moves to a line of the text after the current one.
  void GoTo(std::string_view line)
  {
    const auto at = static_cast<std::size_t>(line.data() - this->Text.data());
    do
    {
      this->Next(line);
    } while (this->At <= at);
  }

  /// Whether no line end follows the current line: where the file is truncated, it is the line in
  /// which it ends.
  bool IsUnfinished() const { return this->At > this->Text.size(); }

  /// "line 7"
  std::string Line() const { return "line " + std::to_string(this->Number); }

  /// "PATH, line 7: "
  std::string Here() const { return this->Path + ", line " + std::to_string(this->Number) + ": "; }

  /// @throws std::runtime_error: PATH, line 7: `reason`.
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw std::runtime_error(this->Here() + reason);
  }

private:
  std::string_view Text;
  std::string Path;
  ProgressCallback Progress;
  std::size_t At = 0;
  std::int64_t Number = 0;
};

constexpr bool IsSpaceOrTab(char c)
{
  return c == ' ' || c == '\t';
}

inline std::string_view Trim(std::string_view text)
{
  while (!text.empty() && IsSpaceOrTab(text.front()))
  {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsSpaceOrTab(text.back()))
  {
    text.remove_suffix(1);
  }
  return text;
}

/// The characters [from, from + count) of `line`, as far as they exist, without surrounding blanks.
inline std::string_view Columns(std::string_view line, std::size_t from, std::size_t count)
{
  return from < line.size() ? Trim(line.substr(from, count)) : std::string_view();
}

/// The last line of `text` if no line end follows it, else empty.
inline std::string_view UnfinishedLine(std::string_view text)
{
  return text.substr(text.find_last_of('\n') + 1);
}

/// Removes the next word from `rest` and returns it; empty at the end.
inline std::string_view NextWord(std::string_view& rest)
{
  std::size_t first = 0;
  while (first < rest.size() && IsSpaceOrTab(rest[first]))
  {
    ++first;
  }
  std::size_t end = first;
  while (end < rest.size() && !IsSpaceOrTab(rest[end]))
  {
    ++end;
  }
  const std::string_view word = rest.substr(first, end - first);
  rest.remove_prefix(end);
  return word;
}

inline std::size_t CountWords(std::string_view line)
{
  std::size_t count = 0;
  while (!NextWord(line).empty())
  {
    ++count;
  }
  return count;
}

/// Whether the text is a decimal of at most 15 digits without an exponent. The quotient of two
/// numbers that a double holds exactly is rounded as the decimal itself would be.
inline bool IsShortDecimal(std::string_view text, double& value)
{
  constexpr std::size_t mostDigits = 15;
  constexpr std::array<double, mostDigits + 1> powers{ 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8,
    1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15 };
  const bool isNegative = !text.empty() && text[0] == '-';
  text.remove_prefix(isNegative ? 1 : 0);
  std::int64_t digits = 0;
  std::size_t count = 0;
  std::size_t beforePoint = std::string_view::npos;
  for (const char c : text)
  {
    if (c == '.' && beforePoint == std::string_view::npos)
    {
      beforePoint = count;
    }
    else if (c >= '0' && c <= '9' && count < mostDigits)
    {
      digits = 10 * digits + (c - '0');
      ++count;
    }
    else
    {
      return false;
    }
  }
  if (count == 0)
  {
    return false;
  }
  const double size = static_cast<double>(digits) /
    (beforePoint == std::string_view::npos ? 1.0 : powers[count - beforePoint]);
  value = isNegative ? -size : size;
  return true;
}

/// Whether the whole text is one number; a leading + is allowed.
template <typename T>
bool IsNumber(std::string_view text, T& value)
{
  if constexpr (std::is_same_v<T, double>)
  {
    if (IsShortDecimal(text, value))
    {
      return true;
    }
  }
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return !text.empty() && result.ec == std::errc() && result.ptr == end;
}

}

#endif
