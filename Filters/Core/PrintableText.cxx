#include "Core/PrintableText.h"

namespace isthmus
{
namespace
{

/// Number of bytes of the UTF-8 character that begins at `at`, 0 if there is none. Overlong forms,
/// surrogates and values beyond U+10FFFF are not valid.
std::size_t LengthOfCharacter(const std::string& text, std::size_t at)
{
  const auto byte = [&text](std::size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned int first = byte(at);
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc2 ? 2 : 0;
  if (length == 0 || first > 0xf4)
  {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xc0) != 0x80)
    {
      return 0;
    }
  }
  const unsigned int second = byte(at + 1);
  const bool wrong = (first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
    (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return wrong ? 0 : length;
}

}

std::string Printable(const std::string& text)
{
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = LengthOfCharacter(text, at);
    const auto first = static_cast<unsigned char>(text[at]);
    const bool control = length == 1 && (first < ' ' || first == 0x7f) && first != '\n';
    if (length == 0 || control)
    {
      result += '?';
      ++at;
      continue;
    }
    result.append(text, at, length);
    at += length;
  }
  return result;
}

}
