#include "OpenDXWriter.h"

#include "NumberTypes.h"

#include <vtk_zlib.h>

#include <filesystem>
#include <stdexcept>
#include <type_traits>

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

/// A file of text that is removed again unless Close() is reached.
class TextFile
{
public:
  explicit TextFile(const std::string& path)
    : Path(path)
    // T: no compression, no header of gzip's.
    , File(gzopen(path.c_str(), EndsWithGz(path) ? "wb6" : "wbT"))
  {
    if (!this->File)
    {
      this->Fail();
    }
    this->Buffer.reserve(bufferBytes + 256);
  }
  ~TextFile()
  {
    if (this->File)
    {
      gzclose(this->File);
      RemoveFile(this->Path);
    }
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  TextFile& operator<<(std::string_view text)
  {
    this->Buffer += text;
    if (this->Buffer.size() > bufferBytes)
    {
      this->Flush();
    }
    return *this;
  }
  template <typename T, typename = std::enable_if_t<std::is_arithmetic_v<T>>>
  TextFile& operator<<(T number)
  {
    std::array<char, 64> digits;
    return *this << ToText(number, digits);
  }

  void Close()
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

private:
  void Flush()
  {
    const auto size = static_cast<unsigned int>(this->Buffer.size());
    if (size > 0 && gzwrite(this->File, this->Buffer.data(), size) != static_cast<int>(size))
    {
      this->Fail();
    }
    this->Buffer.clear();
  }
  [[noreturn]] void Fail() const
  {
    throw std::runtime_error("The file '" + this->Path +
      "' can't be written to its end: check its folder and the space left.");
  }

  std::string Path;
  gzFile File;
  std::string Buffer;
};

void WriteGrid(TextFile& file, const VoxelLattice& grid)
{
  const auto& n = grid.Dimensions;
  const auto counts = [&](const char* object)
  { file << object << n[0] << " " << n[1] << " " << n[2] << "\n"; };
  counts("object 1 class gridpositions counts ");
  file << "origin " << grid.Origin[0] << " " << grid.Origin[1] << " " << grid.Origin[2] << "\n";
  for (std::size_t a = 0; a < 3; ++a)
  {
    file << "delta " << grid.Steps[0][a] << " " << grid.Steps[1][a] << " " << grid.Steps[2][a]
         << "\n";
  }
  counts("object 2 class gridconnections counts ");
}

/// Without the characters that would end a text in quotes or a comment.
std::string OneLine(std::string text)
{
  for (char& c : text)
  {
    c = c == '"' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}

}

template <typename T>
void WriteOpenDX(const std::string& path, const VoxelLattice& grid, const T* values, int components,
  const OpenDXLabels& labels, const ProgressCallback& progress)
{
  TextFile file(path);
  for (const std::string& comment : labels.Comments)
  {
    file << "# " << OneLine(comment) << "\n";
  }
  WriteGrid(file, grid);
  const auto& n = grid.Dimensions;
  file << "object 3 class array type " << (std::is_same_v<T, float> ? "float" : "double");
  if (components == 1)
  {
    file << " rank 0";
  }
  else
  {
    file << " rank 1 shape " << components;
  }
  file << " items " << n[0] * n[1] * n[2] << " data follows\n";
  int onLine = 0;
  for (std::int64_t i = 0; i < n[0]; ++i)
  {
    for (std::int64_t row = 0; row < n[1] * n[2]; ++row)
    {
      const std::int64_t node = i + n[0] * (row / n[2] + n[1] * (row % n[2]));
      for (int c = 0; c < components; ++c)
      {
        onLine = (onLine + 1) % 3; // readers that go by lines expect three values on each
        file << values[node * components + c] << (onLine == 0 ? "\n" : " ");
      }
    }
    Report(progress, static_cast<double>(i + 1) / static_cast<double>(n[0]));
  }
  file << (onLine == 0 ? "" : "\n") << "attribute \"dep\" string \"positions\"\n"
       << "object \"" << OneLine(labels.FieldName) << "\" class field\n"
       << "component \"positions\" value 1\ncomponent \"connections\" value 2\n"
       << "component \"data\" value 3\n";
  file.Close();
}

template void WriteOpenDX(const std::string&, const VoxelLattice&, const float*, int,
  const OpenDXLabels&, const ProgressCallback&);
template void WriteOpenDX(const std::string&, const VoxelLattice&, const double*, int,
  const OpenDXLabels&, const ProgressCallback&);

}
