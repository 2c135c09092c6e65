/**
 * @file SurfaceCoarsening.h
 * @brief A closed surface with fewer points, as fine as given sizes require, near a fine one.
 */
#ifndef isthmus_SurfaceCoarsening_h
#define isthmus_SurfaceCoarsening_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// Result of CoarsenSurface().
struct CoarseSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> Origin; ///< for each point of Mesh: the point of the input that it is
  /// For each point of Mesh: upper bound for the distance from Mesh of the points of the input that
  /// are assigned to its triangles and those of its neighbours.
  std::vector<double> Deviation;
  /// For each point of the input: a triangle of Mesh within its tolerance.
  std::vector<std::int64_t> Nearest;
};

/**
 * Collapses edges of `surface` where its triangles are finer than required, so that no new edge is
 * longer than `size` at either of its ends, and no point of the input is farther from the result
 * than `tolerance` there. Points of the result are points of the input; the number of components
 * and their genus stay the same. Where the input is coarser than `size`, it stays as it is.
 *
 * Each removed point is assigned to a triangle of the result, and its distance from that triangle
 * is checked at each collapse that changes it (R. Klein, G. Liebich, W. Strasser, "Mesh reduction
 * with error control", IEEE Visualization 1996). An edge is collapsed only if its ends have exactly
 * two common neighbours (T. Dey et al., "Topology preserving edge contraction", 1999), and if no
 * triangle turns by more than 60 degrees. The result may intersect itself where sheets are closer
 * than the tolerance.
 *
 * O(n log(n / m)) for m points of the result: about 2 microseconds a point. Memory: about 100 bytes
 * a point besides the input. The result does not depend on the number of threads.
 *
 * @pre `surface` is closed, manifold and oriented, `size` and `tolerance` have a positive value for
 * each point.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT CoarseSurface CoarsenSurface(const SurfaceView& surface,
  const std::vector<double>& size, const std::vector<double>& tolerance,
  const ProgressCallback& progress = {});

}

#endif
