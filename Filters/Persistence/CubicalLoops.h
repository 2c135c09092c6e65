/**
 * @file CubicalLoops.h
 * @brief Pairs of dimension 1 of a volume, by reduction of the boundaries of critical faces.
 */
#ifndef isthmus_CubicalLoops_h
#define isthmus_CubicalLoops_h

#include "Core/ParallelFor.h"
#include "Persistence/CubicalGradient.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// From the key of a critical cell to its number in the sorted list.

/// Finds the number of a key in a sorted list in constant time, with 8 to 16 bytes for each key.
template <typename Key>
class KeyIndex
{
public:
  explicit KeyIndex(const std::vector<Key>& keys)
    : Keys(keys)
  {
    std::size_t slots = 16;
    while (slots < 2 * keys.size())
    {
      slots *= 2;
    }
    this->Slots.assign(slots, 0);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      std::size_t slot = this->FindSlot(keys[i]);
      while (this->Slots[slot] != 0)
      {
        slot = (slot + 1) & (this->Slots.size() - 1);
      }
      this->Slots[slot] = static_cast<std::uint32_t>(i + 1);
    }
  }

  /// The number of a key that is in the list.
  std::size_t operator()(const Key& key) const
  {
    std::size_t slot = this->FindSlot(key);
    while (!(this->Keys[this->Slots[slot] - 1] == key))
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return this->Slots[slot] - 1;
  }

private:
  std::size_t FindSlot(const Key& key) const
  {
    return static_cast<std::size_t>(key.Hash() * 0x9e3779b97f4a7c15U >> 20) &
      (this->Slots.size() - 1);
  }

  const std::vector<Key>& Keys;
  std::vector<std::uint32_t> Slots;
};

//--------------------------------------------------------------------------------------------------
// A chain of edges of a volume under reduction, latest first.

/**
 * A chain of edges over Z/2 as a heap, latest first, in which pairs cancel when they reach the top.
 * An edge that the gradient matches with a face is immediately replaced by the rest of the boundary
 * of that face. An edge that joins components is dropped, since it never closes a loop.
 */
template <typename Gradient>
class EdgeColumn
{
public:
  using Key = typename Gradient::Key;
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

  /// `numbers`: of the critical edges; `negative`: those of them that join components.
  EdgeColumn(
    const Gradient& gradient, const KeyIndex<Key>& numbers, const std::vector<char>& negative)
    : Cells(gradient)
    , NumberOf(numbers)
    , Negative(negative)
  {
  }

  void Clear() { this->Heap.clear(); }

  void Add(const Key* edges, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Push(edges[i]);
    }
  }

  /// Adds the boundary of a face.
  void AddFace(const Key& face)
  {
    for (const Key& edge : this->Cells.GetBoundary(face.Node(), Gradient::GetFace(face)))
    {
      this->Push(edge);
    }
  }

  /// Number of the latest remaining critical edge that joins no components, or None. It is taken
  /// off.
  std::size_t NextCritical()
  {
    while (!this->Heap.empty())
    {
      // Stars are processed one at a time: the remaining critical edges are known only when all
      // matched edges of the star are gone, since a face can replace one edge of a star by another.
      const std::int64_t node = this->Heap.front().Node();
      std::uint32_t edges = this->PopStar(node);
      this->ReplaceMatched(node, edges);
      edges &= this->Cells.Lower()[node].Critical;
      for (int edge = Star::FirstFace - 1; edges != 0; --edge)
      {
        if ((edges >> edge & 1U) == 0)
        {
          continue;
        }
        edges &= ~(1U << edge);
        const std::size_t number = this->NumberOf(this->Cells.EdgeKey(node, StarCell(edge)));
        if (!this->Negative[number])
        {
          this->PushStar(node, edges);
          return number;
        }
      }
    }
    return None;
  }

  /// The remaining edges, latest first (so that adding them to a heap is cheap), without those that
  /// cancel or would be dropped.
  const std::vector<Key>& Rest()
  {
    std::sort(this->Heap.rbegin(), this->Heap.rend());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Heap.size();)
    {
      std::size_t next = i;
      while (next < this->Heap.size() && this->Heap[next] == this->Heap[i])
      {
        ++next;
      }
      if ((next - i) % 2 == 1 && !this->IsDropped(this->Heap[i]))
      {
        this->Heap[kept++] = this->Heap[i];
      }
      i = next;
    }
    this->Heap.resize(kept);
    return this->Heap;
  }

  /// Number of edges processed so far, as a measure of work.
  std::int64_t Steps() const { return this->Work; }

private:
  void Push(const Key& edge)
  {
    this->Heap.push_back(edge);
    std::push_heap(this->Heap.begin(), this->Heap.end());
  }

  /// The edges of the latest star on the heap, as bits; those that occur twice cancel.
  std::uint32_t PopStar(std::int64_t node)
  {
    std::uint32_t edges = 0;
    while (!this->Heap.empty() && this->Heap.front().Node() == node)
    {
      edges ^= 1U << this->Heap.front().Place();
      std::pop_heap(this->Heap.begin(), this->Heap.end());
      this->Heap.pop_back();
      ++this->Work;
    }
    return edges;
  }

  void PushStar(std::int64_t node, std::uint32_t edges)
  {
    for (int edge = 0; edge < Star::FirstFace; ++edge)
    {
      if ((edges >> edge & 1U) != 0)
      {
        this->Push(this->Cells.EdgeKey(node, StarCell(edge)));
      }
    }
  }

  /// Replaces edges that the gradient matches with faces by the rest of the boundaries of these
  /// faces.
  void ReplaceMatched(std::int64_t node, std::uint32_t& edges)
  {
    if (edges == 0)
    {
      return;
    }
    const StarMatching& star = this->Cells.Lower()[node];
    while ((edges & star.EdgesWithFaces) != 0)
    {
      std::size_t edge = 0;
      while (((edges & star.EdgesWithFaces) >> edge & 1U) == 0)
      {
        ++edge;
      }
      const StarCell face(star.Partner[edge]);
      const auto& both = Star::FaceEdges[face.Index() - Star::FirstFace];
      edges ^= 1U << both[0] | 1U << both[1];
      const auto boundary = this->Cells.GetBoundary(node, face);
      this->Push(boundary[2]);
      this->Push(boundary[3]);
    }
  }

  bool IsDropped(const Key& edge) const
  {
    const int partner =
      this->Cells.Lower()[edge.Node()].Partner[static_cast<std::size_t>(edge.Place())];
    return partner == Star::Node ||
      (partner == edge.Place() && this->Negative[this->NumberOf(edge)]);
  }

  const Gradient& Cells;
  const KeyIndex<Key>& NumberOf;
  const std::vector<char>& Negative;
  std::vector<Key> Heap;
  std::int64_t Work = 0;
};

/**
 * Reduces boundaries over Z/2 until the loop of their latest edge has not been filled yet.
 *
 * Only columns with a critical edge at the top are kept (CubicalLoops.h). Nearly linear for maps,
 * cubic in the worst case.
 */
template <typename Gradient>
class LoopReduction
{
public:
  using Key = typename Gradient::Key;

  /// `edges`: the critical ones, sorted; `negative`: those that join components.
  LoopReduction(
    const Gradient& gradient, const std::vector<Key>& edges, const std::vector<char>& negative)
    : Cells(gradient)
    , Edges(edges)
    , Negative(negative)
    , NumberOf(edges)
    , Columns(edges.size())
    , Working(gradient, this->NumberOf, negative)
  {
  }
  LoopReduction(const LoopReduction&) = delete;
  LoopReduction& operator=(const LoopReduction&) = delete;

  /// The edge whose loop `face` fills. Faces must be passed in ascending order, without those that
  /// close voids.
  Key Fill(const Key& face)
  {
    const std::size_t pivot = this->ReduceFace(face);
    this->Store(pivot);
    return this->Edges[pivot];
  }

  /**
   * Computes the edges that Fill would return for `faces`, one after the other, and calls found(i,
   * edge) in this order. For a reduction that has filled nothing yet.
   *
   * The reduction works in rounds on all threads. Each of a few thousand faces adds columns of
   * earlier ones until it reaches an edge that none of them has. Then, in order, the earliest of
   * the faces that reached an edge gets it; the others, and a face that had it before, continue in
   * the next round, together with the following faces. Only earlier columns are ever added, so the
   * pairs are those of Fill (D. Morozov, A. Nigmetov, Towards lockfree persistent homology, SPAA
   * 2020), and rounds do not depend on the threads.
   */
  template <typename Found>
  void FillAll(const std::vector<Key>& faces, Found&& found, const ProgressCallback& progress)
  {
    const std::size_t most = std::max<std::size_t>(1024, faces.size() / 16);
    std::vector<PartialColumn> waiting;
    // Progress within a round is reported only if the round is long, since each part requires
    // starting threads.
    double seconds = std::numeric_limits<double>::infinity();
    for (std::size_t next = 0; next < faces.size() || !waiting.empty();)
    {
      // It is measured by the faces that were started, because the number of finished faces goes up
      // and down.
      const double before = static_cast<double>(next) / static_cast<double>(faces.size());
      while (waiting.size() < most && next < faces.size())
      {
        waiting.push_back({ EdgeColumn<Gradient>::None, { nullptr, 0, true, next++ } });
      }
      const double after = static_cast<double>(next) / static_cast<double>(faces.size());
      const auto start = std::chrono::steady_clock::now();
      this->Advance(
        faces, waiting, seconds < 0.2 ? ProgressCallback() : Between(progress, before, after));
      waiting = this->Claim(waiting);
      seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      Report(progress, after);
    }
    std::vector<typename Key::Link> edgeOf(faces.size());
    for (std::size_t edge = 0; edge < this->Columns.size(); ++edge)
    {
      if (this->Columns[edge].Used)
      {
        edgeOf[this->Columns[edge].Face] = static_cast<typename Key::Link>(edge);
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      found(static_cast<std::int64_t>(i), this->Edges[edgeOf[i]]);
    }
  }

  /// The value that Fill would return, without storing anything.
  Key Find(const Key& face) { return this->Edges[this->ReduceFace(face)]; }

  /// The edges of the column of the face for which Fill returned `edge`, without those that join
  /// components.
  std::vector<Key> BuildColumn(const Key& edge) const
  {
    const Column& column = this->Columns[this->NumberOf(edge)];
    std::vector<Key> edges(column.First, column.First + column.Count);
    edges.push_back(edge);
    return edges;
  }

  /// Removes the face that fills the loop of `edge`, or restores it.
  void SetUsed(const Key& edge, bool used) { this->Columns[this->NumberOf(edge)].Used = used; }

  /// Whether the loop of these edges is filled by the faces given so far.
  bool IsFilled(const std::vector<Key>& loop)
  {
    this->Working.Clear();
    this->Working.Add(loop.data(), loop.size());
    return this->Reduce(this->Working, Latest) == EdgeColumn<Gradient>::None;
  }

private:
  static constexpr std::size_t Latest = std::numeric_limits<std::size_t>::max();

  struct Column
  {
    const Key* First = nullptr;
    std::size_t Count = 0;
    bool Used = false;
    std::size_t Face = 0; ///< the face whose column it is, where FillAll numbers them
  };

  /// State of the reduction of a face: it has reached the edge Pivot, with Rest below it.
  struct PartialColumn
  {
    std::size_t Pivot = EdgeColumn<Gradient>::None;
    Column Rest;
  };

  /// Removes the latest remaining edge for which no face before `face` has a column, and returns
  /// its number, or None.
  std::size_t Reduce(EdgeColumn<Gradient>& working, std::size_t face) const
  {
    std::size_t number = working.NextCritical();
    while (number != EdgeColumn<Gradient>::None && this->Columns[number].Used &&
      this->Columns[number].Face < face)
    {
      working.Add(this->Columns[number].First, this->Columns[number].Count);
      number = working.NextCritical();
    }
    return number;
  }

  static std::size_t RequirePivot(std::size_t pivot)
  {
    if (pivot == EdgeColumn<Gradient>::None)
    {
      throw std::logic_error(
        "A face that does not close a void fills no loop either, so the pairing is wrong.");
    }
    return pivot;
  }

  std::size_t ReduceFace(const Key& face)
  {
    this->Working.Clear();
    this->Working.AddFace(face);
    return RequirePivot(this->Reduce(this->Working, Latest));
  }

  /// Reduces the waiting faces as far as the existing columns allow.
  void Advance(const std::vector<Key>& faces, std::vector<PartialColumn>& waiting,
    const ProgressCallback& progress)
  {
    constexpr std::size_t grain = 16;
    const std::size_t chunks = (waiting.size() + grain - 1) / grain;
    const std::size_t before = this->Blocks.size();
    this->Blocks.resize(before + chunks);
    ParallelFor(
      0, static_cast<std::int64_t>(chunks), 1,
      [&](std::int64_t firstChunk, std::int64_t lastChunk)
      {
        EdgeColumn<Gradient> working(this->Cells, this->NumberOf, this->Negative);
        for (auto chunk = static_cast<std::size_t>(firstChunk);
             chunk < static_cast<std::size_t>(lastChunk); ++chunk)
        {
          const std::size_t from = chunk * grain;
          this->AdvanceChunk(faces, waiting.data() + from, std::min(grain, waiting.size() - from),
            working, this->Blocks[before + chunk]);
        }
      },
      progress);
  }

  void AdvanceChunk(const std::vector<Key>& faces, PartialColumn* who, std::size_t count,
    EdgeColumn<Gradient>& working, std::vector<Key>& block) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      PartialColumn& own = who[i];
      working.Clear();
      if (own.Pivot == EdgeColumn<Gradient>::None)
      {
        working.AddFace(faces[own.Rest.Face]);
      }
      else
      {
        const Column& other = this->Columns[own.Pivot];
        working.Add(own.Rest.First, own.Rest.Count);
        working.Add(other.First, other.Count);
      }
      own.Pivot = RequirePivot(this->Reduce(working, own.Rest.Face));
      const std::vector<Key>& rest = working.Rest();
      own.Rest.Count = rest.size();
      block.insert(block.end(), rest.begin(), rest.end());
    }
    block.shrink_to_fit();
    const Key* next = block.data();
    for (std::size_t i = 0; i < count; ++i)
    {
      who[i].Rest.First = next;
      next += who[i].Rest.Count;
    }
  }

  /// Assigns each edge to the earliest of the faces that reached it; returns the others in order.
  std::vector<PartialColumn> Claim(const std::vector<PartialColumn>& waiting)
  {
    std::vector<PartialColumn> left;
    for (const PartialColumn& own : waiting)
    {
      Column& column = this->Columns[own.Pivot];
      if (column.Used && column.Face < own.Rest.Face)
      {
        left.push_back(own);
        continue;
      }
      if (column.Used)
      {
        left.push_back({ own.Pivot, column });
      }
      column = own.Rest;
    }
    std::sort(left.begin(), left.end(),
      [](const PartialColumn& a, const PartialColumn& b) { return a.Rest.Face < b.Rest.Face; });
    return left;
  }

  /// Keeps the remaining edges below the pivot.
  void Store(std::size_t pivot)
  {
    constexpr std::size_t blockSize = 16384;
    const std::vector<Key>& rest = this->Working.Rest();
    if (this->Kept.empty() || this->Kept.back().capacity() - this->Kept.back().size() < rest.size())
    {
      this->Kept.emplace_back();
      this->Kept.back().reserve(std::max(blockSize, rest.size()));
    }
    std::vector<Key>& block = this->Kept.back();
    block.insert(block.end(), rest.begin(), rest.end());
    this->Columns[pivot] = { block.data() + (block.size() - rest.size()), rest.size(), true, 0 };
  }

  const Gradient& Cells;
  const std::vector<Key>& Edges;
  const std::vector<char>& Negative;
  KeyIndex<Key> NumberOf;
  std::vector<Column> Columns;
  std::vector<std::vector<Key>> Blocks; ///< of columns made by FillAll
  std::vector<std::vector<Key>> Kept;   ///< of those by Fill; never grown beyond what they reserved
  EdgeColumn<Gradient> Working;
};

}

#endif
