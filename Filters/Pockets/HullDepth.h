/**
 * @file HullDepth.h
 * @brief The depth of points below the convex hull of a surface.
 */
#ifndef isthmus_HullDepth_h
#define isthmus_HullDepth_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"

#include <array>
#include <vector>

namespace isthmus
{

/**
 * The convex hull, approximated by an intersection of 1000 half spaces n.x <= max over the surface
 * of n.p, with n evenly spread over the sphere (a Fibonacci lattice; no direction is farther than
 * 0.07 from one of them). The intersection contains the hull, so depths are never too small. They
 * are too large by at most 0.07 times the distance from the nearest point of the hull to the
 * nearest of its corners, and on a round hull (radius R) by 0.0025 R. Points that no triangle uses
 * are ignored.
 */
class HullDepth
{
public:
  HullDepth(const SurfaceView& mesh, const ProgressCallback& progress);

  /// Distance of a point within the hull to its boundary.
  double operator()(const double* point) const;

private:
  std::vector<std::array<double, 3>> Directions;
  std::vector<double> Heights;
};

}

#endif
