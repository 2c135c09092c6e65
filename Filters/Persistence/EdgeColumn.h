/**
 * @file EdgeColumn.h
 * @brief A chain of edges of a volume under reduction, latest first.
 */
#ifndef isthmus_EdgeColumn_h
#define isthmus_EdgeColumn_h

#include "Persistence/CubicalGradient.h"
#include "Persistence/KeyNumbers.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace isthmus
{

/**
 * Edges over Z/2 as a heap, latest first, in which pairs cancel when they surface. An edge that
 * the gradient matches with a face is replaced by the rest of that face's boundary on the spot; one
 * that joins components is dropped, since it never closes a loop.
 */
template <typename Gradient>
class EdgeColumn
{
public:
  using Key = typename Gradient::Key;
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

  /// `numbers`: of the critical edges; `negative`: those of them that join components.
  EdgeColumn(
    const Gradient& gradient, const KeyNumbers<Key>& numbers, const std::vector<char>& negative)
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
    for (const Key& edge : this->Cells.BoundaryOf(face.Node(), Gradient::FaceOf(face)))
    {
      this->Push(edge);
    }
  }

  /// Number of the latest critical edge that stays and joins no components, None where there is
  /// none. It is taken off.
  std::size_t NextCritical()
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

  /// What is left, latest first (so that adding it to a heap is cheap), without what cancels or
  /// would be dropped.
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

  /// Edges looked at so far, as a measure of work.
  std::int64_t Steps() const { return this->Work; }

private:
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
        this->Push(this->Cells.EdgeKey(node, StarCell(edge)));
      }
    }
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
      const StarCell face(star.Partner[edge]);
      const auto& both = Star::FaceEdges[face.Index() - Star::FirstFace];
      edges ^= 1U << both[0] | 1U << both[1];
      const auto boundary = this->Cells.BoundaryOf(node, face);
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
  const KeyNumbers<Key>& NumberOf;
  const std::vector<char>& Negative;
  std::vector<Key> Heap;
  std::int64_t Work = 0;
};

}

#endif
