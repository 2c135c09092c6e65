/**
 * @file MRCVoxels.h
 * @brief Reads the voxels of a box, or every n-th of them, into an array whose axes are x, y, z.
 */
#ifndef isthmus_MRCVoxels_h
#define isthmus_MRCVoxels_h

#include "Core/Progress.h"
#include "Files/ByteSource.h"
#include "Maps/MRCMode.h"
#include "vtkIsthmusReadersMapsModule.h"

#include <array>
#include <cstdint>

namespace isthmus
{

/// How the voxels of one volume lie in a file. File axes: columns (fastest), rows, sections.
struct MRCVoxelLayout
{
  std::uint64_t Offset = 0; ///< of the first voxel
  MRCVoxelType Type;
  bool Swap = false;                             ///< the file's byte order is not this machine's
  std::array<std::int64_t, 3> Counts{ 0, 0, 0 }; ///< file axes
  std::array<int, 3> OutputAxis{ 0, 1, 2 };      ///< of each file axis: 0 x, 1 y, 2 z
};

/// Nodes First, First + Stride, ... (Count of them) along x, y, z.
struct MRCSelection
{
  std::array<std::int64_t, 3> First{ 0, 0, 0 };
  std::array<std::int64_t, 3> Count{ 0, 0, 0 };
  std::array<std::int64_t, 3> Stride{ 1, 1, 1 };
};

/**
 * Fills `out`, x fastest, with the selected voxels as layout.Type has them in memory.
 *
 * @pre the selection lies within the volume and is not empty; `out` has room for it.
 *
 * A
 * plain file is read in bricks by several threads, only where the selection lies; a compressed one
 * from front to back up to the last selected voxel, the next part being decompressed while the one
 * before is decoded. Scratch memory: 1 MiB a thread, or 32 MiB for a compressed file, at least one
 * row.
 * @throws ReaderError (Truncated, Damaged, CannotRead) and Cancelled.
 */
VTKISTHMUSREADERSMAPS_EXPORT void ReadMRCVoxels(ByteSource& source, const MRCVoxelLayout& layout,
  const MRCSelection& selection, void* out, const ProgressCallback& progress);

}

#endif
