#include "CellComplex/EdgeTable.h"

#include "Core/ParallelFor.h"

#include <algorithm>

namespace isthmus
{

template <typename Id>
EdgeTable<Id>::EdgeTable(const Map& map, const ProgressCallback& progress)
  : Mesh(map)
{
  this->SortByVertices(
    this->LeadingDarts(Between(progress, 0.0, 0.6)), Between(progress, 0.6, 1.0));
  this->JoinPinchedEdges();
  this->E2V.resize(this->E2D.size() + Stride, 0);
  for (std::size_t edge = 0; edge < this->E2D.size(); ++edge)
  {
    this->E2V[edge] = map.EndVertex(this->E2D[edge]).Value;
  }
}

/// Whether `dart`, from the smaller to the larger vertex, is the one that represents its fan.
template <typename Id>
bool EdgeTable<Id>::IsLeader(Dart dart) const
{
  if (this->Mesh.IsOutside(this->Mesh.Beta3(this->Mesh.Beta2(dart))))
  {
    return true;
  }
  for (Dart other = dart;;)
  {
    const Dart across = this->Mesh.Beta3(other);
    if (this->Mesh.IsOutside(across))
    {
      return false; // a boundary fan, and its clockwise end is another dart
    }
    other = this->Mesh.Beta2(across);
    if (!(dart < other))
    {
      return other == dart;
    }
  }
}

template <typename Id>
auto EdgeTable<Id>::LeadingDarts(const ProgressCallback& progress) const
  -> std::vector<std::vector<Dart>>
{
  constexpr std::size_t CellsPerChunk = 1u << 15;
  const std::size_t cells = this->Mesh.NumberOfCells();
  // A list for each chunk, read in the order of chunks: the table does not depend on the threads.
  std::vector<std::vector<Dart>> leaders((cells + CellsPerChunk - 1) / CellsPerChunk);
  ParallelFor(
    0, static_cast<std::int64_t>(leaders.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto chunk = static_cast<std::size_t>(first); chunk < static_cast<std::size_t>(last);
           ++chunk)
      {
        const std::size_t end = std::min((chunk + 1) * CellsPerChunk, cells);
        for (std::size_t c = chunk * CellsPerChunk; c < end; ++c)
        {
          for (Dart dart : this->Mesh.EdgeDarts(typename Map::Cell(static_cast<Id>(c))))
          {
            dart = this->Mesh.EndVertex(dart) < this->Mesh.StartVertex(dart)
              ? this->Mesh.Beta2(dart)
              : dart;
            if (this->IsLeader(dart))
            {
              leaders[chunk].push_back(dart);
            }
          }
        }
      }
    },
    progress);
  return leaders;
}

template <typename Id>
void EdgeTable<Id>::SortByVertices(
  std::vector<std::vector<Dart>> leaders, const ProgressCallback& progress)
{
  this->V2E.assign(this->Mesh.NumberOfVertices() + 1, 0);
  std::size_t count = 0;
  for (const std::vector<Dart>& chunk : leaders)
  {
    count += chunk.size();
    for (const Dart dart : chunk)
    {
      ++this->V2E[this->Mesh.StartVertex(dart).Value];
    }
  }
  // First the ends of each vertex's edges; filling backwards turns them into beginnings.
  Id sum = 0;
  for (Id& place : this->V2E)
  {
    place = sum += place;
  }
  this->E2D.resize(count);
  for (std::vector<Dart>& chunk : leaders)
  {
    for (const Dart dart : chunk)
    {
      this->E2D[--this->V2E[this->Mesh.StartVertex(dart).Value]] = dart;
    }
    std::vector<Dart>().swap(chunk);
  }
  // An open fan precedes a closed one of the same edge, so that it decides IsBoundary.
  constexpr std::int64_t VerticesPerPiece = 1 << 14;
  const auto key = [this](Dart dart)
  {
    return std::make_tuple(this->Mesh.EndVertex(dart),
      !this->Mesh.IsOutside(this->Mesh.Beta3(this->Mesh.Beta2(dart))), dart);
  };
  ParallelFor(
    0, static_cast<std::int64_t>(this->Mesh.NumberOfVertices()), VerticesPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto v = static_cast<std::size_t>(first); v < static_cast<std::size_t>(last); ++v)
      {
        std::sort(this->E2D.begin() + static_cast<std::ptrdiff_t>(this->V2E[v]),
          this->E2D.begin() + static_cast<std::ptrdiff_t>(this->V2E[v + 1]),
          [&](Dart a, Dart b) { return key(a) < key(b); });
      }
    },
    progress);
}

/// Where one pair of vertices has several fans, keeps the first in E2D and the others aside.
template <typename Id>
void EdgeTable<Id>::JoinPinchedEdges()
{
  std::size_t kept = 0, next = 0;
  for (std::size_t v = 0; v + 1 < this->V2E.size(); ++v)
  {
    const std::size_t begin = kept;
    for (; next < this->V2E[v + 1]; ++next)
    {
      const Dart dart = this->E2D[next];
      if (kept > begin && this->Mesh.EndVertex(this->E2D[kept - 1]) == this->Mesh.EndVertex(dart))
      {
        this->Pinched.emplace_back(Edge(static_cast<Id>(kept - 1)), dart);
      }
      else
      {
        this->E2D[kept++] = dart;
      }
    }
    this->V2E[v] = static_cast<Id>(begin);
  }
  this->V2E.back() = static_cast<Id>(kept);
  if (kept < this->E2D.size())
  {
    this->E2D.resize(kept);
    this->E2D.shrink_to_fit();
    this->Pinched.shrink_to_fit();
  }
}

template <typename Id>
auto EdgeTable<Id>::FurtherFans(Edge edge) const -> View<std::pair<Edge, Dart>>
{
  const auto range = std::equal_range(this->Pinched.begin(), this->Pinched.end(),
    std::pair<Edge, Dart>(edge, Dart()),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  return { this->Pinched.data() + (range.first - this->Pinched.begin()),
    static_cast<std::size_t>(range.second - range.first) };
}

template <typename Id>
void EdgeTable<Id>::AppendMemory(std::vector<TableMemory>& report) const
{
  report.push_back({ "E2D", this->E2D.capacity() * sizeof(Dart) });
  report.push_back({ "E2V", this->E2V.capacity() * sizeof(Id) });
  report.push_back({ "V2E", this->V2E.capacity() * sizeof(Id) });
  report.push_back({ "PinchedEdges", this->Pinched.capacity() * sizeof(this->Pinched[0]) });
}

template class EdgeTable<std::uint32_t>;
template class EdgeTable<std::uint64_t>;

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
          this->C2E[map.GetIndex(dart) / 2] = edges.Find(dart);
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
