/**
 * @file PointDerivative.h
 * @brief First and second derivatives of grid data at points between the nodes.
 *
 * At t in [0, 1] of a cell, on each axis, the local polynomials Q_a of degree 2R that the central
 * differences of radius R stand for (see FiniteDifference.h) are differentiated at t for the 2R
 * nearest nodes a, and blended,
 *
 *     f^(m)(t) ~ sum_a L_a(t) Q_a^(m)(t),
 *
 * with L_a the Lagrange weights of these nodes; the three axes are multiplied. For R = 1 that is
 * parabolic blending (A. W. Overhauser, Analytic definition of curves and surfaces by parabolic
 * blending, Ford Motor Company Technical Report SL 68-40, 1968).
 *
 * So a point on a node gets the node's differences, the result is continuous from cell to cell, and
 * the order stays 2R at every point: the leading error of Q_a^(m) is a polynomial in t - a, which
 * for R = 2 the weights L_a reproduce and which vanishes at 0; for R = 1 it is of order 2 already.
 * Next to the border the blended nodes are the nearest ones that have their stencil inside.
 */
#ifndef isthmus_PointDerivative_h
#define isthmus_PointDerivative_h

#include "Curvature/FiniteDifference.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

namespace isthmus
{

/**
 * Derivatives at `index`, a position in node units from the grid's first node, into `place` of
 * `rows`. Answers false, and writes nothing, where the stencil would leave the grid: nearer than
 * StencilRadius(accuracy) nodes to its border (less an allowance of 1e-4 node distances for rounded
 * coordinates), outside of it, not a number, or a grid of less than 4R nodes on some axis.
 *
 * Every value in the (4R)^3 nodes read counts: one NaN among them makes derivatives NaN.
 * Cost: 64 or 512 values read.
 */
template <typename T>
VTKISTHMUSFILTERSCURVATURE_EXPORT bool DifferentiateAtPoint(const GridView<const T>& grid,
  const std::array<double, 3>& index, int accuracy, std::int64_t place, DerivativeRows& rows);

}

#endif
