#include "SurfacePaths.h"

#include <cmath>
#include <queue>
#include <tuple>

namespace isthmus
{

SurfacePaths::SurfacePaths(
  const SurfaceAdjacency& surface, SimplexId from, double reach, SimplexId to)
{
  using Entry = std::tuple<double, SimplexId, HalfEdgeId>; // length, point, half edge that came
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  queue.emplace(0.0, from, HalfEdgeId::None());
  while (!queue.empty())
  {
    const auto [length, p, last] = queue.top();
    queue.pop();
    std::int32_t& place = this->Places[p];
    if (place >= 0)
    {
      continue;
    }
    place = static_cast<std::int32_t>(this->Settled.size());
    this->Settled.push_back(p);
    this->Lengths.push_back(length);
    this->Lasts.push_back(last);
    if (p == to)
    {
      return;
    }
    const HalfEdgeId first = surface.Leaving(p);
    if (!first.Exists())
    {
      return; // no triangle uses it
    }
    HalfEdgeId h = first;
    do
    {
      const SimplexId next = surface.To(h);
      const double there = this->Has(next) ? HUGE_VAL : length + surface.Length(h);
      if (there <= reach)
      {
        queue.emplace(there, next, h);
      }
      h = surface.Turn(h);
    } while (h != first);
  }
}

}
