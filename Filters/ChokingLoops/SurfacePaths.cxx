#include "ChokingLoops/SurfacePaths.h"

#include "Core/Index.h"

namespace isthmus
{

SurfacePaths::SurfacePaths(
  const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to)
  : Surface(surface)
  , Goal(to)
{
  this->Queue.push({ this->Left(from), from, HalfEdgeId::None(), 0.0 });
  this->Grow(reach);
}

/// No path from p to the goal is shorter; 0 without one.
double SurfacePaths::Left(SimplexId p) const
{
  const auto& points = this->Surface.Mesh().Points;
  return this->Goal < 0 ? 0.0 : Distance(points[At(p)], points[At(this->Goal)]);
}

void SurfacePaths::Grow(double reach)
{
  while (!this->Queue.empty() && this->Queue.top().Least <= reach)
  {
    const Entry entry = this->Queue.top();
    this->Queue.pop();
    if (!this->Has(entry.Point))
    {
      this->Settle(entry);
      if (entry.Point == this->Goal)
      {
        return;
      }
    }
  }
}

void SurfacePaths::Settle(const Entry& entry)
{
  this->Places[entry.Point] = static_cast<std::int32_t>(this->Settled.size());
  this->Settled.push_back(entry.Point);
  this->Lengths.push_back(entry.Length);
  this->Lasts.push_back(entry.Last);
  const HalfEdgeId first = this->Surface.Leaving(entry.Point);
  if (!first.Exists())
  {
    return; // no triangle uses it
  }
  HalfEdgeId h = first;
  do
  {
    const SimplexId next = this->Surface.To(h);
    if (!this->Has(next))
    {
      const double edge = this->Surface.Length(h);
      const double length = entry.Length + edge;
      this->Longest = std::max(this->Longest, edge);
      this->Queue.push({ length + this->Left(next), next, h, length });
    }
    h = this->Surface.Turn(h);
  } while (h != first);
}

}
