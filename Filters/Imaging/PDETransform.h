/**
 * @file PDETransform.h
 * @brief Splits a volume into modes that add up to it, from the finest detail to a smooth residue.
 *
 * The PDE transform (Y. Wang, G. W. Wei, S. Yang, Int. J. Numer. Methods Biomed. Eng. 27 (2011)
 * 1996; J. Sci. Comput. 50 (2012) 495): repeated high-pass filters made of diffusion of high, then
 * falling order,
 *
 *     X_1 = input,   X_(k+1) = low-pass_k(X_k),   mode_k = X_k - X_(k+1),   residue = X_(n+1).
 *
 * Low-pass k is hyperdiffusion of constant coefficient for the time at which a wave of wavelength
 * lambda_k = FirstWavelength * WavelengthRatio^(k-1) has lost half its amplitude. The higher the
 * order, the sharper the cut-off, exp(-ln 2 (lambda_k / lambda)^(2q+2)).
 *
 * All low-passes are functions of one matrix, the 7-point Laplacian L of the grid: X_(k+1) =
 * f_k(L) X_1 with f_k(L) = exp(-sum_(m<=k) t_m (-L)^(q_m+1)), and are computed together by one
 * Chebyshev recurrence (H. Tal-Ezer, SIAM J. Numer. Anal. 26 (1989) 1):
 *
 *     f_k(L) u = u + sum_n a_(k,n) (T_n u - u),   T_(n+1) u = 2 T_n u - T_(n-1) u + 4/b L T_n u,
 *
 * b the bound of -L. There are no time steps: terms are dropped while the sum of their coefficients
 * is below 1e-7 (float) or 1e-13 (double), which bounds the error relative to the input in the root
 * mean square, apart from rounding.
 */
#ifndef isthmus_PDETransform_h
#define isthmus_PDETransform_h

#include "Imaging/HighOrderDiffusion.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <vector>

namespace isthmus
{

struct PDETransformParameters
{
  int NumberOfModes = 4; ///< 1 to 16, without the residue
  int FirstOrder = 3;    ///< q of the first low-pass, 0 to 3; falls by one a mode, to LastOrder
  int LastOrder = 0;
  double FirstWavelength = 4.0; ///< length; at least two nodes
  double WavelengthRatio = 2.0; ///< of a mode's wavelength to the one before, above 1
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const PDETransformParameters& parameters);

/// The low-pass filter after mode k (the first is 0).
VTKISTHMUSFILTERSIMAGING_EXPORT DiffusionParameters LowPass(
  const PDETransformParameters& parameters, int k);

/**
 * Computes modes[k] = X_(k+1) - X_(k+2) (k from 0) from the input in `values`, and leaves the
 * residue in `values`.
 *
 * @pre modes has parameters.NumberOfModes volumes of the grid's size, none of them `values`.
 * @throws std::invalid_argument for bad parameters, also for wavelengths so long that the
 * recurrence would be longer than MaximumEvaluations.
 *
 * Cost: one recurrence for all modes, whose length is about five times b^(1/2) times the longest
 * wavelength over 2 pi (89 stages with the defaults in float), and for each mode an addition in the
 * stages that it needs. Memory in addition to `values` and `modes`: on one rank the rows of
 * SweepBytes, at most four volumes; on several ranks two volumes.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT void TransformByPDE(const DiffusionGrid<T>& grid,
  const PDETransformParameters& parameters, T* values, const std::vector<T*>& modes,
  const ProgressCallback& progress = {});

}

#endif
