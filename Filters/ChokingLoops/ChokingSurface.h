/**
 * @file ChokingSurface.h
 * @brief What choking loops ask of a surface, and how it is told when it does not comply.
 */
#ifndef isthmus_ChokingSurface_h
#define isthmus_ChokingSurface_h

#include "ChokingLoops/SurfaceMending.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/**
 * `surface` with coinciding points merged and unused ones left out, if it is closed, manifold,
 * consistently oriented, finite, between 1e-32 and 1e32 in size, not in a plane and, unless
 * `allowCrossings`, free of self-intersections. Else std::invalid_argument with a sentence that
 * names the triangles.
 *
 * With `mending`, what is closed and oriented but has crossings, touching or double parts or thin
 * triangles is repaired as MendedSurface() does, and what was done is told there.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh CheckedSurface(TriangleMesh surface,
  bool allowCrossings, const ProgressCallback& progress = {}, SurfaceMending* mending = nullptr);

}

#endif
