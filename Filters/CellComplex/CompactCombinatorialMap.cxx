#include "CellComplex/CompactCombinatorialMap.h"

#include "CellComplex/CellVertexCheck.h"
#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "CellComplex/HalfFaceMatching.h"
#include "CellComplex/StarTable.h"
#include "CellComplex/StarWalk.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>

namespace isthmus
{
namespace
{

constexpr std::int64_t CellsPerPiece = 1 << 14;

/// Low bits that hold 0 and every local dart.
unsigned BitsFor(const std::vector<CellType>& types)
{
  unsigned bits = 1;
  for (const CellType& type : types)
  {
    while ((1 << bits) < type.NumberOfDarts() + 1)
    {
      ++bits;
    }
  }
  return bits;
}

std::size_t Count(const std::vector<CellRun>& runs)
{
  std::size_t cells = 0;
  for (const CellRun& run : runs)
  {
    cells += static_cast<std::size_t>(run.NumberOfCells);
  }
  return cells;
}

}

template <typename Id>
bool CompactCombinatorialMap<Id>::FitsIn(const CellList& mesh)
{
  const Id cells = std::numeric_limits<Id>::max() >> BitsFor(mesh.Types);
  return Count(mesh.Runs) <= cells &&
    static_cast<std::uint64_t>(mesh.NumberOfVertices) <= std::numeric_limits<Id>::max();
}

template <typename Id>
CompactCombinatorialMap<Id>::CompactCombinatorialMap(
  CellList mesh, const ProgressCallback& progress)
{
  this->Types = std::move(mesh.Types);
  this->Bits = BitsFor(this->Types);
  const auto vertices = static_cast<std::size_t>(mesh.NumberOfVertices);
  if (Count(mesh.Runs) > (std::numeric_limits<Id>::max() >> this->Bits) ||
    vertices > std::numeric_limits<Id>::max())
  {
    throw MeshError(MeshError::Reason::TooLarge,
      std::to_string(Count(mesh.Runs)) + " cells and " + std::to_string(vertices) +
        " vertices can't be numbered in " + std::to_string(8 * sizeof(Id)) +
        " bits: use the map with 64-bit ids.");
  }
  this->LayOutBlocks(mesh.Runs);
  this->CopyVertices(mesh.CellVertices, vertices);
  Report(progress, 0.1);
  this->V2D.assign(vertices, Dart());
  HalfFaceMatching<Id>(*this).Run(Between(progress, 0.1, 0.6));
  this->NumberBoundaryFaces();
  Report(progress, 0.7);
  this->ChooseVertexDarts();
  Report(progress, 0.8);
  this->FindUmbrellas(Between(progress, 0.8, 1.0));
}

template <typename Id>
CompactCombinatorialMap<Id>::~CompactCombinatorialMap() = default;

template <typename Id>
void CompactCombinatorialMap<Id>::LayOutBlocks(const std::vector<CellRun>& runs)
{
  std::size_t vertex = 0, halfFace = 0;
  for (const CellRun& run : runs)
  {
    if (run.NumberOfCells <= 0)
    {
      continue;
    }
    const CellType& type = this->Types.at(run.Type);
    Block block;
    block.Type = &type;
    block.Darts = &type.At(0);
    block.FirstCell = this->CellCount;
    this->CellCount += static_cast<std::size_t>(run.NumberOfCells);
    block.EndCell = this->CellCount;
    block.VertexCount = static_cast<unsigned>(type.NumberOfVertices());
    block.FaceCount = static_cast<unsigned>(type.NumberOfFaces());
    block.DartCount = static_cast<unsigned>(type.NumberOfDarts());
    // Unsigned arithmetic: a base may wrap around, base + cell * count never does.
    block.VertexBase = vertex - block.FirstCell * block.VertexCount;
    block.HalfFaceBase = halfFace - block.FirstCell * block.FaceCount;
    block.DartBase = this->DartCount - block.FirstCell * block.DartCount;
    const std::size_t cells = block.EndCell - block.FirstCell;
    vertex += cells * block.VertexCount;
    halfFace += cells * block.FaceCount;
    this->DartCount += cells * block.DartCount;
    this->Blocks.push_back(block);
  }
  this->Blocks.shrink_to_fit();
  if (this->Blocks.size() > 1)
  {
    // With one run, all cells have one type and no table of blocks is needed.
    this->C2B.resize(this->CellCount);
    for (std::size_t b = 0; b < this->Blocks.size(); ++b)
    {
      std::fill(this->C2B.begin() + static_cast<std::ptrdiff_t>(this->Blocks[b].FirstCell),
        this->C2B.begin() + static_cast<std::ptrdiff_t>(this->Blocks[b].EndCell),
        static_cast<std::uint32_t>(b));
    }
  }
  this->Cv2V.resize(vertex);
  this->H2D.resize(halfFace);
}

template <typename Id>
void CompactCombinatorialMap<Id>::CopyVertices(
  View<std::int64_t> cellVertices, std::size_t numberOfVertices)
{
  if (cellVertices.size() != this->Cv2V.size())
  {
    throw MeshError(MeshError::Reason::Inconsistent,
      "The cells need " + std::to_string(this->Cv2V.size()) + " vertex numbers, but " +
        std::to_string(cellVertices.size()) + " were given: the list does not match their types.");
  }
  CellVertexCheck check(static_cast<std::int64_t>(numberOfVertices));
  ParallelFor(0, static_cast<std::int64_t>(this->CellCount), CellsPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c)
      {
        const Cell cell(static_cast<Id>(c));
        const Block& block = this->GetBlock(cell);
        const std::size_t base = block.VertexIndex(cell, 0);
        const std::int64_t* vertices = &cellVertices[base];
        check.Add(c, { vertices, block.VertexCount });
        for (unsigned v = 0; v < block.VertexCount; ++v)
        {
          this->Cv2V[base + v] = Vertex(static_cast<Id>(vertices[v]));
        }
      }
    });
  check.ThrowIfBad();
}

/// After matching, half faces without a partner are those of the boundary. Serial, so that their
/// numbers follow the order of the cells.
template <typename Id>
void CompactCombinatorialMap<Id>::NumberBoundaryFaces()
{
  const std::size_t open = static_cast<std::size_t>(std::count_if(
    this->H2D.begin(), this->H2D.end(), [this](Dart across) { return this->IsOutside(across); }));
  if (open > (std::numeric_limits<Id>::max() >> this->Bits))
  {
    throw MeshError(MeshError::Reason::TooLarge,
      std::to_string(open) + " boundary faces can't be numbered in " +
        std::to_string(8 * sizeof(Id)) + " bits: use the map with 64-bit ids.");
  }
  this->B2D.reserve(open);
  for (std::size_t c = 0; c < this->CellCount; ++c)
  {
    const Cell cell(static_cast<Id>(c));
    const Block& block = this->GetBlock(cell);
    for (unsigned f = 0; f < block.FaceCount; ++f)
    {
      Dart& across = this->H2D[block.HalfFaceIndex(cell, f)];
      if (this->IsOutside(across))
      {
        across = this->MakeDart(Cell(static_cast<Id>(this->B2D.size())), 0);
        this->B2D.push_back(this->MakeDart(cell, block.Type->FaceDart(f, 0)));
      }
    }
  }
}

/// A dart on the boundary comes first: the fan of a boundary vertex has two ends, and a walk must
/// begin at one of them.
template <typename Id>
void CompactCombinatorialMap<Id>::ChooseVertexDarts()
{
  for (const Dart first : this->B2D)
  {
    for (const Dart dart : this->Darts(this->GetHalfFace(first)))
    {
      Dart& chosen = this->V2D[this->StartVertex(dart).Value];
      chosen = this->IsOutside(chosen) ? dart : chosen;
    }
  }
  for (std::size_t c = 0; c < this->CellCount; ++c)
  {
    const Cell cell(static_cast<Id>(c));
    const Block& block = this->GetBlock(cell);
    for (unsigned v = 0; v < block.VertexCount; ++v)
    {
      Dart& chosen = this->V2D[this->Cv2V[block.VertexIndex(cell, v)].Value];
      chosen =
        this->IsOutside(chosen) ? this->MakeDart(cell, block.Type->VertexDart(v, 0)) : chosen;
    }
  }
}

/// Stars reached from V2D hold each corner of each cell once, unless the mesh is pinched somewhere.
template <typename Id>
void CompactCombinatorialMap<Id>::FindUmbrellas(const ProgressCallback& progress)
{
  constexpr std::int64_t VerticesPerPiece = 1 << 12;
  std::atomic<std::size_t> reached{ 0 };
  ParallelFor(
    0, static_cast<std::int64_t>(this->V2D.size()), VerticesPerPiece,
    [&](std::int64_t first, std::int64_t last)
    {
      StarWalk<Id> star(*this);
      std::size_t cells = 0;
      for (std::int64_t v = first; v < last; ++v)
      {
        cells += star.Gather(Vertex(static_cast<Id>(v))).size();
      }
      reached += cells;
    },
    progress);
  // Nearly all meshes end here; the slower search for other umbrellas is needed only for pinched
  // ones.
  if (reached == this->Cv2V.size())
  {
    return;
  }
  StarWalk<Id> star(*this);
  const std::vector<std::pair<Vertex, Dart>> corners = this->CornersOfPinchedVertices();
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (i == 0 || corners[i].first != corners[i - 1].first)
    {
      star.Gather(corners[i].first);
    }
    if (star.Extend(corners[i].second))
    {
      this->Umbrellas.push_back(corners[i]);
    }
  }
  this->Umbrellas.shrink_to_fit();
}

/// (vertex, dart of one of its cells) for all cells at vertices whose star is incomplete, sorted.
template <typename Id>
auto CompactCombinatorialMap<Id>::CornersOfPinchedVertices() const
  -> std::vector<std::pair<Vertex, Dart>>
{
  std::vector<std::size_t> missing(this->V2D.size(), 0);
  for (const Vertex vertex : this->Cv2V)
  {
    ++missing[vertex.Value];
  }
  StarWalk<Id> star(*this);
  for (std::size_t v = 0; v < missing.size(); ++v)
  {
    missing[v] -= star.Gather(Vertex(static_cast<Id>(v))).size();
  }
  std::vector<std::pair<Vertex, Dart>> corners;
  for (std::size_t c = 0; c < this->CellCount; ++c)
  {
    const Cell cell(static_cast<Id>(c));
    const View<Vertex> vertices = this->Vertices(cell);
    for (unsigned v = 0; v < vertices.size(); ++v)
    {
      if (missing[vertices[v].Value])
      {
        corners.emplace_back(
          vertices[v], this->MakeDart(cell, this->GetType(cell).VertexDart(v, 0)));
      }
    }
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

template <typename Id>
const EdgeTable<Id>& CompactCombinatorialMap<Id>::Edges(const ProgressCallback& progress) const
{
  std::call_once(this->EdgesOnce,
    [&]() { this->EdgesBuilt = std::make_unique<EdgeTable<Id>>(*this, progress); });
  return *this->EdgesBuilt;
}

template <typename Id>
const FaceTable<Id>& CompactCombinatorialMap<Id>::Faces(const ProgressCallback& progress) const
{
  std::call_once(this->FacesOnce,
    [&]() { this->FacesBuilt = std::make_unique<FaceTable<Id>>(*this, progress); });
  return *this->FacesBuilt;
}

template <typename Id>
const StarTable<Id>& CompactCombinatorialMap<Id>::Stars() const
{
  std::call_once(
    this->StarsOnce, [this]() { this->StarsBuilt = std::make_unique<StarTable<Id>>(*this); });
  return *this->StarsBuilt;
}

template <typename Id>
const CellEdgeTable<Id>& CompactCombinatorialMap<Id>::CellEdges() const
{
  std::call_once(this->CellEdgesOnce,
    [this]() { this->CellEdgesBuilt = std::make_unique<CellEdgeTable<Id>>(*this, this->Edges()); });
  return *this->CellEdgesBuilt;
}

template <typename Id>
std::vector<TableMemory> CompactCombinatorialMap<Id>::MemoryReport() const
{
  const auto bytes = [](const auto& table)
  { return table.capacity() * sizeof(typename std::decay_t<decltype(table)>::value_type); };
  std::size_t types = 0;
  for (const CellType& type : this->Types)
  {
    types += type.MemoryBytes();
  }
  std::vector<TableMemory> report{ { "Cv2V", bytes(this->Cv2V) }, { "H2D", bytes(this->H2D) },
    { "V2D", bytes(this->V2D) }, { "B2D", bytes(this->B2D) },
    { "Runs", bytes(this->Blocks) + bytes(this->C2B) }, { "Types", types },
    { "Umbrellas", bytes(this->Umbrellas) } };
  const auto append = [&report](const auto& table)
  {
    if (table)
    {
      table->AppendMemory(report);
    }
  };
  append(this->EdgesBuilt);
  append(this->FacesBuilt);
  append(this->StarsBuilt);
  append(this->CellEdgesBuilt);
  return report;
}

template class CompactCombinatorialMap<std::uint32_t>;
template class CompactCombinatorialMap<std::uint64_t>;

}
