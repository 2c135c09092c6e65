/**
 * @file MorseValues.h
 * @brief The functions on a tetrahedral mesh by which X. Feng, PhD thesis, 6.3.2, filters it:
 * distances to a surface, and approximations to them.
 */
#ifndef isthmus_MorseValues_h
#define isthmus_MorseValues_h

#include "Core/TetrahedralMesh.h"
#include "Persistence/SurfaceDistance.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * Length of the shortest path along edges of the mesh from each of its points to the nearest point
 * of `sources` (Dijkstra's algorithm). Infinity where there is none. O(n log n).
 */
std::vector<double> EdgeDistances(const TetrahedralMesh& mesh,
  const std::vector<std::int64_t>& sources, const ProgressCallback& progress = {});

/**
 * ComputeDistanceGrid() by fast marching (FastMarch()) from the nodes within two spacings of the
 * surface, where it is exact: |grad d| = 1 solved to first order, error O(h log h).
 */
DistanceGrid MarchedDistances(const SurfaceView& surface, const Bounds3& box, std::int64_t cells,
  const ProgressCallback& progress = {});

/// The numbers are vtkChokingLoops::MorseFunctionType's.
enum class MorseFunction
{
  ClosestPoint = 0, ///< exact
  EdgePaths = 1,    ///< shortest way along edges of the mesh (thesis, field B)
  GridDistance = 2, ///< exact at the nodes of a grid, between them trilinear (field A)
  FastMarching = 4  ///< marched on that grid (field C)
};

/// Number of cells of the grids along the longest side of the bounding box of the mesh.
constexpr std::int64_t MorseGridCells = 100;

/// Values at the mesh's points, 0 on the surface. For errors and cost see above, and
/// SurfaceDistance.h.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<double> MorseValues(const SurfaceView& surface,
  const TetrahedralMesh& mesh, MorseFunction function, const ProgressCallback& progress = {});

}

#endif
