#include "SurfaceHomology.h"

#include "Index.h"

#include <algorithm>

namespace isthmus
{
SurfaceHomology::SurfaceHomology(const SurfaceAdjacency& surface)
  : Surface(surface)
  , Parent(surface.Mesh().Points.size(), -1)
  , Component(surface.Mesh().Points.size(), -1)
  , InTree(At(surface.Edges()), 0)
{
  this->GrowTree();
  std::vector<SimplexId> dualParent;
  std::vector<SimplexId> depth;
  this->GrowCotree(dualParent, depth);
  this->Words = (this->Rank() + 63) / 64;
  if (this->Rank() > 0)
  {
    this->MarkDualLoops(dualParent, depth);
  }
}

// Breadth first, so that basis loops have few edges.
void SurfaceHomology::GrowTree()
{
  std::vector<SimplexId> queue;
  for (SimplexId seed = 0; seed < static_cast<SimplexId>(this->Parent.size()); ++seed)
  {
    if (this->Component[At(seed)] >= 0 || this->Surface.Leaving(seed) < 0)
    {
      continue;
    }
    queue.assign(1, seed);
    this->Component[At(seed)] = this->ComponentCount;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      const SimplexId start = this->Surface.Leaving(queue[i]);
      SimplexId h = start;
      do
      {
        const SimplexId to = this->Surface.To(h);
        if (this->Component[At(to)] < 0)
        {
          this->Component[At(to)] = this->ComponentCount;
          this->Parent[At(to)] = this->Surface.Opposite(h);
          this->InTree[At(this->Surface.Edge(h))] = 1;
          queue.push_back(to);
        }
        h = this->Surface.Turn(h);
      } while (h != start);
    }
    ++this->ComponentCount;
  }
}

// A spanning tree of the triangles across edges that the tree does not use; what neither uses
// generates.
void SurfaceHomology::GrowCotree(std::vector<SimplexId>& dualParent, std::vector<SimplexId>& depth)
{
  const std::size_t triangles = this->Surface.Mesh().Triangles.size();
  dualParent.assign(triangles, -1); // half edge of the triangle across which its parent lies
  depth.assign(triangles, -1);
  std::vector<char> used(this->InTree);
  std::vector<SimplexId> queue;
  for (SimplexId seed = 0; seed < static_cast<SimplexId>(triangles); ++seed)
  {
    if (depth[At(seed)] >= 0)
    {
      continue;
    }
    queue.assign(1, seed);
    depth[At(seed)] = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (SimplexId h = 3 * queue[i]; h < 3 * queue[i] + 3; ++h)
      {
        const SimplexId other = SurfaceAdjacency::Triangle(this->Surface.Opposite(h));
        if (!this->InTree[At(this->Surface.Edge(h))] && depth[At(other)] < 0)
        {
          depth[At(other)] = depth[At(queue[i])] + 1;
          dualParent[At(other)] = this->Surface.Opposite(h);
          used[At(this->Surface.Edge(h))] = 1;
          queue.push_back(other);
        }
      }
    }
  }
  for (SimplexId e = 0; e < this->Surface.Edges(); ++e)
  {
    if (!used[At(e)])
    {
      this->Generators.push_back(e);
    }
  }
}

void SurfaceHomology::MarkDualLoops(
  const std::vector<SimplexId>& dualParent, const std::vector<SimplexId>& depth)
{
  this->Crossings.assign(this->Words * At(this->Surface.Edges()), 0);
  for (std::size_t i = 0; i < this->Generators.size(); ++i)
  {
    const auto mark = [this, i](SimplexId h)
    {
      this->Crossings[this->Words * At(this->Surface.Edge(h)) + i / 64] ^= std::uint64_t{ 1 }
        << (i % 64);
    };
    const SimplexId h = this->Surface.HalfEdgeOf(this->Generators[i]);
    mark(h);
    SimplexId a = SurfaceAdjacency::Triangle(h);
    SimplexId b = SurfaceAdjacency::Triangle(this->Surface.Opposite(h));
    while (a != b)
    {
      SimplexId& deeper = depth[At(a)] >= depth[At(b)] ? a : b;
      const SimplexId up = dualParent[At(deeper)];
      mark(up);
      deeper = SurfaceAdjacency::Triangle(this->Surface.Opposite(up));
    }
  }
}

Chain SurfaceHomology::Loop(std::size_t i) const
{
  const SimplexId h = this->Surface.HalfEdgeOf(this->Generators[i]);
  Chain edges{ this->Generators[i] };
  for (SimplexId p : { this->Surface.From(h), this->Surface.To(h) })
  {
    for (; this->Parent[At(p)] >= 0; p = this->Surface.To(this->Parent[At(p)]))
    {
      edges.push_back(this->Surface.Edge(this->Parent[At(p)]));
    }
  }
  // The part that both ways to the root share cancels.
  std::sort(edges.begin(), edges.end());
  Chain odd;
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

HomologyClass SurfaceHomology::ClassOf(const Chain& edges) const
{
  HomologyClass c(this->Words, 0);
  for (const SimplexId e : edges)
  {
    for (std::size_t w = 0; w < this->Words; ++w)
    {
      c[w] ^= this->Crossings.empty() ? 0 : this->Crossings[this->Words * At(e) + w];
    }
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
