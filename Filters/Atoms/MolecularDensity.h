/**
 * @file MolecularDensity.h
 * @brief Samples atoms as a function on a grid: the union of their balls, or a sum of Gaussians.
 *
 * With the balls' centers x_i and radii R_i (van der Waals radii times a factor eta), the union is
 *
 *   rho(x) = 1 if |x - x_i| <= R_i for any i, else 0,
 *
 * the sharp start of geometric-flow surfaces (thesis 3.11), and the smooth form is
 *
 *   rho(x) = sum_i exp(-d (|x - x_i|^2 / R_i^2 - 1))
 *
 * (J. F. Blinn, ACM Trans. Graph. 1 (1982) 235; in this form Y. Zhang, G. Xu, C. Bajaj, Comput.
 * Aided Geom. Des. 23 (2006) 510, with beta = -d). Each term is 1 on the sphere of its ball, so the
 * level 1 of either form encloses all balls. It is exactly the sphere for a single atom and lies
 * slightly outside where atoms meet, the closer the greater the decay d. Terms below 1e-6 are
 * neglected. The integral is e^d (pi / d)^(3/2) sum R_i^3.
 */
#ifndef isthmus_MolecularDensity_h
#define isthmus_MolecularDensity_h

#include "Atoms/Ball.h"
#include "Core/GridView.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <array>
#include <vector>

namespace isthmus
{

/// Cubic cells around balls.
struct DensityGrid
{
  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 };
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  double Spacing = 1.0;
};

/**
 * The smallest grid of this spacing whose box contains all balls and a margin (`padding` along x, y
 * and z) on each side. Throws std::invalid_argument if the spacing is not positive, the padding is
 * negative, a ball is not finite, or there are more than 2^31 nodes along an axis.
 */
VTKISTHMUSFILTERSATOMS_EXPORT DensityGrid GridAroundBalls(
  const std::vector<Ball>& balls, double spacing, const std::array<double, 3>& padding);

/**
 * Writes the union of the balls to the nodes of `to`, using its dimensions and (first) spacing; its
 * first node is at `origin`.
 *
 * Both functions work brick by brick in parallel. The result does not depend on the number of
 * threads, nor on the order of the balls. Time and memory O(nodes + sum over balls of the nodes in
 * reach); balls with radius 0 have no effect. Throws std::invalid_argument for radii that are
 * negative, not finite, or so large compared with the grid that the lists would not fit into
 * memory.
 */
void UnionOfBalls(const std::vector<Ball>& balls, const std::array<double, 3>& origin,
  GridView<float> to, const ProgressCallback& progress = {});

/// The same for the sum of Gaussians with the given decay (above 0, up to 500), summed in double
/// precision.
VTKISTHMUSFILTERSATOMS_EXPORT void GaussianSum(const std::vector<Ball>& balls, double decay,
  const std::array<double, 3>& origin, GridView<float> to, const ProgressCallback& progress = {});

/// -log of that sum: 0 on the surface, below 0 inside, a quadratic around a single atom. All terms
/// that matter within `margin` spacings of the level are summed, however small; where there are
/// none, the value is FarFromBalls.
VTKISTHMUSFILTERSATOMS_EXPORT void GaussianLevel(const std::vector<Ball>& balls, double decay,
  double margin, const std::array<double, 3>& origin, GridView<float> to,
  const ProgressCallback& progress = {});

constexpr float FarFromBalls = 700.0F;

}

#endif
