#include "Meshes/TetGenMeshFile.h"

#include "Files/FileReplacement.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Files/TextFileWriter.h"
#include "Files/TextLines.h"
#include "Meshes/MeshWords.h"
#include "Meshes/MiddleNodes.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

using Place = MeshAttribute::Place;

/// VTK's place of each of TetGen's ten corners: the middles of edges are in another order.
constexpr std::array<std::size_t, 10> tetGenOfVTK{ 0, 1, 2, 3, 6, 7, 9, 5, 8, 4 };

std::string Partner(const std::string& path, const char* extension)
{
  return std::filesystem::path(path).replace_extension(extension).string();
}

/// Rows of one file: number of additional columns, and their contents.
struct Columns
{
  std::int64_t Attributes = 0;
  bool Marker = false;
  std::vector<double> Values;
  std::vector<std::int64_t> Markers;

  void Read(MeshWords& words)
  {
    for (std::int64_t a = 0; a < this->Attributes; ++a)
    {
      this->Values.push_back(words.Number("an attribute"));
    }
    if (this->Marker)
    {
      this->Markers.push_back(words.Whole("a boundary marker"));
    }
  }

  void MoveTo(std::vector<MeshAttribute>& attributes, Place place)
  {
    if (this->Attributes > 0)
    {
      attributes.push_back({ place, "Attribute", this->Attributes, std::move(this->Values) });
    }
    if (this->Marker)
    {
      attributes.push_back({ place, "BoundaryMarker", 1, std::move(this->Markers) });
    }
  }
};

/// The id that begins a row; they count up from that of the first row.
void ReadId(MeshWords& words, std::int64_t row, std::int64_t& first)
{
  const std::int64_t id = words.Whole("the number of a row");
  first = row == 0 ? id : first;
  if (id != first + row || first < 0 || first > 1)
  {
    words.Reject("row " + std::to_string(row + 1) + " has the number " + std::to_string(id) +
      "; rows are numbered from 0 or 1, one by one. The file may be truncated, damaged, or not a "
      "TetGen file.");
  }
}

/// Returns the number of the first point: 0 or 1.
std::int64_t ReadPoints(const std::string& path, CellMesh& mesh, const ProgressCallback& progress)
{
  const auto source = OpenTextSource(path);
  MeshWords words(*source, progress);
  const std::int64_t points = words.Count("the number of points", 6);
  const std::int64_t dimension = words.Whole("the dimension");
  if (dimension != 3)
  {
    words.Reject("the points have " + std::to_string(dimension) +
      " coordinates: only meshes in space are read.");
  }
  Columns columns;
  columns.Attributes = words.Count("the number of attributes");
  columns.Marker = words.Whole("the number of boundary markers") != 0;
  std::int64_t first = 1;
  for (std::int64_t i = 0; i < points; ++i)
  {
    ReadId(words, i, first);
    words.Point(mesh.Coordinates);
    columns.Read(words);
    words.ReportRow(i, points);
  }
  words.EndFile(points, "points");
  columns.MoveTo(mesh.Attributes, Place::Vertices);
  source->CheckEnd();
  return first;
}

void ReadTetrahedra(const std::string& path, std::int64_t firstPoint, CellMesh& mesh,
  const ProgressCallback& progress)
{
  const auto source = OpenTextSource(path);
  MeshWords words(*source, progress);
  const std::int64_t cells = words.Count("the number of tetrahedra", 8);
  const std::int64_t corners = words.Whole("the number of corners");
  if (corners != 4 && corners != 10)
  {
    words.Reject("tetrahedra have 4 or 10 corners, not " + std::to_string(corners) + ".");
  }
  Columns columns;
  columns.Attributes = words.Count("the number of attributes");
  std::int64_t first = 1;
  std::array<std::int64_t, 10> ids{};
  for (std::int64_t i = 0; i < cells; ++i)
  {
    ReadId(words, i, first);
    for (std::int64_t c = 0; c < corners; ++c)
    {
      ids[static_cast<std::size_t>(c)] = words.Vertex(mesh.NumberOfPoints(), firstPoint);
    }
    for (std::int64_t c = 0; c < corners; ++c)
    {
      mesh.Vertices.push_back(ids[tetGenOfVTK[static_cast<std::size_t>(c)]]);
    }
    mesh.EndCell(corners == 4 ? CellShape::Tetrahedron : CellShape::QuadraticTetrahedron);
    columns.Read(words);
    words.ReportRow(i, cells);
  }
  words.EndFile(cells, "tetrahedra");
  columns.MoveTo(mesh.Attributes, Place::Cells);
  source->CheckEnd();
}

/// The numbers that follow the corners of a triangle on its line.
std::vector<std::int64_t> FurtherNumbers(MeshWords& words, std::int64_t row)
{
  const std::string rest = words.RestOfLine();
  std::vector<std::int64_t> numbers;
  std::string_view left = rest;
  for (std::string_view word = NextWord(left); !word.empty(); word = NextWord(left))
  {
    numbers.emplace_back();
    if (!IsNumber(word, numbers.back()))
    {
      words.Reject("row " + std::to_string(row + 1) + ", above this line, has '" +
        std::string(word.substr(0, 30)) +
        "' where a whole number should be. The file may be truncated, damaged, or not a TetGen "
        "file.");
    }
  }
  return numbers;
}

/**
 * After its corners, a row has the middles of the edges (with TetGen's -o2), the marker, and two
 * neighbours (with -nn). The line of counts only says whether there are markers: how many numbers
 * there are decides.
 */
void ReadTriangles(const std::string& path, std::int64_t firstPoint, CellMesh& mesh,
  const ProgressCallback& progress)
{
  const auto source = OpenTextSource(path);
  MeshWords words(*source, progress);
  const std::int64_t cells = words.Count("the number of triangles", 7);
  Columns columns;
  columns.Marker = words.Whole("the number of boundary markers") != 0;
  const std::size_t markers = columns.Marker ? 1 : 0;
  std::int64_t first = 1;
  std::size_t further = 0;
  for (std::int64_t i = 0; i < cells; ++i)
  {
    ReadId(words, i, first);
    for (int c = 0; c < 3; ++c)
    {
      mesh.Vertices.push_back(words.Vertex(mesh.NumberOfPoints(), firstPoint));
    }
    const std::vector<std::int64_t> numbers = FurtherNumbers(words, i);
    further = i == 0 ? numbers.size() : further;
    const std::size_t behind = further - markers; // middles, neighbours, or both
    if (numbers.size() != further || further < markers ||
      (behind != 0 && behind != 2 && behind != 3 && behind != 5))
    {
      words.Reject("row " + std::to_string(i + 1) + ", above this line, has " +
        std::to_string(numbers.size()) + " numbers after its corners instead of " +
        std::to_string(numbers.size() == further ? markers : further) +
        ". The file is truncated or damaged.");
    }
    const bool isQuadratic = further == markers + 3 || further == markers + 5;
    for (std::size_t n = 0; isQuadratic && n < 3; ++n)
    {
      if (numbers[n] < firstPoint || numbers[n] - firstPoint >= mesh.NumberOfPoints())
      {
        words.Reject("row " + std::to_string(i + 1) + ", above this line, names vertex " +
          std::to_string(numbers[n]) + ", which is not there.");
      }
      mesh.Vertices.push_back(numbers[n] - firstPoint);
    }
    mesh.EndCell(isQuadratic ? CellShape::QuadraticTriangle : CellShape::Triangle);
    if (columns.Marker)
    {
      columns.Markers.push_back(numbers[isQuadratic ? 3 : 0]);
    }
    words.ReportRow(i, cells);
  }
  words.EndFile(cells, "triangles");
  OrderMiddleNodes(mesh, 0, mesh.Shapes.size());
  columns.MoveTo(mesh.Attributes, Place::Cells);
  source->CheckEnd();
}

const std::vector<double>* Reals(const CellMesh& mesh, Place on, std::int64_t& components)
{
  const MeshAttribute* found = mesh.Find(on, "Attribute");
  components = found ? found->Components : 0;
  const auto* values = found ? std::get_if<std::vector<double>>(&found->Values) : nullptr;
  components = values ? components : 0;
  return values;
}

const std::vector<std::int64_t>* Markers(const CellMesh& mesh, Place on)
{
  const MeshAttribute* found = mesh.Find(on, "BoundaryMarker");
  return found && found->Components == 1 ? std::get_if<std::vector<std::int64_t>>(&found->Values)
                                         : nullptr;
}

void WriteAttributes(
  TextFileWriter& file, const std::vector<double>* values, std::int64_t components, std::size_t row)
{
  for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c)
  {
    file << " " << (*values)[row * static_cast<std::size_t>(components) + c];
  }
}

void WritePoints(const CellMesh& mesh, TextFileWriter& file)
{
  std::int64_t components = 0;
  const auto* values = Reals(mesh, Place::Vertices, components);
  const auto* markers = Markers(mesh, Place::Vertices);
  file << mesh.NumberOfPoints() << " 3 " << components << " " << (markers ? 1 : 0) << "\n";
  for (std::size_t i = 0; i < mesh.Coordinates.size() / 3; ++i)
  {
    const double* p = mesh.Coordinates.data() + 3 * i;
    file << i + 1 << " " << p[0] << " " << p[1] << " " << p[2];
    WriteAttributes(file, values, components, i);
    if (markers)
    {
      file << " " << (*markers)[i];
    }
    file << "\n";
  }
}

/// The cells of one shape.
std::vector<std::size_t> FindCells(const CellMesh& mesh, CellShape shape)
{
  std::vector<std::size_t> cells;
  for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
  {
    if (mesh.Shapes[cell] == shape)
    {
      cells.push_back(cell);
    }
  }
  return cells;
}

void WriteTetrahedra(const CellMesh& mesh, const std::vector<std::size_t>& cells,
  std::size_t corners, TextFileWriter& file)
{
  std::int64_t components = 0;
  const auto* values = Reals(mesh, Place::Cells, components);
  file << cells.size() << " " << corners << " " << components << "\n";
  std::array<std::int64_t, 10> ids{};
  for (std::size_t row = 0; row < cells.size(); ++row)
  {
    const auto first = static_cast<std::size_t>(mesh.Offsets[cells[row]]);
    for (std::size_t c = 0; c < corners; ++c)
    {
      ids[tetGenOfVTK[c]] = mesh.Vertices[first + c] + 1;
    }
    file << row + 1;
    for (std::size_t c = 0; c < corners; ++c)
    {
      file << " " << ids[c];
    }
    WriteAttributes(file, values, components, cells[row]);
    file << "\n";
  }
}

void WriteTriangles(
  const CellMesh& mesh, const std::vector<std::size_t>& cells, TextFileWriter& file)
{
  const auto* markers = Markers(mesh, Place::Cells);
  file << cells.size() << " " << (markers ? 1 : 0) << "\n";
  for (std::size_t row = 0; row < cells.size(); ++row)
  {
    const auto first = static_cast<std::size_t>(mesh.Offsets[cells[row]]);
    file << row + 1;
    for (std::size_t c = 0; c < 3; ++c)
    {
      file << " " << mesh.Vertices[first + c] + 1;
    }
    if (markers)
    {
      file << " " << (*markers)[cells[row]];
    }
    file << "\n";
  }
}

}

CellMesh ReadTetGenFiles(const std::string& path, const ProgressCallback& progress)
{
  CellMesh mesh;
  const std::string extension = std::filesystem::path(path).extension().string();
  std::error_code none;
  if (extension == ".face" && !std::filesystem::exists(Partner(path, ".node"), none) &&
    std::filesystem::exists(Partner(path, ".vert"), none))
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path +
        ": this belongs to a surface of MSMS, not to a mesh of TetGen. Open it with the MSMS "
        "Surface Reader.");
  }
  const std::int64_t first = ReadPoints(Partner(path, ".node"), mesh, Between(progress, 0.0, 0.4));
  if (extension == ".ele")
  {
    ReadTetrahedra(path, first, mesh, Between(progress, 0.4, 1.0));
  }
  else if (extension == ".face")
  {
    ReadTriangles(path, first, mesh, Between(progress, 0.4, 1.0));
  }
  else if (extension != ".node")
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": TetGen's files end in .node, .ele or .face. Name one of these.");
  }
  return mesh;
}

void WriteTetGenFiles(
  const CellMesh& mesh, const std::string& path, const ProgressCallback& progress)
{
  const auto linear = FindCells(mesh, CellShape::Tetrahedron);
  const auto quadratic = FindCells(mesh, CellShape::QuadraticTetrahedron);
  const auto triangles = FindCells(mesh, CellShape::Triangle);
  const auto vertices = FindCells(mesh, CellShape::Vertex);
  if (linear.size() + quadratic.size() + triangles.size() + vertices.size() != mesh.Shapes.size() ||
    (!linear.empty() && !quadratic.empty()))
  {
    throw std::invalid_argument("TetGen's files hold tetrahedra, all with 4 or all with 10 points, "
                                "and triangles: remove other cells, or triangulate them.");
  }
  // An existing file of this name would look like the one just written.
  const std::string extension = std::filesystem::path(path).extension().string();
  if ((extension == ".ele" && linear.empty() && quadratic.empty()) ||
    (extension == ".face" && triangles.empty()))
  {
    throw std::invalid_argument("The mesh has no " +
      std::string(extension == ".ele" ? "tetrahedra" : "triangles") + " for the file '" + path +
      "': name a file that ends in " + (extension == ".ele" ? ".face" : ".ele") +
      " for its other cells, or in .node for its points.");
  }
  // All files are completed before any is renamed: points and cells belong together.
  std::vector<std::unique_ptr<TextFileWriter>> files;
  const auto file = [&](const char* extensionOfPart) -> TextFileWriter&
  {
    files.push_back(std::make_unique<TextFileWriter>(Partner(path, extensionOfPart)));
    return *files.back();
  };
  WritePoints(mesh, file(".node"));
  Report(progress, 0.4);
  if (!linear.empty())
  {
    WriteTetrahedra(mesh, linear, 4, file(".ele"));
  }
  if (!quadratic.empty())
  {
    WriteTetrahedra(mesh, quadratic, 10, file(".ele"));
  }
  if (!triangles.empty())
  {
    WriteTriangles(mesh, triangles, file(".face"));
  }
  for (const auto& part : files)
  {
    part->Finish();
  }
  Report(progress, 1.0); // an abort leaves the old files
  // Cells of an earlier mesh would be read with the new points.
  std::vector<std::unique_ptr<FileRemoval>> old;
  for (const auto& [extensionOfPart, isWritten] :
    { std::pair(".ele", !linear.empty() || !quadratic.empty()),
      std::pair(".face", !triangles.empty()) })
  {
    const std::string partner = Partner(path, extensionOfPart);
    if (!isWritten && LooksLikeTetGen(partner))
    {
      old.push_back(std::make_unique<FileRemoval>(partner));
      old.back()->Hide();
    }
  }
  for (const auto& part : files)
  {
    part->Replace();
  }
  for (const auto& part : old)
  {
    part->Remove();
  }
}

bool LooksLikeTetGen(const std::string& path)
{
  try
  {
    const auto source = OpenTextSource(path);
    TextWords words(*source);
    const std::int64_t count = words.Whole("a count");
    const std::int64_t second = words.Whole("a count");
    const std::string rest = words.RestOfLine();
    std::string_view left = rest;
    int further = 0; // MSMS' .face files begin with four numbers or with five
    while (!NextWord(left).empty())
    {
      ++further;
    }
    const std::string extension = std::filesystem::path(path).extension().string();
    const bool nodes = extension == ".node" && second == 3 && further == 2;
    const bool cells = extension == ".ele" && (second == 4 || second == 10) && further == 1;
    const bool faces = extension == ".face" && (second == 0 || second == 1) && further == 0;
    return count >= 0 && (nodes || cells || faces);
  }
  catch (const ReaderError&)
  {
    return false;
  }
}

}
