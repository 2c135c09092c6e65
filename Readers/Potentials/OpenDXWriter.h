/**
 * @file OpenDXWriter.h
 * @brief Writes values on a regular grid as an OpenDX file, as plain text or gzip-compressed.
 */
#ifndef isthmus_OpenDXWriter_h
#define isthmus_OpenDXWriter_h

#include "Core/Progress.h"
#include "Files/VoxelLattice.h"

#include <string>
#include <vector>

namespace isthmus
{

/// Header and trailer around the values in the file.
struct OpenDXLabels
{
  std::string FieldName;
  std::vector<std::string> Comments;
};

/**
 * Writes `values` (components for each node of `grid`, x fastest; T float or double) to `path`;
 * gzip-compressed if the path ends in .gz. Each number, including those of the grid, is written
 * with the fewest digits that are read back bit for bit.
 *
 * Time: O(numbers). Memory: 1 MiB.
 * @throws std::runtime_error if the file cannot be written completely, and Cancelled; in both cases
 * no file is left.
 */
template <typename T>
void WriteOpenDX(const std::string& path, const VoxelLattice& grid, const T* values, int components,
  const OpenDXLabels& labels, const ProgressCallback& progress);

}

#endif
