/**
 * @file CurvatureScale.h
 * @brief Automatic choice of the smoothing scale for curvature, and an estimate of its error.
 *
 * Smoothing reduces the error caused by noise and adds a bias. The chosen scale is the candidate
 * with the least sum of both, following T. Lindeberg's scale selection (International Journal of
 * Computer Vision 30 (1998) 79) and O. V. Lepski's comparison of neighbouring scales (Theory of
 * Probability and its Applications 35 (1991) 454). Candidates are 0 and 0.5 sqrt(2)^k times the
 * unit u, the cube root of a voxel's volume, up to 8 u and an eighth of the image's thickness.
 *
 * The filter does not know which level set is of interest, so variance and bias are estimated at up
 * to 2000 nodes of a regular lattice whose gradient is that of edges. The noise, white or coloured,
 * is measured at nodes without an edge, and bounded by what changes at the edges from scale to
 * scale; white noise, as that of values rounded to few digits, also by differences of high order at
 * the edges. Where the noise is no part of the error without smoothing, there is no smoothing,
 * unless it would reduce the error threefold, as at edges that the grid does not resolve. With H =
 * -(tangential Laplacian) / (2 |g|), to first order in the noise,
 *
 *     Var H = (Var L / 4 + H^2 Var g) / |g|^2
 *
 * with L the sum of the second derivatives along two axes and g the derivative along the normal,
 * which are not correlated. The bias due to a Gaussian is proportional to s^2 to leading order, so
 * at scale s it equals the change of the curvature from s to sqrt(2) s. The error of the finite
 * differences is estimated by their change when their order is raised by 2. With H(s) by the
 * filter's differences and R(s) by those of the next order, both are
 *
 *     D = H(s) - 2 R(s) + R(sqrt(2) s)
 *
 * at each node; the squared bias is the mean square B of D, less the contribution N of the noise.
 * At a point, where D is known (with fourth-order differences, H replaces R there), the expectation
 * of the squared bias is r^2 D^2 + r N with r = B / (B + N), to which the variance is added.
 */
#ifndef isthmus_CurvatureScale_h
#define isthmus_CurvatureScale_h

#include "Core/Progress.h"
#include "Curvature/GaussianDerivative.h"

#include <array>
#include <cstdint>
#include <functional>

namespace isthmus
{

/// A chosen scale, with the quantities that determine the error of the curvature.
struct CurvatureScale
{
  double Scale = 0.0;     ///< standard deviation of the Gaussian, unit of the spacing; 0 for none
  double NextScale = 0.0; ///< the next scale, for the bias at a point
  double Noise = 0.0;     ///< standard deviation of the noise in the values
  double Correlation =
    0.0; ///< correlation length of the noise (CorrelatedNoise), unit of the spacing
  std::int64_t Samples = 0; ///< nodes at edges that were used; 0 if nothing could be estimated

  double Unit = 1.0;               ///< unit of the following lengths, in that of the spacing
  double LaplacianVariance = 0.0;  ///< of noise, in the sum of two second derivatives at Scale
  double GradientVariance = 0.0;   ///< of noise, in the derivative along an axis at Scale
  double DifferenceVariance = 0.0; ///< of noise, in the Laplacians of the difference D
  double BiasSquare = 0.0;         ///< mean square bias of the mean curvature at the sampled edges
  double DifferenceSquare = 0.0; ///< mean square of its change from Scale to NextScale, less noise

  /// Standard error of the mean curvature, bias included, at a point where the mean curvature at
  /// Scale is `mean`, its bias estimated from differences of scales and orders is `difference`, and
  /// the length of the gradient at Scale is `gradient`.
  double Error(double mean, double difference, double gradient) const;
};

/// Replaces each value by the maximum over the ranks. Empty if there is one rank.
using MaximumOverRanks = std::function<void(double* values, std::int64_t count)>;

/// The largest smoothing scale considered for a grid of `whole` nodes, in the unit of the spacing.
/// Around each node, nodes within GaussianReach() of this scale plus DifferenceReach are read.
double LargestCandidateScale(
  const std::array<double, 3>& spacing, const std::array<std::int64_t, 3>& whole);

/**
 * Chooses the scale for differences of order `accuracy` (2 or 4).
 *
 * With several ranks, each has its part of the grid including the nodes within reach, and all must
 * call this function together. Every rank gets bitwise the same result as a single rank with all
 * nodes. `part` may be empty except for Values.Spacing and Whole. The result does not depend on the
 * number of threads.
 *
 * For grids with fewer than 12 nodes on an axis, without edges, or without finite values, there is
 * no estimate: Scale and Samples are 0. Time: at most about 3e9 multiplications, however large the
 * grid; memory: 10 MB.
 * @throws Cancelled when `progress` asks to stop
 */
template <typename T>
CurvatureScale ChooseCurvatureScale(const GridPart<T>& part, int accuracy,
  const MaximumOverRanks& combine = {}, const ProgressCallback& progress = {});

}

#endif
