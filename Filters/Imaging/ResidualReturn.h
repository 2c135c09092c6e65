/**
 * @file ResidualReturn.h
 * @brief Gives back what a denoising filter took from long waves, where it is signal and not noise.
 *
 *     result + G (input - result),   G a Gaussian (by heat flow, Neumann boundaries)
 *
 * The residual of a good denoiser is noise alone; what a low-pass finds in it is mostly structure
 * (J. W. Tukey, "Exploratory data analysis", 1977, called adding it back twicing; S. Osher et al.,
 * Multiscale Model. Simul. 4 (2005) 460, for diffusions). Waves much longer than G become those of
 * the input again, waves much shorter stay those of the result, and between them both are averaged,
 * which has less error than the worse of the two. The mean becomes the input's.
 */
#ifndef isthmus_ResidualReturn_h
#define isthmus_ResidualReturn_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "vtkIsthmusFiltersImagingModule.h"

namespace isthmus
{

/**
 * Adds the smoothed residual to `values`. `deviation` (length, above 0) is G's; `residual` holds
 * the input, which is overwritten. Memory: a volume beside these two. Cost: about 5 (deviation /
 * spacing)^2 evaluations of the heat equation. Throws as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void ReturnResidual(const DiffusionGrid<T>& grid, double deviation,
  T* residual, T* values, const ProgressCallback& progress = {});

}

#endif
