#include "Files/TextFileWriter.h"

#include <vtk_zlib.h>

#include <filesystem>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr std::size_t bufferBytes = std::size_t{ 1 } << 20;

bool EndsWithGz(const std::string& path)
{
  return path.size() >= 3 && path.compare(path.size() - 3, 3, ".gz") == 0;
}

/// Not what only looks like a file: a device, say.
void RemoveFile(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored))
  {
    std::filesystem::remove(path, ignored);
  }
}

}

TextFileWriter::TextFileWriter(const std::string& path)
  : Path(path)
  // T: no compression, no header of gzip's.
  , File(gzopen(path.c_str(), EndsWithGz(path) ? "wb6" : "wbT"))
{
  if (!this->File)
  {
    this->Fail();
  }
}

TextFileWriter::~TextFileWriter()
{
  if (this->File)
  {
    gzclose(this->File);
    RemoveFile(this->Path);
  }
}

TextFileWriter& TextFileWriter::operator<<(std::string_view text)
{
  this->Buffer += text;
  if (this->Buffer.size() > bufferBytes)
  {
    this->Flush();
  }
  return *this;
}

void TextFileWriter::Close()
{
  this->Flush();
  const gzFile file = this->File;
  this->File = nullptr;
  if (gzclose(file) != Z_OK)
  {
    RemoveFile(this->Path);
    this->Fail();
  }
}

void TextFileWriter::Flush()
{
  const auto size = static_cast<unsigned int>(this->Buffer.size());
  if (size > 0 && gzwrite(this->File, this->Buffer.data(), size) != static_cast<int>(size))
  {
    this->Fail();
  }
  this->Buffer.clear();
}

void TextFileWriter::Fail() const
{
  throw std::runtime_error("The file '" + this->Path +
    "' can't be written to its end: check its folder and the space left.");
}

}
