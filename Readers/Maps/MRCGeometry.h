/**
 * @file MRCGeometry.h
 * @brief The positions of the voxels of a map in space, and the stacks to which they belong.
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

/// The grouping of the sections of a file.
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
 * .st and .ali (before .gz or .bz2) with ISPG 0 or .mrcs with any other: images. Everything else is
 * one volume, even with ISPG 0, which ChimeraX and cryoSPARC write for volumes. If the number of
 * sections is not a multiple of MZ, a message is added to header.Repairs, and the file is read as
 * one volume.
 */
MRCStack DescribeStack(MRCHeader& header, const std::string& path);

/**
 * The lattice of one volume, whose number of sections (as stored in the file) is `sections`.
 *
 * A step is CELLA / M along the cell's axes: a along x, b in the x-y plane, c with a positive z
 * component. Node 0 lies at ORIGIN (x, y, z, never permuted) if any component of it is not zero,
 * otherwise at NSTART steps (file axes, permuted), but never at the sum of both; this is the rule
 * of ChimeraX. The skew transformation of CCP4, x_map = SKWMAT (x_world - SKWTRN), is applied in
 * addition. With `keepCellAxes`, the angles of the cell are treated as 90 degrees.
 */
VoxelLattice MakeLattice(const MRCHeader& header, int sections, bool keepCellAxes);

/// False if an angle of the cell differs from 90 degrees by more than 0.01.
bool HasOrthogonalCell(const MRCHeader& header);

}

#endif
