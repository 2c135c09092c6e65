/**
 * @file MRCHeaderWords.h
 * @brief The raw words of an MRC header, and which byte order makes sense of them.
 */
#ifndef isthmus_MRCHeaderWords_h
#define isthmus_MRCHeaderWords_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace isthmus
{

using MRCHeaderBytes = std::array<unsigned char, 1024>;

/// The words under one assumption on the byte order. Words count from 1, as in the format's tables.
class MRCHeaderWords
{
public:
  MRCHeaderWords(const MRCHeaderBytes& bytes, bool bigEndian);

  std::int32_t Int(std::size_t word) const;
  double Float(std::size_t word) const;
  std::array<int, 3> Ints(std::size_t word) const;
  std::array<double, 3> Floats(std::size_t word) const;
  /// `size` bytes from `offset`; blanks and zeros at the end left out, odd characters as '?'.
  std::string Text(std::size_t offset, std::size_t size) const;

  bool BigEndian() const { return this->Big; }
  bool HasMapWord() const { return this->Text(208, 3) == "MAP"; }
  /// Mode is known and the grid positive.
  bool Possible() const;
  /// How many things look as they should, 0 if not even Possible().
  int Plausibility(std::uint64_t contentBytes) const;

private:
  std::uint32_t Bits(std::size_t word) const;

  const MRCHeaderBytes& Bytes;
  bool Big;
};

/// Bytes that NX x NY x NZ voxels of a known mode take; the largest number when 64 bits overflow.
std::uint64_t MRCDataBytes(const std::array<int, 3>& counts, int mode);

/// Byte order that the machine stamp states (true: big endian), if the stamp is a valid one.
std::optional<bool> ByteOrderOfMRCStamp(const MRCHeaderBytes& bytes);

/// The words in the byte order that makes more sense; the stamp decides where both do.
MRCHeaderWords ChooseMRCByteOrder(const MRCHeaderBytes& bytes, std::uint64_t contentBytes);

/// True for 1, 2, 3 in any order.
bool IsAxisPermutation(const std::array<int, 3>& order);

}

#endif
