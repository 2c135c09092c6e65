/**
 * @file ByteSource.h
 * @brief The bytes of a file that is stored plain, gzip- or bzip2-compressed.
 *
 * The compression is detected from the first bytes, never from the file name.
 */
#ifndef isthmus_ByteSource_h
#define isthmus_ByteSource_h

#include "Core/Progress.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace isthmus
{

class ByteSource
{
public:
  virtual ~ByteSource() = default;

  /**
   * Copies `size` bytes at `offset` of the content into a buffer; returns the number of bytes,
   * which is smaller only at the end of the content.
   *
   * With RandomAccess() any number of threads may read at once. Without it only one thread may read
   * at a time, and decompression restarts from the last known place before the offset if that is
   * before the previous one: files are indexed while they are decompressed (by gzip, or bzip2 on
   * several threads), and the index is kept while the program runs.
   * @throws ReaderError on an input error or a damaged compressed stream.
   */
  virtual std::size_t Read(std::uint64_t offset, void* to, std::size_t size) = 0;

  virtual bool RandomAccess() const = 0;

  /// Whether Read itself uses several threads; then it must not be called from within a parallel
  /// loop.
  virtual bool UsesThreads() const { return false; }

  /// Upper bound of the size of the content, based only on the size of the file: exact for a plain
  /// file, 1032 times the file size for gzip (the best that deflate can do), unlimited for bzip2.
  virtual std::uint64_t MaximumBytes() const = 0;

  /// Size of the content in bytes, counted up to `limit` by decompressing (immediate for plain
  /// files).
  virtual std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) = 0;

  /// Moves to `offset` before a Read there, with progress, since decompressing may take long.
  virtual void SkipTo(std::uint64_t offset, const ProgressCallback& progress) = 0;

  /// Verifies the checksum of a compressed stream after the last Read.
  /// @throws ReaderError.
  virtual void CheckEnd() = 0;

  /// Whether a compressed stream turned out to be truncated, after the last Read.
  virtual bool IsCut() const = 0;

  /// Whether lone carriage returns, the line ends of the file, are converted to newlines; then raw
  /// bytes cannot be read.
  virtual bool ChangesLineEnds() const { return false; }

  /// The compression of the file: "none", "gzip" or "bzip2".
  virtual std::string Compression() const = 0;

  /// Bytes on the disk.
  virtual std::uint64_t FileSize() const = 0;

  virtual const std::string& Path() const = 0;
};

}

#endif
