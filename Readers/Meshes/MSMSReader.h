/**
 * @file MSMSReader.h
 * @brief Reads molecular surfaces of the program MSMS: pairs of .vert and .face files.
 *
 * Format: M. F. Sanner, A. J. Olson, J.-C. Spehner, Biopolymers 38 (1996) 305, and the manual of
 * MSMS 2.6. Lines that begin with # are comments; a line of counts (four numbers) may come first. A
 * vertex is x y z nx ny nz face sphere type [atom], a face v1 v2 v3 type face, ids from 1.
 */
#ifndef isthmus_MSMSReader_h
#define isthmus_MSMSReader_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace isthmus
{

/// One or more surfaces, one after the other. Lengths are in angstrom; ids start at 0.
struct MSMSSurface
{
  std::vector<std::array<double, 3>> Points;
  std::vector<std::array<double, 3>> Normals; ///< as in the file: away from the molecule
  std::vector<int> AnalyticFaceOfPoint;       ///< as in the file; 0: none
  std::vector<int> SphereOfPoint;             ///< nearest atom, from 0 in the order of MSMS' input
  std::vector<int>
    TypeOfPoint; ///< 1 of a toric face, 2 within a reentrant, 3 within a contact face
  std::vector<Triangle> Triangles;
  std::vector<int> TypeOfTriangle; ///< 1 toric, 2 spheric reentrant, 3 contact
  std::vector<int> AnalyticFaceOfTriangle;
  std::vector<int> ComponentOfTriangle; ///< number of the file pair: 0 the one named, 1, 2, ...
};

/**
 * Appends the surface in `file` (either file of a pair) and its partner to `surface`. O(bytes).
 * @throws std::runtime_error with file, line and reason if one of them is missing, is not a regular
 * file, is not as described above, or has fewer rows than its line of counts states.
 */
void ReadMSMS(const std::filesystem::path& file, int component, MSMSSurface& surface,
  const ProgressCallback& progress = {});

/// The pairs that belong together: `file`, then X_1, X_2, ..., as long as they exist.
std::vector<std::filesystem::path> MSMSComponents(const std::filesystem::path& file);

/// Whether the file begins like a .vert or .face file of MSMS.
bool LooksLikeMSMS(const std::filesystem::path& file);

}

#endif
