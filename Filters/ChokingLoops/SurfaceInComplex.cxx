#include "SurfaceInComplex.h"

#include "Index.h"
#include "SurfacePaths.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
SurfaceInComplex::SurfaceInComplex(
  const SurfaceAdjacency& surface, const CellFiltration& f, const ProgressCallback& progress)
  : Surface(surface)
  , F(f)
  , OnSurface(f.Edges.size(), -1)
  , InComplex(At(surface.Edges()), -1)
  , FirstSmaller(f.Points.size() + 1, 0)
  , SmallerEdges(f.Edges.size())
{
  for (SimplexId e = 0; e < surface.Edges(); ++e)
  {
    if (e % (1 << 18) == 0)
    {
      Report(progress, 0.7 * static_cast<double>(e) / static_cast<double>(surface.Edges()));
    }
    const SimplexId h = surface.HalfEdgeOf(e);
    const SimplexId image = f.FindEdge(surface.From(h), surface.To(h));
    if (image < 0)
    {
      continue;
    }
    this->OnSurface[At(image)] = e;
    const double half = 0.5 * surface.Length(h);
    const bool first = !f.EdgeFirst.empty() && f.EdgeFirst[At(image)];
    if (first || f.EdgeValue[At(image)] <= half * half * (1.0 + 1e-9))
    {
      this->InComplex[At(e)] = image; // else it enters late, and the walk goes round it
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
  for (std::size_t e = 0; e < f.Edges.size(); ++e)
  {
    this->SmallerEdges[At(next[At(f.Edges[e][1])]++)] = static_cast<SimplexId>(e);
  }
}

Chain SurfaceInComplex::Image(SimplexId surfaceEdge) const
{
  if (this->InComplex[At(surfaceEdge)] >= 0)
  {
    return { this->InComplex[At(surfaceEdge)] };
  }
  const SimplexId h = this->Surface.HalfEdgeOf(surfaceEdge);
  const SimplexId end = this->Surface.To(h);
  const Point3& start = this->F.Points[At(this->Surface.From(h))];
  const Point3 direction = this->F.Points[At(end)] - start;
  Chain path;
  SimplexId here = this->Surface.From(h);
  while (here != end)
  {
    // The neighbour whose cell the segment enters first.
    const Point3& p = this->F.Points[At(here)];
    double best = HUGE_VAL;
    SimplexId through = -1;
    const auto consider = [&](SimplexId e)
    {
      const auto& ends = this->F.Edges[At(e)];
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
    for (SimplexId e = this->F.FirstEdge[At(here)]; e < this->F.FirstEdge[At(here) + 1]; ++e)
    {
      consider(e);
    }
    for (SimplexId i = this->FirstSmaller[At(here)]; i < this->FirstSmaller[At(here) + 1]; ++i)
    {
      consider(this->SmallerEdges[At(i)]);
    }
    path.push_back(through);
    const auto& ends = this->F.Edges[At(through)];
    here = ends[0] == here ? ends[1] : ends[0];
  }
  return path;
}

std::vector<SimplexId> SurfaceInComplex::ShortestPath(
  SimplexId from, SimplexId to, double reach) const
{
  const SurfacePaths paths(this->Surface, from, reach, to);
  std::vector<SimplexId> path;
  for (SimplexId p = to; paths.Has(to) && p != from; p = this->Surface.From(paths.Last(p)))
  {
    path.push_back(this->Surface.Edge(paths.Last(p)));
  }
  return path;
}

}
