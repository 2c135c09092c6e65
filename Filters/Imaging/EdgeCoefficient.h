/**
 * @file EdgeCoefficient.h
 * @brief Edge-stopping coefficients that depend on more than the neighbours of a node and are
 * stored for a step.
 */
#ifndef isthmus_EdgeCoefficient_h
#define isthmus_EdgeCoefficient_h

#include "Imaging/DiffusionGrid.h"

#include <array>

namespace isthmus
{

struct EdgeCoefficientParameters
{
  double PreSmoothing = 0.0;  ///< Standard deviation (length) of the Gaussian that is applied
                              ///< before the gradient.
  double Sigma = 1.0;         ///< Scale of gradients (data units per length), not used with
                              ///< LocalVariance.
  bool LocalVariance = false; ///< sigma from the window around each node (4.35)
  int Order = 0;              ///< q: of u (0) or of grad u (1 to 3)
  int Window = 5;             ///< Width of the window in nodes: odd, 3 or more.
};

/**
 * Fills `coefficient` with exp(-|grad v|^2 / (2 sigma^2)) at every node.
 *
 * v is `values` under a Gaussian of standard deviation PreSmoothing (F. Catte, P.-L. Lions,
 * J.-M. Morel, T. Coll, SIAM J. Numer. Anal. 29 (1992) 182), done by heat flow. sigma is given, or
 * with LocalVariance the standard deviation of u (order 0) or of grad u (orders 1 to 3) in the
 * window around the node (4.35). `scratch` are two volumes of working memory. Returns the
 * equivalent number of evaluations of a right-hand side: those of the heat flow and one more.
 */
template <typename T>
int FillEdgeCoefficient(const DiffusionGrid<T>& grid, const EdgeCoefficientParameters& parameters,
  const T* values, const std::array<T*, 2>& scratch, T* coefficient);

}

#endif
