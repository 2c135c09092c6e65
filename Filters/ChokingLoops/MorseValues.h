/**
 * @file MorseValues.h
 * @brief Functions on a tetrahedral mesh that grow with the distance from a surface.
 */
#ifndef isthmus_MorseValues_h
#define isthmus_MorseValues_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// The numbers are vtkChokingLoops::MorseFunctionType's.
enum class MorseFunction
{
  ClosestPoint = 0, ///< exact
  EdgePaths = 1,    ///< shortest way along edges of the mesh (thesis, field B)
  GridDistance = 2, ///< exact at the nodes of a grid, between them trilinear (field A)
  FastMarching = 4  ///< marched on that grid (field C)
};

/// Cells of the grids along the longest side of the mesh's box.
constexpr std::int64_t MorseGridCells = 100;

/// Values at the mesh's points, 0 on the surface. Errors and cost: SurfaceDistance.h,
/// EdgeDistances.h.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<double> MorseValues(const SurfaceView& surface,
  const TetrahedralMesh& mesh, MorseFunction function, const ProgressCallback& progress = {});

}

#endif
