/**
 * @file ContourRefinement.h
 * @brief The coarsest contour of a hierarchy that is manifold, near enough and free of crossings.
 *
 * The choice of clusters by their own errors is only the beginning: the polygons are made, looked
 * at, and what breaks a promise is taken apart, until nothing does. That ends, since in the end the
 * uniform contour is left, which is manifold. Checked are, in this order:
 * 1. the polygons around each point form one ring of three or more (a chain at the grid's border);
 * 2. no corner, middle of an edge or middle of a triangle of this surface or the uniform one is
 *    farther than the tolerance from the other;
 * 3. where asked for, that no two triangles cross. Where none of their points is a cluster, their
 *    quadrilaterals are cut (ContourPolygons.h); where they cross still, their points go to the
 *    mean of their crossings. Triangles around such a point stay in the hull of its crossings,
 *    which is apart from those of the other points of its cell.
 */
#ifndef isthmus_ContourRefinement_h
#define isthmus_ContourRefinement_h

#include "Contouring/UniformContour.h"

namespace isthmus
{

/// O(n log n) a round; rounds: a few. @throws Cancelled
DualContour RefinedContour(const UniformContour& contour,
  const DualContouringParameters& parameters, const ProgressCallback& progress);

}

#endif
