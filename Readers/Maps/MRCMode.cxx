#include "Maps/MRCMode.h"

#include <cstring>

namespace isthmus
{
namespace
{

/// IEEE 754 half to single precision. Written without branches, so that the loop is vectorised.
float FloatOfHalf(std::uint16_t half)
{
  const std::uint32_t magnitude = static_cast<std::uint32_t>(half & 0x7fffu) << 13;
  float value = 0;
  std::memcpy(&value, &magnitude, sizeof(value));
  value *= 0x1p112f; // the difference of the exponents' biases; right for subnormals too
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  bits |= magnitude >= 0x0f800000u ? 0x7f800000u : 0u; // infinity and NaN
  bits |= static_cast<std::uint32_t>(half & 0x8000u) << 16;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

void DecodeHalves(const unsigned char* from, float* to, std::size_t voxels)
{
  for (std::size_t i = 0; i < voxels; ++i)
  {
    std::uint16_t half = 0;
    std::memcpy(&half, from + 2 * i, sizeof(half));
    to[i] = FloatOfHalf(half);
  }
}

void DecodeNibbles(
  const unsigned char* from, unsigned char* to, std::size_t voxels, std::size_t skip)
{
  if (skip > 0 && voxels > 0)
  {
    *to++ = static_cast<unsigned char>(*from++ >> 4);
    --voxels;
  }
  for (std::size_t pair = 0; pair < voxels / 2; ++pair)
  {
    to[2 * pair] = static_cast<unsigned char>(from[pair] & 0xf);
    to[2 * pair + 1] = static_cast<unsigned char>(from[pair] >> 4);
  }
  if (voxels % 2 > 0)
  {
    to[voxels - 1] = static_cast<unsigned char>(from[voxels / 2] & 0xf);
  }
}

std::uint16_t Swapped(std::uint16_t word)
{
  return static_cast<std::uint16_t>((word >> 8) | (word << 8));
}

std::uint32_t Swapped(std::uint32_t word)
{
  return (word >> 24) | ((word >> 8) & 0xff00u) | ((word << 8) & 0xff0000u) | (word << 24);
}

/// Reverses the bytes of each word. vtkByteSwap does it at 0.5 GB/s, this at memory speed.
template <typename Word>
void SwapWords(unsigned char* bytes, std::size_t words)
{
  for (std::size_t i = 0; i < words; ++i)
  {
    Word word = 0;
    std::memcpy(&word, bytes + i * sizeof(Word), sizeof(Word));
    word = Swapped(word);
    std::memcpy(bytes + i * sizeof(Word), &word, sizeof(Word));
  }
}

}

bool IsKnownMRCMode(int mode)
{
  return (mode >= 0 && mode <= 4) || mode == 6 || mode == 12 || mode == 16 || mode == 101;
}

MRCVoxelType VoxelTypeOfMRCMode(int mode, bool unsignedBytes)
{
  switch (mode)
  {
    case 0:
      return { mode, unsignedBytes ? MRCValue::UnsignedChar : MRCValue::SignedChar, 1, 8, 1, 1 };
    case 1:
      return { mode, MRCValue::Short, 1, 16, 2, 2 };
    case 3:
      return { mode, MRCValue::Short, 2, 32, 2, 4 };
    case 4:
      return { mode, MRCValue::Float, 2, 64, 4, 8 };
    case 6:
      return { mode, MRCValue::UnsignedShort, 1, 16, 2, 2 };
    case 12:
      return { mode, MRCValue::Float, 1, 16, 2, 4 };
    case 16:
      return { mode, MRCValue::UnsignedChar, 3, 24, 1, 3 };
    case 101:
      return { mode, MRCValue::UnsignedChar, 1, 4, 1, 1 };
    default:
      return { mode, MRCValue::Float, 1, 32, 4, 4 };
  }
}

void DecodeMRCVoxels(const MRCVoxelType& type, bool swap, unsigned char* from, void* to,
  std::size_t voxels, std::size_t skip)
{
  if (type.FileBits == 4)
  {
    DecodeNibbles(from, static_cast<unsigned char*>(to), voxels, skip);
    return;
  }
  const std::size_t bytes = static_cast<std::size_t>(type.FileBytes(voxels));
  if (swap && type.Word == 2)
  {
    SwapWords<std::uint16_t>(from, bytes / 2);
  }
  else if (swap && type.Word == 4)
  {
    SwapWords<std::uint32_t>(from, bytes / 4);
  }
  if (type.Mode == 12)
  {
    DecodeHalves(from, static_cast<float*>(to), voxels);
  }
  else if (from != to)
  {
    std::memcpy(to, from, bytes);
  }
}

}
