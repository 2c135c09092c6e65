#include "CellComplex/StarTable.h"

namespace isthmus
{

template <typename Id>
StarTable<Id>::StarTable(const Map& map)
  : Offsets(map.NumberOfVertices() + 1, 0)
{
  std::size_t corners = 0;
  for (std::size_t c = 0; c < map.NumberOfCells(); ++c)
  {
    for (const Vertex vertex : map.Vertices(typename Map::Cell(static_cast<Id>(c))))
    {
      ++this->Offsets[vertex.Value];
      ++corners;
    }
  }
  // First the ends of each star; filling backwards, last cell first, turns them into beginnings.
  Id sum = 0;
  for (Id& offset : this->Offsets)
  {
    offset = sum += offset;
  }
  this->Darts.resize(corners);
  for (std::size_t c = map.NumberOfCells(); c-- > 0;)
  {
    const typename Map::Cell cell(static_cast<Id>(c));
    const View<Vertex> vertices = map.Vertices(cell);
    const CellType& type = map.GetType(cell);
    for (unsigned v = 0; v < vertices.size(); ++v)
    {
      this->Darts[--this->Offsets[vertices[v].Value]] = map.MakeDart(cell, type.VertexDart(v, 0));
    }
  }
}

template <typename Id>
void StarTable<Id>::AppendMemory(std::vector<TableMemory>& report) const
{
  report.push_back(
    { "V2S", this->Offsets.capacity() * sizeof(Id) + this->Darts.capacity() * sizeof(Dart) });
}

template class StarTable<std::uint32_t>;
template class StarTable<std::uint64_t>;

}
