/**
 * @file TetGenMeshFile.h
 * @brief Meshes in the format of TetGen: points in .node, tetrahedra in .ele, triangles in .face.
 *
 * Source: H. Si, TetGen user's manual 1.5, section 5.2. Each file is a line of counts, then a row
 * for each item; the first number of a row is its index, counted from 0 or 1 as in the first row of
 * .node.
 *
 *     .node  POINTS 3 ATTRIBUTES MARKERS(0|1)       id x y z attribute* [marker]
 *     .ele   TETRAHEDRA CORNERS(4|10) ATTRIBUTES    id vertex* attribute*
 *     .face  TRIANGLES MARKERS(0|1)                 id v1 v2 v3 [m1 m2 m3] [marker] [n1 n2]
 *
 * m1 to m3 are the middles of the edges, with TetGen's -o2; n1 and n2 neighbours, with -nn.
 */
#ifndef isthmus_TetGenMeshFile_h
#define isthmus_TetGenMeshFile_h

#include "Core/Progress.h"
#include "Meshes/CellMesh.h"

#include <string>

namespace isthmus
{

/**
 * Reads the points of NAME.node and the contents of the given file: tetrahedra of .ele (with ten
 * corners: QuadraticTetrahedron), triangles of .face (with -o2: QuadraticTriangle), or only the
 * points of .node. Attributes: `Attribute` (double, on points or cells), `BoundaryMarker` (int64).
 *
 * @throws ReaderError with path, line and reason: a partner that is missing, points of two
 * dimensions, a vertex that does not exist, ids out of order, an early end, anything but comments
 * after the last row. If no line end follows the last number of a file, digits of it may be
 * missing: such a file cannot be distinguished from a whole one. Time and memory: O(bytes).
 */
CellMesh ReadTetGenFiles(const std::string& path, const ProgressCallback& progress = {});

/**
 * Writes NAME.node, NAME.ele if there are tetrahedra, and NAME.face if there are triangles, with
 * ids from 1. When the files are read again, coordinates and the attributes named above are bitwise
 * equal. An old NAME.ele or NAME.face of TetGen's that is not written is removed when all others
 * are complete, since its cells would be read with the new points.
 * @throws std::invalid_argument for other cells, or tetrahedra of both orders;
 * std::runtime_error if a file cannot be written.
 */
void WriteTetGenFiles(
  const CellMesh& mesh, const std::string& path, const ProgressCallback& progress = {});

/// Whether the file begins with such a line of counts.
bool LooksLikeTetGen(const std::string& path);

}

#endif
