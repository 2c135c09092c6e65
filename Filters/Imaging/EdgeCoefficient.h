/**
 * @file EdgeCoefficient.h
 * @brief Edge-stopping coefficients that need more than a node's neighbours: stored for a step.
 */
#ifndef isthmus_EdgeCoefficient_h
#define isthmus_EdgeCoefficient_h

#include "Imaging/DiffusionGrid.h"
#include "Imaging/DiffusionParameters.h"

namespace isthmus
{

/// True if the coefficient needs FillEdgeCoefficient.
bool LooksBeyondNeighbours(const DiffusionParameters& parameters);

/**
 * Fills `coefficient` with exp(-|grad v|^2 / (2 sigma^2)) at every node.
 *
 * v is `values` under a Gaussian of standard deviation PreSmoothing (F. Catte, P.-L. Lions,
 * J.-M. Morel, T. Coll, SIAM J. Numer. Anal. 29 (1992) 182), done by heat flow. sigma is given, or
 * with LocalVariance the standard deviation of u (order 0) or of grad u (orders 1 to 3) in the
 * window around the node (4.35). `scratch` are two volumes to work in. Returns how many evaluations
 * of a right-hand side this counts for: the heat flow's and one more.
 */
template <typename T>
int FillEdgeCoefficient(const DiffusionGrid<T>& grid, const DiffusionParameters& parameters,
  const T* values, const std::array<T*, 2>& scratch, T* coefficient);

}

#endif
