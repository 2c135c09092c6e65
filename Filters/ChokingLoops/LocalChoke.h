/**
 * @file LocalChoke.h
 * @brief The radius of a narrowing of a fine surface, from its points around the choke alone.
 */
#ifndef isthmus_LocalChoke_h
#define isthmus_LocalChoke_h

#include "ChokingLoops/AdaptiveSamples.h"
#include "ChokingLoops/FeatureDiagram.h"

#include <optional>

namespace isthmus
{

/// Where a ball gets stuck between the points of a fine surface.
struct LocalChoke
{
  double Radius = 0.0; ///< no larger ball passes between the points
  double Lower = 0.0;  ///< a ball of this radius passes between the triangles of the surface
  Point3 Center{ 0.0, 0.0, 0.0 };
};

/**
 * The narrowing of `fine` at a choke of its samples.
 *
 * A path along the edges of the Voronoi diagram of the samples leaves the choke on both sides; no
 * sample is nearer to it than the choke's radius, and it ends where the surface is farther away
 * than that in spite of the errors (FineSurface). Points of the surface that are nearer to the path
 * are added to the samples around it, and the path through the widest bottleneck between its ends
 * is found again, until no point is nearer than `tolerance` (a fraction of the radius) below the
 * bottleneck. With t, the surface's own sampling error, its triangles are then at least
 * sqrt(d^2 - t^2) away from a path whose nearest point has the distance d.
 *
 * Empty where the samples are too coarse for such a path, or if the search does not end. O(n / 1000
 * + m log m) for m samples around the choke.
 */
std::optional<LocalChoke> FindLocalChoke(
  const FeatureContext& context, const FineSurface& fine, TriangleId choke, double tolerance);

/// The same for the largest ball near `center`, where `radius` is its radius between the samples.
std::optional<LocalChoke> FindLocalDeath(const FeatureContext& context, const FineSurface& fine,
  const Point3& center, double radius, double tolerance);

}

#endif
