/**
 * @file BallDistance.h
 * @brief The distance to a union of balls on the nodes of a flow's grid.
 *
 * d(x) = min_i (|x - x_i| - r_i): the exact distance outside of the union; inside it is negative,
 * and exact up to where balls cut each other.
 */
#ifndef isthmus_BallDistance_h
#define isthmus_BallDistance_h

#include "Core/Progress.h"
#include "MolecularSurfaces/FlowField.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <vector>

namespace isthmus
{

/**
 * Writes d, in spacings and clamped to +-`band` spacings, to the array `to` (one value for each
 * node of `grid`), for balls whose radius is `scale` times the radius plus `more` angstrom. Time:
 * O(nodes + sum over balls of the nodes within radius and band). The result depends neither on the
 * order of the balls nor on the threads.
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void DistanceToBalls(const FlowGrid& grid,
  const std::vector<Ball>& balls, double scale, double more, double band, std::vector<float>& to,
  const ProgressCallback& progress = {});

}

#endif
