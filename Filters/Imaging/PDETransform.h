/**
 * @file PDETransform.h
 * @brief Splits a volume into modes, from the finest detail to a smooth rest, that add up to it.
 *
 * The PDE transform (Y. Wang, G. W. Wei, S. Yang, Int. J. Numer. Methods Biomed. Eng. 27 (2011)
 * 1996; J. Sci. Comput. 50 (2012) 495): repeated high-pass filters made of diffusion of high, then
 * falling order,
 *
 *     X_1 = input,   X_(k+1) = low-pass_k(X_k),   mode_k = X_k - X_(k+1),   residue = X_(n+1).
 *
 * Low-pass k is hyperdiffusion of constant coefficient for the time at which a wave of wavelength
 * lambda_k = FirstWavelength * Ratio^(k-1) has lost half its amplitude; the higher its order, the
 * sharper the cut, exp(-ln 2 (lambda_k / lambda)^(2q+2)).
 */
#ifndef isthmus_PDETransform_h
#define isthmus_PDETransform_h

#include "HighOrderDiffusion.h"

#include <functional>

namespace isthmus
{

struct PDETransformParameters
{
  int Modes = 4;      ///< 1 to 16
  int FirstOrder = 3; ///< q of the first low-pass, 0 to 3; falls by one a mode, to LastOrder
  int LastOrder = 0;
  double FirstWavelength = 4.0; ///< length; at least two nodes
  double Ratio = 2.0;           ///< of a mode's wavelength to the one before, above 1
};

/// @throws std::invalid_argument, in a sentence, for parameters that mean nothing.
VTKISTHMUS_EXPORT void Check(const PDETransformParameters& parameters);

/// The low-pass behind mode k (0 the first).
VTKISTHMUS_EXPORT DiffusionParameters LowPass(const PDETransformParameters& parameters, int k);

/**
 * Calls `takeMode(k, before, after)` for each mode with X_k and X_(k+1); their difference is the
 * mode. At the end `values` holds the residue. Memory: one volume beside values, and Diffuse's.
 */
template <typename T>
VTKISTHMUS_EXPORT void TransformByPDE(const DiffusionGrid<T>& grid,
  const PDETransformParameters& parameters, T* values,
  const std::function<void(int k, const T* before, const T* after)>& takeMode,
  const ProgressCallback& progress = {});

}

#endif
