#include "SurfaceAdjacency.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace isthmus
{

SurfaceAdjacency::SurfaceAdjacency(const SurfaceView& mesh)
  : Surface(mesh)
  , Opposites(3 * mesh.Triangles.size(), -1)
  , EdgeIds(3 * mesh.Triangles.size(), -1)
  , Outgoing(mesh.Points.size(), -1)
{
  // Half edges in buckets by their smaller end; partners meet in a short list.
  std::vector<SimplexId> first(mesh.Points.size() + 1, 0);
  const auto smaller = [this](SimplexId h)
  { return static_cast<std::size_t>(std::min(this->From(h), this->To(h))); };
  for (SimplexId h = 0; h < this->HalfEdges(); ++h)
  {
    ++first[smaller(h) + 1];
    this->Outgoing[static_cast<std::size_t>(this->From(h))] = h;
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SimplexId> next(first.begin(), first.end() - 1);
  std::vector<SimplexId> bucket(this->Opposites.size());
  for (SimplexId h = 0; h < this->HalfEdges(); ++h)
  {
    const std::size_t p = smaller(h);
    for (SimplexId i = first[p]; i < next[p]; ++i)
    {
      const SimplexId other = bucket[static_cast<std::size_t>(i)];
      if (this->From(other) == this->To(h) && this->To(other) == this->From(h))
      {
        this->Opposites[static_cast<std::size_t>(h)] = other;
        this->Opposites[static_cast<std::size_t>(other)] = h;
        this->EdgeIds[static_cast<std::size_t>(h)] = this->EdgeCount;
        this->EdgeIds[static_cast<std::size_t>(other)] = this->EdgeCount++;
        this->Halves.push_back(other);
      }
    }
    bucket[static_cast<std::size_t>(next[p]++)] = h;
  }
  if (std::find(this->Opposites.begin(), this->Opposites.end(), -1) != this->Opposites.end())
  {
    throw std::invalid_argument("The surface is not closed: an edge has one triangle only.");
  }
}

double SurfaceAdjacency::Length(SimplexId h) const
{
  return Distance(this->Surface.Points[static_cast<std::size_t>(this->From(h))],
    this->Surface.Points[static_cast<std::size_t>(this->To(h))]);
}

SimplexId SurfaceAdjacency::Find(SimplexId a, SimplexId b) const
{
  const SimplexId start = this->Leaving(a);
  if (start < 0)
  {
    return -1;
  }
  SimplexId h = start;
  do
  {
    if (this->To(h) == b)
    {
      return h;
    }
    h = this->Turn(h);
  } while (h != start);
  return -1;
}

}
