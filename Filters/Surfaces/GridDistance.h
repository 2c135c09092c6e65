/**
 * @file GridDistance.h
 * @brief Distance from the nodes of a grid to a triangle surface.
 *
 * Within `band` of the surface, the distance is exact: every triangle visits all nodes within this
 * distance. Farther away it is the distance to the nearest crossing of the surface with a line of
 * the grid, by the lower envelopes of P. Felzenszwalb and D. Huttenlocher, "Distance transforms of
 * sampled functions", Theory of Computing 8 (2012) 415, doi:10.4086/toc.2012.v008a019. Crossings
 * lie on the surface, about a spacing h apart, so these values are never too small, and too large
 * by at most about h^2 / (2 distance), or by up to 2 h where the nearest point lies within h of a
 * sharp edge or corner. For a surface that crosses no line of the grid, the distance is exact
 * everywhere.
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
 * threads. Time O(triangles x nodes of their boxes grown by the band + about 40 x nodes); memory:
 * 16 bytes for each node, and 8 for each pair of a triangle and a nearby block of four layers.
 * @throws std::invalid_argument for a band that is not a positive number, and Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::vector<double> DistanceToSurface(const SurfaceView& mesh,
  const GridShape& grid, double band, const ProgressCallback& progress = {});

/**
 * The same, but exact at every node up to the rounding of doubles: the smallest of the distances to
 * all triangles, found in a TriangleTree.
 *
 * Time: O(triangles log triangles) for the tree, then a search in it for each node, and more where
 * a large part of the surface is at the same distance (e.g. at the center of a sphere). Memory: 8
 * bytes for each node and 150 for each triangle. Parallel, bitwise the same on any number of
 * threads.
 * @throws Cancelled.
 */
std::vector<double> ExactDistanceToSurface(
  const SurfaceView& mesh, const GridShape& grid, const ProgressCallback& progress = {});

}

#endif
