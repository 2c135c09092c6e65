/**
 * @file EdgeDistances.h
 * @brief Shortest paths along the edges of a tetrahedral mesh.
 */
#ifndef isthmus_EdgeDistances_h
#define isthmus_EdgeDistances_h

#include "Core/Progress.h"
#include "Core/TetrahedralMesh.h"

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

}

#endif
