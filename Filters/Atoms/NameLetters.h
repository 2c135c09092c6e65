/**
 * @file NameLetters.h
 * @brief Letters of the names of atoms and residues, in ASCII regardless of the locale.
 */
#ifndef isthmus_NameLetters_h
#define isthmus_NameLetters_h

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace isthmus
{

constexpr bool IsLetter(char c)
{
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// The first run of letters of a name, without digits before it: "CA" of "1CA2".
inline std::string_view FirstLetters(std::string_view name)
{
  const auto first = std::find_if(name.begin(), name.end(), IsLetter);
  const auto last = std::find_if_not(first, name.end(), IsLetter);
  return name.substr(
    static_cast<std::size_t>(first - name.begin()), static_cast<std::size_t>(last - first));
}

inline std::string Capitals(std::string_view text)
{
  std::string capitals(text);
  for (char& c : capitals)
  {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  return capitals;
}

}

#endif
