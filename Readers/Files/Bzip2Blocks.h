/**
 * @file Bzip2Blocks.h
 * @brief Members of a bzip2 file, unpacked block by block on all threads.
 *
 * Bzip2BlockFinder cuts the stream, libbz2 unpacks each block as a stream of its own (and checks
 * its checksum), and the results are handed out in order; the checksum of the member is compared at
 * its end. As pbzip2 and lbzip2 do (J. Gilchrist, Parallel data compression with bzip2, PDCS 2004).
 * The bytes are those of libbz2, for any number of threads. What does not fit is only told as
 * damaged: libbz2 must say what it is, since a block may look cut where it is not.
 *
 * Memory: 13 MB a thread, twice libbz2's 3.7 MB, a block's packed bytes and the first MiB of its
 * content. What a block holds beyond that (runs of one value: 46 MB at most) is unpacked as it is
 * handed out. The first block comes alone, the next two together, and so on: whoever reads a header
 * waits for one.
 */
#ifndef isthmus_Bzip2Blocks_h
#define isthmus_Bzip2Blocks_h

#include "Files/Bzip2BlockFinder.h"
#include "Files/Bzip2Codec.h"
#include "Files/CodecState.h"

#include <deque>
#include <memory>
#include <vector>

namespace isthmus
{

class Bzip2Blocks
{
public:
  static constexpr const char* Name = Bzip2Codec::Name;
  static std::uint64_t MostBytes(std::uint64_t size) { return Bzip2Codec::MostBytes(size); }
  static bool StartsMember(const unsigned char* bytes, std::size_t size)
  {
    return Bzip2Codec::StartsMember(bytes, size);
  }

  Bzip2Blocks();
  ~Bzip2Blocks();
  Bzip2Blocks(const Bzip2Blocks&) = delete;
  Bzip2Blocks& operator=(const Bzip2Blocks&) = delete;

  /// As Bzip2Codec's, but goes on with members that follow at once; without input (the end of the
  /// file) it hands out what it has.
  CodecState Step(
    unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize);

private:
  class Unpacked;

  void Gather(unsigned char*& in, std::size_t& inSize);
  void UnpackAll();
  bool HandOut(unsigned char*& out, std::size_t& outSize);

  Bzip2BlockFinder Finder;
  std::vector<Bzip2Block> Waiting;
  std::size_t WaitingBlocks = 0; ///< the rest of them are ends of members
  std::deque<std::unique_ptr<Unpacked>> Ready;
  std::size_t AtOnce = 1;
  std::uint32_t Checksum = 0; ///< of the member so far
  bool Ended = false;
  bool Foreign = false;
};

}

#endif
