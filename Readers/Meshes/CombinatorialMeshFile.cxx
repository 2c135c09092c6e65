#include "Meshes/CombinatorialMeshFile.h"

#include "Files/NumberTypes.h"

#include <algorithm>
#include <cctype>
#include <locale>
#include <numeric>
#include <ostream>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

constexpr std::string_view Magic = "isthmus-combinatorial-mesh";

bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// A place in the contents, with the words and blocks that follow it.
class Scanner
{
public:
  explicit Scanner(std::string_view contents)
    : Contents(contents)
  {
  }

  [[noreturn]] void Fail(const std::string& what) const
  {
    const auto line = 1 +
      std::count(this->Contents.begin(),
        this->Contents.begin() + static_cast<std::ptrdiff_t>(this->At), '\n');
    throw std::runtime_error("Combinatorial mesh file, " +
      (this->Binary ? "byte " + std::to_string(this->At) : "line " + std::to_string(line)) + ": " +
      what);
  }

  std::string_view Word(const std::string& meaning)
  {
    while (this->At < this->Contents.size() && IsBlank(this->Contents[this->At]))
    {
      ++this->At;
    }
    const std::size_t first = this->At;
    while (this->At < this->Contents.size() && !IsBlank(this->Contents[this->At]))
    {
      ++this->At;
    }
    if (first == this->At)
    {
      this->Fail("the file ends where " + meaning + " should be. It is truncated.");
    }
    return this->Contents.substr(first, this->At - first);
  }

  void Keyword(std::string_view keyword)
  {
    const std::string_view word = this->Word("'" + std::string(keyword) + "'");
    if (word != keyword)
    {
      this->Fail("'" + std::string(keyword) + "' should be where '" + QuoteWord(word) + "' is.");
    }
  }

  template <typename T>
  T Number(const std::string& meaning, T least, T most)
  {
    const std::string_view word = this->Word(meaning);
    T value{};
    if (!FromText(word, value) || value < least || value > most)
    {
      this->Fail(meaning + " should be a number from " + std::to_string(least) + " to " +
        std::to_string(most) + ", not '" + QuoteWord(word) + "'.");
    }
    return value;
  }

  /// The maximum number of following items of at least `bytes` bytes each; no count may exceed it.
  std::int64_t AtMost(std::int64_t bytes) const
  {
    return static_cast<std::int64_t>(this->Contents.size() - this->At) / bytes;
  }

  std::string_view RestOfLine()
  {
    while (this->At < this->Contents.size() && this->Contents[this->At] == ' ')
    {
      ++this->At;
    }
    const std::size_t first = this->At;
    this->At = std::min(this->Contents.find('\n', first), this->Contents.size());
    std::string_view rest = this->Contents.substr(first, this->At - first);
    while (!rest.empty() && rest.back() == '\r')
    {
      rest.remove_suffix(1); // a text file may have come from Windows
    }
    return rest;
  }

  template <typename T>
  void Numbers(std::vector<T>& values, std::int64_t count, const std::string& meaning)
  {
    const auto size = static_cast<std::int64_t>(sizeof(T));
    // A number of text takes a digit and a blank.
    if (count > this->AtMost(this->Binary ? size : 2) + (this->Binary ? 0 : 1))
    {
      this->Fail("the file is too short for " + std::to_string(count) + " " + meaning + ".");
    }
    values.resize(static_cast<std::size_t>(count));
    if (this->Binary)
    {
      this->Bytes(values, meaning);
      return;
    }
    for (T& value : values)
    {
      const std::string_view word = this->Word(meaning);
      if (!FromText(word, value))
      {
        this->Fail(
          "'" + QuoteWord(word) + "' among the " + meaning + " is not a number of their type.");
      }
    }
  }

  bool Binary = false;

private:
  static std::string QuoteWord(std::string_view word)
  {
    std::string text(word.substr(0, 30));
    for (char& c : text)
    {
      c = std::isprint(static_cast<unsigned char>(c)) ? c : '?';
    }
    return text;
  }

  template <typename T>
  void Bytes(std::vector<T>& values, const std::string& meaning)
  {
    // A block begins after exactly one line break.
    if (this->At >= this->Contents.size() || this->Contents[this->At] != '\n')
    {
      this->Fail("a line break should come before the " + meaning + ".");
    }
    ++this->At;
    const std::size_t bytes = values.size() * sizeof(T);
    if (bytes > this->Contents.size() - this->At)
    {
      this->Fail("the file ends within the " + meaning + ". It is truncated.");
    }
    if (bytes > 0)
    {
      std::memcpy(values.data(), this->Contents.data() + this->At, bytes);
    }
    SwapToLittleEndian(values.data(), values.size());
    this->At += bytes;
  }

  std::string_view Contents;
  std::size_t At = 0;
};

std::size_t NumberType(Scanner& scanner)
{
  const std::string_view name = scanner.Word("a number type");
  const auto found = std::find(NumberTypeNames.begin(), NumberTypeNames.end(), name);
  if (found == NumberTypeNames.end())
  {
    scanner.Fail("the number type should be int8 ... uint64, float32 or float64.");
  }
  return static_cast<std::size_t>(found - NumberTypeNames.begin());
}

CellType ParseType(Scanner& scanner)
{
  scanner.Keyword("type");
  const int vertices =
    static_cast<int>(scanner.Number<std::int64_t>("the number of vertices", 4, 32767));
  FaceList faces(static_cast<std::size_t>(scanner.Number<std::int64_t>(
    "the number of faces", 4, std::min<std::int64_t>(32767, scanner.AtMost(8)))));
  const std::string name(scanner.RestOfLine());
  for (std::vector<int>& face : faces)
  {
    face.resize(static_cast<std::size_t>(scanner.Number<std::int64_t>(
      "the size of a face", 3, std::min<std::int64_t>(vertices, scanner.AtMost(2)))));
    for (int& vertex : face)
    {
      vertex = scanner.Number<int>("a vertex of a face", 0, vertices - 1);
    }
  }
  try
  {
    return CellType(name, vertices, faces);
  }
  catch (const std::invalid_argument& error)
  {
    scanner.Fail(error.what());
  }
}

void ParseCoordinates(Scanner& scanner, CombinatorialMesh& mesh)
{
  scanner.Keyword("vertices");
  mesh.NumberOfVertices =
    scanner.Number<std::int64_t>("the number of vertices", 0, scanner.AtMost(6) + 1);
  const std::size_t type = NumberType(scanner);
  if (NumberTypeNames[type] != "float32" && NumberTypeNames[type] != "float64")
  {
    scanner.Fail("coordinates should be float32 or float64.");
  }
  mesh.Coordinates = EmptyNumberList(type);
  std::visit([&](auto& values)
    { scanner.Numbers(values, 3 * mesh.NumberOfVertices, "coordinates"); },
    mesh.Coordinates);
}

void ParseCells(Scanner& scanner, CombinatorialMesh& mesh)
{
  scanner.Keyword("blocks");
  const auto blocks = scanner.Number<std::int64_t>("the number of blocks", 0, scanner.AtMost(9));
  for (std::int64_t b = 0; b < blocks; ++b)
  {
    scanner.Keyword("block");
    const auto type = scanner.Number<std::int64_t>(
      "the number of a cell type", 0, static_cast<std::int64_t>(mesh.Types.size()) - 1);
    const CellType& cellType = mesh.Types[static_cast<std::size_t>(type)];
    const auto count = scanner.Number<std::int64_t>(
      "the number of cells", 1, scanner.AtMost(2 * cellType.NumberOfVertices()) + 1);
    std::vector<std::int64_t> vertices;
    scanner.Numbers(vertices, count * cellType.NumberOfVertices(), "vertices of cells");
    for (const std::int64_t vertex : vertices)
    {
      if (vertex < 0 || vertex >= mesh.NumberOfVertices)
      {
        scanner.Fail("block " + std::to_string(b) + " has the vertex number " +
          std::to_string(vertex) + ", but vertices are numbered 0 ... " +
          std::to_string(mesh.NumberOfVertices - 1) + ".");
      }
    }
    mesh.Runs.push_back({ static_cast<std::size_t>(type), count });
    mesh.CellVertices.insert(mesh.CellVertices.end(), vertices.begin(), vertices.end());
  }
}

void ParseAttributes(Scanner& scanner, CombinatorialMesh& mesh)
{
  scanner.Keyword("attributes");
  const auto count =
    scanner.Number<std::int64_t>("the number of attributes", 0, scanner.AtMost(10));
  for (std::int64_t a = 0; a < count; ++a)
  {
    MeshAttribute attribute;
    scanner.Keyword("attribute");
    const std::string_view place = scanner.Word("'vertices' or 'cells'");
    if (place != "vertices" && place != "cells")
    {
      scanner.Fail("an attribute should be on 'vertices' or on 'cells'.");
    }
    attribute.On = place == "cells" ? MeshAttribute::Place::Cells : MeshAttribute::Place::Vertices;
    attribute.Values = EmptyNumberList(NumberType(scanner));
    attribute.Components = scanner.Number<std::int64_t>("the number of components", 1, 1 << 20);
    attribute.Name = scanner.RestOfLine();
    const std::int64_t tuples =
      attribute.On == MeshAttribute::Place::Cells ? mesh.NumberOfCells() : mesh.NumberOfVertices;
    std::visit([&](auto& values)
      { scanner.Numbers(values, tuples * attribute.Components, "values of an attribute"); },
      attribute.Values);
    mesh.Attributes.push_back(std::move(attribute));
  }
}

}

std::int64_t CombinatorialMesh::NumberOfCells() const
{
  return std::accumulate(this->Runs.begin(), this->Runs.end(), std::int64_t(0),
    [](std::int64_t sum, const CellRun& run) { return sum + run.NumberOfCells; });
}

CombinatorialMesh ParseCombinatorialMesh(std::string_view contents)
{
  CombinatorialMesh mesh;
  Scanner scanner(contents);
  if (scanner.Word("the file's name") != Magic)
  {
    scanner.Fail(
      "this is not a combinatorial mesh: it should begin with '" + std::string(Magic) + "'.");
  }
  scanner.Number("the version of the format", 1, 1);
  const std::string_view coding = scanner.Word("'text' or 'binary'");
  if (coding != "text" && coding != "binary")
  {
    scanner.Fail("'text' or 'binary' should follow the version.");
  }
  scanner.Keyword("types");
  const auto types =
    scanner.Number<std::int64_t>("the number of cell types", 0, scanner.AtMost(40));
  for (std::int64_t t = 0; t < types; ++t)
  {
    mesh.Types.push_back(ParseType(scanner));
  }
  // Types are text in binary files, too; numbers come as bytes from here on.
  scanner.Binary = coding == "binary";
  ParseCoordinates(scanner, mesh);
  ParseCells(scanner, mesh);
  ParseAttributes(scanner, mesh);
  scanner.Keyword("end");
  return mesh;
}

namespace
{

/// Writes blocks of numbers as text or as bytes.
class Printer
{
public:
  /// `all`: the numbers that all calls together write.
  Printer(std::ostream& stream, bool binary, std::size_t all, const ProgressCallback& progress)
    : Stream(stream)
    , Binary(binary)
    , All(static_cast<double>(all) + 1.0)
    , Progress(progress)
  {
  }

  /// `perLine` numbers per line of text.
  template <typename T>
  void Numbers(const T* values, std::size_t count, std::size_t perLine)
  {
    if (this->Binary)
    {
      this->Bytes(values, count);
      return;
    }
    std::array<char, 64> buffer;
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Stream << ToText(values[i], buffer) << ((i + 1) % perLine ? ' ' : '\n');
      if ((i + 1) % Piece == 0)
      {
        this->ReportNumbers(Piece);
      }
    }
    this->ReportNumbers(count % Piece);
  }

private:
  template <typename T>
  void Bytes(const T* values, std::size_t count)
  {
    std::array<T, Piece> swapped;
    for (std::size_t first = 0; first < count; first += Piece)
    {
      const std::size_t size = std::min(Piece, count - first);
      std::copy_n(values + first, size, swapped.begin());
      SwapToLittleEndian(swapped.data(), size);
      this->Stream.write(reinterpret_cast<const char*>(swapped.data()),
        static_cast<std::streamsize>(size * sizeof(T)));
      this->ReportNumbers(size);
    }
    this->Stream << '\n';
  }

  void ReportNumbers(std::size_t count)
  {
    this->Written += static_cast<double>(count);
    Report(this->Progress, this->Written / this->All);
  }

  static constexpr std::size_t Piece = 4096;

  std::ostream& Stream;
  bool Binary;
  double All;
  double Written = 0.0;
  const ProgressCallback& Progress;
};

/// A name that the reader returns unchanged.
const std::string& CheckName(const std::string& name)
{
  const bool trimmed = !name.empty() && (name.front() == ' ' || name.back() == '\r');
  if (trimmed || name.find('\n') != std::string::npos)
  {
    throw std::invalid_argument(
      "The name '" + name + "' begins with a blank or holds a line break: rename it.");
  }
  return name;
}

void WriteTypes(const CombinatorialMesh& mesh, std::ostream& stream)
{
  stream << "types " << mesh.Types.size() << '\n';
  for (const CellType& type : mesh.Types)
  {
    stream << "type " << type.NumberOfVertices() << ' ' << type.NumberOfFaces() << ' '
           << CheckName(type.Name()) << '\n';
    for (const std::vector<int>& face : type.Faces())
    {
      stream << face.size();
      for (const int vertex : face)
      {
        stream << ' ' << vertex;
      }
      stream << '\n';
    }
  }
}

/// Total number of values in its blocks.
std::size_t CountNumbers(const CombinatorialMesh& mesh)
{
  const auto size = [](const auto& values) { return values.size(); };
  std::size_t all = std::visit(size, mesh.Coordinates) + mesh.CellVertices.size();
  for (const MeshAttribute& attribute : mesh.Attributes)
  {
    all += std::visit(size, attribute.Values);
  }
  return all;
}

}

void WriteCombinatorialMesh(const CombinatorialMesh& mesh, bool binary, std::ostream& stream,
  const ProgressCallback& progress)
{
  stream.imbue(std::locale::classic()); // no separators in large numbers
  Printer printer(stream, binary, CountNumbers(mesh), progress);
  stream << "isthmus-combinatorial-mesh 1 " << (binary ? "binary" : "text") << '\n';
  WriteTypes(mesh, stream);
  stream << "vertices " << mesh.NumberOfVertices << ' ' << NumberTypeNames[mesh.Coordinates.index()]
         << '\n';
  std::visit([&](const auto& values) { printer.Numbers(values.data(), values.size(), 3); },
    mesh.Coordinates);
  stream << "blocks " << mesh.Runs.size() << '\n';
  std::size_t next = 0;
  for (const CellRun& run : mesh.Runs)
  {
    const auto size = static_cast<std::size_t>(mesh.Types[run.Type].NumberOfVertices());
    const std::size_t count = static_cast<std::size_t>(run.NumberOfCells) * size;
    stream << "block " << run.Type << ' ' << run.NumberOfCells << '\n';
    printer.Numbers(mesh.CellVertices.data() + next, count, size);
    next += count;
  }
  stream << "attributes " << mesh.Attributes.size() << '\n';
  for (const MeshAttribute& attribute : mesh.Attributes)
  {
    stream << "attribute " << (attribute.On == MeshAttribute::Place::Cells ? "cells " : "vertices ")
           << NumberTypeNames[attribute.Values.index()] << ' ' << attribute.Components << ' '
           << CheckName(attribute.Name) << '\n';
    std::visit(
      [&](const auto& values) {
        printer.Numbers(
          values.data(), values.size(), static_cast<std::size_t>(attribute.Components));
      },
      attribute.Values);
  }
  stream << "end\n";
  Report(progress, 1.0);
}

}
