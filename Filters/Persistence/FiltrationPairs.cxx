#include "Persistence/FiltrationPairs.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Persistence/CellFiltration.h"

#include <algorithm>

namespace isthmus
{

namespace
{

constexpr std::int64_t SimplicesPerTask = 1 << 14;
constexpr std::size_t ReportEveryVoid = 1 << 18;
constexpr std::size_t LeastSides = 1 << 16;

using Sides = std::vector<std::array<TetrahedronRank, 2>>;

/// For the triangles of ranks [first, first + sides.size()) the ranks of the tetrahedra beside
/// them; the exterior comes last. Triangles are processed in the order of their numbers, since
/// their tetrahedra are then close in memory.
void FindSides(const CellFiltration& f, const HandleVector<TriangleId, TriangleRank>& triangleRank,
  const HandleVector<TetrahedronId, TetrahedronRank>& cellRank, std::size_t first, Sides& sides)
{
  const auto rank = [&cellRank](TetrahedronId cell)
  { return cell.Exists() ? cellRank[cell] : TetrahedronRank::At(cellRank.size()); };
  ParallelFor(0, static_cast<std::int64_t>(f.TriangleCount()), SimplicesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        const std::size_t place = triangleRank[t].Index() - first; // huge if below `first`
        if (place < sides.size())
        {
          const auto beside = f.TriangleSides(t);
          sides[place] = { rank(beside[0]), rank(beside[1]) };
        }
      }
    });
}

/// Triangles in an order, and their ranks in it.
struct TriangleOrder
{
  const HandleVector<TriangleRank, TriangleId>& InOrder;
  const HandleVector<TriangleId, TriangleRank>& Ranks;
};

/// Calls pair(triangle, tetrahedron) for each void: see VoidPairs().
template <typename Pair>
void ForEachVoidPair(const CellFiltration& f, const TriangleOrder& triangles,
  const HandleVector<TetrahedronId, char>& first, const ProgressCallback& progress,
  const Pair& pair)
{
  const std::size_t count = f.TriangleCount();
  HandleVector<TetrahedronId, TetrahedronRank> rank;
  const auto inOrder = SimplexOrder(f.TetrahedronValue, first, rank, Between(progress, 0.0, 0.2));
  // Basins of tetrahedra by rank, the last one the exterior. The root of each is its latest one, so
  // that the elder rule compares the numbers of two roots.
  DisjointSets<TetrahedronRank> basins(inOrder.size() + 1);
  // A quarter of the triangles at a time, so that their sides need a quarter of the memory.
  Sides sides;
  for (std::size_t end = count; end > 0;)
  {
    const std::size_t from = end - std::min(end, std::max(count / 4 + 1, LeastSides));
    sides.resize(end - from);
    FindSides(f, triangles.Ranks, rank, from, sides);
    for (std::size_t i = end; i-- > from;)
    {
      if (i % ReportEveryVoid == 0)
      {
        Report(progress, 1.0 - 0.8 * static_cast<double>(i) / static_cast<double>(count));
      }
      const TetrahedronRank a = basins.Find(sides[i - from][0]);
      const TetrahedronRank b = basins.Find(sides[i - from][1]);
      if (a != b)
      {
        basins.JoinUnder(std::min(a, b), std::max(a, b));
        pair(triangles.InOrder[TriangleRank::At(i)], inOrder[std::min(a, b)]);
      }
    }
    end = from;
  }
}

}

HandleVector<TriangleId, TetrahedronId> VoidPairs(
  const CellFiltration& f, const ProgressCallback& progress)
{
  HandleVector<TriangleId, TetrahedronId> filledBy(f.TriangleCount(), TetrahedronId::None());
  const auto store = [&filledBy](TriangleId triangle, TetrahedronId cell)
  { filledBy[triangle] = cell; };
  if (f.TriangleIndistinct.empty())
  {
    ForEachVoidPair(f, { f.TrianglesInOrder, f.RankOfTriangle }, {}, progress, store);
    return filledBy;
  }
  HandleVector<TriangleId, TriangleRank> ranks;
  const auto order = SimplexOrder(f.TriangleValue, {}, ranks, Between(progress, 0.0, 0.3));
  ForEachVoidPair(f, { order, ranks }, {}, Between(progress, 0.3, 1.0), store);
  return filledBy;
}

namespace
{

/// A chain under reduction: a heap of ranks in which equal ones cancel in pairs.
template <typename Rank>
class RankHeap
{
public:
  void Add(Rank rank)
  {
    this->Ranks.push_back(rank);
    std::push_heap(this->Ranks.begin(), this->Ranks.end());
  }

  void Clear() { this->Ranks.clear(); }

  /// Takes out the greatest rank; None when nothing is left.
  Rank Take()
  {
    while (!this->Ranks.empty())
    {
      const Rank top = this->Pop();
      if (this->Ranks.empty() || this->Ranks.front() != top)
      {
        return top;
      }
      this->Pop();
    }
    return Rank::None();
  }

  /// Appends all that is left to `ranks`, in descending order.
  void TakeAll(std::vector<Rank>& ranks)
  {
    for (Rank rank = this->Take(); rank.Exists(); rank = this->Take())
    {
      ranks.push_back(rank);
    }
  }

private:
  Rank Pop()
  {
    std::pop_heap(this->Ranks.begin(), this->Ranks.end());
    const Rank top = this->Ranks.back();
    this->Ranks.pop_back();
    return top;
  }

  std::vector<Rank> Ranks;
};

/// Triangles that occur an odd number of times.
void KeepOdd(TriangleChain& chain)
{
  std::sort(chain.begin(), chain.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < chain.size();)
  {
    std::size_t j = i;
    while (j < chain.size() && chain[j] == chain[i])
    {
      ++j;
    }
    if ((j - i) % 2 == 1)
    {
      chain[kept++] = chain[i];
    }
    i = j;
  }
  chain.resize(kept);
}

constexpr std::int64_t ReportEvery = 1 << 16;

}

/// Working memory of successive reductions, allocated once.
struct FiltrationPairs::Reduction
{
  RankHeap<EdgeRank> Column;
  std::vector<EdgeRank> Reduced;
  std::vector<TriangleRank> Added;
};

FiltrationPairs::FiltrationPairs(const CellFiltration& f, const ProgressCallback& progress)
  : F(f)
  , Columns(f.TriangleCount())
{
  this->Partner.assign(f.TriangleCount(), -1);
  ForEachVoidPair(f, { f.TrianglesInOrder, f.RankOfTriangle }, f.TetrahedronIndistinct,
    Between(progress, 0.0, 0.2),
    [this](TriangleId triangle, TetrahedronId cell) { this->Partner[triangle] = -2 - cell.Value; });
  this->PairLoops(Between(progress, 0.2, 0.8));
  if (!f.TriangleIndistinct.empty())
  {
    this->ByValue = VoidPairs(f, Between(progress, 0.8, 1.0));
  }
}

/// For each triangle, by rank, the rank of its latest edge; None for those that close voids.
/// Triangles are processed in the order of their numbers, since their edges are then close in
/// memory.
HandleVector<TriangleRank, EdgeRank> FiltrationPairs::Pivots() const
{
  HandleVector<TriangleRank, EdgeRank> pivots(this->F.TriangleCount());
  ParallelFor(0, static_cast<std::int64_t>(pivots.size()), SimplicesPerTask,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        const auto edges = this->F.TriangleEdges(t);
        const auto& rank = this->F.RankOfEdge;
        pivots[this->F.RankOfTriangle[t]] = this->Partner[t] < -1
          ? EdgeRank::None()
          : std::max({ rank[edges[0]], rank[edges[1]], rank[edges[2]] });
      }
    });
  return pivots;
}

void FiltrationPairs::PairLoops(const ProgressCallback& progress)
{
  const std::size_t triangles = this->F.TriangleCount();
  HandleVector<EdgeRank, TriangleRank>& filler = this->Filler;
  filler.assign(this->F.Edges.size(), TriangleRank::None());
  const auto pivots = this->Pivots();
  Reduction work;
  std::size_t done = 0;
  std::int64_t steps = 0;
  // Columns added count too: those of a few triangles may take longer than all others.
  const auto tick = [&]
  {
    if (++steps % ReportEvery == 0)
    {
      Report(progress, static_cast<double>(done) / static_cast<double>(triangles));
    }
  };
  for (; done < triangles; ++done)
  {
    tick();
    const auto triangle = TriangleRank::At(done);
    EdgeRank pivot = pivots[triangle];
    if (pivot.Exists() &&
      (!filler[pivot].Exists() || this->Reduce(triangle, filler, pivot, work, tick)))
    {
      filler[pivot] = triangle;
    }
  }
  this->Columns.Finish();
  for (const EdgeRank rank : filler.Keys())
  {
    if (filler[rank].Exists())
    {
      this->Partner[this->F.TrianglesInOrder[filler[rank]]] = this->F.EdgesInOrder[rank].Value;
    }
  }
}

/// Edges of a triangle, all by rank.
std::array<EdgeRank, 3> FiltrationPairs::GetBoundary(TriangleRank rank) const
{
  const auto edges = this->F.TriangleEdges(this->F.TrianglesInOrder[rank]);
  const auto& ranks = this->F.RankOfEdge;
  return { ranks[edges[0]], ranks[edges[1]], ranks[edges[2]] };
}

/// The column of a triangle but for its pivot, which the caller has just removed from the heap.
template <typename Heap>
void FiltrationPairs::AddColumn(TriangleRank rank, EdgeRank pivot, Heap& heap) const
{
  const auto add = [&heap, pivot](EdgeRank edge)
  {
    if (edge != pivot)
    {
      heap.Add(edge);
    }
  };
  const std::int64_t place = this->Columns.Find(rank);
  if (place >= 0)
  {
    this->Columns.ForEachEdge(place, add);
    return;
  }
  for (const EdgeRank edge : this->GetBoundary(rank))
  {
    add(edge);
  }
}

/// Reduces the column of a triangle, by rank, until its latest edge has no filler; false when
/// nothing is left, which happens only where the complex has a void that nothing fills.
bool FiltrationPairs::Reduce(TriangleRank rank, const HandleVector<EdgeRank, TriangleRank>& filler,
  EdgeRank& pivot, Reduction& work, const std::function<void()>& tick)
{
  auto& [column, reduced, added] = work;
  column.Clear();
  reduced.clear();
  added.clear();
  for (const EdgeRank e : this->GetBoundary(rank))
  {
    column.Add(e);
  }
  EdgeRank low = column.Take();
  while (low.Exists() && filler[low].Exists())
  {
    const TriangleRank other = filler[low];
    tick();
    added.push_back(other);
    this->AddColumn(other, low, column);
    low = column.Take();
  }
  if (!low.Exists())
  {
    return false;
  }
  pivot = low;
  reduced.push_back(low);
  column.TakeAll(reduced);
  this->Columns.Add(rank, reduced, added);
  return true;
}

/// By what it fills or else, for one of a void, by bisection.
TriangleRank FiltrationPairs::FindRank(TriangleId triangle) const
{
  const EdgeId closer = this->LoopClosed(triangle);
  if (closer.Exists())
  {
    return this->Filler[this->F.RankOfEdge[closer]];
  }
  const auto& order = this->F.TrianglesInOrder;
  const auto at = std::lower_bound(order.begin(), order.end(), triangle,
    [this](TriangleId one, TriangleId other) { return this->F.RanksAbove(other, one); });
  return TriangleRank::At(static_cast<std::size_t>(at - order.begin()));
}

TriangleChain FiltrationPairs::Filling(TriangleId triangle) const
{
  return this->Filling(this->FindRank(triangle));
}

TriangleChain FiltrationPairs::Filling(TriangleRank triangle) const
{
  // A triangle may be reached on many paths: latest first, each is expanded once, with its parity.
  RankHeap<TriangleRank> pending;
  pending.Add(triangle);
  TriangleChain filling;
  for (TriangleRank rank = pending.Take(); rank.Exists(); rank = pending.Take())
  {
    filling.push_back(this->F.TrianglesInOrder[rank]);
    const std::int64_t place = this->Columns.Find(rank);
    if (place >= 0)
    {
      this->Columns.ForEachAdded(place, [&pending](TriangleRank other) { pending.Add(other); });
    }
  }
  return filling;
}

EdgeChain FiltrationPairs::Push(
  const EdgeChain& z, TriangleId limit, const Unwanted& unwanted, TriangleChain& swept) const
{
  const TriangleRank end = this->FindRank(limit);
  RankHeap<EdgeRank> cycle;
  for (const EdgeId e : z)
  {
    cycle.Add(this->F.RankOfEdge[e]);
  }
  EdgeChain kept;
  for (EdgeRank rank = cycle.Take(); rank.Exists(); rank = cycle.Take())
  {
    const EdgeId e = this->F.EdgesInOrder[rank];
    const TriangleRank filler = this->Filler[rank];
    if (!filler.Exists() || filler >= end || !unwanted(e))
    {
      kept.push_back(e);
      continue;
    }
    this->AddColumn(filler, rank, cycle);
    const TriangleChain passed = this->Filling(filler);
    swept.insert(swept.end(), passed.begin(), passed.end());
  }
  KeepOdd(swept);
  return kept;
}

std::vector<std::int64_t> FiltrationPairs::Bounding(const EdgeChain& z) const
{
  RankHeap<EdgeRank> cycle;
  for (const EdgeId e : z)
  {
    cycle.Add(this->F.RankOfEdge[e]);
  }
  std::vector<std::int64_t> ranks;
  for (EdgeRank rank = cycle.Take(); rank.Exists(); rank = cycle.Take())
  {
    const TriangleRank filler = this->Filler[rank];
    if (!filler.Exists())
    {
      ranks.push_back(rank.Value + static_cast<std::int64_t>(this->F.TriangleCount()));
      continue;
    }
    ranks.push_back(filler.Value);
    this->AddColumn(filler, rank, cycle);
  }
  std::sort(ranks.begin(), ranks.end(), std::greater<>());
  return ranks;
}

}
