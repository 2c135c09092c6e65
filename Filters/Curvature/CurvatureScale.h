/**
 * @file CurvatureScale.h
 * @brief Automatic choice of the smoothing scale for curvature, and the error of the curvature.
 *
 * Smoothing reduces the error that noise makes and adds a bias; the scale chosen is the candidate
 * with the least sum of both, in the spirit of T. Lindeberg's scale selection (International
 * Journal of Computer Vision 30 (1998) 79) and O. V. Lepski's comparison of neighbouring scales
 * (Theory of Probability and its Applications 35 (1991) 454). Candidates are 0 and 0.5 sqrt(2)^k
 * times the unit u, the cube root of a voxel's volume, up to 8 u and an eighth of the image's
 * thickness.
 *
 * **Where.** The filter does not know which level set matters. Edges do: nodes of a regular lattice
 * whose gradient, at scale 2 u, exceeds 5 times that of noise and the edges' typical one,
 * sqrt(sum g^4 / sum g^2), the mean over nodes weighted with g^2. Up to 2000 of them are used.
 *
 * **Noise.** At nodes without an edge: those that remain when gradients beyond 3 standard
 * deviations of a Maxwell distribution are removed, again and again. There, the median squares of
 * the sums of two second derivatives, at the scales up to 2 u, give the deviation and the
 * correlation length of Gaussian-correlated noise, from which all variances at all scales follow
 * exactly (CovarianceOfDerivatives). So coloured noise is measured, not assumed white. The
 * Laplacians at the edges must change from scale to scale at least as much as this noise makes
 * them: else the background has structure of its own, and the noise is reduced to what the edges
 * allow. Noise that edge-preserving filters leave at edges only shows as differences between the
 * finest scales there, and is added as white noise if two successive differences agree on its
 * variance.
 *
 * **Variance.** With H = -(tangential Laplacian) / (2 |g|), to first order in the noise,
 *
 *     Var H = (Var L / 4 + H^2 Var g) / |g|^2
 *
 * with L the sum of the second derivatives along two axes and g the derivative along the normal,
 * which are not correlated.
 *
 * **Bias.** The bias of a Gaussian is s^2 to leading order, so that of scale s equals the change of
 * the curvature from s to sqrt(2) s; the error of the differences is their change when their order
 * is raised by 2. With H(s) by the filter's differences and R(s) by those of the next order,
 *
 *     D = H(s) - 2 R(s) + R(sqrt(2) s)
 *
 * at each node; its mean square B, less the part N that the noise has in it, is the bias that
 * counts. Where noise hides it, it is a quarter of that of the next scale. Scales that have
 * smoothed whole features away, such as the atoms of a molecule, hardly change to the next. So the
 * bias is at least the mean square of R(s) - R(t) for each smaller scale t, less noise and the
 * error of the differences at t.
 *
 * **Error at a place.** The bias varies, and D is known at each place (with differences of fourth
 * order, R is H there), its noise has the variance N = Var(combination of Laplacians) / (4 |g|^2).
 * With r = B / (B + N), the expectation of the square of the bias given D is r^2 D^2 + r N. That,
 * joined by a fiftieth of B, so that it does not vanish where D changes its sign, is added to the
 * variance.
 */
#ifndef isthmus_CurvatureScale_h
#define isthmus_CurvatureScale_h

#include "Core/Progress.h"
#include "Curvature/GaussianDerivative.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <functional>

namespace isthmus
{

/// A choice of scale, and what determines the error of the curvature with it.
struct CurvatureScale
{
  double Scale = 0.0;       ///< standard deviation of the Gaussian, unit of the spacing; 0 for none
  double NextScale = 0.0;   ///< the next one, for the bias at a place
  double Noise = 0.0;       ///< standard deviation of the noise in the values
  double Correlation = 0.0; ///< of the noise (CorrelatedNoise), unit of the spacing
  std::int64_t Samples = 0; ///< nodes at edges that were used; 0 if nothing could be estimated

  double Unit = 1.0;               ///< of the lengths in the following, in that of the spacing
  double LaplacianVariance = 0.0;  ///< of noise, in the sum of two second derivatives at Scale
  double GradientVariance = 0.0;   ///< of noise, in the derivative along an axis at Scale
  double DifferenceVariance = 0.0; ///< of noise, in the Laplacians of the difference D
  double BiasSquare = 0.0;         ///< mean square bias of the mean curvature at the sampled edges
  double DifferenceSquare = 0.0; ///< mean square of its change from Scale to NextScale, less noise

  /// Standard error of the mean curvature, bias included, at a place where the mean curvature is
  /// `mean` at Scale, its bias by differences of scales and orders is `difference`, and the
  /// gradient has the length `gradient` at Scale.
  VTKISTHMUSFILTERSCURVATURE_EXPORT double Error(
    double mean, double difference, double gradient) const;
};

/// Replaces each value by the maximum of the ranks' values at its place. Empty on one rank.
using MaximumOverRanks = std::function<void(double* values, std::int64_t count)>;

/// The largest scale that the choice for a grid of `whole` nodes smooths with, in the unit of the
/// spacing: nodes within its GaussianReach and DifferenceReach more are read around each node.
double LargestScaleOfChoice(
  const std::array<double, 3>& spacing, const std::array<std::int64_t, 3>& whole);

/**
 * The scale for differences of order `accuracy` (2 or 4).
 *
 * With several ranks, each has its part of the grid with the nodes within reach, and all call it
 * together; every one has the result of one rank with all nodes, bit by bit. `part` may be
 * empty but for Values.Spacing and Whole. The number of threads does not matter.
 *
 * Grids of less than 12 nodes on an axis, and grids without edges or with values that are not
 * numbers throughout, get no estimate: Scale and Samples are 0. Time: at most some 3e9
 * multiplications, however large the grid; memory: 10 MB.
 * @throws Cancelled when `progress` asks to stop
 */
template <typename T>
VTKISTHMUSFILTERSCURVATURE_EXPORT CurvatureScale ChooseCurvatureScale(const GridPart<T>& part,
  int accuracy, const MaximumOverRanks& combine = {}, const ProgressCallback& progress = {});

}

#endif
