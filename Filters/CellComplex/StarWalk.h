/**
 * @file StarWalk.h
 * @brief Walks the cells around a vertex of a combinatorial map.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * Algorithm 2, with the boundary test that its print lacks.
 */
#ifndef isthmus_StarWalk_h
#define isthmus_StarWalk_h

#include "CellComplex/DartMap.h"
#include "CellComplex/ReusableSet.h"
#include "CellComplex/TetrahedronWays.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isthmus
{

/**
 * The star and link of one vertex after the other. Each thread needs one of its own; its memory is
 * that of the largest star it has met, so that queries soon allocate nothing.
 *
 * Views stay valid until the same function, or Gather, is called again. A vertex without cells has
 * an empty star. Cost: about the number of the star's cells times their faces at the vertex.
 */
template <typename Id = std::uint32_t>
class StarWalk
{
public:
  using Map = DartMap<Id>;
  using Vertex = typename Map::Vertex;
  using Dart = typename Map::Dart;
  using HalfFace = typename Map::HalfFace;

  explicit StarWalk(const Map& map)
    : Mesh(map)
    , Ways(map.HasOnlyTetrahedra() ? &WaysOfTetrahedra() : nullptr)
  {
  }

  /// Moves to `vertex`; returns one dart that starts there for each cell around it.
  View<Dart> Gather(Vertex vertex)
  {
    this->Found.Clear();
    this->Count = 0;
    this->Center = vertex;
    this->Flood(this->Mesh.DartOf(vertex));
    for (const auto& further : this->Mesh.FurtherUmbrellas(vertex))
    {
      this->Flood(further.second);
    }
    return this->Star();
  }

  /// Adds the umbrella of the cell of `seed`, a dart at the vertex; false if it was there already.
  bool Extend(Dart seed)
  {
    const std::size_t before = this->Count;
    this->Flood(seed);
    return this->Count > before;
  }

  /// All darts that start at the vertex.
  View<Dart> Darts()
  {
    this->Buffer.clear();
    this->ForEachDart([this](Dart dart) { this->Buffer.push_back(dart); });
    return { this->Buffer.data(), this->Buffer.size() };
  }

  /// One dart that starts at the vertex for each edge there; it ends at a neighbour vertex.
  View<Dart> EdgeDarts()
  {
    this->Found.Clear();
    this->Buffer.clear();
    this->ForEachDart(
      [this](Dart dart)
      {
        if (this->Found.Insert(this->Mesh.EndVertex(dart).Value))
        {
          this->Buffer.push_back(dart);
        }
      });
    return { this->Buffer.data(), this->Buffer.size() };
  }

  /// One half face for each face at the vertex.
  View<HalfFace> HalfFaces()
  {
    this->Faces.clear();
    this->ForEachDart(
      [this](Dart dart)
      {
        const HalfFace half = this->Mesh.HalfFaceOf(dart);
        const Dart across = this->Mesh.Across(half);
        if (this->Mesh.IsOutside(across) || half < this->Mesh.HalfFaceOf(across))
        {
          this->Faces.push_back(half);
        }
      });
    return { this->Faces.data(), this->Faces.size() };
  }

  /// The link: half faces of the star's cells that do not touch the vertex (seen from within).
  View<HalfFace> LinkHalfFaces()
  {
    this->Faces.clear();
    for (const Dart spoke : this->Star())
    {
      for (const HalfFace half : this->Mesh.HalfFaces(this->Mesh.CellOf(spoke)))
      {
        if (!this->Touches(half))
        {
          this->Faces.push_back(half);
        }
      }
    }
    return { this->Faces.data(), this->Faces.size() };
  }

private:
  template <typename Visit>
  void ForEachDart(Visit&& visit) const
  {
    for (const Dart spoke : this->Star())
    {
      Dart dart = spoke;
      do
      {
        visit(dart);
        dart = this->Mesh.Beta1(this->Mesh.Beta2(dart));
      } while (dart != spoke);
    }
  }

  void Flood(Dart seed)
  {
    if (this->Mesh.IsOutside(seed) || !this->Found.Insert(this->Mesh.CellOf(seed).Value))
    {
      return;
    }
    std::size_t next = this->Count;
    this->Add(seed);
    if (this->Ways)
    {
      this->FloodTetrahedra(next);
      return;
    }
    for (; next < this->Count; ++next)
    {
      this->CrossFaces(this->Spokes[next]);
    }
  }

  void Add(Dart spoke)
  {
    this->MakeRoom(this->Count + 1);
    this->Spokes[this->Count++] = spoke;
  }

  typename ReusableSet<Id>::Marks MakeRoom(std::size_t spokes)
  {
    if (this->Spokes.size() < spokes)
    {
      this->Spokes.resize(2 * spokes + 64);
    }
    return this->Found.WithRoomFor(spokes);
  }

  /// Flood for tetrahedra, by tables and in registers; all but the first cell need not look back
  /// where they came from. Each spoke is written, new or not, so that no branch hangs on that.
  void FloodTetrahedra(std::size_t next)
  {
    const TetrahedronWays& ways = *this->Ways;
    const Dart* const beyond = this->Mesh.Neighbours(typename Map::Cell(0)).begin();
    const unsigned bits = this->Mesh.DartBits();
    const Id localMask = static_cast<Id>((Id(1) << bits) - 1);
    std::size_t count = this->Count, room = 0;
    auto marks = this->Found.WithRoomFor(count);
    Dart* spokes = nullptr;
    for (unsigned first = 0; next < count; ++next, first = 1)
    {
      if (room < count + 3)
      {
        marks = this->MakeRoom(count + 3);
        spokes = this->Spokes.data();
        room = std::min(this->Spokes.size(), this->Found.Room());
      }
      const Id spoke = spokes[next].Value;
      const Dart* const faces = beyond + 4 * std::size_t(spoke >> bits);
      const TetrahedronWays::Way* const way = ways.Onward[spoke & localMask].data();
      for (unsigned w = first; w < 3; ++w)
      {
        const Id across = faces[way[w].Face].Value;
        const auto local = static_cast<unsigned>(across & localMask);
        if (local != 0)
        {
          spokes[count] = Dart(across - local + ways.Spoke[local][way[w].Position]);
          count += marks.Insert(across >> bits) ? 1 : 0;
        }
      }
    }
    this->Count = count;
  }

  static const TetrahedronWays& WaysOfTetrahedra()
  {
    static const TetrahedronWays ways;
    return ways;
  }

  /// Adds the new cells beyond the faces at the vertex of one cell.
  void CrossFaces(Dart spoke)
  {
    const auto cell = this->Mesh.CellOf(spoke);
    const CellType& type = this->Mesh.TypeOf(cell);
    const View<Dart> beyond = this->Mesh.Neighbours(cell);
    const unsigned corner = type.At(this->Mesh.LocalDart(spoke)).Start;
    for (unsigned i = 0; i < type.VertexDegree(corner); ++i)
    {
      const unsigned local = type.VertexDart(corner, i);
      const Dart across = beyond[type.At(local).Face];
      if (!this->Mesh.IsOutside(across) && this->Found.Insert(this->Mesh.CellOf(across).Value))
      {
        // beta3 ends at the vertex, so the dart after it starts there.
        this->Add(this->Mesh.Beta1(this->Mesh.Beta3(this->Mesh.MakeDart(cell, local))));
      }
    }
  }

  bool Touches(HalfFace half) const
  {
    for (const Dart dart : this->Mesh.Darts(half))
    {
      if (this->Mesh.StartVertex(dart) == this->Center)
      {
        return true;
      }
    }
    return false;
  }

  View<Dart> Star() const { return { this->Spokes.data(), this->Count }; }

  Vertex Center;
  std::vector<Dart> Spokes; // the first Count of them
  std::size_t Count = 0;
  std::vector<HalfFace> Faces;

protected:
  const Map& Mesh;
  const TetrahedronWays* const Ways; // null unless there are tetrahedra alone
  std::vector<Dart> Buffer;
  ReusableSet<Id> Found;
};

}

#endif
