#include "FiltrationPairs.h"

#include "CompactDisjointSets.h"

#include <algorithm>
#include <queue>

namespace isthmus
{
namespace
{

std::size_t At(SimplexId i)
{
  return static_cast<std::size_t>(i);
}

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

}

FiltrationPairs::FiltrationPairs(const CellFiltration& f, const ProgressCallback& progress)
  : F(f)
{
  this->PairVoids(Between(progress, 0.0, 0.3));
  this->PairLoops(Between(progress, 0.3, 1.0));
}

// Tetrahedra are joined from the last triangle to the first: the younger of two basins, the one
// whose deepest tetrahedron enters earlier, ends there.
void FiltrationPairs::PairVoids(const ProgressCallback& progress)
{
  const std::size_t cells = this->F.Tetrahedra.size();
  CompactDisjointSets basins(cells + 1); // the last one is the exterior
  std::vector<SimplexId> deepest(cells + 1);
  for (std::size_t i = 0; i <= cells; ++i)
  {
    deepest[i] = static_cast<SimplexId>(i);
  }
  const auto rank = [this, cells](SimplexId cell)
  { return At(cell) == cells ? static_cast<SimplexId>(cells) : this->F.TetrahedronRank[At(cell)]; };
  this->VoidFilledBy.assign(this->F.Triangles.size(), -1);
  for (std::size_t i = this->F.TrianglesInOrder.size(); i-- > 0;)
  {
    if (i % ReportEvery == 0)
    {
      Report(
        progress, 1.0 - static_cast<double>(i) / static_cast<double>(this->F.Triangles.size()));
    }
    const SimplexId t = this->F.TrianglesInOrder[i];
    const auto& sides = this->F.TriangleSides[At(t)];
    const std::size_t a = basins.Find(sides[0] < 0 ? cells : At(sides[0]));
    const std::size_t b = basins.Find(sides[1] < 0 ? cells : At(sides[1]));
    if (a == b)
    {
      continue;
    }
    const bool aIsYounger = rank(deepest[a]) < rank(deepest[b]);
    const SimplexId elder = deepest[aIsYounger ? b : a];
    this->VoidFilledBy[At(t)] = deepest[aIsYounger ? a : b];
    deepest[basins.Join(a, b)] = elder;
  }
}

void FiltrationPairs::PairLoops(const ProgressCallback& progress)
{
  this->LoopFilledBy.assign(this->F.Edges.size(), -1);
  this->LoopClosedBy.assign(this->F.Triangles.size(), -1);
  this->Reduced.assign(this->F.Triangles.size(), -1);
  std::int64_t done = 0;
  std::int64_t steps = 0;
  // Columns added count too: those of a few triangles may take longer than all others.
  const auto tick = [&]
  {
    if (++steps % ReportEvery == 0)
    {
      Report(progress, static_cast<double>(done) / static_cast<double>(this->F.Triangles.size()));
    }
  };
  for (const SimplexId t : this->F.TrianglesInOrder)
  {
    ++done;
    tick();
    if (this->VoidFilledBy[At(t)] == -1)
    {
      this->Reduce(t, tick);
    }
  }
}

template <typename Heap>
void FiltrationPairs::AddColumn(SimplexId triangle, Heap& heap) const
{
  const SimplexId stored = this->Reduced[At(triangle)];
  if (stored >= 0)
  {
    for (const SimplexId rank : this->Columns[At(stored)])
    {
      heap.Add(rank);
    }
    return;
  }
  for (const SimplexId e : this->F.TriangleEdges[At(triangle)])
  {
    heap.Add(this->F.EdgeRank[At(e)]);
  }
}

void FiltrationPairs::Reduce(SimplexId t, const std::function<void()>& tick)
{
  const auto& edges = this->F.TriangleEdges[At(t)];
  const auto& edgeRank = this->F.EdgeRank;
  const SimplexId latest = *std::max_element(edges.begin(), edges.end(),
    [&edgeRank](SimplexId a, SimplexId b) { return edgeRank[At(a)] < edgeRank[At(b)]; });
  SimplexId pivot = latest;
  if (this->LoopFilledBy[At(latest)] >= 0)
  {
    RankHeap column;
    Chain added;
    for (const SimplexId e : edges)
    {
      column.Add(edgeRank[At(e)]);
    }
    SimplexId low = column.Take();
    while (low >= 0 && this->LoopFilledBy[At(this->F.EdgesInOrder[At(low)])] >= 0)
    {
      const SimplexId other = this->LoopFilledBy[At(this->F.EdgesInOrder[At(low)])];
      tick();
      added.push_back(other);
      column.Add(low);
      this->AddColumn(other, column);
      low = column.Take();
    }
    if (low < 0)
    {
      return; // only where the complex has a void that nothing fills
    }
    pivot = this->F.EdgesInOrder[At(low)];
    Chain ranks = column.TakeAll();
    ranks.insert(ranks.begin(), low);
    this->Reduced[At(t)] = static_cast<SimplexId>(this->Columns.size());
    this->Columns.push_back(std::move(ranks));
    this->Added.push_back(std::move(added));
  }
  this->LoopFilledBy[At(pivot)] = t;
  this->LoopClosedBy[At(t)] = pivot;
}

Chain FiltrationPairs::Filling(SimplexId triangle) const
{
  // A triangle may be reached on many ways: latest first, each is expanded once, with its parity.
  RankHeap pending;
  pending.Add(this->F.TriangleRank[At(triangle)]);
  Chain filling;
  for (SimplexId rank = pending.Take(); rank >= 0; rank = pending.Take())
  {
    const SimplexId t = this->F.TrianglesInOrder[At(rank)];
    filling.push_back(t);
    if (this->Reduced[At(t)] >= 0)
    {
      for (const SimplexId other : this->Added[At(this->Reduced[At(t)])])
      {
        pending.Add(this->F.TriangleRank[At(other)]);
      }
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
    cycle.Add(rank);
    this->AddColumn(filler, cycle);
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
      ranks.push_back(rank + static_cast<std::int64_t>(this->F.Triangles.size()));
      continue;
    }
    ranks.push_back(this->F.TriangleRank[At(filler)]);
    cycle.Add(rank);
    this->AddColumn(filler, cycle);
  }
  std::sort(ranks.begin(), ranks.end(), std::greater<>());
  return ranks;
}

}
