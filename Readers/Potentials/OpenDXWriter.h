/**
 * @file OpenDXWriter.h
 * @brief Values on a regular grid as an OpenDX file, plain text or gzip-compressed.
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
 * gzip-compressed where the path ends in .gz. Each number has the fewest digits that are read back
 * bit for bit, the grid's numbers too.
 *
 * Time: about 0.1 us a number, gzip 1 us. Memory: 1 MiB.
 * @throws std::runtime_error when the file can't be written to its end, and Cancelled; either
 * leaves no file behind.
 */
template <typename T>
void WriteOpenDX(const std::string& path, const VoxelLattice& grid, const T* values, int components,
  const OpenDXLabels& labels, const ProgressCallback& progress);

}

#endif
