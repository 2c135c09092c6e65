/**
 * @file CellBox.h
 * @brief The box of a cell of a grid or octree, and the cell at a place.
 */
#ifndef isthmus_CellBox_h
#define isthmus_CellBox_h

#include "Core/Geometry.h"
#include "Surfaces/SurfaceCrossings.h"

namespace isthmus
{

/// The cube of `size` cells each way at `index`, grown by `reach` of its sides, within the grid
/// grown by `reach` cells.
Bounds3 CellBox(const GridShape& shape, const std::array<std::int64_t, 3>& index, std::int64_t size,
  double reach);

/// Lowest node of the cell that `x` lies in, -1 outside the grid.
std::int64_t CellAt(const GridShape& grid, const Point3& x);

}

#endif
