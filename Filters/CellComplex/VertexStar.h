/**
 * @file VertexStar.h
 * @brief The star and link of a vertex of a combinatorial map, including the edges of the link.
 */
#ifndef isthmus_VertexStar_h
#define isthmus_VertexStar_h

#include "CellComplex/CompactCombinatorialMap.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/StarWalk.h"

namespace isthmus
{

/// A StarWalk that numbers edges by the map's edge table. Cost and memory are those of StarWalk.
template <typename Id = std::uint32_t>
class VertexStar : public StarWalk<Id>
{
public:
  using Map = CompactCombinatorialMap<Id>;
  using typename StarWalk<Id>::Dart;
  using typename StarWalk<Id>::HalfFace;

  explicit VertexStar(const Map& map)
    : StarWalk<Id>(map)
    , Whole(map)
  {
  }

  /// One dart for each edge of the link: the edges of LinkHalfFaces(). Uses the map's Edges().
  View<Dart> LinkEdgeDarts()
  {
    this->Found.Clear();
    this->Buffer.clear();
    for (const HalfFace half : this->LinkHalfFaces())
    {
      for (const Dart dart : this->Mesh.Darts(half))
      {
        if (this->Found.Insert(this->Whole.Edges().Find(dart).Value))
        {
          this->Buffer.push_back(dart);
        }
      }
    }
    return { this->Buffer.data(), this->Buffer.size() };
  }

private:
  const Map& Whole;
};

}

#endif
