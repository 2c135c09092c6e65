/**
 * @file LoopLimits.h
 * @brief Loops that are too long, or too far from where the ball gets stuck, left out.
 *
 * Source: X. Feng, PhD thesis, 6.5: a ball is stuck in a slot long before it is in a round passage
 * of the same girth. Where round ones are sought, loops are sorted by length, and those round a
 * choke face that do not reach the surface within a given distance are discarded.
 */
#ifndef isthmus_LoopLimits_h
#define isthmus_LoopLimits_h

#include "ChokingLoops/SharedLoops.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

struct LoopLimits
{
  double MaximumLength = 0.0; ///< of a feature's longest loop, in the unit of the points; 0: any
  double MaximumReach = 0.0;  ///< ReachOf() a feature; 0: any
  bool ByLength = false;      ///< ascending by the longest loop instead of by radius
};

/// Distance of the farthest point of a feature's loops from its choke point, in radii: 1 and little
/// more for a round neck, sqrt(1 + (a/b)^2) for a slot with sides a and b < a.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double ReachOf(
  const ChokingLoops& loops, const ShownFeature& feature);

/// Leaves out what is beyond the limits, and sorts. Where the first of several features that share
/// a loop goes, the next takes its place in SharedWith. O(points of all loops).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void KeepWithin(
  const ChokingLoops& loops, const LoopLimits& limits, std::vector<ShownFeature>& features);

}

#endif
