/**
 * @file DenoisingRisk.h
 * @brief Determines which diffusion denoises a volume best, by an estimate of the error that needs
 * no ground truth.
 *
 * For y = x + n with noise n of known covariance, the mean squared error of f(y) is estimated by
 *
 *     |f(y) - y|^2 - E|n|^2 + 2 E[n . f(y)],
 *
 * without bias for normal noise (Stein's unbiased risk estimate, SURE; coloured noise: Y. C. Eldar,
 * IEEE Trans. Signal Process. 57 (2009) 471).
 *
 * **Linear** diffusion for a time t at order q multiplies the wave of eigenvalue lambda of -L by
 * exp(-t lambda^(q+1)), a polynomial p(-L) to good accuracy. The last term is then exact, a mean of
 * noise times factor over the modes of the grid. The first term is a quadratic form of the
 * Chebyshev coefficients of p with the Gram matrix of T_n(L) y. Thus one recurrence of 42 terms
 * gives the risk of all orders and times.
 *
 * **Edge stopping** diffusions are run. With one probe b, noise like n, the last term is 2 b . (f(y
 * + e b) - f(y)) / e (S. Ramani, T. Blu, M. Unser, IEEE Trans. Image Process. 17 (2008) 1540).
 * White probes are +-1, hashed from the position of the node in the whole grid; coloured probes are
 * filtered white ones. If a volume of noise is available, e.g. from half maps, it is the probe.
 *
 * The goal **volumes** is the least mean squared error of the values. The goal **surfaces** is the
 * least error of the mean curvature of level sets, estimated in the same way from second
 * differences where the gradient is large, which is where surfaces lie, among the linear diffusions
 * whose error of the values is within 1 dB of the least one.
 */
#ifndef isthmus_DenoisingRisk_h
#define isthmus_DenoisingRisk_h

#include "Core/Progress.h"
#include "Imaging/HighOrderDiffusion.h"
#include "Imaging/NoiseSpectrum.h"
#include "Imaging/VolumeSample.h"

#include <array>
#include <vector>

namespace isthmus
{

enum class DenoisingGoal
{
  Surfaces,
  Volumes
};

struct DenoisingSearch
{
  DenoisingGoal Goal = DenoisingGoal::Surfaces;
  bool LinearOnly = false;
  /// Strength from 0 to 1: the smoothing length is 2^(Strength - 1/2) times the best one.
  double Strength = 0.5;
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSIMAGING_EXPORT void Check(const DenoisingSearch& search);

/// The best candidate and its estimates; all values are in units of the Scale of the sample.
struct DenoisingChoice
{
  DiffusionParameters Parameters;
  double NoisePower = 0.0; ///< mean variance of the noise over all nodes
  double Residual = 0.0;   ///< mean of (f - y)^2 over the sample
  double Covariance = 0.0; ///< mean of n f(y) over all nodes
  double Spread = 0.0;     ///< root mean square of 1 - 2 (factor of a wave), for standard errors
  std::vector<double> RiskTime;
  /// What is minimised: risk of the values, or of the curvature less a constant.
  std::vector<double> RiskValue;

  double Risk() const { return this->Residual - this->NoisePower + 2.0 * this->Covariance; }
  bool IsLinear() const
  {
    return this->Parameters.EdgeStopping == DiffusionParameters::EdgeStoppingType::None;
  }
};

/**
 * The diffusion with the least risk. `spacing` is the grid spacing along each axis.
 *
 * Cost: for surfaces, four recurrences of 41 terms on the sample and up to 100 combinations of
 * their terms; for volumes, one recurrence and six to fifteen pairs of runs with edge stopping.
 * @throws Cancelled if `progress` returns false.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT DenoisingChoice ChooseDenoising(const VolumeSample& sample,
  const NoiseSpectrum& noise, const std::array<double, 3>& spacing, const DenoisingSearch& search,
  const ProgressCallback& progress = {});

/// Estimated risk of one candidate on the sample, for tests.
VTKISTHMUSFILTERSIMAGING_EXPORT DenoisingChoice EvaluateDenoising(const VolumeSample& sample,
  const NoiseSpectrum& noise, const std::array<double, 3>& spacing,
  const DiffusionParameters& parameters);

}

#endif
