/**
 * @file ShellCrossings.h
 * @brief What several closed shells enclose: one rule for all filters that need an inside.
 *
 * - A shell that lies in another without crossing it bounds a cavity, one within that a solid
 *   again, and so on, whichever way its triangles face: a point is inside where it lies in an odd
 *   number of shells.
 * - Shells that cross or coincide are refused, with the place. By the rule above the overlap would
 *   be outside, by the divergence theorem it would count twice; neither is what is meant, and the
 *   union is a surface that has to be made (by Tetrahedral Mesher with Library Automatic).
 * - Shells that touch in points, edges or parts of faces count as apart.
 *
 * NodesInside() applies it too.
 */
#ifndef isthmus_ShellCrossings_h
#define isthmus_ShellCrossings_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

#include <functional>
#include <optional>
#include <string>

namespace isthmus
{

/// From the coordinates of a mesh to those that users know.
using PlaceInWorld = std::function<Point3(const Point3&)>;

/// Two closed shells that enclose a part of space together without one being in the other.
struct ShellCrossing
{
  Point3 Place{ 0.0, 0.0, 0.0 }; ///< on both
  bool Coincide = false;         ///< they are the same shell twice

  VTKISTHMUSFILTERSSURFACES_EXPORT std::string Message(const PlaceInWorld& inWorld = {}) const;
};

/**
 * A place where two closed shells (components by edges, coinciding points merged) of `mesh` cross;
 * nothing where they are nested or apart. Open components and crossings of a component with itself
 * are not looked at.
 *
 * An edge of one through a triangle of the other, by more than 1e-10 of the diagonal, decides it.
 * Where there is none, but triangles touch (faces in one plane, edges through edges), winding
 * numbers of their points and middles decide. O(n log n + pairs of boxes), parallel, the same
 * answer on any number of threads; nearly nothing for a single shell.
 * @throws Cancelled.
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::optional<ShellCrossing> FindShellCrossing(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

/// @throws std::invalid_argument with the place where two closed shells of `mesh` cross.
VTKISTHMUSFILTERSSURFACES_EXPORT void RequireShellsApart(
  const SurfaceView& mesh, const PlaceInWorld& inWorld = {}, const ProgressCallback& progress = {});

}

#endif
