/**
 * @file MRCTestFile.h
 * @brief Writes map files of any mode, byte order and axis order, for the tests.
 *
 * It shares no code with the reader: it follows only the format's tables.
 */
#ifndef isthmus_MRCTestFile_h
#define isthmus_MRCTestFile_h

#include "TemporaryFile.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

namespace isthmus::testing
{

/// A map to be written: a header with valid words, which tests overwrite, and its voxels.
class MRCTestFile
{
public:
  MRCTestFile(std::array<int, 3> counts, int mode, bool bigEndian = false)
    : Counts(counts)
    , Mode(mode)
    , BigEndian(bigEndian)
    , Content(1024, '\0')
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->SetInt(1 + i, counts[i]);
      this->SetInt(8 + i, counts[i]);
      this->SetFloat(11 + i, static_cast<float>(counts[i]));
      this->SetFloat(14 + i, 90.0f);
      this->SetInt(17 + i, static_cast<int>(i) + 1);
    }
    this->SetInt(4, mode);
    this->SetInt(23, 1);
    this->SetText(208, "MAP ");
    this->SetText(212, bigEndian ? std::string("\x11\x11\0\0", 4) : std::string("DD\0\0", 4));
  }

  void SetInt(std::size_t word, std::int32_t value) { this->Put(4 * (word - 1), &value, 4); }
  void SetFloat(std::size_t word, float value) { this->Put(4 * (word - 1), &value, 4); }
  void SetInts(std::size_t word, std::array<int, 3> values)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->SetInt(word + i, values[i]);
    }
  }
  void SetFloats(std::size_t word, std::array<float, 3> values)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->SetFloat(word + i, values[i]);
    }
  }
  void SetText(std::size_t offset, const std::string& text)
  {
    this->Content.replace(offset, text.size(), text);
  }

  /// Adds an extended header; call it before the voxels.
  void AddExtendedHeader(std::size_t bytes)
  {
    this->SetInt(24, static_cast<int>(bytes));
    this->Content.append(bytes, 'X');
  }

  /// Adds all voxels: `value(column, row, section, component)`, integers for integer modes.
  template <typename Value>
  void AddVoxels(Value&& value)
  {
    for (int s = 0; s < this->Counts[2]; ++s)
    {
      for (int r = 0; r < this->Counts[1]; ++r)
      {
        const std::size_t rowStart = this->Content.size();
        for (int c = 0; c < this->Counts[0]; ++c)
        {
          for (int k = 0; k < this->Components(); ++k)
          {
            this->AddValue(value(c, r, s, k), c, rowStart);
          }
        }
      }
    }
  }

  int Components() const
  {
    return this->Mode == 16 ? 3 : (this->Mode == 3 || this->Mode == 4 ? 2 : 1);
  }

  const std::string& Bytes() const { return this->Content; }

private:
  void Put(std::size_t offset, const void* value, std::size_t size)
  {
    char bytes[8];
    std::memcpy(bytes, value, size);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->Content[offset + i] = bytes[this->BigEndian ? size - 1 - i : i];
    }
  }

  template <typename T>
  void Append(T value)
  {
    this->Content.append(sizeof(T), '\0');
    this->Put(this->Content.size() - sizeof(T), &value, sizeof(T));
  }

  void AddValue(double value, int column, std::size_t rowStart)
  {
    switch (this->Mode)
    {
      case 1:
      case 3:
        return this->Append(static_cast<std::int16_t>(value));
      case 2:
      case 4:
        return this->Append(static_cast<float>(value));
      case 6:
        return this->Append(static_cast<std::uint16_t>(value));
      case 12:
        return this->Append(Half(value));
      case 101:
        return this->AddNibble(static_cast<unsigned>(value), column, rowStart);
      default: // 0 signed or not, 16
        return this->Append(static_cast<std::uint8_t>(static_cast<std::int16_t>(value) & 0xff));
    }
  }

  void AddNibble(unsigned value, int column, std::size_t rowStart)
  {
    if (column % 2 == 0)
    {
      this->Content.push_back(static_cast<char>(value));
      return;
    }
    char& byte = this->Content[rowStart + static_cast<std::size_t>(column / 2)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) | (value << 4));
  }

  /// Half precision of a value that has an exact one (normal or zero).
  static std::uint16_t Half(double value)
  {
    if (value == 0.0)
    {
      return 0;
    }
    int exponent = 0;
    const double mantissa = std::frexp(std::abs(value), &exponent); // in [0.5, 1)
    const auto fraction = static_cast<unsigned>((mantissa * 2.0 - 1.0) * 1024.0);
    return static_cast<std::uint16_t>(
      (value < 0 ? 0x8000u : 0u) | (static_cast<unsigned>(exponent + 14) << 10) | fraction);
  }

  std::array<int, 3> Counts;
  int Mode;
  bool BigEndian;
  std::string Content;
};

}

#endif
