/**
 * @file MeshEdges.h
 * @brief The sides of all triangles, sorted so that sides on the same edge are adjacent. Private.
 */
#ifndef isthmus_MeshEdges_h
#define isthmus_MeshEdges_h

#include "Core/TriangleMesh.h"

#include <algorithm>
#include <vector>

namespace isthmus
{

/// Whether the triangle has the same corner twice and therefore lacks an edge.
inline bool HasRepeated(const Triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// One side of one triangle, with its ends in ascending order so that neighbours sort together.
struct HalfEdge
{
  vtkIdType Low;
  vtkIdType High;
  vtkIdType Triangle;
  bool Ascending; ///< the triangle's side runs from Low to High

  bool SameEdge(const HalfEdge& o) const { return this->Low == o.Low && this->High == o.High; }
};

/// Sides of the triangles of `mesh`, except those in `skip` (one flag for each, or empty).
inline std::vector<HalfEdge> SortedHalfEdges(const SurfaceView& mesh, const std::vector<bool>& skip)
{
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    if (!skip.empty() && skip[t])
    {
      continue;
    }
    const Triangle& ids = mesh.Triangles[t];
    for (std::size_t c = 0; c < 3; ++c)
    {
      const vtkIdType a = ids[c];
      const vtkIdType b = ids[(c + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), static_cast<vtkIdType>(t), a < b });
    }
  }
  std::sort(edges.begin(), edges.end(),
    [](const HalfEdge& a, const HalfEdge& b)
    {
      return a.Low != b.Low ? a.Low < b.Low
        : a.High != b.High  ? a.High < b.High
                            : a.Triangle < b.Triangle;
    });
  return edges;
}

/// Calls visit(first, last) for each run of half edges on the same edge.
template <typename Visit>
void ForEachEdge(const std::vector<HalfEdge>& edges, Visit&& visit)
{
  for (auto first = edges.begin(); first != edges.end();)
  {
    auto last = first + 1;
    while (last != edges.end() && last->SameEdge(*first))
    {
      ++last;
    }
    visit(first, last);
    first = last;
  }
}

}

#endif
