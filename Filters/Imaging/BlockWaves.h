/**
 * @file BlockWaves.h
 * @brief Cosine waves of the blocks in which noise is measured, sorted by frequency.
 *
 * The waves of a block of n nodes along an axis of spacing h are cos(omega h (i + 1/2)) with omega
 * = pi k / (n h), k = 0 to n - 1: the modes of the discrete Laplacian L. A wave's bin is given by
 * sqrt(s), where s = -L/b is between 0 and 1 and b is the bound of -L on the grid.
 */
#ifndef isthmus_BlockWaves_h
#define isthmus_BlockWaves_h

#include "Imaging/VolumeSample.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Number of bins, of equal width in sqrt(s).
constexpr std::size_t waveBins = 24;

/// Squared amplitudes of the orthonormal cosine waves of blocks of the same size.
struct BlockWaves
{
  Index3 Size{ 0, 0, 0 };
  std::vector<int> Bin;                    ///< of each wave; -1 for the constant
  std::vector<std::vector<float>> Squares; ///< of each block
};

/// Cost: 3 n^4 multiplications for a block of n^3 nodes; blocks are transformed in parallel.
BlockWaves TransformBlocks(const NoiseBlocks& blocks, const std::array<double, 3>& spacing);

/// s of the cosine waves of an axis of n nodes, bound the bound of all three axes.
std::vector<double> AxisModes(std::int64_t n, double spacing, double bound);

/// The bound of -L: the sum of 4 / spacing^2.
double SpectralBound(const std::array<double, 3>& spacing);

/// The bin of a wave of this s.
std::size_t FrequencyBin(double s);

/// The quantile of chi squared over its degrees of freedom (Wilson and Hilferty, Proc. Natl. Acad.
/// Sci. 17 (1931) 684) that corresponds to z of the normal distribution.
double SpreadAtQuantile(double degrees, double z);

/// The value below which this share of the values lies.
double Quantile(std::vector<double> values, double share);

}

#endif
