/**
 * @file Bzip2BlockFinder.h
 * @brief Cuts a bzip2 stream into blocks that can be unpacked each for itself.
 *
 * A member is "BZh" and a digit, blocks, and an end; a block begins with 0x314159265359 and the
 * checksum of its content, the end is 0x177245385090 and the checksum of all blocks', padded to a
 * byte. Blocks follow each other at any bit, so those 48 bits are looked for at every bit, by a
 * table of the bytes that can lie within them. They may turn up in a block's own data as well (in
 * one bit of 2.8e14): such a piece does not unpack, so what was cut must be judged by libbz2.
 *
 * Time: some 2 ns a byte. Memory: one block, 4 MB at most.
 */
#ifndef isthmus_Bzip2BlockFinder_h
#define isthmus_Bzip2BlockFinder_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A block as a stream of its own; or, without a stream, the end of a member.
struct Bzip2Block
{
  std::vector<unsigned char> Stream;
  std::uint64_t DataBits = 0; ///< of Stream, up to the end that was put behind the block
  std::uint32_t Checksum = 0; ///< of the block, or of all of the member
};

class Bzip2BlockFinder
{
public:
  enum class Found
  {
    Nothing, ///< the input is used up
    Block,
    MemberEnd, ///< the input is moved to the byte behind the member, where another may begin
    Foreign    ///< no bzip2
  };

  /// Moves the input on to the next thing found, which is then put into `block`.
  Found Take(unsigned char*& in, std::size_t& inSize, Bzip2Block& block);

private:
  enum class Stage
  {
    Header,
    Block,
    Checksum
  };

  Found TakeHeader();
  Found TakeBlockByte(Bzip2Block& block);
  Found TakeChecksum(Bzip2Block& block);
  void Cut(std::uint64_t end, Bzip2Block& block) const;
  std::uint32_t WordAt(std::uint64_t bit) const;

  Stage Now = Stage::Header;
  unsigned char Level = 0;
  std::vector<unsigned char> Bytes; ///< from the one where the header, block or end begins
  std::uint64_t FirstBit = 0;       ///< where it begins in the first of them
  std::uint64_t Window = 0;         ///< the last eight bytes
};

}

#endif
