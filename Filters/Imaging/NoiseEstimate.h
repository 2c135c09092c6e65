/**
 * @file NoiseEstimate.h
 * @brief The noise level of a volume, independent of its content.
 */
#ifndef isthmus_NoiseEstimate_h
#define isthmus_NoiseEstimate_h

#include "Imaging/DiffusionGrid.h"
#include "vtkIsthmusFiltersImagingModule.h"

namespace isthmus
{

struct NoiseEstimate
{
  double Noise = 0.0;     ///< standard deviation of the noise, in the data's unit
  double Deviation = 0.0; ///< standard deviation of the values that count
  double Counted = 0.0;   ///< share of the nodes that count: those that show noise
  bool FewValues = false; ///< a mask or labels: at most 32 values among those that count
};

/**
 * Standard deviation of white noise from the median absolute pseudo-residual.
 *
 * The pseudo-residual of a node is its value minus the mean of its six neighbours (T. Gasser, L.
 * Sroka, C. Jennen-Steinmetz, Biometrika 73 (1986) 625, in three dimensions); its median absolute
 * value over the grid is insensitive to edges, which are rare. For normal noise it is 0.6745
 * sqrt(7/6) standard deviations. Low-pass filtered noise is underestimated.
 *
 * Nodes that have the same value as three or more of their neighbours show no noise, for example in
 * a background that was masked or padded with one value (and its border), or in a constant volume.
 * They are not counted, neither here nor in the deviation, so that a map is as noisy as its part
 * within the mask. A mask itself, or an image of labels, has edges in the remaining nodes but no
 * noise; then Noise is 0.
 *
 * @pre `values` are finite, their halo valid.
 *
 * The median has a relative accuracy of 1e-4. The time is that of five passes and of a search for
 * more than 32 different values, which ends soon in a map.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT NoiseEstimate EstimateNoise(
  const DiffusionGrid<T>& grid, const T* values);

/// A gradient, in data units per length, that noise alone rarely reaches; 1 for an image without
/// noise. `voxel` is the grid spacing.
VTKISTHMUSFILTERSIMAGING_EXPORT double NoiseGradient(const NoiseEstimate& noise, double voxel);

}

#endif
