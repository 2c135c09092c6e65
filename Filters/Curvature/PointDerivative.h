/**
 * @file PointDerivative.h
 * @brief First and second derivatives of grid data at points between the nodes.
 *
 * Central differences of radius R are the derivatives of local polynomials Q_a of degree 2R (see
 * FiniteDifference.h). At position t in [0, 1] of a cell, on each axis, the polynomials of the 2R
 * nearest nodes a are differentiated and blended,
 *
 *     f^(m)(t) ~ sum_a L_a(t) Q_a^(m)(t),
 *
 * with L_a the Lagrange weights of these nodes; the three axes are multiplied. For R = 1 that is
 * parabolic blending (A. W. Overhauser, Analytic definition of curves and surfaces by parabolic
 * blending, Ford Motor Company Technical Report SL 68-40, 1968).
 *
 * At a node, this equals the differences of the node. The result is continuous from cell to cell,
 * and the order is 2R at every point: for R = 2 the leading error of Q_a^(m) is a polynomial in t -
 * a that vanishes at 0 and is reproduced by the weights L_a; for R = 1 it is already of order 2.
 * Next to the border, the nearest nodes whose stencils lie inside the grid are blended.
 */
#ifndef isthmus_PointDerivative_h
#define isthmus_PointDerivative_h

#include "Curvature/FiniteDifference.h"

namespace isthmus
{

/**
 * Computes the derivatives at `index`, a position in node units from the grid's first node, and
 * stores them at `place` of `rows`. Returns false, and writes nothing, if the stencil would leave
 * the grid: if the index is NaN, lies outside the grid or closer than StencilRadius(accuracy) nodes
 * to its border (with a tolerance of 1e-4 nodes for rounded coordinates), or if the grid has fewer
 * than 4R nodes on some axis.
 *
 * A NaN at any of the (4R)^3 nodes read makes the derivatives NaN. Cost: 64 or 512 values read.
 */
template <typename T>
bool DifferentiateAtPoint(const GridView<const T>& grid, const std::array<double, 3>& index,
  int accuracy, std::int64_t place, DerivativeRows& rows);

}

#endif
