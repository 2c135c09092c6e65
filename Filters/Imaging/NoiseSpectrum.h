/**
 * @file NoiseSpectrum.h
 * @brief Level and spectrum of the noise in a volume, from its quietest blocks.
 *
 * Each block of a VolumeSample is transformed by a cosine transform, whose waves are the modes of
 * the discrete Laplacian. Power is averaged over bins of equal width in the square root of s =
 * -L/b, which is in proportion to the frequency.
 *
 * White noise has the same power at all wave numbers, and a map has little power at the highest
 * ones, so the level is a low quantile of that power over the blocks, corrected for the statistical
 * spread of the power of noise (chi squared). It is independent of the map if a quarter of the
 * blocks has no detail at the finest waves.
 *
 * Coloured noise has no such floor: the power falls until the end of the spectrum. If it does so
 * like white noise under a Gaussian (SmoothedNoise.h), that is the spectrum, or else the mean over
 * blocks without signal, if there are such. Otherwise only the floor is used, which is then low.
 */
#ifndef isthmus_NoiseSpectrum_h
#define isthmus_NoiseSpectrum_h

#include "Imaging/VolumeSample.h"

#include <array>
#include <vector>

namespace isthmus
{

/// Variance of the noise for each wave of the grid, in units of the squared Scale of the sample.
struct NoiseSpectrum
{
  bool Found = false;          ///< there were blocks to measure the noise in, or it was given
  bool White = true;           ///< the same for all waves
  bool Background = true;      ///< false: power falls as in coloured noise, but no blocks agree
  double Deviation = 0.0;      ///< standard deviation of the noise
  double Coherence = 1.0;      ///< mean square of the density over its squared mean
  std::vector<double> Density; ///< of bins of equal width in sqrt(s); empty if White

  /// The variance at s = -L/b, from 0 to 1.
  double At(double s) const;
};

/// White noise of a given standard deviation, in units of the sample's Scale.
NoiseSpectrum WhiteNoise(double deviation);

/// `spacing` is the grid spacing along each axis.
VTKISTHMUSFILTERSIMAGING_EXPORT NoiseSpectrum EstimateNoiseSpectrum(
  const VolumeSample& sample, const std::array<double, 3>& spacing);

/// Values of s along each axis, whose combinations are the modes of a grid. At most 64 per axis are
/// used; longer axes are sampled by 64 evenly spaced values.
std::array<std::vector<double>, 3> LaplacianModes(
  const Index3& whole, const std::array<double, 3>& spacing);

}

#endif
