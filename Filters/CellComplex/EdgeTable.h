/**
 * @file EdgeTable.h
 * @brief Numbered edges of a combinatorial map: tables E2D and V2E.
 *
 * Source: X. Feng, "Geometric and topological modeling techniques for large and complex shapes",
 * 3.3.2.4 and Algorithms 1 and 3, with the direction rule and the boundary test that are missing in
 * the printed algorithms.
 */
#ifndef isthmus_EdgeTable_h
#define isthmus_EdgeTable_h

#include "CellComplex/DartMap.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersCellComplexModule.h"

#include <algorithm>
#include <cstdint>

#if defined(__SSE2__) && defined(__GNUC__)
#include <emmintrin.h>
#endif

namespace isthmus
{

/// The index of the first of the eight `numbers` that equals `wanted`; 8 if none does.
template <typename Id>
inline unsigned FirstEqualOfEight(const Id* numbers, Id wanted)
{
  unsigned place = 0;
  while (place < 8 && numbers[place] != wanted)
  {
    ++place;
  }
  return place;
}

#if defined(__SSE2__) && defined(__GNUC__)
/// The same without branches, by vector instructions available on every x86-64.
inline unsigned FirstEqualOfEight(const std::uint32_t* numbers, std::uint32_t wanted)
{
  const __m128i all = _mm_set1_epi32(static_cast<int>(wanted));
  const auto* const fours = reinterpret_cast<const __m128i*>(numbers);
  const __m128i low = _mm_cmpeq_epi32(_mm_loadu_si128(fours), all);
  const __m128i high = _mm_cmpeq_epi32(_mm_loadu_si128(fours + 1), all);
  const int bytes = _mm_movemask_epi8(_mm_packs_epi16(_mm_packs_epi32(low, high), low));
  return static_cast<unsigned>(__builtin_ctz(static_cast<unsigned>(bytes & 0xff) | 0x100u));
}
#endif

/**
 * Each pair of vertices joined by an edge of a cell is one edge, however many fans of cells it has
 * (more than one where the mesh is pinched).
 *
 * E2D holds, for each edge, a dart from its smaller to its larger vertex: for a boundary edge the
 * one at the clockwise end of its fan, otherwise the smallest such dart. Edges are ordered by
 * smaller, then larger vertex. V2E holds the index of the first edge of each vertex. E2V, which is
 * not in the thesis, holds the larger vertex, so that a search stays within one cache line. Built
 * in parallel in time linear in the number of cells; memory 2 n1 + n0 + 9 ids, and n1 more during
 * construction.
 */
template <typename Id>
class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT EdgeTable
{
public:
  using Map = DartMap<Id>;
  using Vertex = typename Map::Vertex;
  using Edge = typename Map::Edge;
  using Dart = typename Map::Dart;

  explicit EdgeTable(const Map& map, const ProgressCallback& progress = {});

  std::size_t Size() const { return this->E2D.size(); }
  /// The dart of an edge, from its smaller to its larger vertex.
  Dart GetDart(Edge edge) const { return this->E2D[edge.Value]; }
  bool IsBoundary(Edge edge) const
  {
    return this->Mesh.IsOutside(this->Mesh.Beta3(this->Mesh.Beta2(this->GetDart(edge))));
  }

  /// The edge of any dart.
  Edge Find(Dart dart) const
  {
    const auto [a, b] = this->Mesh.EndVertices(dart);
    const Id start = std::min(a, b).Value, end = std::max(a, b).Value;
    // The edge exists, and its end occurs exactly once among those of its start, which come first,
    // so the first match is correct. Comparing in strides avoids branches that are hard to predict.
    for (Id edge = this->V2E[start];; edge += Stride)
    {
      const unsigned place = FirstEqualOfEight(this->E2V.data() + edge, end);
      if (place < Stride)
      {
        return Edge(edge + place);
      }
    }
  }

  /// The edges whose smaller vertex is `vertex`, ordered by the other one.
  auto StartingAt(Vertex vertex) const
  {
    const Id first = this->V2E[vertex.Value];
    return IndexRange(static_cast<std::size_t>(this->V2E[vertex.Value + std::size_t(1)] - first),
      [first](std::size_t i) { return Edge(static_cast<Id>(first + i)); });
  }

  /// Iterates over one dart of each cell around an edge.
  class FanIterator
  {
  public:
    using FurtherFan = const std::pair<Edge, Dart>*;

    FanIterator(const Map* map, Dart first, View<std::pair<Edge, Dart>> further)
      : Mesh(map)
      , First(first)
      , Current(first)
      , Next(further.begin())
      , Last(further.end())
    {
    }
    Dart operator*() const { return this->Current; }
    FanIterator& operator++()
    {
      const Dart across = this->Mesh->Beta3(this->Current);
      this->Current = this->Mesh->IsOutside(across) ? this->First : this->Mesh->Beta2(across);
      if (this->Current == this->First)
      {
        this->First = this->Current = this->Next == this->Last ? Dart() : this->Next++->second;
      }
      return *this;
    }
    bool operator!=(const FanIterator& other) const { return this->Current != other.Current; }

  private:
    const Map* Mesh;
    Dart First, Current; // Dart() at the end
    FurtherFan Next, Last;
  };
  struct FanRange
  {
    FanIterator First;
    const FanIterator& begin() const { return this->First; }
    FanIterator end() const { return FanIterator(nullptr, Dart(), {}); }
  };

  /// One dart of each cell around an edge, from the smaller to the larger vertex, in
  /// counter-clockwise order seen from the larger; at the boundary from one end of the fan to the
  /// other. The two half faces of each cell at the edge are those of the dart and of its beta2.
  FanRange Fan(Edge edge) const
  {
    return { FanIterator(&this->Mesh, this->GetDart(edge), this->FurtherFans(edge)) };
  }

  void AppendMemory(std::vector<TableMemory>& report) const;

private:
  View<std::pair<Edge, Dart>> FurtherFans(Edge edge) const;
  bool IsLeader(Dart dart) const;
  std::vector<std::vector<Dart>> LeadingDarts(const ProgressCallback& progress) const;
  void SortByVertices(std::vector<std::vector<Dart>> leaders, const ProgressCallback& progress);
  void JoinPinchedEdges();

  static constexpr Id Stride = 8;

  const Map& Mesh;
  std::vector<Dart> E2D;
  std::vector<Id> E2V; // the larger vertex of each edge; Stride more places, so that Of may overrun
  std::vector<Id> V2E; // n0 + 1 places
  std::vector<std::pair<Edge, Dart>> Pinched; // sorted; empty unless the mesh is pinched
};

//--------------------------------------------------------------------------------------------------
// The number of each edge of each cell of a combinatorial map, as a list: table C2E.
//
// EdgeTable finds the edge of a dart by a short search; if the edges of all cells are needed
// repeatedly, this table provides them directly, at the cost of more memory.

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

  Edge Find(Dart dart) const { return this->C2E[this->Mesh.GetIndex(dart) / 2]; }
  /// The edges of a cell, in the order of the map's EdgeDarts(cell).
  View<Edge> Find(Cell cell) const
  {
    return { this->C2E.data() + this->Mesh.GetIndex(this->Mesh.MakeDart(cell, 1)) / 2,
      this->Mesh.EdgeDarts(cell).size() };
  }

  void AppendMemory(std::vector<TableMemory>& report) const;

private:
  const Map& Mesh;
  std::vector<Edge> C2E;
};

}

#endif
