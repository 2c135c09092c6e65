/**
 * @file GridCells.h
 * @brief The volume cells of a vtkUnstructuredGrid as a list of cells of a few types.
 */
#ifndef isthmus_GridCells_h
#define isthmus_GridCells_h

#include "CellComplex/CellType.h"
#include "Core/InvertedCells.h"
#include "Core/Progress.h"

#include "vtkIsthmusFiltersCellComplexModule.h" // for the export macro

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace isthmus
{

/// One kind of linear VTK cell.
struct GridCellType
{
  int VTKType;
  CellType Type;              ///< VTK's faces, in VTK's numbering
  std::vector<int> TurnedOut; ///< the order of vertices that reverses the orientation of the cell
};

/// The linear VTK volume cells, except polyhedra.
VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT const std::vector<GridCellType>& LinearCellTypes();

/**
 * Reads the three-dimensional cells: linear cells, VTK_POLYHEDRON (with faces oriented consistently
 * with the first one), and quadratic and Lagrange cells, represented by their corners.
 */
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT GridCells
{
public:
  enum class Orientation
  {
    AsGiven, ///< oriented according to VTK's numbering
    ByVolume ///< reversed where the signed volume is negative
  };

  /// Time and memory O(cells).
  /// @throws std::invalid_argument naming the cell for a volume cell that has no fixed faces
  /// (VTK_CONVEX_POINT_SET) or a polyhedron that is not closed.
  GridCells(
    vtkUnstructuredGrid* grid, Orientation orientation, const ProgressCallback& progress = {});

  CellList List() const;
  std::int64_t NumberOfCells() const { return static_cast<std::int64_t>(this->GridIds.size()); }
  /// The id in the grid of cell `cell` of the list.
  vtkIdType GridId(std::size_t cell) const { return this->GridIds[cell]; }
  /// A message about cells that were simplified or dropped or are inverted; empty if there are
  /// none.
  std::string Remark() const;

private:
  class Builder;

  std::int64_t NumberOfPoints = 0;
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  std::vector<std::int64_t> Vertices;
  std::vector<vtkIdType> GridIds;
  std::int64_t Simplified = 0, DroppedCells = 0;
  InvertedCells Inverted;
};

}

#endif
