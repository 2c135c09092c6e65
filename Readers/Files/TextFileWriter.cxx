#include "Files/TextFileWriter.h"

#include <vtk_zlib.h>

#include <cerrno>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::size_t flushBytes = std::size_t{ 1 } << 20;

bool EndsWithGz(const std::string& path)
{
  return path.size() >= 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
}

}

TextFileWriter::TextFileWriter(const std::string& path)
  : File(path)
  // T: no compression, no header of gzip's.
  , Stream(gzopen(this->File.Written().c_str(), EndsWithGz(path) ? "wb6" : "wbT"))
{
  if (!this->Stream)
  {
    this->File.Fail(errno);
  }
}

TextFileWriter::~TextFileWriter()
{
  if (this->Stream)
  {
    gzclose(this->Stream);
  }
}

TextFileWriter& TextFileWriter::operator<<(std::string_view text)
{
  this->Buffer += text;
  if (this->Buffer.size() > flushBytes)
  {
    this->Flush();
  }
  return *this;
}

void TextFileWriter::Finish()
{
  this->Flush();
  errno = 0;
  if (gzclose(std::exchange(this->Stream, nullptr)) != Z_OK)
  {
    this->File.Fail(errno);
  }
  this->File.Finish();
}

void TextFileWriter::Close()
{
  this->Finish();
  this->Replace();
}

void TextFileWriter::Flush()
{
  const auto size = static_cast<unsigned int>(this->Buffer.size());
  errno = 0;
  if (size > 0 && gzwrite(this->Stream, this->Buffer.data(), size) != static_cast<int>(size))
  {
    this->File.Fail(errno);
  }
  this->Buffer.clear();
}

}
