/**
 * @file Bzip2Codec.h
 * @brief One member of a bzip2 file, unpacked step by step by libbz2.
 *
 * Memory: 3.7 MB at most, as libbz2 says.
 */
#ifndef isthmus_Bzip2Codec_h
#define isthmus_Bzip2Codec_h

#include "Files/CodecState.h"

#include <bzlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

namespace isthmus
{

/// @throws std::bad_alloc where libbz2 has no memory.
class Bzip2Codec
{
public:
  static constexpr const char* Name = "bzip2";
  // A block of 45 bytes can hold 46 MB of one value: no bound worth the name.
  static std::uint64_t MostBytes(std::uint64_t) { return std::numeric_limits<std::int64_t>::max(); }
  static bool StartsMember(const unsigned char* bytes, std::size_t size)
  {
    return size >= 3 && bytes[0] == 'B' && bytes[1] == 'Z' && bytes[2] == 'h';
  }

  Bzip2Codec()
  {
    if (BZ2_bzDecompressInit(&this->Stream, 0, 0) != BZ_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~Bzip2Codec() { BZ2_bzDecompressEnd(&this->Stream); }
  Bzip2Codec(const Bzip2Codec&) = delete;
  Bzip2Codec& operator=(const Bzip2Codec&) = delete;

  /// Unpacks from `in` to `out`, both of which it moves on, until one of them is used up.
  CodecState Step(
    unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize)
  {
    constexpr std::size_t mostAtOnce = std::size_t{ 1 } << 30; // it counts in 32 bits
    this->Stream.next_in = reinterpret_cast<char*>(in);
    this->Stream.avail_in = static_cast<unsigned int>(std::min(inSize, mostAtOnce));
    this->Stream.next_out = reinterpret_cast<char*>(out);
    this->Stream.avail_out = static_cast<unsigned int>(std::min(outSize, mostAtOnce));
    const int state = BZ2_bzDecompress(&this->Stream);
    auto* const used = reinterpret_cast<unsigned char*>(this->Stream.next_in);
    auto* const written = reinterpret_cast<unsigned char*>(this->Stream.next_out);
    inSize -= static_cast<std::size_t>(used - in);
    outSize -= static_cast<std::size_t>(written - out);
    in = used;
    out = written;
    return state == BZ_STREAM_END ? CodecState::MemberEnd
                                  : (state == BZ_OK ? CodecState::Running : CodecState::Damaged);
  }

private:
  bz_stream Stream{};
};

}

#endif
