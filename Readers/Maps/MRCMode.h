/**
 * @file MRCMode.h
 * @brief What a voxel of each MRC mode is in the file and in memory.
 */
#ifndef isthmus_MRCMode_h
#define isthmus_MRCMode_h

#include <cstddef>
#include <cstdint>

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
 * A voxel type. MRC2014 (doi:10.1016/j.jsb.2015.04.002) and the extensions 16 and 101 of IMOD.
 *
 * | mode | file                       | memory                    |
 * |------|----------------------------|---------------------------|
 * | 0    | 8-bit integer              | signed or unsigned char   |
 * | 1    | 16-bit integer             | short                     |
 * | 2    | 32-bit float               | float                     |
 * | 3    | 2 x 16-bit integer         | short, 2 components       |
 * | 4    | 2 x 32-bit float           | float, 2 components       |
 * | 6    | 16-bit unsigned integer    | unsigned short            |
 * | 12   | 16-bit float (IEEE 754)    | float                     |
 * | 16   | red, green, blue bytes     | unsigned char, 3 components |
 * | 101  | 4-bit integer, low nibble first | unsigned char        |
 */
struct MRCVoxelType
{
  int Mode = 2;
  MRCValue Value = MRCValue::Float;
  int Components = 1;
  int FileBits = 32;     ///< of one voxel
  std::size_t Word = 4;  ///< bytes that a change of byte order reverses together
  std::size_t Bytes = 4; ///< of one voxel in memory

  /// True where file and memory differ at most in byte order.
  bool SameInFile() const { return static_cast<std::size_t>(this->FileBits) == 8 * this->Bytes; }

  /// Bytes of `voxels` voxels of one row in the file; rows of mode 101 end on a whole byte.
  std::uint64_t FileBytes(std::uint64_t voxels) const
  {
    return this->FileBits == 4 ? (voxels + 1) / 2
                               : voxels * static_cast<std::uint64_t>(this->FileBits / 8);
  }
};

bool IsKnownMRCMode(int mode);

/// `unsignedBytes`: mode 0 holds 0..255 (IMOD's flag). @pre IsKnownMRCMode(mode).
MRCVoxelType VoxelTypeOfMRCMode(int mode, bool unsignedBytes);

/**
 * Turns `voxels` voxels from the file's form into memory's; `swap` when the byte orders differ.
 * `from` may be changed. It may be `to` itself where type.SameInFile(), otherwise they must not
 * overlap. For 4-bit voxels `skip` (0 or 1) nibbles of the first byte are left out.
 */
void DecodeMRCVoxels(const MRCVoxelType& type, bool swap, unsigned char* from, void* to,
  std::size_t voxels, std::size_t skip);

}

#endif
