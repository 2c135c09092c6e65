/**
 * @file DiffusionHighPass.h
 * @brief Extracts the edges of a volume as the difference of two coupled diffusions with different
 * speeds.
 *
 * Equations 4.37 to 4.39 of X. Feng's thesis, after G. W. Wei and Y. Q. Jia, Europhys. Lett. 59
 * (2002) 814:
 *
 *     u_t = div(d_1 grad u) + epsilon_u (v - u),   v_t = div(d_2 grad v) + epsilon_v (u - v),
 *     w = u - v,   u = v = input at time 0,
 *
 * with d_1, d_2 Gaussian edge-stopping coefficients (4.34). d_2 >> d_1: v loses detail first, and w
 * is the detail that v has lost and u still has. Coupling pulls the two together, so w vanishes for
 * long times.
 */
#ifndef isthmus_DiffusionHighPass_h
#define isthmus_DiffusionHighPass_h

#include "Imaging/HighOrderDiffusion.h"
#include "vtkIsthmusFiltersImagingModule.h"

namespace isthmus
{

struct HighPassParameters
{
  double DiffusivityU = 0.05; ///< d_10, length^2 / time
  double DiffusivityV = 1.0;  ///< d_20, length^2 / time
  double CouplingU = 0.05;    ///< epsilon_u, 1 / time
  double CouplingV = 0.05;    ///< epsilon_v, 1 / time
  double Sigma = 0.0; ///< Gradient that stops the diffusion, in data units per length; 0: no
                      ///< gradient does.
  double Time = 4.0;  ///< End time.
  int Steps = 0; ///< Number of splitting steps; 0: enough that coupling and diffusion change little
                 ///< in each.
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const HighPassParameters& parameters);

/**
 * Evolves u and v in place; both initially hold the input.
 *
 * Strang splitting, second order in time for constant coefficients: half a step of coupling (solved
 * exactly), a step of both diffusions, half a step of coupling. Memory: four volumes in addition to
 * u and v. Throws as Diffuse does.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void EvolveHighPass(const DiffusionGrid<T>& grid,
  const HighPassParameters& parameters, T* u, T* v, const ProgressCallback& progress = {});

}

#endif
