/**
 * @file ByteSource.h
 * @brief The bytes of a file, whether it is stored plain, gzip- or bzip2-compressed.
 *
 * Compression is found from the first bytes, never from the file's name.
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
   * Copies `size` bytes from `offset` of the content to `to`; returns how many there were, fewer
   * only at the end of the content.
   *
   * With RandomAccess() any number of threads may read at once. Without it one thread at a time,
   * and an offset before the last one starts decompressing from the beginning again.
   * @throws ReaderError on an input error or a damaged compressed stream.
   */
  virtual std::size_t Read(std::uint64_t offset, void* to, std::size_t size) = 0;

  virtual bool RandomAccess() const = 0;

  /// Whether Read itself runs on several threads: not to be called from within a parallel loop.
  virtual bool UsesThreads() const { return false; }

  /// Most bytes that the content can have, judged by the size of the file alone: exact for a plain
  /// file, 1032 times the file for gzip (deflate can't do better), without limit for bzip2.
  virtual std::uint64_t MostBytes() const = 0;

  /// Bytes of content up to `limit`, counted by decompressing (immediate for plain files).
  virtual std::uint64_t CountUpTo(std::uint64_t limit, const ProgressCallback& progress) = 0;

  /// Goes to `offset` before a Read there, with progress, since decompressing may take long.
  virtual void SkipTo(std::uint64_t offset, const ProgressCallback& progress) = 0;

  /// After the last Read: lets a compressed stream check its checksum.
  /// @throws ReaderError.
  virtual void CheckEnd() = 0;

  /// After the last Read: whether a compressed stream broke off before its end.
  virtual bool IsCut() const = 0;

  /// Whether line ends of the file, lone carriage returns, are given as newlines: raw bytes in it
  /// cannot be read.
  virtual bool ChangesLineEnds() const { return false; }

  /// How the file is stored: "none", "gzip" or "bzip2".
  virtual std::string Compression() const = 0;

  /// Bytes on the disk.
  virtual std::uint64_t FileSize() const = 0;

  virtual const std::string& Path() const = 0;
};

}

#endif
