/**
 * @file LocalResolution.h
 * @brief Local resolution from two half maps: Fourier shell correlation in windows.
 *
 * Windows 24 nodes wide (fewer along a shorter axis), with a Hann taper, are placed on a lattice;
 * in each, the correlation of both halves is computed shell by shell (G. Cardone, J. B. Heymann, A.
 * C. Steven, J. Struct. Biol. 184 (2013) 226). The resolution is the wavelength at which the
 * correlation falls below 0.5; with so few waves per shell, a threshold of 0.143 cannot be
 * distinguished from chance. Frequencies between the lattice's points are interpolated linearly.
 */
#ifndef isthmus_LocalResolution_h
#define isthmus_LocalResolution_h

#include "Core/Progress.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Computes `resolution` (in the unit of the spacing) for all nodes of two half maps.
 *
 * Values are between twice the spacing (correlated up to the last shell) and the length of the
 * window (correlated in no shell). There are at most about 2000 windows, so the time does not grow
 * further for larger volumes.
 * Scaling a half does not change the result, and adding a constant changes only rounding.
 * @pre values are finite and at most 1e36; a mean much larger than their deviations is subtracted
 * before they are rounded to single precision.
 * @throws Cancelled if `progress` returns false.
 */
void FindLocalResolution(const std::array<std::int64_t, 3>& dimensions,
  const std::array<double, 3>& spacing, const std::vector<float>& one,
  const std::vector<float>& other, float* resolution, const ProgressCallback& progress = {});

}

#endif
