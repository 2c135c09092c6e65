/**
 * @file CubicalLoops.h
 * @brief Pairs of dimension 1 of a volume: reduction of the critical faces' boundaries.
 */
#ifndef isthmus_CubicalLoops_h
#define isthmus_CubicalLoops_h

#include "EdgeColumn.h"
#include "ParallelFor.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace isthmus
{

/**
 * Reduces boundaries over Z/2 until their latest edge is one whose loop nothing has filled yet.
 *
 * Only columns with a critical edge at the top are kept (EdgeColumn.h). Near linear on maps, cubic
 * at worst.
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

  /// The edge whose loop `face` fills. Faces are given in ascending order, those that close voids
  /// left out.
  Key Fill(const Key& face)
  {
    const std::size_t pivot = this->ReduceFace(face);
    this->Store(pivot);
    return this->Edges[pivot];
  }

  /**
   * The edges whose loops `faces` fill, as Fill would give them in turn: calls found(i, edge) in
   * their order. For a reduction that has filled nothing yet.
   *
   * Batch by batch, on all threads, in rounds: each face adds columns of earlier ones until it
   * comes to an edge that none of them has; then, in order, the earliest of those that came to an
   * edge gets it, and the others, with whoever had it before, go on in the next round. Only earlier
   * columns are ever added, so the pairs are those of Fill (D. Morozov, A. Nigmetov, Towards
   * lockfree persistent homology, SPAA 2020), and rounds do not depend on the threads.
   */
  template <typename Found>
  void FillAll(const std::vector<Key>& faces, Found&& found, const ProgressCallback& progress)
  {
    const auto count = static_cast<std::int64_t>(faces.size());
    const std::int64_t batch = std::max<std::int64_t>(1024, count / 64);
    std::vector<Begun> begun;
    std::vector<std::int64_t> waiting;
    for (std::int64_t first = 0; first < count; first += batch)
    {
      const std::int64_t last = std::min(count, first + batch);
      begun.assign(static_cast<std::size_t>(last - first), Begun());
      waiting.resize(begun.size());
      std::iota(waiting.begin(), waiting.end(), std::int64_t{ 0 });
      const auto report = [&](double done)
      {
        Report(progress,
          (static_cast<double>(first) + done * static_cast<double>(last - first)) /
            static_cast<double>(count));
      };
      while (!waiting.empty())
      {
        const double left = static_cast<double>(waiting.size()) / static_cast<double>(begun.size());
        this->Advance(faces, first, begun, waiting, report, 1.0 - left);
        waiting = this->Claim(first, begun, waiting);
      }
      for (std::int64_t i = first; i < last; ++i)
      {
        found(i, this->Edges[begun[static_cast<std::size_t>(i - first)].Pivot]);
      }
    }
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
    this->Working.Clear();
    this->Working.Add(loop.data(), loop.size());
    return this->Reduce(this->Working, Latest) == EdgeColumn<Gradient>::None;
  }

private:
  static constexpr std::int64_t Latest = std::numeric_limits<std::int64_t>::max();

  struct Column
  {
    const Key* First = nullptr;
    std::size_t Count = 0;
    bool Used = false;
    std::int64_t Face = -1; ///< the face whose column it is, where FillAll numbers them
  };

  /// How far a face of a batch has come: to the edge Pivot, with Rest below it.
  struct Begun
  {
    std::size_t Pivot = EdgeColumn<Gradient>::None;
    Column Rest;
  };

  /// Number of the latest edge that stays and has no column of a face before `face`, None where
  /// there is none. It is taken off.
  std::size_t Reduce(EdgeColumn<Gradient>& working, std::int64_t face) const
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

  static std::size_t Demanded(std::size_t pivot)
  {
    if (pivot == EdgeColumn<Gradient>::None)
    {
      throw std::logic_error("A face that closes no void fills no loop: the pairing is wrong.");
    }
    return pivot;
  }

  std::size_t ReduceFace(const Key& face)
  {
    this->Working.Clear();
    this->Working.AddFace(face);
    return Demanded(this->Reduce(this->Working, Latest));
  }

  /// Reduces those who wait as far as the columns there are let them.
  template <typename Told>
  void Advance(const std::vector<Key>& faces, std::int64_t first, std::vector<Begun>& begun,
    const std::vector<std::int64_t>& waiting, const Told& report, double done)
  {
    constexpr std::int64_t grain = 32;
    const auto count = static_cast<std::int64_t>(waiting.size());
    const std::int64_t chunks = (count + grain - 1) / grain;
    const std::size_t before = this->Blocks.size();
    this->Blocks.resize(before + static_cast<std::size_t>(chunks));
    const double share = static_cast<double>(count) / static_cast<double>(begun.size());
    ParallelFor(
      0, chunks, 1,
      [&](std::int64_t firstChunk, std::int64_t lastChunk)
      {
        EdgeColumn<Gradient> working(this->Cells, this->NumberOf, this->Negative);
        for (std::int64_t chunk = firstChunk; chunk < lastChunk; ++chunk)
        {
          const std::int64_t from = chunk * grain;
          this->AdvanceChunk(faces, first, begun, waiting.data() + from,
            static_cast<std::size_t>(std::min(grain, count - from)), working,
            this->Blocks[before + static_cast<std::size_t>(chunk)]);
        }
      },
      [&](double fraction)
      {
        report(done + 0.5 * share * fraction);
        return true;
      });
  }

  void AdvanceChunk(const std::vector<Key>& faces, std::int64_t first, std::vector<Begun>& begun,
    const std::int64_t* who, std::size_t count, EdgeColumn<Gradient>& working,
    std::vector<Key>& block) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      Begun& own = begun[static_cast<std::size_t>(who[i])];
      working.Clear();
      if (own.Pivot == EdgeColumn<Gradient>::None)
      {
        working.AddFace(faces[static_cast<std::size_t>(first + who[i])]);
      }
      else
      {
        const Column& other = this->Columns[own.Pivot];
        working.Add(own.Rest.First, own.Rest.Count);
        working.Add(other.First, other.Count);
      }
      own.Pivot = Demanded(this->Reduce(working, first + who[i]));
      const std::vector<Key>& rest = working.Rest();
      own.Rest = { nullptr, rest.size(), true, first + who[i] };
      block.insert(block.end(), rest.begin(), rest.end());
    }
    block.shrink_to_fit();
    const Key* next = block.data();
    for (std::size_t i = 0; i < count; ++i)
    {
      Column& rest = begun[static_cast<std::size_t>(who[i])].Rest;
      rest.First = next;
      next += rest.Count;
    }
  }

  /// Gives each edge to the earliest of those that came to it; the others, in order.
  std::vector<std::int64_t> Claim(
    std::int64_t first, const std::vector<Begun>& begun, const std::vector<std::int64_t>& waiting)
  {
    std::vector<std::int64_t> left;
    for (const std::int64_t who : waiting)
    {
      const Begun& own = begun[static_cast<std::size_t>(who)];
      Column& column = this->Columns[own.Pivot];
      if (column.Used && column.Face < first + who)
      {
        left.push_back(who);
        continue;
      }
      if (column.Used)
      {
        left.push_back(column.Face - first);
      }
      column = own.Rest;
    }
    std::sort(left.begin(), left.end());
    return left;
  }

  /// Keeps what is left below the pivot.
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
    this->Columns[pivot] = { block.data() + (block.size() - rest.size()), rest.size(), true, -1 };
  }

  const Gradient& Cells;
  const std::vector<Key>& Edges;
  const std::vector<char>& Negative;
  KeyNumbers<Key> NumberOf;
  std::vector<Column> Columns;
  std::vector<std::vector<Key>> Blocks; ///< of columns made by FillAll
  std::vector<std::vector<Key>> Kept;   ///< of those by Fill; never grown beyond what they reserved
  EdgeColumn<Gradient> Working;
};

}

#endif
