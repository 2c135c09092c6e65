#include "CellComplex/HalfFaceMatching.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <string>
#include <tuple>

namespace isthmus
{
namespace
{

// Half faces that match have the same smallest vertex, so each bucket is matched independently, in
// a hash table that stays in the cache.
constexpr std::size_t CellsPerChunk = 1u << 16;
constexpr std::size_t HalfFacesPerBucket = 1u << 13;
constexpr std::uint32_t Free = 0xFFFFFFFFu;
constexpr std::size_t NamedClashes = 5;

/// Multipliers of splitmix64: neighbouring numbers of vertices must not have similar sums.
std::uint32_t HashVertex(std::uint64_t vertex)
{
  vertex *= 0x9E3779B97F4A7C15u;
  vertex ^= vertex >> 29;
  return static_cast<std::uint32_t>((vertex * 0xBF58476D1CE4E5B9u) >> 32);
}

}

template <typename Id>
HalfFaceMatching<Id>::HalfFaceMatching(Map& map)
  : Mesh(map)
  , Chunks(static_cast<std::int64_t>((map.CellCount + CellsPerChunk - 1) / CellsPerChunk))
{
  // Few enough buckets that one chunk's table of them stays in the cache.
  const std::size_t wanted =
    std::clamp<std::size_t>(map.H2D.size() / HalfFacesPerBucket, 1, std::size_t(1) << 14);
  const std::size_t vertices = map.V2D.size();
  std::size_t buckets = vertices + 1;
  for (; buckets > wanted && buckets > 1; ++this->BucketShift)
  {
    buckets = (vertices >> (this->BucketShift + 1)) + 1;
  }
  this->Buckets = buckets;
}

template <typename Id>
template <typename Visit>
void HalfFaceMatching<Id>::ForEachHalfFace(std::int64_t chunk, Visit&& visit) const
{
  const std::size_t first = static_cast<std::size_t>(chunk) * CellsPerChunk;
  const std::size_t last = std::min(first + CellsPerChunk, this->Mesh.CellCount);
  for (std::size_t c = first; c < last; ++c)
  {
    const typename Map::Cell cell{ static_cast<Id>(c) };
    const CellType& type = this->Mesh.GetType(cell);
    const auto vertices = this->Mesh.Vertices(cell);
    for (unsigned f = 0; f < static_cast<unsigned>(type.NumberOfFaces()); ++f)
    {
      Key key{ vertices[type.At(type.FaceDart(f, 0)).Start].Value, 0 };
      for (unsigned i = 0; i < type.FaceSize(f); ++i)
      {
        const std::size_t vertex = vertices[type.At(type.FaceDart(f, i)).Start].Value;
        key.SmallestVertex = std::min(key.SmallestVertex, vertex);
        key.Hash += HashVertex(vertex); // a sum: the order of the vertices does not matter
      }
      visit(this->Mesh.MakeHalfFace(cell, f), key);
    }
  }
}

template <typename Id>
void HalfFaceMatching<Id>::CountChunk(std::int64_t chunk)
{
  Id* counts = this->Places.data() + static_cast<std::size_t>(chunk) * this->Buckets;
  this->ForEachHalfFace(
    chunk, [&](HalfFace, const Key& key) { ++counts[this->Bucket(key.SmallestVertex)]; });
}

template <typename Id>
void HalfFaceMatching<Id>::DistributeChunk(std::int64_t chunk)
{
  Id* places = this->Places.data() + static_cast<std::size_t>(chunk) * this->Buckets;
  this->ForEachHalfFace(chunk,
    [&](HalfFace half, const Key& key) {
      this->Entries[places[this->Bucket(key.SmallestVertex)]++] = { half, key.Hash };
    });
}

template <typename Id>
std::size_t HalfFaceMatching<Id>::ConvertCountsToOffsets()
{
  std::size_t total = 0;
  this->BucketStarts.resize(this->Buckets + 1);
  for (std::size_t bucket = 0; bucket < this->Buckets; ++bucket)
  {
    this->BucketStarts[bucket] = total;
    for (std::size_t chunk = 0; chunk < static_cast<std::size_t>(this->Chunks); ++chunk)
    {
      Id& place = this->Places[chunk * this->Buckets + bucket];
      const std::size_t count = place;
      place = static_cast<Id>(total);
      total += count;
    }
  }
  this->BucketStarts[this->Buckets] = total;
  return total;
}

template <typename Id>
void HalfFaceMatching<Id>::Run(const ProgressCallback& progress)
{
  this->Places.assign(static_cast<std::size_t>(this->Chunks) * this->Buckets, 0);
  const auto eachChunk = [&](void (HalfFaceMatching::*work)(std::int64_t), double from, double to)
  {
    ParallelFor(
      0, this->Chunks, 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t chunk = first; chunk < last; ++chunk)
        {
          (this->*work)(chunk);
        }
      },
      Between(progress, from, to));
  };
  eachChunk(&HalfFaceMatching::CountChunk, 0.0, 0.2);
  // Each chunk has its own places in each bucket: no locks, and an order independent of the
  // threads.
  const std::size_t total = this->ConvertCountsToOffsets();
  this->Entries.reset(new Entry[total]); // not filled twice
  eachChunk(&HalfFaceMatching::DistributeChunk, 0.2, 0.5);
  ParallelFor(
    0, static_cast<std::int64_t>(this->Buckets), 16,
    [this](std::int64_t first, std::int64_t last) { this->MatchBuckets(first, last); },
    Between(progress, 0.5, 1.0));
  this->ThrowFirstClashes();
}

template <typename Id>
void HalfFaceMatching<Id>::MatchBuckets(std::int64_t first, std::int64_t last)
{
  std::vector<std::uint32_t> slots;
  for (std::int64_t bucket = first; bucket < last; ++bucket)
  {
    this->MatchBucket(static_cast<std::size_t>(bucket), slots);
  }
}

template <typename Id>
void HalfFaceMatching<Id>::MatchBucket(std::size_t bucket, std::vector<std::uint32_t>& slots)
{
  const Entry* entries = this->Entries.get() + this->BucketStarts[bucket];
  const std::size_t count = this->BucketStarts[bucket + 1] - this->BucketStarts[bucket];
  std::size_t capacity = 16;
  while (capacity < 2 * count)
  {
    capacity *= 2;
  }
  slots.assign(capacity, Free);
  for (std::size_t i = 0; i < count; ++i)
  {
    std::size_t slot = entries[i].Hash & (capacity - 1);
    for (; slots[slot] != Free; slot = (slot + 1) & (capacity - 1))
    {
      const Entry& other = entries[slots[slot]];
      if (other.Hash != entries[i].Hash)
      {
        continue;
      }
      const Alignment alignment = this->Compare(other.Half, entries[i].Half);
      if (alignment.SameVertices)
      {
        this->Join(other.Half, entries[i].Half, alignment);
        break;
      }
    }
    if (slots[slot] == Free)
    {
      slots[slot] = static_cast<std::uint32_t>(i);
    }
  }
}

template <typename Id>
void HalfFaceMatching<Id>::Join(HalfFace a, HalfFace b, const Alignment& alignment)
{
  const auto indexA = this->Mesh.GetIndex(a);
  if (!this->Mesh.IsOutside(this->Mesh.H2D[indexA]))
  {
    this->RecordClash({ Reason::NonManifold, a, b });
    return;
  }
  if (!alignment.Opposite)
  {
    this->RecordClash({ Reason::Orientation, a, b });
    return;
  }
  // Dart i of a lies on dart Position - i of b, so the first of b lies on dart Position of a.
  const auto cellA = this->Mesh.GetCell(a), cellB = this->Mesh.GetCell(b);
  this->Mesh.H2D[indexA] = this->Mesh.MakeDart(
    cellB, this->Mesh.GetType(cellB).FaceDart(this->Mesh.LocalFace(b), alignment.Position));
  this->Mesh.H2D[this->Mesh.GetIndex(b)] = this->Mesh.MakeDart(
    cellA, this->Mesh.GetType(cellA).FaceDart(this->Mesh.LocalFace(a), alignment.Position));
}

template <typename Id>
typename HalfFaceMatching<Id>::Alignment HalfFaceMatching<Id>::Compare(HalfFace a, HalfFace b) const
{
  const CellType& typeA = this->Mesh.GetType(this->Mesh.GetCell(a));
  const CellType& typeB = this->Mesh.GetType(this->Mesh.GetCell(b));
  const auto verticesA = this->Mesh.Vertices(this->Mesh.GetCell(a));
  const auto verticesB = this->Mesh.Vertices(this->Mesh.GetCell(b));
  const unsigned faceA = this->Mesh.LocalFace(a), faceB = this->Mesh.LocalFace(b);
  const unsigned size = typeA.FaceSize(faceA);
  if (size != typeB.FaceSize(faceB))
  {
    return { false, false, 0 };
  }
  const auto vertexA = [&](unsigned i)
  { return verticesA[typeA.At(typeA.FaceDart(faceA, i)).Start]; };
  const auto vertexB = [&](unsigned i)
  { return verticesB[typeB.At(typeB.FaceDart(faceB, i)).Start]; };
  // Faces seen from two cells have opposite directions.
  unsigned end = 0; // where the first dart of a ends in b
  while (end < size && vertexB(end) != vertexA(0))
  {
    ++end;
  }
  bool opposite = end < size;
  for (unsigned i = 1, j = end; opposite && i < size; ++i)
  {
    j = j == 0 ? size - 1 : j - 1;
    opposite = vertexA(i) == vertexB(j);
  }
  if (opposite)
  {
    return { true, true, end == 0 ? size - 1 : end - 1 };
  }
  return { this->SameVertices(a, b), false, 0 };
}

template <typename Id>
bool HalfFaceMatching<Id>::SameVertices(HalfFace a, HalfFace b) const
{
  const auto sorted = [this](HalfFace half)
  {
    std::vector<Id> vertices;
    for (const auto dart : this->Mesh.Darts(half))
    {
      vertices.push_back(this->Mesh.StartVertex(dart).Value);
    }
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  return sorted(a) == sorted(b);
}

template <typename Id>
void HalfFaceMatching<Id>::RecordClash(const Clash& clash)
{
  const std::lock_guard<std::mutex> lock(this->ClashMutex);
  this->Clashes.push_back(clash);
}

template <typename Id>
void HalfFaceMatching<Id>::ThrowFirstClashes()
{
  if (this->Clashes.empty())
  {
    return;
  }
  // Threads found them in any order; the message must not depend on that.
  std::sort(this->Clashes.begin(), this->Clashes.end(),
    [](const Clash& a, const Clash& b)
    { return std::tie(a.Why, a.First, a.Second) < std::tie(b.Why, b.First, b.Second); });
  const Reason reason = this->Clashes.front().Why;
  std::string pairs;
  std::size_t count = 0;
  for (const Clash& clash : this->Clashes)
  {
    if (clash.Why == reason && ++count <= NamedClashes)
    {
      pairs += (pairs.empty() ? "" : ", ") + std::to_string(this->Mesh.GetCell(clash.First).Value) +
        " and " + std::to_string(this->Mesh.GetCell(clash.Second).Value);
    }
  }
  pairs += count > NamedClashes ? " and " + std::to_string(count - NamedClashes) + " more" : "";
  throw MeshError(reason,
    reason == Reason::NonManifold ? "Cells " + pairs +
        " share a face with a third cell: a face can't have more "
        "than two cells. Remove the cells that overlap."
                                  : "Cells " + pairs +
        " see their common face in the same direction, or disagree on the order "
        "of its vertices. Reverse cells that are inverted, remove cells that overlap.");
}

template class HalfFaceMatching<std::uint32_t>;
template class HalfFaceMatching<std::uint64_t>;

}
