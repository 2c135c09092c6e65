#include "Files/TextWords.h"

#include "Files/NumberTypes.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace isthmus
{
namespace
{

constexpr std::size_t bufferBytes = std::size_t{ 1 } << 20;
constexpr std::size_t longestWord = 1024;
constexpr std::size_t mostComments = 100;

bool IsBlank(char c)
{
  return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ',' || c == '\f' || c == '\v';
}

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// from_chars does not accept a plus sign before a number.
const char* SkipPlus(const char* begin, const char* end)
{
  return begin + 1 < end && *begin == '+' && begin[1] != '-' ? begin + 1 : begin;
}

}

TextWords::TextWords(ByteSource& source)
  : Source(source)
  // Room for a word before, the current one and the next, which IsDecimalComma() looks at.
  , Buffer(3 * longestWord + std::min<std::uint64_t>(bufferBytes, source.MaximumBytes()))
{
  this->Next = this->End = this->Buffer.data();
}

void TextWords::Reject(const std::string& sentence) const
{
  throw ReaderError(ReaderFailure::Damaged,
    this->Source.Path() + ", line " + std::to_string(this->Line) + ": " + sentence);
}

void TextWords::RejectEnd(const char* what) const
{
  throw ReaderError(ReaderFailure::Truncated,
    this->Source.Path() + ": the file ends at line " + std::to_string(this->Line) + " before " +
      what + ". It is truncated or incomplete; fetch or write it again.");
}

bool TextWords::Refill()
{
  // Characters before Next stay, for IsDecimalComma().
  const auto stay =
    std::min(static_cast<std::size_t>(this->Next - this->Buffer.data()), longestWord);
  const std::size_t kept = stay + static_cast<std::size_t>(this->End - this->Next);
  std::memmove(this->Buffer.data(), this->Next - stay, kept);
  const std::size_t got =
    this->Source.Read(this->Position, this->Buffer.data() + kept, this->Buffer.size() - kept);
  this->Position += got;
  this->Next = this->Buffer.data() + stay;
  this->End = this->Buffer.data() + kept + got;
  return got > 0;
}

bool TextWords::IsDecimalComma()
{
  if (static_cast<std::size_t>(this->End - this->Next) < longestWord)
  {
    this->Refill();
  }
  const char* const begin = this->Buffer.data();
  const char* const end = this->End;
  const char* first = this->Next; // of the previous word
  const char* last = first + 1;   // after the next word
  if (first == begin || last == end || !IsDigit(first[-1]) || !IsDigit(*last))
  {
    return false;
  }
  for (; first != begin && !IsBlank(first[-1]); --first)
  {
  }
  last = std::find_if(last, end, IsBlank);
  // Three numbers or more with commas alone between them are a list: 0 1,2,3.
  const bool isListBefore = first - begin > 1 && first[-1] == ',' && !IsBlank(first[-2]);
  const bool isListAfter = end - last > 1 && *last == ',' && !IsBlank(last[1]);
  if (isListBefore || isListAfter)
  {
    return false;
  }
  for (; first != begin && first[-1] != '\n' && IsBlank(first[-1]); --first)
  {
  }
  last = std::find_if(last, end, [](char c) { return c == '\n' || !IsBlank(c); });
  return (first != begin && first[-1] != '\n') || (last != end && *last != '\n' && *last != '#');
}

void TextWords::CheckComma()
{
  if (this->IsDecimalComma())
  {
    this->Reject("a comma between two digits, which must be a point if it is a decimal comma, and "
                 "have a blank beside it if not. Write the file again, with decimal points.");
  }
}

void TextWords::SkipComment()
{
  std::string comment;
  for (++this->Next; this->Next != this->End || this->Refill(); ++this->Next)
  {
    if (*this->Next == '\n')
    {
      break;
    }
    if (comment.size() < longestWord)
    {
      comment += *this->Next;
    }
  }
  const std::size_t first = comment.find_first_not_of(" \t\r");
  if (first != std::string::npos && this->Notes.size() < mostComments)
  {
    this->Notes.push_back(comment.substr(first, comment.find_last_not_of(" \t\r") + 1 - first));
  }
}

bool TextWords::SkipToWord()
{
  while (this->Next != this->End || this->Refill())
  {
    if (*this->Next == '#')
    {
      this->SkipComment();
    }
    else if (IsBlank(*this->Next))
    {
      this->Line += *this->Next == '\n' ? 1 : 0;
      if (*this->Next == ',')
      {
        this->CheckComma();
      }
      ++this->Next;
    }
    else
    {
      return true;
    }
  }
  return false;
}

std::string_view TextWords::Word()
{
  if (!this->SkipToWord())
  {
    return {};
  }
  if (static_cast<std::size_t>(this->End - this->Next) < longestWord + 2)
  {
    this->Refill();
  }
  const char* const last = std::min(this->End, this->Next + longestWord + 1);
  if (*this->Next == '"')
  {
    const char* const close = std::find(this->Next + 1, last, '"');
    if (close == last)
    {
      this->Reject("a quoted text is not terminated. Fetch or write the file again.");
    }
    this->Quoted.assign(this->Next + 1, close);
    this->Line += std::count(this->Next, close, '\n');
    this->Next = close + 1;
    return this->Quoted.empty() ? std::string_view("\"\"") : std::string_view(this->Quoted);
  }
  const char* const begin = this->Next;
  const char* const end = std::find_if(begin, last, [](char c) { return IsBlank(c); });
  if (end == begin + longestWord + 1)
  {
    this->Reject("a word of more than 1024 characters: this is not a text of words and numbers.");
  }
  this->Next = end;
  return { begin, static_cast<std::size_t>(end - begin) };
}

std::string_view TextWords::RequireWord(const char* what)
{
  const std::string_view word = this->Word();
  if (word.empty())
  {
    this->RejectEnd(what);
  }
  return word;
}

std::int64_t TextWords::Whole(const char* what)
{
  const std::string_view word = this->RequireWord(what);
  std::int64_t value = 0;
  if (!FromText(word, value))
  {
    this->Reject(std::string(what) + " should be an integer, but is '" + std::string(word) + "'.");
  }
  return value;
}

double TextWords::Number(const char* what)
{
  return this->SlowNumber<double>(what);
}

template <typename T>
T TextWords::SlowNumber(const char* what)
{
  const std::string_view word = this->RequireWord(what);
  const char* const end = word.data() + word.size();
  T value{};
  const auto result = std::from_chars(SkipPlus(word.data(), end), end, value);
  if (result.ec == std::errc::result_out_of_range && result.ptr == end)
  {
    // Numbers that are too small are zero, as for strtod; those that are too large have no value.
    if (word.find("e-") != word.npos || word.find("E-") != word.npos)
    {
      return T(0);
    }
    this->Reject(std::string(word) + " is too large a number for " + what + ".");
  }
  if (result.ec != std::errc() || result.ptr != end)
  {
    this->Reject(std::string(what) + " should be a number, but is '" + std::string(word) + "'.");
  }
  return value;
}

template <typename T>
void TextWords::Numbers(T* values, std::int64_t count)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (!this->SkipToWord())
    {
      this->SlowNumber<T>("the last of its values"); // throws
    }
    if (static_cast<std::size_t>(this->End - this->Next) < longestWord)
    {
      this->Refill();
    }
    // from_chars, since strtod follows the locale; unusual numbers take the slow path, which
    // reports errors.
    const auto result = std::from_chars(SkipPlus(this->Next, this->End), this->End, values[i]);
    if (result.ec == std::errc() && (result.ptr == this->End || IsBlank(*result.ptr)))
    {
      this->Next = result.ptr;
    }
    else
    {
      values[i] = this->SlowNumber<T>("a value");
    }
  }
}

template void TextWords::Numbers(float*, std::int64_t);
template void TextWords::Numbers(double*, std::int64_t);

std::string TextWords::RestOfLine()
{
  std::string rest;
  bool comment = false;
  for (; this->Next != this->End || this->Refill(); ++this->Next)
  {
    if (*this->Next == '\n')
    {
      ++this->Line;
      ++this->Next;
      break;
    }
    comment = comment || *this->Next == '#';
    if (!comment && *this->Next == ',')
    {
      this->CheckComma();
    }
    if (!comment && rest.size() < longestWord)
    {
      rest += IsBlank(*this->Next) ? ' ' : *this->Next;
    }
  }
  return rest;
}

void TextWords::EndLine()
{
  while (this->Next != this->End || this->Refill())
  {
    const char c = *this->Next;
    if (!IsBlank(c))
    {
      this->Reject("raw bytes should begin on a line of their own.");
    }
    ++this->Next;
    if (c == '\n')
    {
      ++this->Line;
      return;
    }
  }
}

void TextWords::Bytes(unsigned char* to, std::size_t count)
{
  if (this->Source.ChangesLineEnds())
  {
    this->Reject("raw bytes follow in a file whose line ends were changed to carriage returns, "
                 "and the bytes with them. Fetch or write it again.");
  }
  while (count > 0)
  {
    if (this->Next == this->End && !this->Refill())
    {
      throw ReaderError(ReaderFailure::Truncated,
        this->Source.Path() + ": the file ends " + std::to_string(count) +
          " bytes before the last of its values. Fetch or write it again.");
    }
    const std::size_t part = std::min(count, static_cast<std::size_t>(this->End - this->Next));
    std::memcpy(to, this->Next, part);
    this->Next += part;
    to += part;
    count -= part;
  }
}

}
