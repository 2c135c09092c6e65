/**
 * @file CellList.h
 * @brief A volume mesh as a list of cells of a few types.
 */
#ifndef isthmus_CellList_h
#define isthmus_CellList_h

#include "CellComplex/CellType.h"
#include "Core/View.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// `NumberOfCells` consecutive cells of one type.
struct CellRun
{
  std::size_t Type = 0; ///< place in the list of types
  std::int64_t NumberOfCells = 0;
};

/// Runs of cells, numbered in their order, and the vertices of all cells one after the other.
struct CellList
{
  std::int64_t NumberOfVertices = 0;
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  View<std::int64_t> CellVertices; ///< not owned
};

}

#endif
