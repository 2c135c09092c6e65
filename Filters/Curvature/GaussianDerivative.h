/**
 * @file GaussianDerivative.h
 * @brief Derivatives of a Gaussian-smoothed grid at single nodes, without smoothing the whole grid,
 * and the covariances of these derivatives under noise.
 *
 * The derivatives are those of FiniteDifference.h on the values of GaussianSmoothing.h (kernel cut
 * at 4 standard deviations and renormalised at the border), written as one sum over the surrounding
 * nodes. Reference derivatives are central differences of the next order of the same smoothed
 * values: the difference between the two estimates the error of the filter's differences.
 */
#ifndef isthmus_GaussianDerivative_h
#define isthmus_GaussianDerivative_h

#include "Core/GridView.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// The available nodes of a whole grid: all of them, or those of one rank.
template <typename T>
struct GridPart
{
  GridView<const T> Values;
  std::array<std::int64_t, 3> First{ 0, 0, 0 }; ///< position of the first node in the whole grid
  std::array<std::int64_t, 3> Whole{ 0, 0, 0 }; ///< nodes of the whole grid
};

/// Value, gradient (x, y, z) and Hessian matrix (xx, yy, zz, xy, xz, yz), per length of the
/// spacing.
struct NodeDerivatives
{
  double Value = 0.0;
  std::array<double, 3> Gradient{};
  std::array<double, 6> Hessian{};
};

/// The radius of the widest difference: nodes closer to the border of the whole grid have no
/// derivatives.
constexpr int DifferenceReach = 3;

/// The order of reference derivatives.
int ReferenceAccuracy(int accuracy);

/// Standard deviations at which kernels are cut.
constexpr double GaussianCutOff = 4.0;

/**
 * Derivatives at a node of the whole grid, after smoothing with standard deviation `scale` (unit of
 * the spacing), by differences of order `accuracy` (2 or 4) into `filter` and of the next order
 * into `reference`. Returns false, and writes nothing, if not all required nodes are available.
 *
 * The result does not depend on which other nodes are available. O((scale / spacing)^3), about 5
 * multiplications for each node within reach.
 * @pre the node has DifferenceReach nodes of the whole grid on each side
 */
template <typename T>
bool DifferentiateSmoothed(const GridPart<T>& part, const std::array<std::int64_t, 3>& node,
  double scale, int accuracy, NodeDerivatives& filter, NodeDerivatives& reference);

/// Value and gradient only, by second-order differences; takes a third of the time.
template <typename T>
bool SmoothedGradient(const GridPart<T>& part, const std::array<std::int64_t, 3>& node,
  double scale, NodeDerivatives& gradient);

/// A smoothing scale and an order of differences, which together turn values into derivatives.
struct DerivativeFilter
{
  double Scale = 0.0;
  int Accuracy = 2;
};

/// Stationary noise: white noise, smoothed by a Gaussian of standard deviation Correlation (unit of
/// the spacing; 0 for white noise), so that its standard deviation is Deviation.
struct CorrelatedNoise
{
  double Deviation = 0.0;
  double Correlation = 0.0;
};

/// Covariances of the derivatives computed by two filters from the same noise, averaged over the
/// axes.
struct NoiseCovariance
{
  double Laplacian = 0.0; ///< of the sum of the second derivatives along two axes
  double Gradient = 0.0;  ///< of the derivative along an axis
};

NoiseCovariance CovarianceOfDerivatives(const CorrelatedNoise& noise, const DerivativeFilter& one,
  const DerivativeFilter& other, const std::array<double, 3>& spacing);

}

#endif
