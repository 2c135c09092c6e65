#include "ChokingLoops/SurfaceHomology.h"

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// SurfaceHomology
/// A spanning tree of the triangles.
struct SurfaceHomology::Cotree
{
  HandleVector<SurfaceTriangleId, HalfEdgeId> Parent; ///< across which the parent lies
  HandleVector<SurfaceTriangleId, SimplexId> Depth;   ///< -1: not yet met
};

SurfaceHomology::SurfaceHomology(const SurfaceAdjacency& surface)
  : Surface(surface)
  , Parent(surface.Mesh().Points.size(), HalfEdgeId::None())
  , Component(surface.Mesh().Points.size(), -1)
  , InTree(surface.EdgeCount(), 0)
{
  this->GrowTree();
  const Cotree cotree = this->GrowCotree();
  this->Words = (this->Rank() + 63) / 64;
  if (this->Rank() > 0)
  {
    this->MarkDualLoops(cotree);
  }
}

// Breadth first, so that basis loops have few edges.
void SurfaceHomology::GrowTree()
{
  std::vector<SimplexId> queue;
  for (SimplexId seed = 0; seed < static_cast<SimplexId>(this->Parent.size()); ++seed)
  {
    if (this->Component[At(seed)] >= 0 || !this->Surface.Leaving(seed).Exists())
    {
      continue;
    }
    queue.assign(1, seed);
    this->Component[At(seed)] = this->ComponentCount;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const HalfEdgeId start = this->Surface.Leaving(queue[i]);
      HalfEdgeId h = start;
      do
      {
        const SimplexId to = this->Surface.To(h);
        if (this->Component[At(to)] < 0)
        {
          this->Component[At(to)] = this->ComponentCount;
          this->Parent[At(to)] = this->Surface.Opposite(h);
          this->InTree[this->Surface.Edge(h)] = 1;
          queue.push_back(to);
        }
        h = this->Surface.Turn(h);
      } while (h != start);
    }
    ++this->ComponentCount;
  }
}

// The cotree goes across edges that the tree does not use; the edges used by neither generate the
// homology.
SurfaceHomology::Cotree SurfaceHomology::GrowCotree()
{
  Cotree cotree;
  cotree.Parent.assign(this->Surface.Mesh().Triangles.size(), HalfEdgeId::None());
  cotree.Depth.assign(this->Surface.Mesh().Triangles.size(), -1);
  auto& depth = cotree.Depth;
  auto used = this->InTree;
  std::vector<SurfaceTriangleId> queue;
  for (const SurfaceTriangleId seed : depth.Keys())
  {
    if (depth[seed] >= 0)
    {
      continue;
    }
    queue.assign(1, seed);
    depth[seed] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (const HalfEdgeId h : SurfaceAdjacency::GetHalfEdges(queue[i]))
      {
        const SurfaceTriangleId other = SurfaceAdjacency::Triangle(this->Surface.Opposite(h));
        if (!this->InTree[this->Surface.Edge(h)] && depth[other] < 0)
        {
          depth[other] = depth[queue[i]] + 1;
          cotree.Parent[other] = this->Surface.Opposite(h);
          used[this->Surface.Edge(h)] = 1;
          queue.push_back(other);
        }
      }
    }
  }
  for (const SurfaceEdgeId e : this->Surface.Edges())
  {
    if (!used[e])
    {
      this->Generators.push_back(e);
    }
  }
  return cotree;
}

void SurfaceHomology::MarkDualLoops(const Cotree& cotree)
{
  this->Crossings.assign(this->Words * this->Surface.EdgeCount(), 0);
  for (std::size_t i = 0; i < this->Generators.size(); ++i)
  {
    const auto mark = [this, i](HalfEdgeId h)
    {
      this->Crossings[this->Words * this->Surface.Edge(h).Index() + i / 64] ^= std::uint64_t{ 1 }
        << (i % 64);
    };
    const HalfEdgeId h = this->Surface.GetHalfEdge(this->Generators[i]);
    mark(h);
    SurfaceTriangleId a = SurfaceAdjacency::Triangle(h);
    SurfaceTriangleId b = SurfaceAdjacency::Triangle(this->Surface.Opposite(h));
    while (a != b)
    {
      SurfaceTriangleId& deeper = cotree.Depth[a] >= cotree.Depth[b] ? a : b;
      const HalfEdgeId up = cotree.Parent[deeper];
      mark(up);
      deeper = SurfaceAdjacency::Triangle(this->Surface.Opposite(up));
    }
  }
}

SurfaceChain SurfaceHomology::Loop(std::size_t i) const
{
  const HalfEdgeId h = this->Surface.GetHalfEdge(this->Generators[i]);
  SurfaceChain edges{ this->Generators[i] };
  for (SimplexId p : { this->Surface.From(h), this->Surface.To(h) })
  {
    for (; this->Parent[At(p)].Exists(); p = this->Surface.To(this->Parent[At(p)]))
    {
      edges.push_back(this->Surface.Edge(this->Parent[At(p)]));
    }
  }
  // The common part of both paths to the root cancels.
  std::sort(edges.begin(), edges.end());
  SurfaceChain odd;
  for (std::size_t k = 0; k < edges.size(); ++k)
  {
    if (k + 1 < edges.size() && edges[k] == edges[k + 1])
    {
      ++k;
      continue;
    }
    odd.push_back(edges[k]);
  }
  return odd;
}

HomologyClass SurfaceHomology::GetClass(const SurfaceChain& edges) const
{
  HomologyClass c(this->Words, 0);
  for (const SurfaceEdgeId e : edges)
  {
    this->AddTo(c, e);
  }
  return c;
}

void HomologySpan::Reduce(HomologyClass& c) const
{
  for (const auto& [bit, row] : this->Rows)
  {
    if ((c[bit / 64] >> (bit % 64)) & 1U)
    {
      for (std::size_t w = 0; w < c.size(); ++w)
      {
        c[w] ^= row[w];
      }
    }
  }
}

bool HomologySpan::Add(HomologyClass c)
{
  this->Reduce(c);
  const auto word = std::find_if(c.begin(), c.end(), [](std::uint64_t w) { return w != 0; });
  if (word == c.end())
  {
    return false;
  }
  std::size_t bit = 64 * static_cast<std::size_t>(word - c.begin());
  for (std::uint64_t w = *word; !(w & 1U); w >>= 1)
  {
    ++bit;
  }
  this->Rows.emplace_back(bit, std::move(c));
  return true;
}

// ------------------------------------------------------------------------------------------
// SurfaceInComplex
SurfaceInComplex::SurfaceInComplex(
  const SurfaceAdjacency& surface, const CellFiltration& f, const ProgressCallback& progress)
  : Surface(surface)
  , F(f)
  , OnSurface(f.Edges.size(), SurfaceEdgeId::None())
  , InComplex(surface.EdgeCount(), EdgeId::None())
{
  for (const SurfaceEdgeId e : surface.Edges())
  {
    if (e.Index() % (1U << 18) == 0)
    {
      Report(
        progress, 0.7 * static_cast<double>(e.Index()) / static_cast<double>(surface.EdgeCount()));
    }
    const HalfEdgeId h = surface.GetHalfEdge(e);
    const EdgeId image = f.FindEdge(surface.From(h), surface.To(h));
    if (!image.Exists())
    {
      continue;
    }
    this->OnSurface[image] = e;
    const double half = 0.5 * surface.Length(h);
    const bool first = (!f.EdgeFirst.empty() && f.EdgeFirst[image]) ||
      (!f.EdgeIndistinct.empty() && f.EdgeIndistinct[image]);
    if (first || f.EdgeValue[image] <= half * half * (1.0 + 1e-9))
    {
      this->InComplex[e] = image; // otherwise it enters late, and the walk avoids it
    }
  }
  Report(progress, 0.7);
  constexpr EdgeId none = EdgeId::None();
  if (std::find(this->InComplex.begin(), this->InComplex.end(), none) == this->InComplex.end())
  {
    return; // no edge needs another path
  }
  this->FirstSmaller.assign(f.Points.size() + 1, 0);
  this->SmallerEdges.resize(f.Edges.size());
  for (const auto& edge : f.Edges)
  {
    ++this->FirstSmaller[At(edge[1]) + 1];
  }
  std::partial_sum(
    this->FirstSmaller.begin(), this->FirstSmaller.end(), this->FirstSmaller.begin());
  std::vector<SimplexId> next(this->FirstSmaller.begin(), this->FirstSmaller.end() - 1);
  for (const EdgeId e : f.Edges.Keys())
  {
    this->SmallerEdges[At(next[At(f.Edges[e][1])]++)] = e;
  }
}

EdgeChain SurfaceInComplex::Image(SurfaceEdgeId surfaceEdge) const
{
  if (this->InComplex[surfaceEdge].Exists())
  {
    return { this->InComplex[surfaceEdge] };
  }
  const HalfEdgeId h = this->Surface.GetHalfEdge(surfaceEdge);
  const SimplexId end = this->Surface.To(h);
  const Point3& start = this->F.Points[At(this->Surface.From(h))];
  const Point3 direction = this->F.Points[At(end)] - start;
  EdgeChain path;
  SimplexId here = this->Surface.From(h);
  while (here != end)
  {
    // The neighbour whose cell the segment enters first.
    const Point3& p = this->F.Points[At(here)];
    double best = HUGE_VAL;
    EdgeId through = EdgeId::None();
    const auto consider = [&](EdgeId e)
    {
      const auto& ends = this->F.Edges[e];
      const Point3& q = this->F.Points[At(ends[0] == here ? ends[1] : ends[0])];
      const double ahead = Dot(q - p, direction);
      if (ahead > 0.0)
      {
        const double u = (Dot(q - start, q - start) - Dot(p - start, p - start)) / (2.0 * ahead);
        if (u < best)
        {
          best = u;
          through = e;
        }
      }
    };
    for (const EdgeId e : this->F.EdgesAbove(here))
    {
      consider(e);
    }
    for (SimplexId i = this->FirstSmaller[At(here)]; i < this->FirstSmaller[At(here) + 1]; ++i)
    {
      consider(this->SmallerEdges[At(i)]);
    }
    path.push_back(through);
    const auto& ends = this->F.Edges[through];
    here = ends[0] == here ? ends[1] : ends[0];
  }
  return path;
}

std::vector<SurfaceEdgeId> SurfaceInComplex::ShortestPath(
  SimplexId from, SimplexId to, double reach) const
{
  const SurfacePaths paths(this->Surface, from, reach, to);
  std::vector<SurfaceEdgeId> path;
  for (SimplexId p = to; paths.Has(to) && p != from; p = this->Surface.From(paths.Last(p)))
  {
    path.push_back(this->Surface.Edge(paths.Last(p)));
  }
  return path;
}

// ------------------------------------------------------------------------------------------
// ChainPieces
EdgeChain ComputeBoundary(const CellFiltration& f, const TriangleChain& triangles)
{
  std::set<EdgeId> edges;
  for (const TriangleId t : triangles)
  {
    for (const EdgeId e : f.TriangleEdges(t))
    {
      Toggle(edges, e);
    }
  }
  return { edges.begin(), edges.end() };
}

TriangleChain ConnectedPiece(const CellFiltration& f, const SurfaceInComplex& surface,
  const std::set<TriangleId>& triangles, TriangleId seed)
{
  std::map<EdgeId, TriangleChain> beside;
  for (const TriangleId t : triangles)
  {
    for (const EdgeId e : f.TriangleEdges(t))
    {
      beside[e].push_back(t);
    }
  }
  std::set<TriangleId> found{ seed };
  TriangleChain piece{ seed };
  for (std::size_t i = 0; i < piece.size(); ++i)
  {
    for (const EdgeId e : f.TriangleEdges(piece[i]))
    {
      if (surface.SurfaceEdge(e).Exists())
      {
        continue;
      }
      for (const TriangleId other : beside[e])
      {
        if (found.insert(other).second)
        {
          piece.push_back(other);
        }
      }
    }
  }
  return piece;
}

// ------------------------------------------------------------------------------------------
// SurfaceGenerators
namespace
{

/// The triangles that bound a loop, as ranks, latest first; unfilled loops rank above them.
struct Column
{
  std::vector<std::int64_t> Ranks;
  std::vector<std::size_t> Sum;
};

template <typename T>
std::vector<T> SymmetricDifference(
  const std::vector<T>& a, const std::vector<T>& b, bool descending)
{
  std::vector<T> sum;
  sum.reserve(a.size() + b.size());
  if (descending)
  {
    std::set_symmetric_difference(
      a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum), std::greater<>());
  }
  else
  {
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  }
  return sum;
}

}

std::vector<SurfaceGenerator> SurfaceGenerators(const SurfaceHomology& homology,
  const SurfaceInComplex& surface, const CellFiltration& f, const FiltrationPairs& pairs,
  const ProgressCallback& progress)
{
  std::vector<Column> columns(homology.Rank());
  ParallelFor(
    0, static_cast<std::int64_t>(columns.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        EdgeChain image;
        for (const SurfaceEdgeId e : homology.Loop(i))
        {
          const EdgeChain path = surface.Image(e);
          image.insert(image.end(), path.begin(), path.end());
        }
        columns[i] = { pairs.Bounding(image), { i } };
      }
    },
    Between(progress, 0.0, 0.8));

  std::map<std::int64_t, std::size_t> pivots;
  const auto triangles = static_cast<std::int64_t>(f.TriangleCount());
  std::vector<SurfaceGenerator> generators;
  for (std::size_t i = 0; i < columns.size(); ++i)
  {
    Report(progress, 0.8 + 0.2 * static_cast<double>(i) / static_cast<double>(columns.size()));
    Column& c = columns[i];
    while (!c.Ranks.empty() && pivots.count(c.Ranks.front()) > 0)
    {
      const Column& other = columns[pivots[c.Ranks.front()]];
      c.Ranks = SymmetricDifference(c.Ranks, other.Ranks, true);
      c.Sum = SymmetricDifference(c.Sum, other.Sum, false);
    }
    if (!c.Ranks.empty())
    {
      pivots[c.Ranks.front()] = i;
    }
  }
  for (const auto& [rank, i] : pivots)
  {
    if (rank < triangles)
    {
      const auto filler = TriangleRank::At(static_cast<std::size_t>(rank));
      generators.push_back({ f.TrianglesInOrder[filler], columns[i].Sum });
    }
  }
  return generators;
}

}
