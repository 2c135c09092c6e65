/**
 * @file CombinatorialMeshFile.h
 * @brief The file format of the thesis for volume meshes: cell types defined by their faces, then
 * vertex lists.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * 3.3.1.1, 3.3.2.2 and Table 3.3, with coordinates and attributes added. The grammar is in
 * vtkCombinatorialMeshReader.h.
 */
#ifndef isthmus_CombinatorialMeshFile_h
#define isthmus_CombinatorialMeshFile_h

#include "CellComplex/CellType.h"
#include "Core/Progress.h"
#include "Meshes/CellMesh.h"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/// What a file holds. Coordinates are float or double, three for each vertex.
struct CombinatorialMesh
{
  std::int64_t NumberOfVertices = 0;
  NumberList Coordinates = std::vector<double>();
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  std::vector<std::int64_t> CellVertices;
  std::vector<MeshAttribute> Attributes;

  std::int64_t NumberOfCells() const;
};

/**
 * Reads a file's contents. Uses at most a small multiple of the size of the contents as memory.
 * O(size).
 * @throws std::runtime_error with the line (of the header part) and what is wrong.
 */
CombinatorialMesh ParseCombinatorialMesh(std::string_view contents);

/// Writes a mesh; parsing the output gives the same mesh, bit for bit.
/// @throws std::invalid_argument for names with line breaks, Cancelled.
void WriteCombinatorialMesh(const CombinatorialMesh& mesh, bool binary, std::ostream& stream,
  const ProgressCallback& progress = {});

}

#endif
