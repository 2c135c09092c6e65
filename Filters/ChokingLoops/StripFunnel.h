/**
 * @file StripFunnel.h
 * @brief The shortest path through a row of edges in the plane.
 *
 * Source: D. T. Lee, F. P. Preparata, "Euclidean shortest paths in the presence of rectilinear
 * barriers", Networks 14 (1984) 393: the funnel between the borders of a sleeve of triangles.
 */
#ifndef isthmus_StripFunnel_h
#define isthmus_StripFunnel_h

#include "ChokingLoops/EdgeStrip.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * The shortest path from `p` on the first edge to `q` on the last one that crosses all edges
 * between: where it crosses each of these, as fractions from From to To; 0 or 1 where it bends
 * round an end. Entry 0 belongs to the first edge and is 0. O(number of edges) for most strips.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<double> ShortestCrossings(
  const UnfoldedStrip& plane, const Point2& p, const Point2& q);

}

#endif
