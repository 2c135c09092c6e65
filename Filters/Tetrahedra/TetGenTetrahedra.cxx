#include "Tetrahedra/TetGenTetrahedra.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// Collects numbers as text and writes them a block at a time.
class TextWriter
{
public:
  explicit TextWriter(const std::filesystem::path& name)
    : File(name, std::ios::binary)
  {
  }

  template <typename Number>
  TextWriter& operator<<(Number value)
  {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    this->Text.append(digits, end).push_back(' ');
    return *this;
  }

  TextWriter& operator<<(const Point3& p) { return *this << p[0] << p[1] << p[2]; }

  void EndLine()
  {
    this->Text.push_back('\n');
    if (this->Text.size() > (1u << 20))
    {
      this->Flush();
    }
  }

  void Flush()
  {
    this->File.write(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->File.flush();
    this->Text.clear();
    if (!this->File)
    {
      throw std::runtime_error("The surface could not be written for TetGen: free some space in "
                               "the folder for temporary files, or set TMPDIR to another.");
    }
  }

private:
  std::ofstream File;
  std::string Text;
};

/// Numbers of a text file, one after the other; '#' begins a comment.
class TextReader
{
public:
  explicit TextReader(const std::filesystem::path& name)
    : Name(name.filename().string())
  {
    std::ifstream file(name, std::ios::binary | std::ios::ate);
    if (!file)
    {
      throw std::runtime_error("TetGen left no file " + this->Name + ".");
    }
    this->Text.resize(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->At = this->Text.data();
    this->End = this->At + this->Text.size();
  }

  template <typename Number>
  Number Next()
  {
    this->SkipBlanks();
    Number value{};
    const auto [rest, error] = std::from_chars(this->At, this->End, value);
    if (error != std::errc{})
    {
      throw std::runtime_error("TetGen's file " + this->Name + " ends early: is the disk full?");
    }
    this->At = rest;
    return value;
  }

private:
  void SkipBlanks()
  {
    while (this->At != this->End && (*this->At <= ' ' || *this->At == '#'))
    {
      if (*this->At == '#')
      {
        this->At = std::find(this->At, this->End, '\n');
        continue;
      }
      ++this->At;
    }
  }

  std::string Name;
  std::string Text;
  const char* At = nullptr;
  const char* End = nullptr;
};

}

void WriteTetGenSurface(const std::filesystem::path& file, const std::vector<SurfaceView>& surfaces,
  const std::vector<SpaceRegion>& holes, const std::vector<SpaceRegion>& regions)
{
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const SurfaceView& surface : surfaces)
  {
    points += surface.Points.size();
    triangles += surface.Triangles.size();
  }
  TextWriter out(file);
  (out << points << 3 << 0 << 0).EndLine();
  std::size_t id = 0;
  for (const SurfaceView& surface : surfaces)
  {
    for (const Point3& p : surface.Points)
    {
      (out << id++ << p).EndLine();
    }
  }
  (out << triangles << 0).EndLine();
  std::int64_t first = 0;
  for (const SurfaceView& surface : surfaces)
  {
    for (const Triangle& t : surface.Triangles)
    {
      (out << 3 << first + t[0] << first + t[1] << first + t[2]).EndLine();
    }
    first += static_cast<std::int64_t>(surface.Points.size());
  }
  (out << holes.size()).EndLine();
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    (out << i << holes[i].Seed).EndLine();
  }
  (out << regions.size()).EndLine();
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    (out << i << regions[i].Seed << i + 1).EndLine();
  }
  out.Flush();
}

TetrahedralMesh ReadTetGenMesh(const std::filesystem::path& folder, const std::string& name)
{
  TetrahedralMesh mesh;
  {
    TextReader nodes(folder / (name + ".1.node"));
    mesh.Points.resize(nodes.Next<std::size_t>());
    const int dimension = nodes.Next<int>();
    const int attributes = nodes.Next<int>();
    const int markers = nodes.Next<int>();
    if (dimension != 3 || attributes != 0 || markers != 0)
    {
      throw std::runtime_error("TetGen's file of points has columns that were not asked for.");
    }
    for (Point3& p : mesh.Points)
    {
      nodes.Next<std::int64_t>(); // its own number
      p = { nodes.Next<double>(), nodes.Next<double>(), nodes.Next<double>() };
    }
  }
  TextReader cells(folder / (name + ".1.ele"));
  const auto count = cells.Next<std::size_t>();
  cells.Next<int>(); // corners
  const int attributes = cells.Next<int>();
  mesh.Tetrahedra.resize(count);
  mesh.Regions.resize(count);
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    cells.Next<std::int64_t>();
    for (vtkIdType& corner : mesh.Tetrahedra[i])
    {
      corner = cells.Next<std::int64_t>();
      if (corner < 0 || corner >= points)
      {
        throw std::runtime_error("TetGen's file of tetrahedra names a point that is not there.");
      }
    }
    mesh.Regions[i] = attributes > 0 ? static_cast<int>(cells.Next<double>()) : 0;
  }
  return mesh;
}

}
