#include "Surfaces/TriangleStars.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <numeric>

namespace isthmus
{

TriangleStars::TriangleStars(const SurfaceView& mesh)
  : Mesh(mesh)
  , First(mesh.Points.size() + 1, 0)
  , Around(3 * mesh.Triangles.size())
{
  // Serial: threads would leave the order within a star to chance, and with it the last bits of
  // every sum over a star. A counting sort that inserts each triangle before those that its point
  // already has.
  for (const Triangle& corners : mesh.Triangles)
  {
    for (const vtkIdType point : corners)
    {
      ++this->First[At(point)];
    }
  }
  std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
  for (vtkIdType t = 0; t < mesh.NumberOfTriangles(); ++t)
  {
    for (const vtkIdType point : mesh.Corners(t))
    {
      this->Around[At(--this->First[At(point)])] = MeshTriangle(t);
    }
  }
}

std::pair<vtkIdType, vtkIdType> TriangleStars::OppositeEdge(
  MeshTriangle triangle, vtkIdType point) const
{
  const Triangle& corner = this->Mesh.Corners(triangle.Value);
  const std::size_t k = corner[0] == point ? 0 : corner[1] == point ? 1 : 2;
  return { corner[(k + 1) % 3], corner[(k + 2) % 3] };
}

void TriangleStars::Link(vtkIdType point, std::vector<std::pair<vtkIdType, vtkIdType>>& edges) const
{
  edges.clear();
  const MeshTriangle* const triangles = this->Triangles(point);
  for (vtkIdType i = 0; i < this->Size(point); ++i)
  {
    edges.push_back(this->OppositeEdge(triangles[i], point));
  }
  std::sort(edges.begin(), edges.end());
}

StarKind TriangleStars::Kind(
  vtkIdType point, std::vector<std::pair<vtkIdType, vtkIdType>>& scratch) const
{
  if (this->Size(point) == 0)
  {
    return StarKind::Isolated;
  }
  this->Link(point, scratch);
  const std::size_t size = scratch.size();
  std::vector<vtkIdType> ends(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto [a, b] = scratch[i];
    if (a == b || a == point || b == point || (i > 0 && scratch[i - 1].first == a))
    {
      return StarKind::Irregular;
    }
    ends[i] = b;
  }
  std::sort(ends.begin(), ends.end());
  if (std::adjacent_find(ends.begin(), ends.end()) != ends.end())
  {
    return StarKind::Irregular;
  }
  // Every neighbour now begins and ends at most one edge: the link is paths and cycles. It is one
  // of them if a walk from a beginning (of a path, if there is one) passes all edges.
  const auto isPathStart = [&](const auto& edge)
  { return !std::binary_search(ends.begin(), ends.end(), edge.first); };
  const auto start = std::find_if(scratch.begin(), scratch.end(), isPathStart);
  const bool open = start != scratch.end();
  auto edge = open ? start : scratch.begin();
  const vtkIdType first = edge->first;
  for (std::size_t steps = 1;; ++steps)
  {
    const vtkIdType next = edge->second;
    edge = std::lower_bound(scratch.begin(), scratch.end(), std::make_pair(next, vtkIdType{ -1 }));
    if (next == first || edge == scratch.end() || edge->first != next)
    {
      return steps != size ? StarKind::Irregular : open ? StarKind::Boundary : StarKind::Interior;
    }
  }
}

std::vector<StarKind> StarKinds(const SurfaceView& mesh, const TriangleStars& stars)
{
  std::vector<StarKind> kinds(mesh.Points.size());
  ParallelFor(0, mesh.NumberOfPoints(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      std::vector<std::pair<vtkIdType, vtkIdType>> scratch;
      for (vtkIdType point = first; point < last; ++point)
      {
        kinds[static_cast<std::size_t>(point)] = stars.Kind(point, scratch);
      }
    });
  return kinds;
}

}
