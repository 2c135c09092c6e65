/**
 * @file ChokeFit.h
 * @brief Does a loop belong to its choke point?
 */
#ifndef isthmus_ChokeFit_h
#define isthmus_ChokeFit_h

#include "ChokingLoops/FeatureDiagram.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * How far the true radius may lie below Distance(): between sqrt(d^2 - e^2) and d, since
 * d_M^2 <= d_S^2 <= d_M^2 + e^2 for a surface M and its samples S.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double UncertaintyOf(const ShapeFeature& feature);

/**
 * No loop that surrounds a choke point is shorter: 2 pi (Distance() - UncertaintyOf()).
 *
 * M keeps that far away from the choke point c. Drawn from c onto the sphere of that radius, a loop
 * on M gets no longer; if c lies in its convex hull, what is drawn lies in no open half of the
 * sphere, and a closed curve on a unit sphere that lies in none is at least 2 pi long (W. Fenchel,
 * Math. Ann. 101 (1929) 238).
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double ShortestGirth(const ShapeFeature& feature);

/// True when `centre` is within `reach` of the convex hull of `points`. By the points that bound
/// it one after another (E. G. Gilbert, SIAM J. Control 4 (1966) 61); O(points) each.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool IsSurrounded(
  const Point3& centre, double reach, const std::vector<Point3>& points);

/// Largest angle, in radians, by which a closed polygon turns at a point; points closer together
/// than `least` count as one.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double SharpestTurn(
  const std::vector<Point3>& polygon, double least);

}

#endif
