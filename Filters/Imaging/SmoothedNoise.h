/**
 * @file SmoothedNoise.h
 * @brief Finds noise with a Gaussian correlation even in blocks that contain signal.
 *
 * White noise that was smoothed by a Gaussian of standard deviation sigma, as by interpolation, by
 * a low-pass filter or by a detector, has the spectral density A exp(-sigma^2 |omega|^2). Signal
 * lies above it in some blocks and at some frequencies, mostly in long waves; noise is the same in
 * all blocks. So sigma and A are those that explain the most bins of frequency, over a quarter of
 * the blocks at least, and are exceeded, but not undercut, in the others: the minimum statistics of
 * R. Martin, IEEE Trans. Speech Audio Process. 9 (2001) 504, over blocks instead of times. The
 * power of long waves under the signal follows from the shape.
 */
#ifndef isthmus_SmoothedNoise_h
#define isthmus_SmoothedNoise_h

#include "Imaging/BlockWaves.h"

#include <array>
#include <vector>

namespace isthmus
{

struct SmoothedNoise
{
  bool Found = false;
  double Length = 0.0;         ///< sigma, in the unit of the spacing
  double Variance = 0.0;       ///< of the noise, in the unit of the squared values
  double Share = 0.0;          ///< of the noise's power in the bins that it explains
  std::vector<double> Density; ///< mean variance of the waves of each bin of a large grid
};

/**
 * The noise of the blocks `waves`, whose volume has the variance `total`.
 *
 * Lengths from 0.4 to 4 of the least spacing are tried, 150 of them.
 * Not found in fewer than 16 blocks of 16^3 nodes or 48 of 8^3.
 * Cost: 150 multiplications per wave of a block; in parallel over the lengths. Bitwise the same on
 * any number of threads.
 */
SmoothedNoise FindSmoothedNoise(
  const BlockWaves& waves, const std::array<double, 3>& spacing, double total);

}

#endif
