/**
 * @file HessianCurvature.h
 * @brief Curvature of the level sets of a scalar grid from its first and second derivatives.
 *
 * With g the gradient, H the Hessian matrix, n = g / |g| and P = I - n n^T, the matrix
 *
 *     G = -P H P / |g|
 *
 * has the principal curvatures kappa_1 >= kappa_2 of the level set as eigenvalues, besides 0 for n
 * (X. Feng's thesis, eqs. 5.42 to 5.51, signs corrected; R. Goldman, Curvature formulas for
 * implicit curves and surfaces, Computer Aided Geometric Design 22 (2005) 632,
 * doi:10.1016/j.cagd.2005.06.005). It is written in an orthonormal basis of the tangent plane,
 * where it is a 2 x 2 matrix [a c; c b], so that
 *
 *     H = (a + b)/2,  d = sqrt(((a - b)/2)^2 + c^2),  kappa_1,2 = H +/- d,  K = a b - c^2.
 *
 * There is no difference under the root of d, so full precision is kept at umbilics. With K and H
 * from the fundamental forms (thesis 5.40, 5.41; equal in exact arithmetic), it would be lost in
 * sqrt(H^2 - K).
 *
 * Sign: the inside of a level set is where the scalar is higher (InsideIsHigher; otherwise lower),
 * and a surface that bends away from its outward normal has positive curvature: sphere +1/r.
 * Units: those of the spacing to the power -1 (H, kappa, curvedness) and -2 (K).
 *
 * A place is valid if the stencil lies in the grid, all values in it are finite, and the gradient
 * does not vanish. The gradient is considered to vanish if |g| is at most
 *   - 1e-6 times the spacing times the Frobenius norm of H (a critical point at the resolution of
 *     the grid: the level set would bend within a millionth of a grid spacing), or
 *   - the rounding of the stored type: 4 epsilon times |value| over the spacing, with the smallest
 *     of the three spacings. Both criteria are local, so cropping and the number of ranks do not
 *     matter. At places that are not valid, all values and Valid are 0.
 */
#ifndef isthmus_HessianCurvature_h
#define isthmus_HessianCurvature_h

#include "Core/GridView.h"
#include "Core/Progress.h"
#include "Curvature/FiniteDifference.h"
#include "Curvature/HessianCurvatureRows.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <array>
#include <cstdint>
#include <functional>

namespace isthmus
{

/// A box of nodes of a grid.
struct NodeBox
{
  std::array<std::int64_t, 3> First{ 0, 0, 0 };
  std::array<std::int64_t, 3> Size{ 0, 0, 0 };
};

/**
 * Curvature at every node of `box`, x fastest, into `arrays`. Nodes of the grid around the box
 * serve as ghost nodes for the stencil.
 *
 * O(nodes) time; about 30 KB of scratch memory per thread. The result does not depend on the number
 * of threads.
 * @throws std::invalid_argument for a wrong accuracy, a spacing that is not positive, or a box that
 * leaves the grid, and Cancelled when `progress` asks to stop.
 */
template <typename T>
VTKISTHMUSFILTERSCURVATURE_EXPORT void HessianCurvatureAtNodes(const GridView<const T>& grid,
  const NodeBox& box, const HessianCurvatureOptions& options,
  const CurvatureArrays<ResultType<T>>& arrays, const ProgressCallback& progress = {});

/// Writes the positions of points [first, first + count) to `indices`, three numbers each, in node
/// units from the grid's first node. Called by several threads at once, with count at most 128.
using PointSource =
  std::function<void(std::int64_t first, std::int64_t count, std::array<double, 3>* indices)>;

/**
 * Curvature of the level set through each of `count` points, of the same order as at the nodes (see
 * PointDerivative.h), into `arrays`. Points whose stencil leaves the grid are invalid.
 *
 * Throws as HessianCurvatureAtNodes does. O(points) time, reading 64 (accuracy 2) or 512 (accuracy
 * 4) values for each point; about 30 KB of scratch memory per thread.
 */
template <typename T>
VTKISTHMUSFILTERSCURVATURE_EXPORT void HessianCurvatureAtPoints(const GridView<const T>& grid,
  std::int64_t count, const PointSource& points, const HessianCurvatureOptions& options,
  const CurvatureArrays<ResultType<T>>& arrays, const ProgressCallback& progress = {});

}

#endif
