/**
 * @file MRCOptions.h
 * @brief The part of a map to read, and options for reading it.
 */
#ifndef isthmus_MRCOptions_h
#define isthmus_MRCOptions_h

#include <array>

namespace isthmus
{

/// Treatment of a cell whose angles are not 90 degrees.
enum class NonOrthogonalCell
{
  Resample = 0,    ///< to an orthogonal grid
  KeepCellAxes = 1 ///< its nodes are used with right angles, which distorts the shape
};

struct MRCOptions
{
  /// Index of the volume or image in a stack, from 0. With -1, all images of an image stack are
  /// read, one above the other along the section axis, or the first volume.
  int VolumeIndex = -1;
  /// First and last node along x, y, z of the volume as stored; a last node of -1 is the end.
  std::array<int, 6> CropExtent{ 0, -1, 0, -1, 0, -1 };
  /// Means of n nodes along x, y, z, from the first of the crop, as floats; every n-th node of
  /// voxels of several components. A rest of less than n nodes is not read.
  std::array<int, 3> SampleRate{ 1, 1, 1 };
  isthmus::NonOrthogonalCell NonOrthogonalCell = isthmus::NonOrthogonalCell::Resample;
};

}

#endif
