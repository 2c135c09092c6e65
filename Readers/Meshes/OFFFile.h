/**
 * @file OFFFile.h
 * @brief Surfaces in Geomview's Object File Format: vertices, then polygons (.off).
 *
 * Source: Geomview Manual 1.9, "OFF Files". The triangle-mesh file of the thesis ("vertices, then
 * triangles") has this format.
 *
 *     file   = [ST][C][N]"OFF"  POINTS FACES EDGES  point* face*
 *     point  = x y z [nx ny nz] [r g b [a]] [s t]        one a line
 *     face   = SIZE VERTEX* [colour]                     one a line, vertices from 0
 *
 * # begins a comment. EDGES is not used, and may be missing from the line. POINTS may follow OFF
 * without a blank, as in the files of ModelNet.
 */
#ifndef isthmus_OFFFile_h
#define isthmus_OFFFile_h

#include "Core/Progress.h"
#include "Meshes/CellMesh.h"

#include <string>

namespace isthmus
{

/**
 * Reads a file, plain or compressed. Faces of one, two, three, four vertices become vertices,
 * lines, triangles, quadrilaterals, others polygons. N adds the attribute Normals (3 components), C
 * adds Colors (4 bytes for each point; numbers with a decimal point are fractions of 255). Texture
 * coordinates and colours of faces are not read.
 *
 * @throws ReaderError with path, line and reason: no OFF file, a binary one, one of other
 * dimensions (4OFF, nOFF), a vertex that does not exist, a coordinate that is not finite, an early
 * end, anything but comments after the last face. If no line end follows the last number of a
 * file, digits of it may be missing: such a file cannot be distinguished from a whole one. Time and
 * memory: O(bytes).
 */
CellMesh ReadOFF(const std::string& path, const ProgressCallback& progress = {});

/**
 * Writes points and cells up to polygons; when the file is read again, coordinates are bitwise
 * equal. With a point attribute Normals of three components, it is an NOFF file.
 * @throws std::invalid_argument for volume cells, std::runtime_error when the file can't be
 * written.
 */
void WriteOFF(const CellMesh& mesh, const std::string& path, const ProgressCallback& progress = {});

/// Whether the file begins like an OFF file.
bool LooksLikeOFF(const std::string& path);

}

#endif
