/**
 * @file ChebyshevSeries.h
 * @brief Functions of a symmetric matrix by Chebyshev polynomials: the coefficients.
 */
#ifndef isthmus_ChebyshevSeries_h
#define isthmus_ChebyshevSeries_h

#include "vtkIsthmusFiltersImagingModule.h" // for the export macro

#include <functional>
#include <vector>

namespace isthmus
{

/**
 * Coefficients a_n with f(s) = sum a_n T_n(1 - 2s) on [0, 1], as many as `tolerance` needs.
 *
 * Interpolates at cosines, twice as many until the second half of the coefficients is rounding, by
 * a fast Fourier transform; then leaves out the last ones while the sum of their moduli, which
 * bounds the error since |T_n| <= 1, stays below the tolerance.
 * @pre f is smooth, |f| <= 1 (steep near 0 it may be: s is exact there), and tolerance is 1e-14 or
 * more.
 * @throws std::invalid_argument for a series longer than MaximumEvaluations (TimeSteps.h).
 */
VTKISTHMUSFILTERSIMAGING_EXPORT std::vector<double> ChebyshevSeries(
  const std::function<double(double)>& f, double tolerance);

}

#endif
