/**
 * @file LocalResolution.h
 * @brief Local resolution from two half maps: Fourier shell correlation in windows.
 *
 * Windows of 24 nodes across (fewer along a shorter axis), with a Hann taper, stand on a lattice;
 * in each, the correlation of both halves is taken shell by shell (G. Cardone, J. B. Heymann, A. C.
 * Steven, J. Struct. Biol. 184 (2013) 226). The resolution is the wavelength at which it falls
 * below 0.5: with so few waves per shell 0.143 cannot be distinguished from chance. Frequencies
 * between the lattice's points are interpolated linearly.
 */
#ifndef isthmus_LocalResolution_h
#define isthmus_LocalResolution_h

#include "Core/Progress.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Fills `resolution` (unit of the spacing) for all nodes of two halves.
 *
 * Values are between twice the spacing (correlated up to the last shell) and the window's length
 * (in no shell). At most about 2000 windows, so time does not grow with the volume beyond that.
 * @pre values are finite. @throws Cancelled when progress says so.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT void FindLocalResolution(
  const std::array<std::int64_t, 3>& dimensions, const std::array<double, 3>& spacing,
  const std::vector<float>& one, const std::vector<float>& other, float* resolution,
  const ProgressCallback& progress = {});

}

#endif
