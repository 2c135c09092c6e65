/**
 * @file NumberTypes.h
 * @brief Lists of numbers of any type, and their names, text and bytes in files.
 */
#ifndef isthmus_NumberTypes_h
#define isthmus_NumberTypes_h

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace isthmus
{

/// A list of numbers of one of these types: int8 uint8 ... int64 uint64 float32 float64.
using NumberList =
  std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
    std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
    std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>, std::vector<double>>;

/// The names, in the order of the alternatives of NumberList.
inline constexpr std::array<std::string_view, 10> NumberTypeNames{ "int8", "uint8", "int16",
  "uint16", "int32", "uint32", "int64", "uint64", "float32", "float64" };

/// An empty list of the type with this index in NumberTypeNames.
template <std::size_t I = 0>
NumberList EmptyNumberList(std::size_t type)
{
  if constexpr (I + 1 < std::variant_size_v<NumberList>)
  {
    if (type != I)
    {
      return EmptyNumberList<I + 1>(type);
    }
  }
  return NumberList(std::in_place_index<I>);
}

/// Whether the whole text is one number of type T.
template <typename T>
bool FromText(std::string_view text, T& value)
{
  const char* end = text.data() + text.size();
  // from_chars takes inf and nan, too, and never looks at the locale.
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

/// The shortest text that FromText converts to the same value.
template <typename T>
std::string_view ToText(T value, std::array<char, 64>& buffer)
{
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return { buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data()) };
}

inline bool IsLittleEndian()
{
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

/// Converts the little-endian bytes of a file to the byte order of this machine, or back.
template <typename T>
void SwapToLittleEndian(T* values, std::size_t count)
{
  if (!IsLittleEndian() && sizeof(T) > 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      auto* bytes = reinterpret_cast<unsigned char*>(values + i);
      std::reverse(bytes, bytes + sizeof(T));
    }
  }
}

}

#endif
