/**
 * @file GzipCodec.h
 * @brief One member of a gzip file, unpacked step by step: by ISA-L where the build has it, else by
 * zlib.
 *
 * Both give the same bytes, and refuse those whose checksum is wrong. Of a file that breaks off
 * ISA-L leaves out up to three bytes that zlib still gives, and it forgives flags of a header that
 * mean nothing. ISA-L holds 90 kB of state, zlib 40 kB.
 */
#ifndef isthmus_GzipCodec_h
#define isthmus_GzipCodec_h

#include "Files/CodecState.h"

#ifdef ISTHMUS_HAS_ISAL
#include <isa-l/igzip_lib.h>
#endif
#include <vtk_zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>

namespace isthmus
{

/// @throws std::bad_alloc where zlib has no memory.
///
/// What both libraries share, down to the names in their streams. `Inflater` has its Stream, set
/// up, and Inflate().
template <typename Inflater>
class GzipCodecOf : private Inflater
{
public:
  static constexpr const char* Name = "gzip";
  static std::uint64_t MostBytes(std::uint64_t fileSize) { return 1032 * fileSize; }
  static bool StartsMember(const unsigned char* bytes, std::size_t size)
  {
    return size >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
  }

  /// Unpacks from `in` to `out`, both of which it moves on, until one of them is used up.
  /// @pre The first time, `in` has the member's whole header: ISA-L 2.30 takes one that comes in
  /// parts, and has a checksum of its own, for damaged.
  CodecState Step(
    unsigned char*& in, std::size_t& inSize, unsigned char*& out, std::size_t& outSize)
  {
    constexpr std::size_t mostAtOnce = std::size_t{ 1 } << 30; // both count in 32 bits
    this->Stream.next_in = in;
    this->Stream.avail_in = static_cast<std::uint32_t>(std::min(inSize, mostAtOnce));
    this->Stream.next_out = out;
    this->Stream.avail_out = static_cast<std::uint32_t>(std::min(outSize, mostAtOnce));
    const CodecState state = this->Inflate();
    inSize -= static_cast<std::size_t>(this->Stream.next_in - in);
    in = this->Stream.next_in;
    outSize -= static_cast<std::size_t>(this->Stream.next_out - out);
    out = this->Stream.next_out;
    return state;
  }
};

class ZlibInflater
{
protected:
  ZlibInflater()
  {
    if (inflateInit2(&this->Stream, 16 + MAX_WBITS) != Z_OK) // 16: a gzip wrapper, not zlib's own
    {
      throw std::bad_alloc();
    }
  }
  ~ZlibInflater() { inflateEnd(&this->Stream); }
  ZlibInflater(const ZlibInflater&) = delete;
  ZlibInflater& operator=(const ZlibInflater&) = delete;

  CodecState Inflate()
  {
    const int state = inflate(&this->Stream, Z_NO_FLUSH);
    return state == Z_STREAM_END
      ? CodecState::MemberEnd
      : (state == Z_OK || state == Z_BUF_ERROR ? CodecState::Running : CodecState::Damaged);
  }

  z_stream Stream{};
};

#ifdef ISTHMUS_HAS_ISAL

class IsalInflater
{
protected:
  IsalInflater()
  {
    isal_inflate_init(&this->Stream);
    this->Stream.crc_flag = ISAL_GZIP; // reads the header, compares the checksum
  }

  CodecState Inflate()
  {
    if (isal_inflate(&this->Stream) != ISAL_DECOMP_OK)
    {
      return CodecState::Damaged;
    }
    return this->Stream.block_state == ISAL_BLOCK_FINISH ? CodecState::MemberEnd
                                                         : CodecState::Running;
  }

  inflate_state Stream;
};

using GzipCodec = GzipCodecOf<IsalInflater>;

#else

using GzipCodec = GzipCodecOf<ZlibInflater>;

#endif

}

#endif
