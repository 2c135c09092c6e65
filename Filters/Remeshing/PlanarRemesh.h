/**
 * @file PlanarRemesh.h
 * @brief Triangles with a bound on their angles for a surface in a plane, by Delaunay refinement.
 *
 * J. Ruppert, J. Algorithms 18 (1995) 548, doi:10.1006/jagm.1995.1021, in CGAL's Mesh_2.
 */
#ifndef isthmus_PlanarRemesh_h
#define isthmus_PlanarRemesh_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"

#include <cstdint>

namespace isthmus
{

struct PlanarRemeshParameters
{
  double EdgeLength; ///< that of the largest equilateral triangle whose circumscribed circle is
                     ///< as large as one may be
  double Angle;      ///< least angle of triangles, degrees, where the boundary has no smaller one
  std::int64_t MaximumPoints;
};

/// @throws std::runtime_error, which says what to change.
[[noreturn]] void RejectManyPoints(std::int64_t most);

/// Whether all points lie in a plane, up to rounding (1e-11 of the size).
bool IsPlanar(const SurfaceView& part);

/**
 * Delaunay refinement of a connected `part` that IsPlanar(), with the bounds of
 * DelaunayRemesh(), which refines tetrahedra and so has nothing to start from here. Points of
 * boundaries stay; their edges are split.
 *
 * @throws std::invalid_argument where the part lies on itself or its boundaries cross,
 * std::runtime_error beyond parameters.MaximumPoints, Cancelled.
 */
TriangleMesh PlanarRemesh(const SurfaceView& part, const PlanarRemeshParameters& parameters,
  const ProgressCallback& progress);

}

#endif
