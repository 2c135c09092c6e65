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
/// is closed, manifold, oriented and free of self-intersections. The remedy that it names is not
/// repair where the surface is `repaired` already.
VTKISTHMUSFILTERSREMESHING_EXPORT void RequireCleanSurface(
  const SurfaceView& mesh, const ProgressCallback& progress = {}, bool repaired = false);

/// The triangles of `mesh`, coinciding points merged, duplicates dropped, and
/// neighbours turned alike; as it is where that is so already. @pre corners exist and are finite.
VTKISTHMUSFILTERSREMESHING_EXPORT TriangleMesh OrientConsistently(const SurfaceView& mesh);

struct RepairedSurface
{
  TriangleMesh Mesh;
  std::vector<std::int64_t> OriginalPoints; ///< for each point: its id in the input, or -1
  std::string Changes;                      ///< one message; empty when nothing was changed
};

/**
 * A closed, manifold, outward oriented surface made of `mesh`: invalid and duplicate triangles
 * removed, coinciding points merged, orientation made consistent (points duplicated where it can't
 * be), holes filled, self-intersections removed (CGAL's experimental routine).
 *
 * It need not succeed: what comes out must be checked with RequireCleanSurface().
 * @throws std::invalid_argument when nothing closed is left, std::runtime_error where that routine
 * tears the surface, Cancelled.
 */
VTKISTHMUSFILTERSREMESHING_EXPORT RepairedSurface RepairSurface(
  const SurfaceView& mesh, const ProgressCallback& progress = {});

}

#endif
