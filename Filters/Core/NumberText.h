/**
 * @file NumberText.h
 * @brief Numbers as text, and text as numbers, with a '.' in every locale and no separators.
 *
 * printf, strtod, std::to_string(double) and streams follow the locale of the program, which a
 * host may set: with de_DE they write and read "1,5". Use these functions instead.
 */
#ifndef isthmus_NumberText_h
#define isthmus_NumberText_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <cctype>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace isthmus
{

/// A number formatted for messages, with at most `digits` significant digits (six by default); NaN
/// is written in words.
VTKISTHMUSFILTERSCORE_EXPORT std::string FormatNumber(double value, int digits = 6);

/// A number with this many digits after the decimal point and no exponent.
VTKISTHMUSFILTERSCORE_EXPORT std::string FixedNumber(double value, int decimals);

/// "-80.94 kcal/mol, to within about 0.07": two digits of the error if the first is 1, else one,
/// and as many decimals of the value.
VTKISTHMUSFILTERSCORE_EXPORT std::string FormatWithError(
  double value, double error, const std::string& unit);

/// `text` padded with blanks in front of it (or behind it) to `width` characters, as the columns
/// of a file need it.
VTKISTHMUSFILTERSCORE_EXPORT std::string RightAligned(std::string text, std::size_t width);
VTKISTHMUSFILTERSCORE_EXPORT std::string LeftAligned(std::string text, std::size_t width);

/// Concatenates the parts: text, integers and numbers (written by FormatNumber).
template <typename... Parts>
std::string JoinText(const Parts&... parts)
{
  std::string text;
  const auto add = [&text](const auto& part)
  {
    using Part = std::decay_t<decltype(part)>;
    if constexpr (std::is_floating_point_v<Part>)
    {
      text += FormatNumber(static_cast<double>(part));
    }
    else if constexpr (std::is_integral_v<Part> && !std::is_same_v<Part, char>)
    {
      text += std::to_string(part);
    }
    else
    {
      text += part;
    }
  };
  (add(parts), ...);
  return text;
}

/// Reads the number at the beginning of `text`, after white space, and removes both from it.
/// Returns false and changes nothing if there is none. The number may begin with a plus sign.
template <typename T>
bool ExtractNumber(std::string_view& text, T& value)
{
  std::size_t begin = 0;
  while (begin < text.size() && std::isspace(static_cast<unsigned char>(text[begin])))
  {
    ++begin;
  }
  if (begin + 1 < text.size() && text[begin] == '+' && text[begin + 1] != '-')
  {
    ++begin;
  }
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + begin, end, value);
  if (error != std::errc())
  {
    return false;
  }
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  return true;
}

/// Returns the next word of `text`, after white space, and removes both from it. Empty at the end.
VTKISTHMUSFILTERSCORE_EXPORT std::string_view ExtractWord(std::string_view& text);

}

#endif
