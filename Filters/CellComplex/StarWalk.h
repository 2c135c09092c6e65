/**
 * @file StarWalk.h
 * @brief Walks the cells around a vertex of a combinatorial map.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * Algorithm 2, with the boundary test that is missing in the printed version.
 */
#ifndef isthmus_StarWalk_h
#define isthmus_StarWalk_h

#include "CellComplex/CellType.h"
#include "CellComplex/DartMap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// A small set of ids that is reused from one walk to the next.

/**
 * A set of ids that is emptied in constant time and keeps its memory: 8 kB (16 for 64-bit ids), or
 * four slots per id once there were more than 512 ids. In a walk, about half of the ids are new, so
 * Insert() does not branch on that. Since few slots are occupied, collisions are rare.
 */
template <typename Id>
class ReusableSet
{
  struct Slot
  {
    Id Key = 0;
    Id Stamp = 0;
  };

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

  /// The set in a form that a loop can keep in registers; valid until the set grows.
  class Marks
  {
  public:
    /// False if `id` was in the set already.
    bool Insert(Id id) const
    {
      Slot* slot = this->Slots +
        static_cast<std::size_t>((std::uint64_t(id) * 0x9E3779B97F4A7C15u) >> this->Shift);
      if ((slot->Stamp == this->Stamp) & (slot->Key != id))
      {
        slot = this->Probe(slot, id);
      }
      const bool fresh = slot->Stamp != this->Stamp;
      *slot = { id, this->Stamp };
      return fresh;
    }

  private:
    friend class ReusableSet;
    Marks(Slot* slots, unsigned shift, Id stamp)
      : Slots(slots)
      , Shift(shift)
      , Stamp(stamp)
    {
    }

    /// The slot of `id`, or a free one for it, if its preferred slot, `taken`, is occupied by
    /// another id.
    [[gnu::noinline, gnu::cold]] Slot* Probe(Slot* taken, Id id) const
    {
      Slot* const end = this->Slots + (std::size_t(1) << (64 - this->Shift));
      while (taken->Stamp == this->Stamp && taken->Key != id)
      {
        taken = taken + 1 == end ? this->Slots : taken + 1;
      }
      return taken;
    }

    Slot* Slots;
    unsigned Shift;
    Id Stamp;
  };

  /// Reserves space for `ids` in all; Room() returns how many fit.
  Marks WithRoomFor(std::size_t ids)
  {
    while (this->Room() < ids)
    {
      this->Grow();
    }
    this->Size = std::max(this->Size, ids);
    return { this->Slots.data(), this->Shift, this->Stamp };
  }
  std::size_t Room() const { return this->Slots.size() / 2; }

  /// False if `id` was in the set already.
  bool Insert(Id id)
  {
    const std::size_t before = this->Size;
    const bool fresh = this->WithRoomFor(before + 1).Insert(id);
    this->Size = before + (fresh ? 1 : 0);
    return fresh;
  }

private:
  [[gnu::noinline, gnu::cold]] void Grow()
  {
    std::vector<Slot> old(2 * this->Slots.size());
    old.swap(this->Slots);
    --this->Shift;
    const Marks marks{ this->Slots.data(), this->Shift, this->Stamp };
    for (const Slot& slot : old)
    {
      if (slot.Stamp == this->Stamp)
      {
        marks.Insert(slot.Key);
      }
    }
  }

  std::vector<Slot> Slots;
  unsigned Shift = 64 - 10;
  Id Stamp = 1;
  std::size_t Size = 0; // at least its number of ids
};

//--------------------------------------------------------------------------------------------------
// The transitions from tetrahedron to tetrahedron around a vertex, as small tables.
//
// A spoke is a dart that starts at the vertex. The three faces at the vertex follow from a spoke's
// local dart, and the spoke beyond a face from the local dart in the table H2D of the map: it is
// beta1 of beta3, as in CellType.

struct TetrahedronTransitions
{
  /// A face at the vertex; `Position` is the position of the spoke in it when StarWalk crosses the
  /// face.
  struct Transition
  {
    std::uint8_t Face = 0, Position = 0;
  };

  static constexpr unsigned Darts = 13; ///< local ones; 0: outside

  /// By spoke; the face of the spoke itself first, then in the order of its vertex' darts.
  std::array<std::array<Transition, 3>, Darts> Transitions;
  std::array<std::array<std::uint8_t, 3>, Darts> Spoke; ///< by dart across and position

  TetrahedronTransitions()
    : Transitions{}
    , Spoke{}
  {
    const CellType& type = CellType::Tetrahedron();
    for (unsigned dart = 1; dart < Darts; ++dart)
    {
      const CellType::Dart& spoke = type.At(dart);
      for (unsigned i = 0, next = 1; i < 3; ++i)
      {
        const CellType::Dart& local = type.At(type.VertexDart(spoke.Start, i));
        const Transition transition{ static_cast<std::uint8_t>(local.Face),
          static_cast<std::uint8_t>(local.Position) };
        this->Transitions[dart][local.Face == spoke.Face ? 0 : next++] = transition;
        this->Spoke[dart][i] = static_cast<std::uint8_t>(type.At(type.Back(dart, i)).Next);
      }
    }
  }
};

/**
 * Computes the star and link of one vertex after the other. Each thread needs its own object. Its
 * memory is that of the largest star so far, so queries soon need no further allocation.
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
    , Table(map.HasOnlyTetrahedra() ? &TransitionsOfTetrahedra() : nullptr)
  {
  }

  /// Moves to `vertex`; returns one dart that starts there for each cell around it.
  View<Dart> Gather(Vertex vertex)
  {
    this->Found.Clear();
    this->Count = 0;
    this->Center = vertex;
    this->Flood(this->Mesh.GetDart(vertex));
    for (const auto& further : this->Mesh.FurtherUmbrellas(vertex))
    {
      this->Flood(further.second);
    }
    return this->Star();
  }

  /// Adds the umbrella of the cell of `seed`, a dart at the vertex; false if it was included
  /// already.
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
        const HalfFace half = this->Mesh.GetHalfFace(dart);
        const Dart across = this->Mesh.Across(half);
        if (this->Mesh.IsOutside(across) || half < this->Mesh.GetHalfFace(across))
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
      for (const HalfFace half : this->Mesh.HalfFaces(this->Mesh.GetCell(spoke)))
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
    if (this->Mesh.IsOutside(seed) || !this->Found.Insert(this->Mesh.GetCell(seed).Value))
    {
      return;
    }
    std::size_t next = this->Count;
    this->Add(seed);
    if (this->Table)
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

  /// Flood fill for tetrahedra, with tables and in registers; no cell except the first one tests
  /// the face through which it was reached. Each spoke is written, whether new or not, so that no
  /// branch depends on that.
  void FloodTetrahedra(std::size_t next)
  {
    const TetrahedronTransitions& table = *this->Table;
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
      const TetrahedronTransitions::Transition* const way =
        table.Transitions[spoke & localMask].data();
      for (unsigned w = first; w < 3; ++w)
      {
        const Id across = faces[way[w].Face].Value;
        const auto local = static_cast<unsigned>(across & localMask);
        if (local != 0)
        {
          spokes[count] = Dart(across - local + table.Spoke[local][way[w].Position]);
          count += marks.Insert(across >> bits) ? 1 : 0;
        }
      }
    }
    this->Count = count;
  }

  static const TetrahedronTransitions& TransitionsOfTetrahedra()
  {
    static const TetrahedronTransitions table;
    return table;
  }

  /// Adds the new cells beyond the faces at the vertex of one cell.
  void CrossFaces(Dart spoke)
  {
    const auto cell = this->Mesh.GetCell(spoke);
    const CellType& type = this->Mesh.GetType(cell);
    const View<Dart> beyond = this->Mesh.Neighbours(cell);
    const unsigned corner = type.At(this->Mesh.LocalDart(spoke)).Start;
    for (unsigned i = 0; i < type.VertexDegree(corner); ++i)
    {
      const unsigned local = type.VertexDart(corner, i);
      const Dart across = beyond[type.At(local).Face];
      if (!this->Mesh.IsOutside(across) && this->Found.Insert(this->Mesh.GetCell(across).Value))
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
  const TetrahedronTransitions* const Table; // null unless all cells are tetrahedra
  std::vector<Dart> Buffer;
  ReusableSet<Id> Found;
};

}

#endif
