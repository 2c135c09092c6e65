/**
 * @file ParallelBzip2.h
 * @brief Decompresses the members of a bzip2 file block by block on all threads.
 *
 * Bzip2BlockFinder cuts the stream, libbz2 decompresses each block as a separate stream (and checks
 * its checksum), and the results are returned in order; the checksum of the member is verified at
 * its end. This is also the method of pbzip2 and lbzip2 (J. Gilchrist, Parallel data compression
 * with bzip2, PDCS 2004). The bytes are those of libbz2, for any number of threads. Any mismatch is
 * reported only as damage; libbz2 must find the cause, since a block boundary may have been
 * detected in the wrong place.
 *
 * Memory: 13 MB for each thread, i.e. twice the 3.7 MB of libbz2, the compressed bytes of a block
 * and the first MiB of its content. The rest of a block (runs of one value, at most 46 MB) is
 * decompressed when it is returned.
 */
#ifndef isthmus_ParallelBzip2_h
#define isthmus_ParallelBzip2_h

#include "Files/Codecs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

namespace isthmus
{

/// A block as a separate stream or, if the stream is empty, the end of a member.
struct Bzip2Block
{
  std::vector<unsigned char> Stream;
  std::uint64_t DataBits = 0; ///< of Stream, up to the end marker that was added after the block
  std::uint32_t Checksum = 0; ///< of the block, or of all of the member
};

/**
 * Cuts a bzip2 stream into blocks that can be decompressed independently.
 *
 * A member is "BZh" and a digit, blocks, and an end; a block begins with 0x314159265359 and the
 * checksum of its content, the end is 0x177245385090 and the checksum of all blocks', padded to a
 * byte. Blocks may begin at any bit. These 48 bits may also occur in the data of a block (with a
 * probability of 1 in 2.8e14 for each bit): libbz2 must validate the pieces.
 *
 * Time: O(bytes). Memory: one block, 4 MB at most.
 */
class Bzip2BlockFinder
{
public:
  enum class Found
  {
    Nothing, ///< the input is used up
    Block,
    MemberEnd, ///< the input is moved to the byte after the member, where another may begin
    Foreign    ///< no bzip2
  };

  /// Advances the input to the end of the next item, which is stored in `block`.
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

class ParallelBzip2
{
public:
  static constexpr const char* Name = Bzip2Codec::Name;
  static std::uint64_t MaximumBytes(std::uint64_t size) { return Bzip2Codec::MaximumBytes(size); }
  static bool StartsMember(const unsigned char* bytes, std::size_t size)
  {
    return Bzip2Codec::StartsMember(bytes, size);
  }

  ParallelBzip2();
  ~ParallelBzip2();
  ParallelBzip2(const ParallelBzip2&) = delete;
  ParallelBzip2& operator=(const ParallelBzip2&) = delete;

  /// Copies that may be kept of one file; each has up to two compressed blocks.
  static constexpr std::size_t MostCopies = 32;

  /// The decoder in its present state, to continue from here again; null while blocks that were
  /// decompressed wait to be returned, or more than one waits to be decompressed.
  std::unique_ptr<ParallelBzip2> Copy() const;

  /// Like that of Bzip2Codec, but continues with members that follow immediately; without input (at
  /// the end of the file) it returns the remaining data.
  CodecState Step(
    unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize);

private:
  class DecodedBlock;

  void Gather(unsigned char*& in, std::size_t& inSize);
  void UnpackAll();
  bool CopyOutput(unsigned char*& out, std::size_t& outSize);

  Bzip2BlockFinder Finder;
  std::vector<Bzip2Block> Waiting;
  std::size_t WaitingBlocks = 0; ///< the rest of them are ends of members
  std::deque<std::unique_ptr<DecodedBlock>> Ready;
  std::size_t AtOnce = 1;
  std::uint32_t Checksum = 0; ///< of the member so far
  bool Ended = false;
  bool Foreign = false;
};

}

#endif
