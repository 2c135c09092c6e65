#include "Meshes/OFFFile.h"

#include "Core/PrintableText.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Files/TextFileWriter.h"
#include "Files/TextLines.h"
#include "Meshes/MeshWords.h"

#include <algorithm>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// The properties of the points, from the first word of the file.
struct OFFHeader
{
  bool Texture = false;
  bool Colours = false;
  bool Normals = false;
};

/// False if it is not the header of an OFF file with three coordinates. `word` becomes what follows
/// it: ModelNet's files have the number of points there.
bool Parse(std::string_view& word, OFFHeader& header)
{
  const auto take = [&word](std::string_view prefix)
  {
    const bool found = word.substr(0, prefix.size()) == prefix;
    word.remove_prefix(found ? prefix.size() : 0);
    return found;
  };
  header.Texture = take("ST");
  header.Colours = take("C");
  header.Normals = take("N");
  return take("OFF") &&
    std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// `rest`: what follows the header in the same word.
OFFHeader ReadHeader(MeshWords& words, std::string& rest)
{
  OFFHeader header;
  const std::string word(words.Word());
  std::string_view left = word;
  const bool isOFF = Parse(left, header);
  rest = left;
  if (!isOFF)
  {
    words.Reject("an OFF file begins with OFF, COFF, NOFF, CNOFF or ST before one of these, not "
                 "with '" +
      Printable(word.substr(0, 30)) + "'. Files of other dimensions (4OFF, nOFF) are not read.");
  }
  return header;
}

/// One colour: whole numbers are bytes, others shares of 255.
void AppendColour(std::string_view rest, std::vector<std::uint8_t>& colours)
{
  std::array<double, 4> colour{ 255, 255, 255, 255 };
  for (double& value : colour)
  {
    const std::string_view word = NextWord(rest);
    double number = 0;
    if (!IsNumber(word, number))
    {
      break;
    }
    value = word.find('.') == word.npos ? number : number * 255.0;
  }
  for (const double value : colour)
  {
    colours.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)));
  }
}

void ReadPoints(MeshWords& words, const OFFHeader& header, std::int64_t points, CellMesh& mesh)
{
  std::vector<double> normals;
  std::vector<std::uint8_t> colours;
  for (std::int64_t i = 0; i < points; ++i)
  {
    words.Point(mesh.Coordinates);
    if (header.Normals)
    {
      words.Point(normals);
    }
    const std::string rest = words.RestOfLine();
    if (header.Colours)
    {
      AppendColour(rest, colours);
    }
    words.ReportRow(i, 2 * points);
  }
  if (header.Normals)
  {
    mesh.Attributes.push_back({ MeshAttribute::Place::Vertices, "Normals", 3, std::move(normals) });
  }
  if (header.Colours)
  {
    mesh.Attributes.push_back({ MeshAttribute::Place::Vertices, "Colors", 4, std::move(colours) });
  }
}

CellShape FindCellShape(std::int64_t corners)
{
  switch (corners)
  {
    case 1:
      return CellShape::Vertex;
    case 2:
      return CellShape::Line;
    case 3:
      return CellShape::Triangle;
    case 4:
      return CellShape::Quadrilateral;
    default:
      return CellShape::Polygon;
  }
}

void ReadFaces(MeshWords& words, std::int64_t faces, CellMesh& mesh)
{
  const std::int64_t points = mesh.NumberOfPoints();
  for (std::int64_t f = 0; f < faces; ++f)
  {
    const std::int64_t corners = words.Count("the number of a face's vertices");
    if (corners == 0)
    {
      words.Reject(
        "a face has no vertices. Remove the line, and reduce the number of faces by one.");
    }
    for (std::int64_t c = 0; c < corners; ++c)
    {
      mesh.Vertices.push_back(words.Vertex(points, 0));
    }
    mesh.EndCell(FindCellShape(corners));
    words.RestOfLine();
    words.ReportRow(faces + f, 2 * faces);
  }
}

void CheckSurface(const CellMesh& mesh)
{
  for (const CellShape shape : mesh.Shapes)
  {
    if (shape > CellShape::Polygon)
    {
      throw std::invalid_argument("An OFF file holds points, lines and polygons, not volume cells: "
                                  "extract the surface first.");
    }
  }
}

}

CellMesh ReadOFF(const std::string& path, const ProgressCallback& progress)
{
  const auto source = OpenTextSource(path);
  MeshWords words(*source, progress);
  std::string first;
  const OFFHeader header = ReadHeader(words, first);
  // "OFF BINARY" is on one line; the counts may be on it as well.
  first = first.empty() ? words.Word() : first;
  std::int64_t points = 0;
  if (!FromText(first, points))
  {
    words.Reject(first == "BINARY"
        ? std::string("binary OFF files are not read: write it as text.")
        : "the number of points should be an integer, but is '" + Printable(first) + "'.");
  }
  // A point takes three digits and three blanks at least.
  if (points < 0 || static_cast<std::uint64_t>(points) > source->MaximumBytes() / 6)
  {
    words.Reject("the file is too short for " + std::to_string(points) +
      " points. It is truncated or damaged: write or fetch it again.");
  }
  const std::int64_t faces = words.Count("the number of faces", 4);
  words.RestOfLine(); // the number of edges
  CellMesh mesh;
  ReadPoints(words, header, points, mesh);
  ReadFaces(words, faces, mesh);
  words.EndFile(faces, "faces");
  source->CheckEnd();
  return mesh;
}

void WriteOFF(const CellMesh& mesh, const std::string& path, const ProgressCallback& progress)
{
  CheckSurface(mesh);
  const MeshAttribute* normals = mesh.Find(MeshAttribute::Place::Vertices, "Normals");
  const auto* directions = normals && normals->Components == 3
    ? std::get_if<std::vector<double>>(&normals->Values)
    : nullptr;
  TextFileWriter file(path);
  file << (directions ? "NOFF\n" : "OFF\n") << mesh.NumberOfPoints() << " " << mesh.NumberOfCells()
       << " 0\n";
  for (std::size_t i = 0; i < mesh.Coordinates.size(); i += 3)
  {
    file << mesh.Coordinates[i] << " " << mesh.Coordinates[i + 1] << " " << mesh.Coordinates[i + 2];
    for (std::size_t c = 0; directions && c < 3; ++c)
    {
      file << " " << (*directions)[i + c];
    }
    file << "\n";
  }
  Report(progress, 0.5);
  for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
  {
    file << mesh.Offsets[cell + 1] - mesh.Offsets[cell];
    for (auto v = mesh.Offsets[cell]; v < mesh.Offsets[cell + 1]; ++v)
    {
      file << " " << mesh.Vertices[static_cast<std::size_t>(v)];
    }
    file << "\n";
  }
  file.Finish();
  Report(progress, 1.0); // an abort leaves the old file
  file.Replace();
}

bool LooksLikeOFF(const std::string& path)
{
  try
  {
    const auto source = OpenTextSource(path);
    OFFHeader header;
    TextWords words(*source);
    std::string_view word = words.Word();
    return Parse(word, header);
  }
  catch (const ReaderError&)
  {
    return false;
  }
}

}
