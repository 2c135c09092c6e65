#include "Maps/MRCHeaderWords.h"

#include "Maps/MRCMode.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace isthmus
{
namespace
{

template <typename Values, typename Test>
bool All(const Values& values, Test&& test)
{
  return std::all_of(values.begin(), values.end(), test);
}

}

MRCHeaderWords::MRCHeaderWords(const MRCHeaderBytes& bytes, bool bigEndian)
  : Bytes(bytes)
  , Big(bigEndian)
{
}

std::uint32_t MRCHeaderWords::Bits(std::size_t word) const
{
  const unsigned char* b = this->Bytes.data() + 4 * (word - 1);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    bits = (bits << 8) | b[this->Big ? i : 3 - i];
  }
  return bits;
}

std::int32_t MRCHeaderWords::Int(std::size_t word) const
{
  return static_cast<std::int32_t>(this->Bits(word));
}

double MRCHeaderWords::Float(std::size_t word) const
{
  const std::uint32_t bits = this->Bits(word);
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<double>(value);
}

std::array<int, 3> MRCHeaderWords::Ints(std::size_t word) const
{
  return { this->Int(word), this->Int(word + 1), this->Int(word + 2) };
}

std::array<double, 3> MRCHeaderWords::Floats(std::size_t word) const
{
  return { this->Float(word), this->Float(word + 1), this->Float(word + 2) };
}

std::string MRCHeaderWords::Text(std::size_t offset, std::size_t size) const
{
  std::string text(reinterpret_cast<const char*>(this->Bytes.data()) + offset, size);
  text.resize(std::min(text.size(), text.find('\0')));
  text.resize(text.find_last_not_of(' ') + 1); // npos + 1 is 0
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

bool MRCHeaderWords::Possible() const
{
  return IsKnownMRCMode(this->Int(4)) && All(this->Ints(1), [](int n) { return n > 0; });
}

int MRCHeaderWords::Plausibility(std::uint64_t contentBytes) const
{
  if (!this->Possible())
  {
    return 0;
  }
  const auto cellFits = [](double length)
  { return length == 0.0 || (std::abs(length) > 1e-6 && std::abs(length) < 1e6); };
  const std::array<int, 3> counts = this->Ints(1);
  return 1 + 2 * All(counts, [](int n) { return n < (1 << 17); }) +
    2 * IsAxisPermutation(this->Ints(17)) +
    2 * (MRCDataBytes(counts, this->Int(4)) <= contentBytes) +
    All(this->Ints(5), [](int start) { return std::abs(start / 2) < (1 << 20); }) +
    All(this->Ints(8), [](int m) { return m >= 0 && m < (1 << 20); }) +
    All(this->Floats(11), cellFits);
}

std::uint64_t MRCDataBytes(const std::array<int, 3>& counts, int mode)
{
  const MRCVoxelType voxel = VoxelTypeOfMRCMode(mode, false);
  std::uint64_t bytes = voxel.FileBytes(static_cast<std::uint64_t>(counts[0]));
  for (const int factor : { counts[1], counts[2] })
  {
    if (__builtin_mul_overflow(bytes, static_cast<std::uint64_t>(factor), &bytes))
    {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  return bytes;
}

std::optional<bool> ByteOrderOfMRCStamp(const MRCHeaderBytes& bytes)
{
  const unsigned char first = bytes[212];
  const unsigned char second = bytes[213];
  if (first == 0x44 && (second == 0x44 || second == 0x41))
  {
    return false;
  }
  if (first == 0x11 && second == 0x11)
  {
    return true;
  }
  return {};
}

MRCHeaderWords ChooseMRCByteOrder(const MRCHeaderBytes& bytes, std::uint64_t contentBytes)
{
  // A first byte alone is a hint, too: 44 00, 44 20 20 20 and the like are in circulation.
  const bool stated = ByteOrderOfMRCStamp(bytes).value_or(bytes[212] == 0x11);
  const MRCHeaderWords words(bytes, stated);
  const MRCHeaderWords swapped(bytes, !stated);
  return swapped.Plausibility(contentBytes) > words.Plausibility(contentBytes) ? swapped : words;
}

bool IsAxisPermutation(const std::array<int, 3>& order)
{
  std::array<int, 3> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  return sorted == std::array<int, 3>{ 1, 2, 3 };
}

}
