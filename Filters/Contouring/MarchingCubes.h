/**
 * @file MarchingCubes.h
 * @brief A level set of a grid as a closed, manifold surface, by marching cubes.
 */
#ifndef isthmus_MarchingCubes_h
#define isthmus_MarchingCubes_h

#include "Core/GridView.h"
#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersContouringModule.h"

namespace isthmus
{

struct MarchingCubesParameters
{
  double Level = 0.0;
  bool InsideIsHigher = true; ///< else the inside is where values are lower
  bool CloseAtBorder = true;  ///< close the surface half a cell beyond the grid where it leaves it
};

/**
 * Triangles of the level set of `grid` in the frame of the grid: first node at the origin, axes
 * along the grid, lengths by spacing; counter-clockwise seen from outside.
 *
 * Each cut edge of the grid gives one point, so the surface is a manifold for any values. With
 * CloseAtBorder it is closed, otherwise open only at the faces of the grid (W. E. Lorensen, H. E.
 * Cline, SIGGRAPH 21 (1987) 163; VTK's table of cases, which agrees across faces). A point is at
 * least a thousandth of its edge away from both ends, so that triangles have an area even where a
 * node has exactly the level. Values that are not numbers are outside; the surface passes halfway
 * between them and their neighbours.
 *
 * Parallel over layers, the same mesh on any number of threads. Time: two passes that compare each
 * node with the level, and the surface; memory: four ids for each node of two layers for each
 * thread, and the mesh.
 * @throws std::invalid_argument for a level that is not a finite number; Cancelled.
 */
template <typename T>
VTKISTHMUSFILTERSCONTOURING_EXPORT TriangleMesh MarchingCubes(const GridView<const T>& grid,
  const MarchingCubesParameters& parameters, const ProgressCallback& progress = {});

}

#endif
