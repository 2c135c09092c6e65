/**
 * @file SurfaceMending.h
 * @brief Small damage of a surface repaired before its choking loops are sought.
 */
#ifndef isthmus_SurfaceMending_h
#define isthmus_SurfaceMending_h

#include "Core/Progress.h"
#include "Core/SurfaceView.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <string>

namespace isthmus
{

/// What was done to a surface.
struct SurfaceMending
{
  std::int64_t Changed = 0;   ///< triangles of the input that are no longer there
  std::vector<Point3> Places; ///< their centres
  std::string Told;           ///< one sentence; empty: nothing was done
};

/// More than this share of the volume is not changed.
constexpr double MendedShare = 0.01;

/**
 * `surface` closed, manifold and oriented, without thin triangles and, unless `allowCrossings`,
 * without crossings: needles and caps as in ThinTriangles.h, double triangles and crossings as in
 * SurfaceRepair.h; points where sheets touch become several, each drawn a hundredth of the way to
 * the middle of its neighbours.
 *
 * std::invalid_argument with a sentence when that fails or changes the volume by more than
 * MendedShare. `what` says what is wrong and begins that sentence.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT TriangleMesh MendedSurface(const SurfaceView& surface,
  const std::string& what, bool allowCrossings, SurfaceMending& mending,
  const ProgressCallback& progress = {});

}

#endif
