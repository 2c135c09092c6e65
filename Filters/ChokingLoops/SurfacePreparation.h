/**
 * @file SurfacePreparation.h
 * @brief A surface split so finely that its points stand for the whole of it.
 */
#ifndef isthmus_SurfacePreparation_h
#define isthmus_SurfacePreparation_h

#include "Core/Progress.h"
#include "Core/SurfaceView.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <functional>

namespace isthmus
{

/**
 * For each point of `mesh`: the largest distance e from a point of a triangle to the nearest corner
 * of that triangle, over the triangles round the point and round its neighbours.
 *
 * For a surface M whose points S are samples, d_M^2 <= d_S^2 <= d_M^2 + e^2 everywhere: a feature
 * of S with death^2 - birth^2 > e^2 is one of M, and a radius d of S means one of M between
 * sqrt(d^2 - e^2) and d. O(n).
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<double> SamplingErrors(const SurfaceView& mesh);

/// Edge length that spreads about `points` samples evenly over the area of `mesh`.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double EdgeLengthFor(const SurfaceView& mesh, double points);

/**
 * Splits edges longer than `limit(point, point)` at their midpoints, again and again, until none is
 * left. Same surface, same orientation, first points unchanged. `limit` gets the two ends.
 *
 * An empty mesh when that takes more than `maximumPoints`.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh SplitLongEdges(TriangleMesh mesh,
  const std::function<double(const Point3&, const Point3&)>& limit, std::size_t maximumPoints,
  const ProgressCallback& progress = {});

}

#endif
