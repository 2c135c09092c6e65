/**
 * @file MRCGeometry.h
 * @brief Where the voxels of a map lie in space, and which of them belong together.
 *
 * Output axes are always x, y, z: file axis f (0 columns, 1 rows, 2 sections) runs along output
 * axis AxisOrder[f] - 1. Lengths are in angstrom.
 */
#ifndef isthmus_MRCGeometry_h
#define isthmus_MRCGeometry_h

#include "Files/VoxelLattice.h"
#include "Maps/MRCHeader.h"

#include <string>

namespace isthmus
{

/// How the sections of a file belong together.
struct MRCStack
{
  enum class Kind
  {
    None,   ///< one volume
    Images, ///< images, one section each
    Volumes ///< volumes of SectionsEach sections
  };
  Kind What = Kind::None;
  int Items = 1;
  int SectionsEach = 1;
};

/**
 * ISPG 401-630: volumes of MZ sections each. ISPG 0 with MZ = 1, and the file name endings .mrcs,
 * .st and .ali (before .gz or .bz2) with ISPG 0 or .mrcs with any other: images. All else is one
 * volume, also with ISPG 0, which ChimeraX and cryoSPARC write for volumes.
 * A number of sections that is no multiple of MZ adds to header.Repairs and is one volume.
 */
MRCStack StackOf(MRCHeader& header, const std::string& path);

/**
 * The lattice of one volume of `sections` sections (as they lie in the file).
 *
 * A step is CELLA / M along the cell's axes: a along x, b in the x-y plane, c with a positive z
 * component. Node 0 lies at ORIGIN (x, y, z, never permuted) when any component of it is not zero,
 * else at NSTART steps (file axes, permuted): never both, as ChimeraX does. The skew transformation
 * of CCP4, x_map = SKWMAT (x_world - SKWTRN), comes on top.
 * `keepCellAxes`: the cell's angles are taken as 90 degrees.
 */
VoxelLattice LatticeOf(const MRCHeader& header, int sections, bool keepCellAxes);

/// False when an angle of the cell is off 90 degrees by more than 0.01.
bool HasOrthogonalCell(const MRCHeader& header);

}

#endif
