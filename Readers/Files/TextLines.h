/**
 * @file TextLines.h
 * @brief Lines, words and numbers of a text that is in memory, without copies.
 */
#ifndef isthmus_TextLines_h
#define isthmus_TextLines_h

#include "Core/Progress.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
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

inline std::string_view Trim(std::string_view text)
{
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos)
  {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
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
  const auto first = std::min(rest.find_first_not_of(" \t"), rest.size());
  const auto end = std::min(rest.find_first_of(" \t", first), rest.size());
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

/// Whether the whole text is one number; a leading + is allowed.
template <typename T>
bool IsNumber(std::string_view text, T& value)
{
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
