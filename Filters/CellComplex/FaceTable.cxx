#include "CellComplex/FaceTable.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <utility>

namespace isthmus
{
template <typename Id>
template <typename Visit>
void FaceTable<Id>::ForEachLeader(const ProgressCallback& progress, Visit&& visit) const
{
  constexpr std::size_t CellsPerReport = 1u << 16;
  const std::size_t cells = this->Mesh.NumberOfCells();
  for (std::size_t c = 0; c < cells; ++c)
  {
    if (c % CellsPerReport == 0)
    {
      Report(progress, static_cast<double>(c) / static_cast<double>(cells));
    }
    for (const HalfFace half : this->Mesh.HalfFaces(typename Map::Cell(static_cast<Id>(c))))
    {
      const Dart across = this->Mesh.Across(half);
      if (this->Mesh.IsOutside(across) || half < this->Mesh.GetHalfFace(across))
      {
        visit(half);
      }
    }
  }
}

template <typename Id>
FaceTable<Id>::FaceTable(const Map& map, const ProgressCallback& progress)
  : Mesh(map)
{
  this->V2F.assign(map.NumberOfVertices() + 1, 0);
  this->ForEachLeader(Between(progress, 0.0, 0.3),
    [this](HalfFace half) { ++this->V2F[this->SmallestVertex(half).Value]; });
  // First the ends of each vertex's faces; filling backwards turns them into beginnings.
  Id sum = 0;
  for (Id& place : this->V2F)
  {
    place = sum += place;
  }
  this->F2D.resize(map.NumberOfFaces());
  this->ForEachLeader(Between(progress, 0.3, 0.6),
    [this](HalfFace half)
    { this->F2D[--this->V2F[this->SmallestVertex(half).Value]] = this->Mesh.FirstDart(half); });
  constexpr std::int64_t VerticesPerPiece = 1 << 14;
  ParallelFor(
    0, static_cast<std::int64_t>(map.NumberOfVertices()), VerticesPerPiece,
    [this](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t v = first; v < last; ++v)
      {
        this->SortVertexFaces(static_cast<std::size_t>(v));
      }
    },
    Between(progress, 0.6, 1.0));
}

template <typename Id>
void FaceTable<Id>::SortVertexFaces(std::size_t vertex)
{
  const auto vertices = [this](Dart first)
  {
    std::vector<Vertex> sorted;
    for (const Dart dart : this->Mesh.Darts(this->Mesh.GetHalfFace(first)))
    {
      sorted.push_back(this->Mesh.StartVertex(dart));
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  };
  /// The second and third smallest vertex decide nearly always.
  struct Keyed
  {
    Vertex Second, Third;
    Dart First;
  };
  std::vector<Keyed> faces;
  for (std::size_t i = this->V2F[vertex]; i < this->V2F[vertex + 1]; ++i)
  {
    const std::vector<Vertex> sorted = vertices(this->F2D[i]);
    faces.push_back({ sorted[1], sorted[2], this->F2D[i] });
  }
  std::sort(faces.begin(), faces.end(),
    [&](const Keyed& a, const Keyed& b)
    {
      if (a.Second != b.Second || a.Third != b.Third)
      {
        return std::make_pair(a.Second, a.Third) < std::make_pair(b.Second, b.Third);
      }
      return std::make_pair(vertices(a.First), a.First) <
        std::make_pair(vertices(b.First), b.First);
    });
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    this->F2D[this->V2F[vertex] + i] = faces[i].First;
  }
}

template <typename Id>
void FaceTable<Id>::AppendMemory(std::vector<TableMemory>& report) const
{
  report.push_back({ "F2D", this->F2D.capacity() * sizeof(Dart) });
  report.push_back({ "V2F", this->V2F.capacity() * sizeof(Id) });
}

template class FaceTable<std::uint32_t>;
template class FaceTable<std::uint64_t>;

}
