/**
 * @file GridDistance.h
 * @brief Distance from the nodes of a grid to a triangle surface.
 *
 * Within `band` of the surface, the distance is exact: every triangle visits all nodes that near.
 * From there, nodes hand their nearest triangle to their neighbours, along x, y and z in both
 * directions and again until nothing changes; each node takes it if it is nearer than its own. In
 * the end, each looks for a nearer one around the corners of its triangle, until there is none. Far
 * values are thus distances to a true triangle, never too small, at a minimum of the distance; near
 * the medial axis, where several minima are about as deep, it may be that of another one.
 */
#ifndef isthmus_GridDistance_h
#define isthmus_GridDistance_h

#include "SurfaceCrossings.h"

namespace isthmus
{

/**
 * Distance (length, not negative) from each node of `grid` to `mesh`; infinite for an empty mesh.
 *
 * `band` is a length, at least one spacing is used. Parallel, the same bits on any number of
 * threads. Time O(#triangles x nodes of their boxes grown by the band + some 40 x nodes); memory 16
 * bytes a node and 8 for each triangle and layer of four it is near. Throws std::invalid_argument
 * for a band that is not a positive number, and Cancelled.
 */
VTKISTHMUS_EXPORT std::vector<double> DistanceToSurface(const SurfaceView& mesh,
  const GridShape& grid, double band, const ProgressCallback& progress = {});

}

#endif
