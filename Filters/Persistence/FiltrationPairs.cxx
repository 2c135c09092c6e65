#include "FiltrationPairs.h"

#include "Index.h"
#include "ParallelFor.h"
#include "VoidPairs.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// A chain under reduction: a heap of ranks in which equal ones cancel in pairs.
class RankHeap
{
public:
  void Add(SimplexId rank)
  {
    this->Ranks.push_back(rank);
    std::push_heap(this->Ranks.begin(), this->Ranks.end());
  }

  /// Takes out the greatest rank; -1 when nothing is left.
  SimplexId Take()
  {
    while (!this->Ranks.empty())
    {
      const SimplexId top = this->Pop();
      if (this->Ranks.empty() || this->Ranks.front() != top)
      {
        return top;
      }
      this->Pop();
    }
    return -1;
  }

  /// All that is left, in descending order.
  Chain TakeAll()
  {
    Chain rest;
    for (SimplexId rank = this->Take(); rank >= 0; rank = this->Take())
    {
      rest.push_back(rank);
    }
    return rest;
  }

private:
  SimplexId Pop()
  {
    std::pop_heap(this->Ranks.begin(), this->Ranks.end());
    const SimplexId top = this->Ranks.back();
    this->Ranks.pop_back();
    return top;
  }

  std::vector<SimplexId> Ranks;
};

/// Ids that occur an odd number of times.
void KeepOdd(Chain& chain)
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
constexpr std::int64_t Grain = 1 << 14;

}

FiltrationPairs::FiltrationPairs(const CellFiltration& f, const ProgressCallback& progress)
  : F(f)
  , Partner(VoidPairs(f, Between(progress, 0.0, 0.3)))
  , Columns(f.TriangleCount())
{
  std::transform(this->Partner.begin(), this->Partner.end(), this->Partner.begin(),
    [](SimplexId cell) { return cell < 0 ? -1 : -2 - cell; });
  this->PairLoops(Between(progress, 0.3, 1.0));
}

/// For each triangle, by rank, the rank of its latest edge; -1 for those that close voids.
/// Triangles are gone through as they are numbered, since their edges then lie near each other.
std::vector<SimplexId> FiltrationPairs::Pivots() const
{
  std::vector<SimplexId> pivots(this->F.TriangleCount());
  ParallelFor(0, static_cast<std::int64_t>(pivots.size()), Grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
      {
        const auto& edges = this->F.TriangleEdges[t];
        const auto& rank = this->F.EdgeRank;
        pivots[At(this->F.TriangleRank[t])] = this->Partner[t] < -1
          ? -1
          : std::max({ rank[At(edges[0])], rank[At(edges[1])], rank[At(edges[2])] });
      }
    });
  return pivots;
}

void FiltrationPairs::PairLoops(const ProgressCallback& progress)
{
  const std::size_t triangles = this->F.TriangleCount();
  std::vector<SimplexId> filler(this->F.Edges.size(), -1); // triangle by edge, both by rank
  const std::vector<SimplexId> pivots = this->Pivots();
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
    SimplexId pivot = pivots[done];
    if (pivot >= 0 &&
      (filler[At(pivot)] < 0 || this->Reduce(static_cast<SimplexId>(done), filler, pivot, tick)))
    {
      filler[At(pivot)] = static_cast<SimplexId>(done);
    }
  }
  this->Columns.Finish();
  this->LoopFilledBy.assign(this->F.Edges.size(), -1);
  for (std::size_t edge = 0; edge < filler.size(); ++edge)
  {
    if (filler[edge] >= 0)
    {
      const SimplexId t = this->F.TrianglesInOrder[At(filler[edge])];
      this->LoopFilledBy[At(this->F.EdgesInOrder[edge])] = t;
      this->Partner[At(t)] = this->F.EdgesInOrder[edge];
    }
  }
}

/// Edges of a triangle, all by rank.
std::array<SimplexId, 3> FiltrationPairs::BoundaryOf(SimplexId rank) const
{
  const auto& edges = this->F.TriangleEdges[At(this->F.TrianglesInOrder[At(rank)])];
  const auto& ranks = this->F.EdgeRank;
  return { ranks[At(edges[0])], ranks[At(edges[1])], ranks[At(edges[2])] };
}

/// The column of a triangle but for its pivot, which the taker has just taken out of the heap.
template <typename Heap>
void FiltrationPairs::AddColumn(SimplexId rank, SimplexId pivot, Heap& heap) const
{
  const auto add = [&heap, pivot](SimplexId edge)
  {
    if (edge != pivot)
    {
      heap.Add(edge);
    }
  };
  const std::int64_t place = this->Columns.Find(rank);
  if (place >= 0)
  {
    this->Columns.ForEdges(place, add);
    return;
  }
  for (const SimplexId edge : this->BoundaryOf(rank))
  {
    add(edge);
  }
}

/// Reduces the column of a triangle, by rank, until its latest edge has no filler; false when
/// nothing is left, which happens only where the complex has a void that nothing fills.
bool FiltrationPairs::Reduce(SimplexId rank, const std::vector<SimplexId>& filler, SimplexId& pivot,
  const std::function<void()>& tick)
{
  RankHeap column;
  Chain added;
  for (const SimplexId e : this->BoundaryOf(rank))
  {
    column.Add(e);
  }
  SimplexId low = column.Take();
  while (low >= 0 && filler[At(low)] >= 0)
  {
    const SimplexId other = filler[At(low)];
    tick();
    added.push_back(other);
    this->AddColumn(other, low, column);
    low = column.Take();
  }
  if (low < 0)
  {
    return false;
  }
  pivot = low;
  Chain ranks = column.TakeAll();
  ranks.insert(ranks.begin(), low);
  this->Columns.Add(rank, ranks, added);
  return true;
}

Chain FiltrationPairs::Filling(SimplexId triangle) const
{
  // A triangle may be reached on many ways: latest first, each is expanded once, with its parity.
  RankHeap pending;
  pending.Add(this->F.TriangleRank[At(triangle)]);
  Chain filling;
  for (SimplexId rank = pending.Take(); rank >= 0; rank = pending.Take())
  {
    filling.push_back(this->F.TrianglesInOrder[At(rank)]);
    const std::int64_t place = this->Columns.Find(rank);
    if (place >= 0)
    {
      this->Columns.ForAdded(place, [&pending](SimplexId other) { pending.Add(other); });
    }
  }
  return filling;
}

Chain FiltrationPairs::Push(
  const Chain& z, SimplexId limit, const Unwanted& unwanted, Chain& swept) const
{
  RankHeap cycle;
  for (const SimplexId e : z)
  {
    cycle.Add(this->F.EdgeRank[At(e)]);
  }
  Chain kept;
  for (SimplexId rank = cycle.Take(); rank >= 0; rank = cycle.Take())
  {
    const SimplexId e = this->F.EdgesInOrder[At(rank)];
    const SimplexId filler = this->LoopFilledBy[At(e)];
    if (filler < 0 || this->F.TriangleRank[At(filler)] >= limit || !unwanted(e))
    {
      kept.push_back(e);
      continue;
    }
    this->AddColumn(this->F.TriangleRank[At(filler)], rank, cycle);
    const Chain passed = this->Filling(filler);
    swept.insert(swept.end(), passed.begin(), passed.end());
  }
  KeepOdd(swept);
  return kept;
}

std::vector<std::int64_t> FiltrationPairs::Bounding(const Chain& z) const
{
  RankHeap cycle;
  for (const SimplexId e : z)
  {
    cycle.Add(this->F.EdgeRank[At(e)]);
  }
  std::vector<std::int64_t> ranks;
  for (SimplexId rank = cycle.Take(); rank >= 0; rank = cycle.Take())
  {
    const SimplexId filler = this->LoopFilledBy[At(this->F.EdgesInOrder[At(rank)])];
    if (filler < 0)
    {
      ranks.push_back(rank + static_cast<std::int64_t>(this->F.TriangleCount()));
      continue;
    }
    ranks.push_back(this->F.TriangleRank[At(filler)]);
    this->AddColumn(this->F.TriangleRank[At(filler)], rank, cycle);
  }
  std::sort(ranks.begin(), ranks.end(), std::greater<>());
  return ranks;
}

}
