#include "Molecules/BinaryCIF.h"

#include "Core/PrintableText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace isthmus
{
namespace
{

using Json = nlohmann::json;

[[noreturn]] void Refuse(const std::string& why)
{
  throw std::invalid_argument(why);
}

/// A column while it is decoded: whole numbers, others or texts.
struct Values
{
  enum class Kind
  {
    Integers,
    Reals,
    Singles, ///< reals of single precision
    Texts
  };

  Kind Is = Kind::Integers;
  std::vector<std::int64_t> Integers;
  std::vector<double> Reals;
  std::vector<std::string> Texts;

  std::size_t Size() const
  {
    return this->Is == Kind::Integers ? this->Integers.size()
      : this->Is == Kind::Texts       ? this->Texts.size()
                                      : this->Reals.size();
  }
};

/// Bytes of a value, and types as the specification numbers them.
enum ByteArrayType
{
  Int8 = 1,
  Int16 = 2,
  Int32 = 3,
  Uint8 = 4,
  Uint16 = 5,
  Uint32 = 6,
  Float32 = 32,
  Float64 = 33
};

template <typename Number>
std::vector<Number> ReadNumbers(const std::vector<std::uint8_t>& bytes)
{
  if (bytes.size() % sizeof(Number) != 0)
  {
    Refuse("its bytes are no whole number of values");
  }
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty())
  {
    std::memcpy(numbers.data(), bytes.data(), bytes.size()); // both are little-endian
  }
  return numbers;
}

template <typename Number>
Values Integers(const std::vector<std::uint8_t>& bytes)
{
  const std::vector<Number> numbers = ReadNumbers<Number>(bytes);
  Values values;
  values.Integers.assign(numbers.begin(), numbers.end());
  return values;
}

template <typename Number>
Values Reals(const std::vector<std::uint8_t>& bytes, Values::Kind kind)
{
  const std::vector<Number> numbers = ReadNumbers<Number>(bytes);
  Values values;
  values.Is = kind;
  values.Reals.assign(numbers.begin(), numbers.end());
  return values;
}

Values DecodeBytes(const std::vector<std::uint8_t>& bytes, int type)
{
  switch (type)
  {
    case Int8:
      return Integers<std::int8_t>(bytes);
    case Int16:
      return Integers<std::int16_t>(bytes);
    case Int32:
      return Integers<std::int32_t>(bytes);
    case Uint8:
      return Integers<std::uint8_t>(bytes);
    case Uint16:
      return Integers<std::uint16_t>(bytes);
    case Uint32:
      return Integers<std::uint32_t>(bytes);
    case Float32:
      return Reals<float>(bytes, Values::Kind::Singles);
    case Float64:
      return Reals<double>(bytes, Values::Kind::Reals);
    default:
      Refuse("there is no ByteArray of type " + std::to_string(type));
  }
}

/// Decodes the columns of one file, which may not have more values than the file has bytes.
class ColumnDecoder
{
public:
  explicit ColumnDecoder(std::size_t bytesOfFile)
    : Most(std::max(bytesOfFile, std::size_t{ 1 } << 16))
  {
  }

  /// `encoded` has the keys encoding and data.
  Values Decode(const Json& encoded) const
  {
    return this->Decode(encoded.at("data"), encoded.at("encoding"));
  }

private:
  /// The last encoding was applied last.
  Values Decode(const Json& data, const Json& encodings) const
  {
    if (!data.is_binary())
    {
      Refuse("its data are not binary");
    }
    if (!encodings.is_array() || encodings.empty())
    {
      Refuse("it has no encoding");
    }
    const std::vector<std::uint8_t>& bytes = data.get_binary();
    Values values;
    for (std::size_t i = encodings.size(); i-- > 0;)
    {
      const Json& encoding = encodings[i];
      const std::string kind = encoding.at("kind").get<std::string>();
      const bool isFirst = i + 1 == encodings.size();
      if (isFirst != (kind == "ByteArray" || (isFirst && kind == "StringArray")))
      {
        Refuse("the encoding " + kind + " is not where it can be");
      }
      values = isFirst ? (kind == "ByteArray" ? DecodeBytes(bytes, encoding.at("type").get<int>())
                                              : this->DecodeTexts(data, encoding))
                       : this->DecodeStep(std::move(values), kind, encoding);
    }
    return values;
  }

  Values DecodeStep(Values values, const std::string& kind, const Json& encoding) const
  {
    if (values.Is != Values::Kind::Integers)
    {
      Refuse("the encoding " + kind + " is not of whole numbers");
    }
    if (kind == "FixedPoint")
    {
      return FixedPoint(values, encoding);
    }
    if (kind == "IntervalQuantization")
    {
      return IntervalQuantization(values, encoding);
    }
    if (kind == "RunLength")
    {
      return this->RunLength(values, encoding);
    }
    if (kind == "Delta")
    {
      return Delta(std::move(values), encoding);
    }
    if (kind == "IntegerPacking")
    {
      return IntegerPacking(values, encoding);
    }
    Refuse("there is no encoding " + Printable(kind.substr(0, 40)));
  }

  static Values FixedPoint(const Values& values, const Json& encoding)
  {
    const double factor = encoding.at("factor").get<double>();
    if (!(std::abs(factor) > 0.0))
    {
      Refuse("the factor of FixedPoint is 0");
    }
    Values decoded;
    decoded.Is = Values::Kind::Reals;
    for (const std::int64_t value : values.Integers)
    {
      decoded.Reals.push_back(static_cast<double>(value) / factor);
    }
    return decoded;
  }

  static Values IntervalQuantization(const Values& values, const Json& encoding)
  {
    const double low = encoding.at("min").get<double>();
    const double high = encoding.at("max").get<double>();
    const double steps = encoding.at("numSteps").get<double>();
    if (!(steps > 1.0))
    {
      Refuse("IntervalQuantization needs two steps or more");
    }
    Values decoded;
    decoded.Is = Values::Kind::Reals;
    for (const std::int64_t value : values.Integers)
    {
      decoded.Reals.push_back(low + static_cast<double>(value) * (high - low) / (steps - 1.0));
    }
    return decoded;
  }

  Values RunLength(const Values& values, const Json& encoding) const
  {
    const auto size = encoding.at("srcSize").get<std::size_t>();
    if (values.Integers.size() % 2 != 0 || size > this->Most)
    {
      Refuse("its runs are damaged");
    }
    Values decoded;
    decoded.Integers.reserve(size);
    for (std::size_t i = 0; i < values.Integers.size(); i += 2)
    {
      const std::int64_t count = values.Integers[i + 1];
      if (count < 0 || static_cast<std::size_t>(count) > size - decoded.Integers.size())
      {
        Refuse("its runs are longer than it says");
      }
      decoded.Integers.insert(
        decoded.Integers.end(), static_cast<std::size_t>(count), values.Integers[i]);
    }
    if (decoded.Integers.size() != size)
    {
      Refuse("its runs are shorter than it says");
    }
    return decoded;
  }

  static Values Delta(Values values, const Json& encoding)
  {
    std::uint64_t sum = static_cast<std::uint64_t>(encoding.at("origin").get<std::int64_t>());
    for (std::int64_t& value : values.Integers)
    {
      sum += static_cast<std::uint64_t>(value); // without overflow of signed numbers
      value = static_cast<std::int64_t>(sum);
    }
    return values;
  }

  static Values IntegerPacking(const Values& values, const Json& encoding)
  {
    const int bytes = encoding.at("byteCount").get<int>();
    const bool isUnsigned = encoding.at("isUnsigned").get<bool>();
    const auto size = encoding.at("srcSize").get<std::size_t>();
    if (bytes != 1 && bytes != 2)
    {
      Refuse("IntegerPacking has 1 or 2 bytes");
    }
    const std::int64_t upper =
      isUnsigned ? (bytes == 1 ? 0xff : 0xffff) : (bytes == 1 ? 0x7f : 0x7fff);
    const std::int64_t lower = isUnsigned ? std::numeric_limits<std::int64_t>::min() : -upper - 1;
    Values decoded;
    std::int64_t sum = 0;
    bool isOpen = false;
    for (const std::int64_t value : values.Integers)
    {
      sum += value;
      isOpen = value == upper || value == lower;
      if (!isOpen)
      {
        decoded.Integers.push_back(std::exchange(sum, 0));
      }
    }
    if (isOpen || decoded.Integers.size() != size)
    {
      Refuse("its packed numbers are not as many as it says");
    }
    return decoded;
  }

  Values DecodeTexts(const Json& data, const Json& encoding) const
  {
    const auto all = encoding.at("stringData").get<std::string>();
    const Values offsets = this->Decode(encoding.at("offsets"), encoding.at("offsetEncoding"));
    const Values places = this->Decode(data, encoding.at("dataEncoding"));
    if (offsets.Is != Values::Kind::Integers || places.Is != Values::Kind::Integers)
    {
      Refuse("the places of its texts are no whole numbers");
    }
    for (std::size_t i = 0; i < offsets.Integers.size(); ++i)
    {
      const std::int64_t before = i > 0 ? offsets.Integers[i - 1] : 0;
      if (offsets.Integers[i] < before ||
        static_cast<std::uint64_t>(offsets.Integers[i]) > all.size())
      {
        Refuse("the places of its texts are damaged");
      }
    }
    Values decoded;
    decoded.Is = Values::Kind::Texts;
    decoded.Texts.reserve(places.Integers.size());
    for (const std::int64_t place : places.Integers)
    {
      const auto next = static_cast<std::size_t>(place + 1);
      if (place < -1 || (place >= 0 && next >= offsets.Integers.size()))
      {
        Refuse("it has a text that does not exist");
      }
      decoded.Texts.push_back(place < 0
          ? std::string()
          : all.substr(static_cast<std::size_t>(offsets.Integers[next - 1]),
              static_cast<std::size_t>(offsets.Integers[next] - offsets.Integers[next - 1])));
    }
    return decoded;
  }

  std::size_t Most;
};

/// The shortest text that is the same number.
template <typename Number>
std::string ShortestText(Number number)
{
  std::array<char, 40> text;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), result.ptr);
}

/// The value at `row` in the words of CIF.
std::string WordOf(const Values& values, std::size_t row)
{
  switch (values.Is)
  {
    case Values::Kind::Integers:
      return std::to_string(values.Integers[row]);
    case Values::Kind::Singles:
      return ShortestText(static_cast<float>(values.Reals[row]));
    case Values::Kind::Reals:
      return ShortestText(values.Reals[row]);
    default:
      return gemmi::cif::quote(values.Texts[row]);
  }
}

/// The words of a column; masked values are . and ?.
std::vector<std::string> ReadColumn(
  const Json& column, std::size_t rows, const ColumnDecoder& decoder)
{
  const Values values = decoder.Decode(column.at("data"));
  Values mask;
  const bool hasMask = column.contains("mask") && !column.at("mask").is_null();
  if (hasMask)
  {
    mask = decoder.Decode(column.at("mask"));
  }
  if (values.Size() != rows ||
    (hasMask && (mask.Is != Values::Kind::Integers || mask.Integers.size() != rows)))
  {
    Refuse("it has not as many values as the category has rows");
  }
  std::vector<std::string> words(rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const std::int64_t masked = hasMask ? mask.Integers[row] : 0;
    words[row] = masked == 0 ? WordOf(values, row) : masked == 1 ? "." : "?";
  }
  return words;
}

void ReadCategory(const Json& category, const std::string& name, const ColumnDecoder& decoder,
  gemmi::cif::Block& block)
{
  const auto rows = category.at("rowCount").get<std::size_t>();
  std::vector<std::string> tags;
  std::vector<std::vector<std::string>> columns;
  for (const Json& column : category.at("columns"))
  {
    const auto tag = column.at("name").get<std::string>();
    try
    {
      columns.push_back(ReadColumn(column, rows, decoder));
    }
    catch (const std::exception& error)
    {
      Refuse("column " + Printable(name + tag) + ": " + error.what());
    }
    tags.push_back(tag);
  }
  if (columns.empty() || rows == 0)
  {
    return;
  }
  gemmi::cif::Loop& loop = block.init_loop(name, tags);
  loop.values.reserve(rows * columns.size());
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::vector<std::string>& column : columns)
    {
      loop.values.push_back(std::move(column[row]));
    }
  }
}

}

bool IsBinaryCIF(std::string_view bytes)
{
  const auto first = static_cast<unsigned char>(bytes.empty() ? ' ' : bytes[0]);
  const bool isMap = (first >= 0x80 && first <= 0x8f) || first == 0xde || first == 0xdf;
  const std::string_view begin = bytes.substr(0, 1000);
  return isMap && begin.find("mmtf") == std::string_view::npos &&
    (begin.find("dataBlocks") != std::string_view::npos ||
      begin.find("encoder") != std::string_view::npos);
}

gemmi::cif::Document ReadBinaryCIF(
  std::string_view bytes, const std::function<bool(const std::string&)>& isWanted)
{
  try
  {
    const Json file = Json::from_msgpack(bytes.begin(), bytes.end());
    const ColumnDecoder decoder(bytes.size());
    gemmi::cif::Document document;
    for (const Json& from : file.at("dataBlocks"))
    {
      document.blocks.emplace_back(from.at("header").get<std::string>());
      for (const Json& category : from.at("categories"))
      {
        auto name = category.at("name").get<std::string>();
        name.insert(0, name.substr(0, 1) == "_" ? "" : "_");
        name += '.';
        if (isWanted(name))
        {
          ReadCategory(category, name, decoder, document.blocks.back());
        }
      }
    }
    return document;
  }
  catch (const Json::exception& error)
  {
    std::string reason = error.what(); // "[json.exception.parse_error.110] ..."
    const std::size_t end = reason.find("] ");
    Refuse("the file is damaged or truncated (" +
      Printable(end == std::string::npos ? reason : reason.substr(end + 2)) + "). Fetch it again");
  }
}

}
