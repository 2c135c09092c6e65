/**
 * @file GridDistance.h
 * @brief Distance from the nodes of a grid to a triangle surface.
 *
 * Within `band` of the surface, the distance is exact: every triangle visits all nodes that near.
 * Farther away it is that to the nearest crossing of the surface with a line of the grid, by the
 * lower envelopes of P. Felzenszwalb and D. Huttenlocher, "Distance transforms of sampled
 * functions", Theory of Computing 8 (2012) 415, doi:10.4086/toc.2012.v008a019. Crossings lie on the
 * surface, about a spacing h apart, so far values are never too small and too large by at most
 * about h^2 / (2 distance). A surface that crosses no line of the grid is exact everywhere.
 */
#ifndef isthmus_GridDistance_h
#define isthmus_GridDistance_h

#include "Surfaces/SurfaceCrossings.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/**
 * Distance (length, not negative) from each node of `grid` to `mesh`; infinite for an empty mesh.
 *
 * `band` is a length, at least one spacing is used. Parallel, bitwise the same on any number of
 * threads. Time O(triangles x nodes of their boxes grown by the band + about 40 x nodes); memory 16
 * bytes a node and 8 for each triangle and layer of four it is near.
 * @throws std::invalid_argument for a band that is not a positive number, and Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<double> DistanceToSurface(const SurfaceView& mesh,
  const GridShape& grid, double band, const ProgressCallback& progress = {});

/**
 * The same, exact at every node to the rounding of doubles: the least of the distances from all
 * triangles, found in a TriangleTree that each node of a block of 8^3 enters with the nearest
 * triangle of the node before: blocks, since what they need of the tree stays in the caches.
 *
 * Time: O(triangles log triangles) for the tree, then some microseconds a node and thread, more
 * where a large part of the surface is equally far (the centre of a sphere). Memory 8 bytes a node
 * and 150 a triangle. Parallel, bitwise the same on any number of threads.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<double> ExactDistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, const ProgressCallback& progress = {});

}

#endif
