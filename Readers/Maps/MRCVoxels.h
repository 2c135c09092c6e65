/**
 * @file MRCVoxels.h
 * @brief Voxel types of an MRC file, and reading a box of voxels into an array with axes x, y, z.
 */
#ifndef isthmus_MRCVoxels_h
#define isthmus_MRCVoxels_h

#include "Core/Progress.h"
#include "Files/ByteSource.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace isthmus
{

enum class MRCValue
{
  SignedChar,
  UnsignedChar,
  Short,
  UnsignedShort,
  Float
};

/**
 * A voxel type, given by its mode, in the file and in memory. MRC2014
 * (doi:10.1016/j.jsb.2015.04.002) and the extensions 16 and 101 of IMOD.
 *
 * - 0: 8-bit integer; in memory signed or unsigned char
 * - 1: 16-bit integer; short
 * - 2: 32-bit float; float
 * - 3: two 16-bit integers; short, 2 components
 * - 4: two 32-bit floats; float, 2 components
 * - 6: 16-bit unsigned integer; unsigned short
 * - 12: 16-bit float (IEEE 754); float
 * - 16: red, green, blue bytes; unsigned char, 3 components
 * - 101: 4-bit integer, low nibble first; unsigned char
 */
struct MRCVoxelType
{
  int Mode = 2;
  MRCValue Value = MRCValue::Float;
  int Components = 1;
  int FileBits = 32;     ///< of one voxel
  std::size_t Word = 4;  ///< bytes that a change of byte order reverses together
  std::size_t Bytes = 4; ///< of one voxel in memory

  /// True if the file and memory formats differ at most in byte order.
  bool SameInFile() const { return static_cast<std::size_t>(this->FileBits) == 8 * this->Bytes; }

  /// Number of bytes of this number of voxels of one row in the file; rows of mode 101 end on a
  /// whole byte.
  std::uint64_t FileBytes(std::uint64_t voxels) const
  {
    return this->FileBits == 4 ? (voxels + 1) / 2
                               : voxels * static_cast<std::uint64_t>(this->FileBits / 8);
  }
};

bool IsKnownMRCMode(int mode);

/// `unsignedBytes`: mode 0 holds 0..255 (IMOD's flag). @pre IsKnownMRCMode(mode).
MRCVoxelType VoxelTypeFromMRCMode(int mode, bool unsignedBytes);

/**
 * Converts this number of voxels from the file format to the memory format; `swap` states whether
 * the byte orders differ. `from` may be changed. Both buffers may be the same if type.SameInFile(),
 * otherwise they must not overlap. For 4-bit voxels, `skip` (0 or 1) nibbles of the first byte are
 * skipped.
 */
void DecodeMRCVoxels(const MRCVoxelType& type, bool swap, unsigned char* from, void* to,
  std::size_t voxels, std::size_t skip);

/// The layout of the voxels of one volume in a file. File axes: columns (fastest), rows, sections.
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
 * Fills `out`, with x varying fastest, with the selected voxels in the memory format of
 * `layout.Type`.
 *
 * @pre the selection lies within the volume and is not empty; `out` has room for it.
 *
 * A plain file is read in bricks by several threads, only within the selection. A compressed file
 * is read from front to back up to the last selected voxel; the next part is decompressed while the
 * previous one is decoded. Scratch memory: 1 MiB for each thread, or 32 MiB for a compressed file,
 * and at least one row.
 * @throws ReaderError (Truncated, Damaged, CannotRead) and Cancelled.
 */
void ReadMRCVoxels(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
  void* out, const ProgressCallback& progress);

/**
 * Fills `out` with the means of all voxels from First on in boxes of Stride, of which Count along
 * each axis. Voxels of the value `ignored` do not count; where there are no others, it is the mean.
 *
 * @pre one component; the boxes lie within the volume; `out` has room for their means.
 *
 * Plain files are read by several threads, compressed ones from front to back. Scratch memory:
 * 2 MiB for each thread and 12 bytes for each mean of a section (those of a few rows for plain
 * files). Bitwise the same for any part of the boxes and number of threads.
 * @throws as ReadMRCVoxels.
 */
void ReadMRCMeans(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
  const std::optional<double>& ignored, float* out, const ProgressCallback& progress);

}

#endif
