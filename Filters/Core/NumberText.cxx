#include "Core/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isthmus
{

std::string FormatNumber(double value, int digits)
{
  if (std::isnan(value))
  {
    return "not a number";
  }
  std::array<char, 64> text;
  const auto end = std::to_chars(
    text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return std::string(text.data(), end.ptr);
}

std::string FixedNumber(double value, int decimals)
{
  // Digits of the largest number, sign, point, decimals.
  std::string text(
    std::numeric_limits<double>::max_exponent10 + 4 + static_cast<std::size_t>(decimals), ' ');
  const auto end =
    std::to_chars(&text[0], &text[0] + text.size(), value, std::chars_format::fixed, decimals);
  text.resize(static_cast<std::size_t>(end.ptr - text.data()));
  return text;
}

std::string FormatWithError(double value, double error, const std::string& unit)
{
  constexpr int most = 12; // decimals, for an error of 0
  const int exponent =
    error > 0.0 && std::isfinite(error) ? static_cast<int>(std::floor(std::log10(error))) : -most;
  const bool one = error * std::pow(10.0, -exponent) < 1.95;
  const int place = one ? 1 - exponent : -exponent;
  const int decimals = std::clamp(place, 0, most);
  const double unitOfPlace = std::pow(10.0, -place);
  return FixedNumber(value, decimals) + " " + unit + ", to within about " +
    FixedNumber(error > 0.0 ? std::round(error / unitOfPlace) * unitOfPlace : 0.0,
      error > 0.0 ? decimals : 0);
}

std::string RightAligned(std::string text, std::size_t width)
{
  text.insert(0, width - std::min(width, text.size()), ' ');
  return text;
}

std::string LeftAligned(std::string text, std::size_t width)
{
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string_view ExtractWord(std::string_view& text)
{
  constexpr const char* blanks = " \t\n\v\f\r";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

}
