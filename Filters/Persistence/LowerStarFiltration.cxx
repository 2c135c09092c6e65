#include "LowerStarFiltration.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <stdexcept>

namespace isthmus
{
namespace
{

std::size_t At(std::int64_t i)
{
  return static_cast<std::size_t>(i);
}

/// A face of a tetrahedron, its points ascending so that twins sort together.
struct Face
{
  std::array<SimplexId, 3> Points;
  SimplexId Cell;
  SimplexId Corner; ///< opposite to the face
};

void FindNeighbours(CellFiltration& f)
{
  std::vector<Face> faces;
  faces.reserve(4 * f.Tetrahedra.size());
  for (std::size_t c = 0; c < f.Tetrahedra.size(); ++c)
  {
    const auto& t = f.Tetrahedra[c];
    for (std::size_t k = 0; k < 4; ++k)
    {
      std::array<SimplexId, 3> p{ t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4] };
      std::sort(p.begin(), p.end());
      faces.push_back({ p, static_cast<SimplexId>(c), static_cast<SimplexId>(k) });
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const Face& a, const Face& b)
    { return a.Points != b.Points ? a.Points < b.Points : a.Cell < b.Cell; });
  f.Neighbours.assign(f.Tetrahedra.size(), { -1, -1, -1, -1 });
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].Points != faces[i + 1].Points)
    {
      continue;
    }
    if (i + 2 < faces.size() && faces[i + 2].Points == faces[i].Points)
    {
      throw std::invalid_argument("The tetrahedral mesh is not manifold: cells " +
        std::to_string(faces[i].Cell) + ", " + std::to_string(faces[i + 1].Cell) + " and " +
        std::to_string(faces[i + 2].Cell) + " share a face.");
    }
    f.Neighbours[At(faces[i].Cell)][At(faces[i].Corner)] = faces[i + 1].Cell;
    f.Neighbours[At(faces[i + 1].Cell)][At(faces[i + 1].Corner)] = faces[i].Cell;
  }
}

/// Gives `surface` the ids of the mesh's points at the same places.
void Match(const CellFiltration& f, TriangleMesh& surface)
{
  std::map<Point3, std::int64_t> ids;
  for (std::size_t i = 0; i < f.Points.size(); ++i)
  {
    ids.emplace(f.Points[i], static_cast<std::int64_t>(i));
  }
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    for (std::int64_t& p : surface.Triangles[i])
    {
      const auto found = ids.find(surface.Points[At(p)]);
      if (found == ids.end())
      {
        throw std::invalid_argument("A corner of triangle " + std::to_string(i) +
          " of the surface is no point of the tetrahedral mesh: mesh this surface without moving "
          "or "
          "splitting it.");
      }
      p = found->second;
    }
  }
  surface.Points = f.Points;
}

void MarkSurface(CellFiltration& f, const TriangleMesh& surface)
{
  f.EdgeFirst.assign(f.Edges.size(), 0);
  f.TriangleFirst.assign(f.Triangles.size(), 0);
  std::map<std::array<SimplexId, 3>, std::size_t> wanted;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    std::array<SimplexId, 3> p{ static_cast<SimplexId>(t[0]), static_cast<SimplexId>(t[1]),
      static_cast<SimplexId>(t[2]) };
    std::sort(p.begin(), p.end());
    wanted.emplace(p, i);
  }
  for (std::size_t t = 0; t < f.Triangles.size(); ++t)
  {
    if (wanted.erase(f.Triangles[t]) > 0)
    {
      f.TriangleFirst[t] = 1;
      for (const SimplexId e : f.TriangleEdges[t])
      {
        f.EdgeFirst[At(e)] = 1;
      }
    }
  }
  if (!wanted.empty())
  {
    throw std::invalid_argument("Triangle " + std::to_string(wanted.begin()->second) +
      " of the surface is no face of the tetrahedral mesh: mesh this surface without moving or "
      "splitting it.");
  }
}

template <std::size_t N>
std::vector<double> LastValues(
  const std::vector<std::array<SimplexId, N>>& simplices, const std::vector<double>& square)
{
  std::vector<double> values(simplices.size(), 0.0);
  for (std::size_t i = 0; i < simplices.size(); ++i)
  {
    for (const SimplexId p : simplices[i])
    {
      values[i] = std::max(values[i], square[At(p)]);
    }
  }
  return values;
}

}

CellFiltration LowerStarFiltration(const TetrahedralMesh& mesh, const std::vector<double>& values,
  TriangleMesh& surface, const ProgressCallback& progress)
{
  if (values.size() != mesh.Points.size())
  {
    throw std::invalid_argument("The function has " + std::to_string(values.size()) +
      " values for the " + std::to_string(mesh.Points.size()) + " points of the tetrahedral mesh.");
  }
  std::vector<double> square(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (!(values[i] >= 0.0) || !std::isfinite(values[i]))
    {
      throw std::invalid_argument("The function is negative or not finite at point " +
        std::to_string(i) + " of the tetrahedral mesh: it must be a distance.");
    }
    square[i] = values[i] * values[i];
  }
  CellFiltration f;
  f.Points = mesh.Points;
  f.Tetrahedra.reserve(mesh.Tetrahedra.size());
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    f.Tetrahedra.push_back({ static_cast<SimplexId>(t[0]), static_cast<SimplexId>(t[1]),
      static_cast<SimplexId>(t[2]), static_cast<SimplexId>(t[3]) });
  }
  FindNeighbours(f);
  Report(progress, 0.4);
  f.Connect(Between(progress, 0.4, 0.6));
  Match(f, surface);
  MarkSurface(f, surface);
  Report(progress, 0.8);
  f.TetrahedronValue = LastValues(f.Tetrahedra, square);
  f.TriangleValue = LastValues(f.Triangles, square);
  f.EdgeValue = LastValues(f.Edges, square);
  f.Order(Between(progress, 0.8, 1.0));
  return f;
}

std::vector<double> EdgeDistances(const TetrahedralMesh& mesh,
  const std::vector<std::int64_t>& sources, const ProgressCallback& progress)
{
  std::vector<std::vector<std::int64_t>> beside(mesh.Points.size());
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    for (const std::int64_t a : t)
    {
      for (const std::int64_t b : t)
      {
        if (a != b)
        {
          beside[At(a)].push_back(b);
        }
      }
    }
  }
  std::vector<double> distance(mesh.Points.size(), HUGE_VAL);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::int64_t p : sources)
  {
    distance[At(p)] = 0.0;
    queue.push({ 0.0, p });
  }
  Report(progress, 0.0);
  std::size_t settled = 0;
  while (!queue.empty())
  {
    const auto [d, p] = queue.top();
    queue.pop();
    if (d > distance[At(p)])
    {
      continue;
    }
    if (settled++ % (1U << 16) == 0)
    {
      Report(progress, static_cast<double>(settled) / static_cast<double>(mesh.Points.size()));
    }
    for (const std::int64_t q : beside[At(p)])
    {
      const Point3 step = mesh.Points[At(q)] - mesh.Points[At(p)];
      const double there = d + std::sqrt(Dot(step, step));
      if (there < distance[At(q)])
      {
        distance[At(q)] = there;
        queue.push({ there, q });
      }
    }
  }
  return distance;
}

}
