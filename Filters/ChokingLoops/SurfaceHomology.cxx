#include "ChokingLoops/SurfaceHomology.h"

#include "Core/Index.h"

#include <algorithm>

namespace isthmus
{
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

// The cotree goes across edges that the tree does not use; what neither uses generates.
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
      for (const HalfEdgeId h : SurfaceAdjacency::HalfEdgesOf(queue[i]))
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
    const HalfEdgeId h = this->Surface.HalfEdgeOf(this->Generators[i]);
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
  const HalfEdgeId h = this->Surface.HalfEdgeOf(this->Generators[i]);
  SurfaceChain edges{ this->Generators[i] };
  for (SimplexId p : { this->Surface.From(h), this->Surface.To(h) })
  {
    for (; this->Parent[At(p)].Exists(); p = this->Surface.To(this->Parent[At(p)]))
    {
      edges.push_back(this->Surface.Edge(this->Parent[At(p)]));
    }
  }
  // The part that both ways to the root share cancels.
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

HomologyClass SurfaceHomology::ClassOf(const SurfaceChain& edges) const
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

}
