#include "Surfaces/SurfaceTopology.h"

#include "Core/DisjointSets.h"
#include "Surfaces/MeshEdges.h"

namespace isthmus
{

std::vector<int> Components(const SurfaceView& mesh)
{
  const std::size_t n = mesh.Triangles.size();
  DisjointSets<std::int64_t> sets(static_cast<std::int64_t>(n));
  ForEachEdge(SortedHalfEdges(mesh, {}),
    [&sets](auto first, auto last)
    {
      for (auto e = first + 1; e != last; ++e)
      {
        sets.Join(first->Triangle, e->Triangle);
      }
    });
  std::vector<int> label(n, -1);
  int count = 0;
  for (std::size_t t = 0; t < n; ++t)
  {
    const auto root = static_cast<std::size_t>(sets.Find(static_cast<std::int64_t>(t)));
    label[t] = root == t ? count++ : label[root]; // the smallest triangle id, so met first
  }
  return label;
}

double SignedVolume(const SurfaceView& mesh)
{
  if (mesh.Triangles.empty())
  {
    return 0.0;
  }
  // About a point of the surface, so that a surface far from the origin loses no digits.
  const Point3 origin = mesh.Points[static_cast<std::size_t>(mesh.Triangles.front()[0])];
  double sum = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const Point3 a = mesh.Points[static_cast<std::size_t>(t[0])] - origin;
    const Point3 b = mesh.Points[static_cast<std::size_t>(t[1])] - origin;
    const Point3 c = mesh.Points[static_cast<std::size_t>(t[2])] - origin;
    sum += Dot(a, Cross(b, c));
  }
  return sum / 6.0;
}

std::int64_t EulerCharacteristic(const SurfaceView& mesh)
{
  std::vector<bool> used(mesh.Points.size());
  for (const Triangle& t : mesh.Triangles)
  {
    for (const std::int64_t p : t)
    {
      used[static_cast<std::size_t>(p)] = true;
    }
  }
  std::int64_t edges = 0;
  ForEachEdge(SortedHalfEdges(mesh, {}), [&edges](auto, auto) { ++edges; });
  return std::count(used.begin(), used.end(), true) - edges +
    static_cast<std::int64_t>(mesh.Triangles.size());
}

}
