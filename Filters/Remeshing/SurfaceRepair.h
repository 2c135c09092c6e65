/**
 * @file SurfaceRepair.h
 * @brief Repair of surfaces by CGAL.
 */
#ifndef isthmus_SurfaceRepair_h
#define isthmus_SurfaceRepair_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Remeshing/SelfIntersections.h"
#include "vtkIsthmusFiltersRemeshingModule.h"

#include <string>

namespace isthmus
{

/// @throws std::invalid_argument with a message that names what is wrong, and where, unless `mesh`
/// is closed, manifold, oriented and free of self-intersections. The message does not suggest a
/// repair if the surface has already been `repaired`.
VTKISTHMUSFILTERSREMESHING_EXPORT void RequireCleanSurface(
  const SurfaceView& mesh, const ProgressCallback& progress = {}, bool repaired = false);

/// The triangles of `mesh` with coinciding points merged, duplicates dropped, and neighbours
/// oriented consistently; unchanged if that is already the case.
/// @pre corners exist and are finite.
VTKISTHMUSFILTERSREMESHING_EXPORT TriangleMesh OrientConsistently(const SurfaceView& mesh);

struct RepairedSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input, or -1
  std::string Changes;                      ///< one message; empty when nothing was changed
};

/**
 * A closed, manifold, outward oriented surface made from `mesh`: invalid and duplicate triangles
 * are removed, coinciding points are merged, orientation is made consistent (points are duplicated
 * where that is impossible), holes are filled, and self-intersections are removed (by an
 * experimental function of CGAL).
 *
 * It can fail: the result must be checked with RequireCleanSurface().
 * @throws std::invalid_argument if nothing closed is left, std::runtime_error if that function
 * tears the surface, Cancelled.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT RepairedSurface RepairSurface(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

}

#endif
