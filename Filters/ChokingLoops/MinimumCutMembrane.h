/**
 * @file MinimumCutMembrane.h
 * @brief The smallest membrane through a choke triangle, whatever cycles the filtration closed.
 */
#ifndef isthmus_MinimumCutMembrane_h
#define isthmus_MinimumCutMembrane_h

#include "ChokingLoops/SpaceRegions.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

struct ShapeFeature;

/**
 * Triangles of the complex that part the space on one side of a feature's choke triangle from that
 * on the other: of all such sets the one of least area, as far as it hangs together with the choke
 * triangle. What is wider than the choke on either side (deeper than its radius and within 1.5
 * radii of `centre`) stays whole, so that the membrane runs through the choke point and does not
 * wrap the way through it.
 *
 * It stands in for the cycle that an edge closed, which may run round the whole shape. The search
 * begins within 3 radii of `centre` and goes on to 6 where the membrane needs it. The boundary lies
 * on M, up to edges as short as the sampling error. Empty when nothing parts the sides there, or
 * beyond 50,000 tetrahedra within reach. Cost: that of MinimumCut on the tetrahedra within
 * reach, which a walk from the choke triangle finds.
 *
 * Empty, too, where the choke triangle lies on M. @pre `feature.Choke` is a triangle of the
 * complex.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleChain TightestCut(const FeatureContext& context,
  const ShapeFeature& feature, const Point3& centre, const ProgressCallback& progress = {});

}

#endif
