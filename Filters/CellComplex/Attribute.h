/**
 * @file Attribute.h
 * @brief Values on the vertices, edges, faces, half faces, darts or cells of a combinatorial map.
 */
#ifndef isthmus_Attribute_h
#define isthmus_Attribute_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"

#include <vector>

namespace isthmus
{

/// @name Number of cells of a kind in a map; the second argument only selects the kind
///@{
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, VertexHandle<Id>)
{
  return map.NumberOfVertices();
}
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, EdgeHandle<Id>)
{
  return map.Edges().Size();
}
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, FaceHandle<Id>)
{
  return map.NumberOfFaces();
}
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, HalfFaceHandle<Id>)
{
  return map.NumberOfHalfFaces();
}
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, DartHandle<Id>)
{
  return map.NumberOfDarts();
}
template <typename Id>
std::size_t CountElements(const CompactCombinatorialMap<Id>& map, CellHandle<Id>)
{
  return map.NumberOfCells();
}
///@}

/**
 * An array with one value for each `Cell` (Map::Vertex, Map::Edge, ...), which only handles of that
 * kind can index. The map must outlive it. Access is O(1).
 */
template <typename Map, typename Cell, typename Value>
class Attribute
{
public:
  explicit Attribute(const Map& map, const Value& initial = Value())
    : Mesh(map)
    , List(CountElements(map, Cell()), initial)
  {
  }
  Value& operator[](Cell cell) { return this->List[this->Mesh.GetIndex(cell)]; }
  const Value& operator[](Cell cell) const { return this->List[this->Mesh.GetIndex(cell)]; }
  /// All values, in the order of the cells' numbers.
  const std::vector<Value>& Values() const { return this->List; }

private:
  const Map& Mesh;
  std::vector<Value> List;
};

}

#endif
