/**
 * @file TemporaryFile.h
 * @brief Files written by tests, plain or compressed.
 */
#ifndef isthmus_TemporaryFile_h
#define isthmus_TemporaryFile_h

#include "Core/ChildProcess.h"

#include <bzlib.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace isthmus::testing
{

/// `content` as a gzip stream; level 1 is quick, 9 small.
inline std::string Gzip(const std::string& content, int level = 6)
{
  z_stream stream{};
  deflateInit2(&stream, level, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, content.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

/// `content` as a bzip2 stream of blocks of `level` x 100 kB.
inline std::string Bzip2(const std::string& content, int level = 9)
{
  auto size = static_cast<unsigned int>(content.size() + content.size() / 50 + 1000);
  std::string packed(size, '\0');
  BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(content.data()),
    static_cast<unsigned int>(content.size()), level, 0, 0);
  packed.resize(size);
  return packed;
}

/// A file of this content, in a folder of its own, for the lifetime of the object.
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::string& content, const std::string& name = "map.mrc")
    : File((this->Folder.Path() / name).string())
  {
    std::ofstream(this->File, std::ios::binary) << content;
  }

  const char* Path() const { return this->File.c_str(); }

private:
  TemporaryFolder Folder;
  std::string File;
};

}

#endif
