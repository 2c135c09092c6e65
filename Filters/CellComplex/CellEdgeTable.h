/**
 * @file CellEdgeTable.h
 * @brief The number of each edge of each cell of a combinatorial map, as a list: table C2E.
 *
 * EdgeTable finds the edge of a dart by a short search; where the edges of all cells are asked for
 * again and again this table gives them at once, for more memory.
 */
#ifndef isthmus_CellEdgeTable_h
#define isthmus_CellEdgeTable_h

#include "CellComplex/EdgeTable.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

namespace isthmus
{

/// Memory: one id for each edge of each cell. Built in parallel from the table of edges.
template <typename Id>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT CellEdgeTable
{
public:
  using Map = DartMap<Id>;
  using Edge = typename Map::Edge;
  using Cell = typename Map::Cell;
  using Dart = typename Map::Dart;

  CellEdgeTable(const Map& map, const EdgeTable<Id>& edges);

  Edge Of(Dart dart) const { return this->C2E[this->Mesh.IndexOf(dart) / 2]; }
  /// The edges of a cell, in the order of the map's EdgeDarts(cell).
  View<Edge> Of(Cell cell) const
  {
    return { this->C2E.data() + this->Mesh.IndexOf(this->Mesh.MakeDart(cell, 1)) / 2,
      this->Mesh.EdgeDarts(cell).size() };
  }

  void AppendMemory(std::vector<TableMemory>& report) const;

private:
  const Map& Mesh;
  std::vector<Edge> C2E;
};

}

#endif
