#include "Meshes/MEDITFile.h"

#include "Core/PrintableText.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Files/TextFileWriter.h"
#include "Meshes/MeshWords.h"
#include "Meshes/MiddleNodes.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace isthmus
{
namespace
{

using Place = MeshAttribute::Place;

constexpr std::string_view firstWord = "MeshVersionFormatted";

/// The sections that hold cells.
struct Kind
{
  std::string_view Name;
  CellShape Shape;
};
constexpr std::array<Kind, 7> kinds{ Kind{ "Edges", CellShape::Line },
  Kind{ "Triangles", CellShape::Triangle }, Kind{ "Quadrilaterals", CellShape::Quadrilateral },
  Kind{ "Tetrahedra", CellShape::Tetrahedron }, Kind{ "Pyramids", CellShape::Pyramid },
  Kind{ "Prisms", CellShape::Wedge }, Kind{ "Hexahedra", CellShape::Hexahedron } };

/// Cells with nodes on their edges, faces and in their middle, which are read and not written.
constexpr std::array<Kind, 6> quadraticKinds{ Kind{ "EdgesP2", CellShape::QuadraticEdge },
  Kind{ "TrianglesP2", CellShape::QuadraticTriangle },
  Kind{ "QuadrilateralsQ2", CellShape::BiquadraticQuadrilateral },
  Kind{ "TetrahedraP2", CellShape::QuadraticTetrahedron },
  Kind{ "PrismsP2", CellShape::BiquadraticWedge },
  Kind{ "HexahedraQ2", CellShape::TriquadraticHexahedron } };

/// Null if the section does not contain cells, or cells of an unsupported kind.
const Kind* FindKind(std::string_view name)
{
  const auto isIt = [name](const Kind& known) { return known.Name == name; };
  const auto* linear = std::find_if(kinds.begin(), kinds.end(), isIt);
  const auto* quadratic = std::find_if(quadraticKinds.begin(), quadraticKinds.end(), isIt);
  return linear != kinds.end() ? linear : quadratic != quadraticKinds.end() ? quadratic : nullptr;
}

/// Whether these are cells of a higher order ("TetrahedraP3", "PyramidsP2")?
bool IsOfHigherOrder(std::string_view name)
{
  return std::any_of(kinds.begin(), kinds.end(),
    [name](const Kind& kind)
    {
      const std::size_t size = kind.Name.size();
      return name.size() == size + 2 && name.substr(0, size) == kind.Name &&
        (name[size] == 'P' || name[size] == 'Q') &&
        std::isdigit(static_cast<unsigned char>(name[size + 1])) != 0;
    });
}

bool BeginsSection(const std::string& word)
{
  return !word.empty() && std::isalpha(static_cast<unsigned char>(word[0]));
}

/// Gathers a file's sections.
class Reading
{
public:
  Reading(ByteSource& source, const ProgressCallback& progress)
    : Words(source, progress)
  {
  }

  CellMesh Read()
  {
    this->ReadHeader();
    std::string word(this->Words.Word());
    while (!word.empty() && word != "End")
    {
      word = this->ReadSection(word);
    }
    this->CheckEnd(!word.empty());
    this->CheckVertices();
    for (const auto& [first, last] : this->Sections)
    {
      OrderMiddleNodes(this->Mesh, first, last);
    }
    this->Mesh.Attributes.push_back(
      { Place::Vertices, "Reference", 1, std::move(this->PointReferences) });
    this->Mesh.Attributes.push_back(
      { Place::Cells, "Reference", 1, std::move(this->CellReferences) });
    return std::move(this->Mesh);
  }

private:
  /// Sections are not counted: without End, none of them needs to be the last one.
  void CheckEnd(bool hasEnd)
  {
    if (hasEnd)
    {
      return;
    }
    if (!this->HasVertices)
    {
      this->Words.RejectEnd("its vertices");
    }
    this->Mesh.Warnings.push_back(
      "The file has no End: it may be truncated, within its last number "
      "or before further sections. Compare the numbers of cells, or "
      "write the file again.");
  }

  void ReadHeader()
  {
    const std::string word(this->Words.Word());
    if (word != firstWord)
    {
      this->Words.Reject("a MEDIT mesh begins with MeshVersionFormatted, not with '" +
        Printable(word.substr(0, 30)) +
        "'. Other programs (MFEM, Netgen) use .mesh for formats of their own: export it as MEDIT.");
    }
    this->Words.Whole("the version");
  }

  /// Returns the word that begins the next one.
  std::string ReadSection(const std::string& name)
  {
    const Kind* kind = FindKind(name);
    if (name == "Dimension")
    {
      this->ReadDimension();
    }
    else if (name == "Vertices")
    {
      this->ReadPoints();
    }
    else if (kind)
    {
      this->ReadCells(*kind);
    }
    else if (BeginsSection(name))
    {
      return this->SkipSection(name);
    }
    else
    {
      this->Words.Reject("a section should begin where '" + Printable(name.substr(0, 30)) +
        "' is: the one before has more rows than it declares, or the file is damaged.");
    }
    return std::string(this->Words.Word());
  }

  void ReadDimension()
  {
    this->Dimension = this->Words.Whole("the dimension");
    if (this->Dimension != 2 && this->Dimension != 3)
    {
      this->Words.Reject("the dimension is " + std::to_string(this->Dimension) +
        "; MEDIT meshes have two or three. The file is damaged: write or fetch it again.");
    }
    if (!this->Mesh.Coordinates.empty())
    {
      this->Words.Reject("the dimension comes after the vertices. Move it before them.");
    }
  }

  std::string SkipSection(const std::string& name)
  {
    std::string word(this->Words.Word());
    if (word.empty())
    {
      this->Words.RejectEnd("the rows of its last section");
    }
    if (IsOfHigherOrder(name) && word != "0")
    {
      this->Mesh.Warnings.push_back("The section " + name + " (" + Printable(word.substr(0, 20)) +
        " cells) was dropped: VTK has no such cell. Export the mesh with linear or quadratic "
        "cells.");
    }
    while (!word.empty() && !BeginsSection(word))
    {
      word = this->Words.Word();
    }
    return word;
  }

  void ReadPoints()
  {
    if (!this->Mesh.Coordinates.empty())
    {
      this->Words.Reject("Vertices occurs twice: the file contains more than one mesh.");
    }
    this->HasVertices = true;
    const std::int64_t points = this->Words.Count("the number of vertices", 6);
    for (std::int64_t i = 0; i < points; ++i)
    {
      for (std::int64_t c = 0; c < 3; ++c)
      {
        this->Mesh.Coordinates.push_back(c < this->Dimension ? this->Words.Coordinate() : 0.0);
      }
      this->PointReferences.push_back(this->Words.Whole("the reference of a vertex"));
      this->Words.ReportRow(i, points);
    }
  }

  void ReadCells(const Kind& kind)
  {
    const std::int64_t size = VerticesOfShape[static_cast<std::size_t>(kind.Shape)];
    const std::int64_t cells =
      this->Words.Count(kind.Name.data(), static_cast<std::uint64_t>(2 * size));
    // Vertices may come later; then the largest number is checked at the end.
    const std::int64_t points = this->Mesh.Coordinates.empty()
      ? std::numeric_limits<std::int64_t>::max() - 1
      : this->Mesh.NumberOfPoints();
    const auto before = static_cast<std::size_t>(this->Mesh.NumberOfCells());
    for (std::int64_t i = 0; i < cells; ++i)
    {
      for (std::int64_t c = 0; c < size; ++c)
      {
        this->Mesh.Vertices.push_back(this->Words.Vertex(points, 1));
      }
      this->Mesh.EndCell(kind.Shape);
      this->CellReferences.push_back(this->Words.Whole("the reference of a cell"));
      this->Words.ReportRow(i, cells);
    }
    this->Sections.emplace_back(before, static_cast<std::size_t>(this->Mesh.NumberOfCells()));
  }

  void CheckVertices()
  {
    const auto& vertices = this->Mesh.Vertices;
    const auto largest = std::max_element(vertices.begin(), vertices.end());
    if (largest != vertices.end() && *largest >= this->Mesh.NumberOfPoints())
    {
      this->Words.Reject("vertex " + std::to_string(*largest + 1) + " is named, but there are " +
        std::to_string(this->Mesh.NumberOfPoints()) + ". The file is truncated or damaged.");
    }
  }

  MeshWords Words;
  CellMesh Mesh;
  std::int64_t Dimension = 3;
  bool HasVertices = false;
  std::vector<std::int64_t> PointReferences;
  std::vector<std::int64_t> CellReferences;
  std::vector<std::pair<std::size_t, std::size_t>> Sections; ///< of cells: first, last + 1
};

/// A 1 of 32 bits in either byte order, and a version from 1 to 4.
bool IsBinary(ByteSource& source)
{
  std::array<unsigned char, 8> begin{};
  if (source.Read(0, begin.data(), begin.size()) < begin.size())
  {
    return false;
  }
  const auto isSmall = [&begin](std::size_t at, unsigned most)
  {
    const bool little = begin[at] >= 1 && begin[at] <= most && begin[at + 3] == 0;
    const bool big = begin[at + 3] >= 1 && begin[at + 3] <= most && begin[at] == 0;
    return (little || big) && begin[at + 1] == 0 && begin[at + 2] == 0;
  };
  return isSmall(0, 1) && isSmall(4, 4);
}

const std::vector<std::int64_t>* References(const CellMesh& mesh, Place on)
{
  const MeshAttribute* found = mesh.Find(on, "Reference");
  return found && found->Components == 1 ? std::get_if<std::vector<std::int64_t>>(&found->Values)
                                         : nullptr;
}

void CheckShapes(const CellMesh& mesh)
{
  for (const CellShape shape : mesh.Shapes)
  {
    const bool known = std::any_of(
      kinds.begin(), kinds.end(), [shape](const Kind& kind) { return kind.Shape == shape; });
    if (!known)
    {
      throw std::invalid_argument(
        "A MEDIT mesh holds edges, triangles, quadrilaterals, tetrahedra, "
        "pyramids, prisms and hexahedra: triangulate other cells first.");
    }
  }
}

void WriteCells(const CellMesh& mesh, const Kind& kind, TextFileWriter& file)
{
  const auto count = std::count(mesh.Shapes.begin(), mesh.Shapes.end(), kind.Shape);
  if (count == 0)
  {
    return;
  }
  const auto* references = References(mesh, Place::Cells);
  file << kind.Name << "\n" << static_cast<std::int64_t>(count) << "\n";
  for (std::size_t cell = 0; cell < mesh.Shapes.size(); ++cell)
  {
    if (mesh.Shapes[cell] != kind.Shape)
    {
      continue;
    }
    for (auto v = mesh.Offsets[cell]; v < mesh.Offsets[cell + 1]; ++v)
    {
      file << mesh.Vertices[static_cast<std::size_t>(v)] + 1 << " ";
    }
    file << (references ? (*references)[cell] : 0) << "\n";
  }
}

}

CellMesh ReadMEDIT(const std::string& path, const ProgressCallback& progress)
{
  const auto source = OpenTextSource(path);
  if (IsBinary(*source))
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path +
        ": this is MEDIT's binary format (.meshb), which is not read. Convert it to text, e.g. by "
        "'meshio convert FILE.meshb FILE.mesh'.");
  }
  CellMesh mesh = Reading(*source, progress).Read();
  source->CheckEnd();
  return mesh;
}

void WriteMEDIT(const CellMesh& mesh, const std::string& path, const ProgressCallback& progress)
{
  CheckShapes(mesh);
  const auto* references = References(mesh, Place::Vertices);
  TextFileWriter file(path);
  file << firstWord << " 2\nDimension 3\nVertices\n" << mesh.NumberOfPoints() << "\n";
  for (std::size_t i = 0; i < mesh.Coordinates.size() / 3; ++i)
  {
    const double* p = mesh.Coordinates.data() + 3 * i;
    file << p[0] << " " << p[1] << " " << p[2] << " " << (references ? (*references)[i] : 0)
         << "\n";
  }
  Report(progress, 0.4);
  for (const Kind& kind : kinds)
  {
    WriteCells(mesh, kind, file);
  }
  file << "End\n";
  file.Finish();
  Report(progress, 1.0); // an abort leaves the old file
  file.Replace();
}

bool LooksLikeMEDIT(const std::string& path)
{
  try
  {
    const auto source = OpenTextSource(path);
    return IsBinary(*source) || TextWords(*source).Word() == firstWord;
  }
  catch (const ReaderError&)
  {
    return false;
  }
}

}
