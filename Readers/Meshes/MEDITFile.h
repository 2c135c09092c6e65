/**
 * @file MEDITFile.h
 * @brief Meshes in MEDIT's text format (.mesh), which Gmsh, Mmg, CGAL and TetWild write.
 *
 * Source: P. Frey, MEDIT: an interactive mesh visualization software, INRIA RT-0253 (2001).
 *
 *     file    = "MeshVersionFormatted" V "Dimension" D section* "End"
 *     section = "Vertices" N (x y [z] reference)* | KIND N (vertex* reference)* | other
 *     KIND    = Edges | Triangles | Quadrilaterals | Tetrahedra | Pyramids | Prisms | Hexahedra
 *             | EdgesP2 | TrianglesP2 | QuadrilateralsQ2 | TetrahedraP2 | PrismsP2 | HexahedraQ2
 *
 * D is 3, or 2, in which case z is 0. Vertices are numbered from 1 and may come after the cells.
 * Quadratic cells are read with all nodes, in VTK's order (MiddleNodes.h); those that VTK lacks
 * (P3, PyramidsP2) are dropped with a warning. Other sections (corners, ridges, normals, ...) are
 * skipped. # begins a comment. Files without End are read, with a warning: some programs do not
 * write it, but a truncated file has none, either.
 */
#ifndef isthmus_MEDITFile_h
#define isthmus_MEDITFile_h

#include "Core/Progress.h"
#include "Meshes/CellMesh.h"

#include <string>

namespace isthmus
{

/**
 * Reads points and cells in the order of their sections, with the attribute `Reference` (int64) on
 * both. @throws ReaderError with path, line and reason: the file is not MEDIT text (MFEM and Netgen
 * also use .mesh; .meshb is binary), a vertex does not exist, or the file ends within a section or
 * before its vertices. Time and
 * memory: O(bytes).
 */
CellMesh ReadMEDIT(const std::string& path, const ProgressCallback& progress = {});

/**
 * Writes points and cells, by kind, with Reference attributes of one int64 component, or 0 without
 * them. When the file is read again, coordinates are bitwise equal and cells of a kind are in the
 * same order.
 * @throws std::invalid_argument for polygons and quadratic cells, std::runtime_error when the file
 * can't be written.
 */
void WriteMEDIT(
  const CellMesh& mesh, const std::string& path, const ProgressCallback& progress = {});

/// Whether the file begins with MEDIT's first word, or like its binary format, which ReadMEDIT
/// refuses by name.
bool LooksLikeMEDIT(const std::string& path);

}

#endif
