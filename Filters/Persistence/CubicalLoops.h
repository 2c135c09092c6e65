/**
 * @file CubicalLoops.h
 * @brief Pairs of dimension 1 of a volume: reduction of the critical faces' boundaries.
 */
#ifndef isthmus_CubicalLoops_h
#define isthmus_CubicalLoops_h

#include "CubicalGradient.h"
#include "Progress.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace isthmus
{

/// Numbers of keys in a sorted list, found in constant time. 8 to 16 bytes a key.
template <typename Key>
class KeyNumbers
{
public:
  explicit KeyNumbers(const std::vector<Key>& keys)
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
      std::size_t slot = this->SlotOf(keys[i]);
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
    std::size_t slot = this->SlotOf(key);
    while (!(this->Keys[this->Slots[slot] - 1] == key))
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return this->Slots[slot] - 1;
  }

private:
  std::size_t SlotOf(const Key& key) const
  {
    return static_cast<std::size_t>(key.Hash() * 0x9e3779b97f4a7c15U >> 20) &
      (this->Slots.size() - 1);
  }

  const std::vector<Key>& Keys;
  std::vector<std::uint32_t> Slots;
};

/**
 * Reduces boundaries over Z/2 until their latest edge is one whose loop nothing has filled yet.
 *
 * A column is a heap of edges, latest first, in which pairs cancel when they surface. An edge that
 * the gradient matches with a face is replaced by the rest of that face's boundary on the spot; one
 * that joins components is dropped, since it never closes a loop. Only columns with a critical edge
 * at the top are kept. Near linear on maps, cubic at worst.
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
  {
  }

  /// The edge whose loop `face` fills. Faces are given in ascending order, those that close voids
  /// left out.
  Key Fill(const Key& face)
  {
    const std::size_t pivot = this->ReduceFace(face);
    this->Store(pivot);
    return this->Edges[pivot];
  }

  /// What Fill would return; nothing is kept.
  Key Find(const Key& face) { return this->Edges[this->ReduceFace(face)]; }

  /// The edges of the column of a face that Fill has returned `edge` for, without those that join
  /// components.
  std::vector<Key> ColumnOf(const Key& edge) const
  {
    const Column& column = this->Columns[this->NumberOf(edge)];
    std::vector<Key> edges(column.First, column.First + column.Count);
    edges.push_back(edge);
    return edges;
  }

  /// Takes the face that fills the loop of `edge` out, or puts it back.
  void SetUsed(const Key& edge, bool used) { this->Columns[this->NumberOf(edge)].Used = used; }

  /// Whether the loop of these edges is filled by the faces given so far.
  bool IsFilled(const std::vector<Key>& loop)
  {
    this->Heap = loop;
    std::make_heap(this->Heap.begin(), this->Heap.end());
    return this->Reduce() == this->Edges.size();
  }

  /// Edges looked at, as a measure of work.
  std::int64_t Steps() const { return this->Work; }

private:
  std::size_t ReduceFace(const Key& face)
  {
    this->Heap.clear();
    this->Add(face.Node(), Gradient::FaceOf(face));
    const std::size_t pivot = this->Reduce();
    if (pivot == this->Edges.size())
    {
      throw std::logic_error("A face that closes no void fills no loop: the pairing is wrong.");
    }
    return pivot;
  }

  struct Column
  {
    const Key* First = nullptr;
    std::size_t Count = 0;
    bool Used = false;
  };

  void Push(const Key& edge)
  {
    this->Heap.push_back(edge);
    std::push_heap(this->Heap.begin(), this->Heap.end());
  }

  /// The edges of the latest star on the heap, as bits; those that are there twice cancel.
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
        this->Push(this->Cells.EdgeKey(node, edge));
      }
    }
  }

  /// Number of the latest edge that stays, Edges.size() where none does. It is taken off the heap.
  std::size_t Reduce()
  {
    while (!this->Heap.empty())
    {
      // A star at a time: only when its matched edges are gone is it known which critical edges
      // are left, since a face can trade one edge of a star for another.
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
        const std::size_t number = this->NumberOf(this->Cells.EdgeKey(node, edge));
        if (this->Negative[number])
        {
          continue;
        }
        this->PushStar(node, edges);
        const Column& column = this->Columns[number];
        if (!column.Used)
        {
          return number;
        }
        for (std::size_t i = 0; i < column.Count; ++i)
        {
          this->Push(column.First[i]);
        }
        break;
      }
    }
    return this->Edges.size();
  }

  /// Trades edges that the gradient matches with faces for the rest of the faces' boundaries.
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
      const int face = star.Partner[edge];
      const auto& both = Star::FaceEdges[static_cast<std::size_t>(face - Star::FirstFace)];
      edges ^= 1U << both[0] | 1U << both[1];
      const auto boundary = this->Cells.BoundaryOf(node, face);
      this->Push(boundary[2]);
      this->Push(boundary[3]);
    }
  }

  void Add(std::int64_t node, int face)
  {
    for (const Key& edge : this->Cells.BoundaryOf(node, face))
    {
      this->Push(edge);
    }
  }

  int Partner(const Key& edge) const
  {
    return this->Cells.Lower()[edge.Node()].Partner[static_cast<std::size_t>(edge.Place())];
  }

  /// Keeps what is on the heap below the pivot, without what cancels or would be dropped.
  void Store(std::size_t pivot)
  {
    std::sort(this->Heap.begin(), this->Heap.end());
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
    this->Columns[pivot] = { this->Keep(kept), kept, true };
  }

  bool IsDropped(const Key& edge) const
  {
    const int partner = this->Partner(edge);
    return partner == Star::Node ||
      (partner == edge.Place() && this->Negative[this->NumberOf(edge)]);
  }

  /// Copies the first `count` of the heap to where they stay.
  const Key* Keep(std::size_t count)
  {
    constexpr std::size_t blockSize = 16384;
    if (this->Blocks.empty() || this->Blocks.back().capacity() - this->Blocks.back().size() < count)
    {
      this->Blocks.emplace_back();
      this->Blocks.back().reserve(std::max(blockSize, count));
    }
    std::vector<Key>& block = this->Blocks.back();
    const auto end = this->Heap.begin() + static_cast<std::ptrdiff_t>(count);
    block.insert(block.end(), this->Heap.begin(), end);
    return block.data() + (block.size() - count);
  }

  const Gradient& Cells;
  const std::vector<Key>& Edges;
  const std::vector<char>& Negative;
  KeyNumbers<Key> NumberOf;
  std::vector<Column> Columns;
  std::vector<std::vector<Key>> Blocks; ///< never grown beyond what they reserved
  std::vector<Key> Heap;
  std::int64_t Work = 0;
};

}

#endif
