/**
 * @file GridMap.h
 * @brief The combinatorial map of a vtkUnstructuredGrid, with ids as wide as it needs.
 */
#ifndef isthmus_GridMap_h
#define isthmus_GridMap_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/GridCells.h"

#include <vtkUnstructuredGrid.h>

namespace isthmus
{

/// Calls `use(map)`, with 32-bit ids if these suffice.
template <typename Use>
void WithMap(const GridCells& cells, const ProgressCallback& progress, Use&& use)
{
  const CellList list = cells.List();
  if (CompactCombinatorialMap<std::uint32_t>::FitsIn(list))
  {
    use(CompactCombinatorialMap<std::uint32_t>(list, progress));
  }
  else
  {
    use(CompactCombinatorialMap<std::uint64_t>(list, progress));
  }
}

/**
 * Calls `use(map, cells)` with the map of `grid`. Cells are oriented by the sign of their volume,
 * so that faces point outwards. If the result is inconsistent, e.g. because tangled cells have a
 * negative volume, the orientation of VTK's numbering is used.
 * @throws MeshError if that is inconsistent, too.
 */
template <typename Use>
void WithMap(vtkUnstructuredGrid* grid, const ProgressCallback& progress, Use&& use)
{
  const auto attempt = [&](GridCells::Orientation orientation)
  {
    const GridCells cells(grid, orientation, Between(progress, 0.0, 0.3));
    WithMap(cells, Between(progress, 0.3, 1.0), [&](const auto& map) { use(map, cells); });
  };
  try
  {
    attempt(GridCells::Orientation::ByVolume);
  }
  catch (const MeshError& error)
  {
    if (error.Kind() != MeshError::Reason::Orientation)
    {
      throw;
    }
    attempt(GridCells::Orientation::AsGiven);
  }
}

}

#endif
