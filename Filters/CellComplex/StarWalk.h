/**
 * @file StarWalk.h
 * @brief Walks the cells around a vertex of a combinatorial map.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * Algorithm 2, with the boundary test that its print lacks.
 */
#ifndef isthmus_StarWalk_h
#define isthmus_StarWalk_h

#include "DartMap.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A small set of ids that is emptied in constant time and keeps its memory.
template <typename Id>
class ReusableSet
{
public:
  ReusableSet() { this->Slots.resize(std::size_t(1) << (64 - this->Shift)); }

  void Clear()
  {
    this->Size = 0;
    if (++this->Stamp == 0)
    {
      std::fill(this->Slots.begin(), this->Slots.end(), Slot{});
      this->Stamp = 1;
    }
  }

  /// False if `id` was there already.
  bool Insert(Id id)
  {
    std::size_t at = this->Place(id);
    for (; this->Slots[at].Stamp == this->Stamp; at = (at + 1) & (this->Slots.size() - 1))
    {
      if (this->Slots[at].Key == id)
      {
        return false;
      }
    }
    this->Slots[at] = { id, this->Stamp };
    if (2 * ++this->Size > this->Slots.size())
    {
      this->Grow();
    }
    return true;
  }

private:
  struct Slot
  {
    Id Key = 0;
    std::uint32_t Stamp = 0;
  };

  std::size_t Place(Id id) const
  {
    return static_cast<std::size_t>((std::uint64_t(id) * 0x9E3779B97F4A7C15u) >> this->Shift);
  }

  void Grow()
  {
    std::vector<Slot> old(2 * this->Slots.size());
    old.swap(this->Slots);
    --this->Shift;
    this->Size = 0;
    for (const Slot& slot : old)
    {
      if (slot.Stamp == this->Stamp)
      {
        this->Insert(slot.Key);
      }
    }
  }

  std::vector<Slot> Slots;
  unsigned Shift = 64 - 8;
  std::uint32_t Stamp = 1;
  std::size_t Size = 0;
};

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
  {
  }

  /// Moves to `vertex`; returns one dart that starts there for each cell around it.
  View<Dart> Gather(Vertex vertex)
  {
    this->Found.Clear();
    this->Spokes.clear();
    this->Center = vertex;
    this->Flood(this->Mesh.DartOf(vertex));
    for (const auto& further : this->Mesh.FurtherUmbrellas(vertex))
    {
      this->Flood(further.second);
    }
    return { this->Spokes.data(), this->Spokes.size() };
  }

  /// Adds the umbrella of the cell of `seed`, a dart at the vertex; false if it was there already.
  bool Extend(Dart seed)
  {
    const std::size_t before = this->Spokes.size();
    this->Flood(seed);
    return this->Spokes.size() > before;
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
    for (const Dart spoke : this->Spokes)
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
    for (const Dart spoke : this->Spokes)
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
    std::size_t next = this->Spokes.size();
    this->Spokes.push_back(seed);
    for (; next < this->Spokes.size(); ++next)
    {
      this->CrossFaces(this->Spokes[next]);
    }
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
        this->Spokes.push_back(
          this->Mesh.Beta1(this->Mesh.Beta3(this->Mesh.MakeDart(cell, local))));
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

  Vertex Center;
  std::vector<Dart> Spokes;
  std::vector<HalfFace> Faces;

protected:
  const Map& Mesh;
  std::vector<Dart> Buffer;
  ReusableSet<Id> Found;
};

}

#endif
