/**
 * @file Codecs.h
 * @brief Decoders of one member of a gzip file (by ISA-L if available, otherwise zlib) or bzip2
 * file.
 */
#ifndef isthmus_Codecs_h
#define isthmus_Codecs_h

#ifdef ISTHMUS_HAS_ISAL
#include <isa-l/igzip_lib.h>
#endif
#include <bzlib.h>
#include <vtk_zlib.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>

namespace isthmus
{

/// State of a decoder after Step(), which advances its arguments past the bytes that it has read
/// and written.
enum class CodecState
{
  Running,
  MemberEnd,
  Damaged
};

/// gzip. ISA-L and zlib produce the same bytes, and both refuse data with a wrong checksum. For a
/// truncated file, ISA-L omits up to three bytes that zlib still produces; it also accepts
/// undefined flags in a header. ISA-L holds 90 kB of state, zlib 40 kB.
///
/// @throws std::bad_alloc where zlib has no memory.
///
/// The code common to both libraries, whose streams have the same member names. `Inflater` provides
/// an initialised Stream and Inflate().
template <typename Inflater>
class BasicGzipCodec : private Inflater
{
public:
  static constexpr const char* Name = "gzip";
  static std::uint64_t MaximumBytes(std::uint64_t fileSize) { return 1032 * fileSize; }
  static bool StartsMember(const unsigned char* bytes, std::size_t size)
  {
    return size >= 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
  }

  /// Copies that may be kept of one file, of 90 kB each.
  static constexpr std::size_t MostCopies = 128;

  /// The decoder in its present state, to continue from here again.
  std::unique_ptr<BasicGzipCodec> Copy() const { return std::make_unique<BasicGzipCodec>(*this); }

  /// Decompresses from `in` to `out`, and advances both, until one of them is exhausted.
  /// @pre The first time, `in` contains the whole header of the member: ISA-L 2.30 reports a header
  /// as damaged if it arrives in parts and has its own checksum.
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
  ZlibInflater(const ZlibInflater& other)
  {
    // It is not changed, but must be the stream itself, to which its state points.
    if (inflateCopy(&this->Stream, const_cast<z_stream*>(&other.Stream)) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
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

using GzipCodec = BasicGzipCodec<IsalInflater>;

#else

using GzipCodec = BasicGzipCodec<ZlibInflater>;

#endif

/// bzip2, by libbz2. Memory: 3.7 MB at most.
///
/// @throws std::bad_alloc where libbz2 has no memory.
class Bzip2Codec
{
public:
  static constexpr const char* Name = "bzip2";
  // A block of 45 bytes can hold 46 MB of one value, so there is no useful bound.
  static std::uint64_t MaximumBytes(std::uint64_t)
  {
    return std::numeric_limits<std::int64_t>::max();
  }
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

  static constexpr std::size_t MostCopies = 0;

  /// Not possible with libbz2.
  std::unique_ptr<Bzip2Codec> Copy() const { return nullptr; }

  /// Decompresses from `in` to `out`, and advances both, until one of them is exhausted.
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
