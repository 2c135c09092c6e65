/**
 * @file ShellCrossings.h
 * @brief The region enclosed by several closed shells: one rule for all filters that need an
 * inside.
 *
 * - A shell that lies in another without crossing it bounds a cavity, one within that a solid
 *   again, and so on, whichever way its triangles face: a point is inside where it lies in an odd
 *   number of shells.
 * - Shells that cross or coincide are refused, with the place. By the rule above the overlap would
 *   be outside, by the divergence theorem it would count twice. Neither is intended, and the union
 *   is another surface, which has to be computed (by Tetrahedral Mesher with Library Automatic).
 * - Shells that touch in points, edges or parts of faces count as separate.
 *
 * NodesInside() applies it too.
 */
#ifndef isthmus_ShellCrossings_h
#define isthmus_ShellCrossings_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace isthmus
{

/// Transforms the coordinates of a mesh to those shown to users.
using PlaceInWorld = std::function<Point3(const Point3&)>;

/// Two closed shells whose insides overlap although neither is inside the other.
struct ShellCrossing
{
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< on both
  bool Coincide = false;         ///< they are the same shell twice

  VTKISTHMUSFILTERSSURFACES_EXPORT std::string Message(const PlaceInWorld& inWorld = {}) const;
};

/**
 * A place where two closed shells (components by edges, coinciding points merged) of `mesh` cross;
 * empty if all shells are nested or apart. Open components and crossings of a component with itself
 * are not considered.
 *
 * Shells cross if an edge of one passes through a triangle of the other by more than 1e-10 of the
 * diagonal. If there is no such edge but triangles touch (faces in the same plane, edges through
 * edges), the winding numbers of their points and centers decide. O(n log n + pairs of boxes),
 * parallel, the same result on any number of threads; almost free for a single shell.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::optional<ShellCrossing> FindShellCrossing(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// Triangles of one component that pass through each other, or only touch.
struct SelfCrossing
{
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< of the first pair
  std::int64_t Pairs = 0;        ///< 0: they only touch
};

/**
 * Pairs of triangles of the same component (by edges, coinciding points merged) without a common
 * point, of which an edge of one passes through the other by more than 1e-6 of the diagonal. Parts
 * that such a surface encloses twice count twice in its volume. If there are none, a place where
 * triangles that are no neighbours are nearer to each other than that, or sheets meet in a point:
 * those of a spindle torus touch where all meridians meet. Empty if there is none either. Cost and
 * exceptions as above.
 */
std::optional<SelfCrossing> FindSelfCrossing(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// @throws std::invalid_argument with the place where two closed shells of `mesh` cross.
VTKISTHMUSFILTERSSURFACES_EXPORT void RequireShellsApart(
  const SurfaceView& mesh, const PlaceInWorld& inWorld = {}, const ProgressCallback& progress = {});

}

#endif
