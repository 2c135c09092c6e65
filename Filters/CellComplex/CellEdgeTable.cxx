#include "CellComplex/CellEdgeTable.h"

#include "Core/ParallelFor.h"

namespace isthmus
{

template <typename Id>
CellEdgeTable<Id>::CellEdgeTable(const Map& map, const EdgeTable<Id>& edges)
  : Mesh(map)
  , C2E(map.NumberOfDarts() / 2)
{
  constexpr std::int64_t cellsPerPiece = 1 << 14;
  ParallelFor(0, static_cast<std::int64_t>(map.NumberOfCells()), cellsPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t c = first; c < last; ++c)
      {
        for (const Dart dart : map.EdgeDarts(Cell(static_cast<Id>(c))))
        {
          this->C2E[map.IndexOf(dart) / 2] = edges.Of(dart);
        }
      }
    });
}

template <typename Id>
void CellEdgeTable<Id>::AppendMemory(std::vector<TableMemory>& report) const
{
  report.push_back({ "C2E", this->C2E.capacity() * sizeof(Edge) });
}

template class CellEdgeTable<std::uint32_t>;
template class CellEdgeTable<std::uint64_t>;

}
