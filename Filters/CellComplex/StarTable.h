/**
 * @file StarTable.h
 * @brief The cells around each vertex of a combinatorial map, as a list: table V2S.
 *
 * VertexStar walks a star with the map's own tables, which is better for a few queries. This table
 * needs more memory than all of those, and is worthwhile if the star of every vertex is needed.
 */
#ifndef isthmus_StarTable_h
#define isthmus_StarTable_h

#include "CellComplex/DartMap.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

namespace isthmus
{

/// Memory: n0 + 1 ids and one for each vertex of each cell. Built in time linear in these.
template <typename Id>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT StarTable
{
public:
  using Map = DartMap<Id>;
  using Vertex = typename Map::Vertex;
  using Dart = typename Map::Dart;

  explicit StarTable(const Map& map);

  /// One dart that starts at `vertex` for each cell around it, ordered by cell.
  View<Dart> Find(Vertex vertex) const
  {
    const Id first = this->Offsets[vertex.Value];
    return { this->Darts.data() + first,
      static_cast<std::size_t>(this->Offsets[vertex.Value + std::size_t(1)] - first) };
  }

  void AppendMemory(std::vector<TableMemory>& report) const;

private:
  std::vector<Id> Offsets;
  std::vector<Dart> Darts;
};

}

#endif
