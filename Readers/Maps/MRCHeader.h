/**
 * @file MRCHeader.h
 * @brief The 1024 bytes at the head of an MRC2014, CCP4 or EMDB map, read tolerantly.
 *
 * Sources: Cheng et al. 2015, doi:10.1016/j.jsb.2015.04.002 (MRC2014); the CCP4 map format
 * (maplib); IMOD's mrc_format for the signed-byte flag and modes 16 and 101.
 */
#ifndef isthmus_MRCHeader_h
#define isthmus_MRCHeader_h

#include "Files/VoxelLattice.h"
#include "Maps/MRCVoxels.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

constexpr std::size_t mrcHeaderBytes = 1024;
using MRCHeaderBytes = std::array<unsigned char, mrcHeaderBytes>;

/**
 * The header after repair: every value can be used without further checks.
 *
 * "File axes" are columns (fastest), rows, sections; "x, y, z" are the axes of the cell. Lengths
 * are in angstrom, angles in degrees.
 */
struct MRCHeader
{
  bool BigEndian = false;
  bool HasMapWord = false; ///< "MAP " at byte 208
  MRCVoxelType Voxel;
  std::array<int, 3> Counts{ 0, 0, 0 };                 ///< NX NY NZ, file axes; positive
  std::array<int, 3> Start{ 0, 0, 0 };                  ///< NXSTART.., file axes
  std::array<int, 3> Sampling{ 1, 1, 1 };               ///< MX MY MZ, x, y, z; positive
  std::array<double, 3> CellLengths{ 1.0, 1.0, 1.0 };   ///< x, y, z; positive
  std::array<double, 3> CellAngles{ 90.0, 90.0, 90.0 }; ///< alpha, beta, gamma
  std::array<int, 3> AxisOrder{ 1, 2, 3 }; ///< MAPC MAPR MAPS: a permutation of 1, 2, 3
  double Minimum = 0.0; ///< DMIN, DMAX, DMEAN, RMS as recorded, which need not be true or finite
  double Maximum = 0.0;
  double Mean = 0.0;
  double Rms = 0.0;
  int SpaceGroup = 0;                            ///< ISPG
  std::int64_t ExtendedHeaderBytes = 0;          ///< NSYMBT
  std::string ExtendedHeaderType;                ///< EXTTYP, where printable
  int Version = 0;                               ///< NVERSION
  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 }; ///< ORIGIN, x, y, z; zero when not set
  bool Skewed = false; ///< LSKFLG is 1 and SKWMAT a rotation; x_map = SKWMAT (x_world - SKWTRN)
  Matrix3 SkewMatrix{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }; ///< SKWMAT, rows
  std::array<double, 3> SkewTranslation{ 0.0, 0.0, 0.0 };
  std::vector<std::string> Labels;
  std::vector<std::string> Repairs; ///< one message for each invalid value

  /// Bytes of all voxels.
  std::uint64_t DataBytes() const;
  /// Bytes from the beginning of the file to the end of the last voxel.
  std::uint64_t FileBytes() const;
};

/**
 * Decodes `bytes`. The byte order is that of the machine stamp unless the header makes sense only
 * in the other byte order. Fields that are out of bounds are replaced; for each one, a message is
 * added to Repairs.
 *
 * `path` is for the messages. `contentBytes` is an upper bound of the content's size; when it is
 * `exact`, a content that is shorter than the header describes is an error, a longer one a repair.
 * @throws ReaderError: ForeignFormat when mode or grid make no sense in either order, Truncated.
 */
MRCHeader ParseMRCHeader(
  const MRCHeaderBytes& bytes, const std::string& path, std::uint64_t contentBytes, bool exact);

/**
 * True if `bytes` are certainly or probably the header of a map: grid and mode make sense, and
 * there is "MAP " or all other fields make sense as well. Never throws.
 */
bool LooksLikeMRCHeader(const MRCHeaderBytes& bytes, std::uint64_t contentBytes);

}

#endif
