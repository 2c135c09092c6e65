#include "Meshes/CombinatorialMeshFile.h"

#include "Files/NumberTypes.h"

#include <ostream>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Writes blocks of numbers as text or as bytes.
class Printer
{
public:
  Printer(std::ostream& stream, bool binary)
    : Stream(stream)
    , Binary(binary)
  {
  }

  /// `perLine` numbers a line of text.
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
    }
  }

private:
  template <typename T>
  void Bytes(const T* values, std::size_t count)
  {
    constexpr std::size_t piece = 4096;
    std::array<T, piece> swapped;
    for (std::size_t first = 0; first < count; first += piece)
    {
      const std::size_t size = std::min(piece, count - first);
      std::copy_n(values + first, size, swapped.begin());
      SwapToLittleEndian(swapped.data(), size);
      this->Stream.write(reinterpret_cast<const char*>(swapped.data()),
        static_cast<std::streamsize>(size * sizeof(T)));
    }
    this->Stream << '\n';
  }

  std::ostream& Stream;
  bool Binary;
};

/// A name that the reader gives back as it is.
const std::string& Checked(const std::string& name)
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
           << Checked(type.Name()) << '\n';
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

}

void WriteCombinatorialMesh(const CombinatorialMesh& mesh, bool binary, std::ostream& stream)
{
  Printer printer(stream, binary);
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
           << Checked(attribute.Name) << '\n';
    std::visit(
      [&](const auto& values) {
        printer.Numbers(
          values.data(), values.size(), static_cast<std::size_t>(attribute.Components));
      },
      attribute.Values);
  }
  stream << "end\n";
}

}
