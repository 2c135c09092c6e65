#include "ChokingLoops/SurfaceInComplex.h"

#include "ChokingLoops/SurfacePaths.h"
#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
SurfaceInComplex::SurfaceInComplex(
  const SurfaceAdjacency& surface, const CellFiltration& f, const ProgressCallback& progress)
  : Surface(surface)
  , F(f)
  , OnSurface(f.Edges.size(), SurfaceEdgeId::None())
  , InComplex(surface.EdgeCount(), EdgeId::None())
  , FirstSmaller(f.Points.size() + 1, 0)
  , SmallerEdges(f.Edges.size())
{
  for (const SurfaceEdgeId e : surface.Edges())
  {
    if (e.Index() % (1U << 18) == 0)
    {
      Report(
        progress, 0.7 * static_cast<double>(e.Index()) / static_cast<double>(surface.EdgeCount()));
    }
    const HalfEdgeId h = surface.HalfEdgeOf(e);
    const EdgeId image = f.FindEdge(surface.From(h), surface.To(h));
    if (!image.Exists())
    {
      continue;
    }
    this->OnSurface[image] = e;
    const double half = 0.5 * surface.Length(h);
    const bool first = !f.EdgeFirst.empty() && f.EdgeFirst[image];
    if (first || f.EdgeValue[image] <= half * half * (1.0 + 1e-9))
    {
      this->InComplex[e] = image; // else it enters late, and the walk goes round it
    }
  }
  Report(progress, 0.7);
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
  const HalfEdgeId h = this->Surface.HalfEdgeOf(surfaceEdge);
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

}
