#include "ChokingLoops/SurfaceAdjacency.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace isthmus
{

SurfaceAdjacency::SurfaceAdjacency(const SurfaceView& mesh)
  : Surface(mesh)
  , Opposites(3 * mesh.Triangles.size(), HalfEdgeId::None())
  , EdgeIds(3 * mesh.Triangles.size(), SurfaceEdgeId::None())
  , Outgoing(mesh.Points.size(), HalfEdgeId::None())
{
  // Half edges in buckets by their smaller end; partners meet in a short list.
  std::vector<SimplexId> first(mesh.Points.size() + 1, 0);
  const auto smaller = [this](HalfEdgeId h)
  { return static_cast<std::size_t>(std::min(this->From(h), this->To(h))); };
  for (const HalfEdgeId h : this->HalfEdges())
  {
    ++first[smaller(h) + 1];
    this->Outgoing[static_cast<std::size_t>(this->From(h))] = h;
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SimplexId> next(first.begin(), first.end() - 1);
  std::vector<HalfEdgeId> bucket(this->Opposites.size());
  for (const HalfEdgeId h : this->HalfEdges())
  {
    const std::size_t p = smaller(h);
    for (SimplexId i = first[p]; i < next[p]; ++i)
    {
      const HalfEdgeId other = bucket[static_cast<std::size_t>(i)];
      if (this->From(other) == this->To(h) && this->To(other) == this->From(h))
      {
        this->Opposites[h] = other;
        this->Opposites[other] = h;
        this->EdgeIds[h] = SurfaceEdgeId::At(this->Halves.size());
        this->EdgeIds[other] = this->EdgeIds[h];
        this->Halves.push_back(other);
      }
    }
    bucket[static_cast<std::size_t>(next[p]++)] = h;
  }
  if (std::find(this->Opposites.begin(), this->Opposites.end(), HalfEdgeId::None()) !=
    this->Opposites.end())
  {
    throw std::invalid_argument("The surface is not closed: an edge has one triangle only.");
  }
}

HalfEdgeId SurfaceAdjacency::Find(SimplexId a, SimplexId b) const
{
  const HalfEdgeId start = this->Leaving(a);
  if (!start.Exists())
  {
    return HalfEdgeId::None();
  }
  HalfEdgeId h = start;
  do
  {
    if (this->To(h) == b)
    {
      return h;
    }
    h = this->Turn(h);
  } while (h != start);
  return HalfEdgeId::None();
}

}
