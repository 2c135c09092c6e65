#include "LowerStarFiltration.h"

#include "Index.h"
#include "ParallelFor.h"
#include "SurfaceView.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// A face of a tetrahedron, but for its smallest point, which is that of its bucket.
struct Face
{
  std::uint64_t Others; ///< the middle point above the last one
  std::uint64_t Place;  ///< 4 * cell + the corner opposite to the face

  bool operator<(const Face& o) const
  {
    return this->Others != o.Others ? this->Others < o.Others : this->Place < o.Place;
  }
};

/// Calls visit(smallest point, face) for the four faces of each cell.
template <typename Visit>
void ForFaces(const CellFiltration& f, const Visit& visit)
{
  for (const TetrahedronId cell : f.Tetrahedra.Keys())
  {
    const auto& t = f.Tetrahedra[cell];
    for (std::size_t k = 0; k < 4; ++k)
    {
      const SimplexId a = t[(k + 1) % 4], b = t[(k + 2) % 4], c = t[(k + 3) % 4];
      const SimplexId low = std::min(a, b), high = std::max(a, b);
      const auto middle = static_cast<std::uint64_t>(std::max(low, std::min(high, c)));
      visit(At(std::min(low, c)),
        Face{ middle << 32 | static_cast<std::uint64_t>(std::max(high, c)), 4 * cell.Index() + k });
    }
  }
}

/// The faces of all tetrahedra in buckets of their smallest points: [first[p], first[p + 1]).
std::vector<Face> FacesByPoint(const CellFiltration& f, std::vector<std::size_t>& first)
{
  // Counted two places on: filling moves each start to where the next one begins.
  first.assign(f.Points.size() + 2, 0);
  ForFaces(f, [&first](std::size_t p, const Face&) { ++first[p + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Face> faces(first.back());
  ForFaces(f, [&](std::size_t p, const Face& face) { faces[first[p + 1]++] = face; });
  return faces;
}

/// Where three cells are on one face, counted from `begin`; -1: nowhere.
std::ptrdiff_t LinkTwins(CellFiltration& f, Face* begin, Face* end)
{
  std::sort(begin, end);
  for (Face* face = begin; face != end; ++face)
  {
    if (face + 1 == end || face[0].Others != face[1].Others)
    {
      continue;
    }
    if (face + 2 != end && face[0].Others == face[2].Others)
    {
      return face - begin;
    }
    const std::uint64_t one = face[0].Place, other = face[1].Place;
    const auto cell = TetrahedronId::At(one / 4), beyond = TetrahedronId::At(other / 4);
    f.Neighbours[cell][one % 4] = beyond;
    f.Neighbours[beyond][other % 4] = cell;
    ++face;
  }
  return -1;
}

void FindNeighbours(CellFiltration& f, const ProgressCallback& progress)
{
  std::vector<std::size_t> first;
  std::vector<Face> faces = FacesByPoint(f, first);
  constexpr TetrahedronId none = TetrahedronId::None();
  f.Neighbours.assign(f.Tetrahedra.size(), { none, none, none, none });
  std::vector<std::ptrdiff_t> crowded(f.Points.size(), -1);
  ParallelFor(
    0, static_cast<std::int64_t>(f.Points.size()), 1024,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t p = begin; p < end; ++p)
      {
        crowded[At(p)] = LinkTwins(f, faces.data() + first[At(p)], faces.data() + first[At(p) + 1]);
      }
    },
    Between(progress, 0.5, 1.0));
  for (std::size_t p = 0; p < crowded.size(); ++p)
  {
    if (crowded[p] >= 0)
    {
      const Face* face = faces.data() + first[p] + crowded[p];
      throw std::invalid_argument("The tetrahedral mesh is not manifold: cells " +
        std::to_string(face[0].Place / 4) + ", " + std::to_string(face[1].Place / 4) + " and " +
        std::to_string(face[2].Place / 4) + " share a face.");
    }
  }
}

/// Gives `surface` the ids of the mesh's points at the same places: the first of several.
void Match(const CellFiltration& f, TriangleMesh& surface)
{
  std::map<Point3, std::int64_t> ids;
  for (const Point3& p : surface.Points)
  {
    ids.emplace(p, -1);
  }
  std::vector<double> heights; // of those points: most others of the mesh are at none of them
  for (const auto& place : ids)
  {
    heights.push_back(place.first[0]);
  }
  for (std::size_t i = 0; i < f.Points.size(); ++i)
  {
    if (std::binary_search(heights.begin(), heights.end(), f.Points[i][0]))
    {
      const auto found = ids.find(f.Points[i]);
      if (found != ids.end() && found->second < 0)
      {
        found->second = static_cast<std::int64_t>(i);
      }
    }
  }
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    for (vtkIdType& p : surface.Triangles[i])
    {
      const std::int64_t id = ids.at(surface.Points[At(p)]);
      if (id < 0)
      {
        throw std::invalid_argument("A corner of triangle " + std::to_string(i) +
          " of the surface is no point of the tetrahedral mesh: mesh this surface without moving "
          "or splitting it.");
      }
      p = id;
    }
  }
  surface.Points = f.Points;
}

/// Triangles of a surface by their points, in ascending order.
using WantedTriangle = std::pair<std::array<SimplexId, 3>, std::size_t>;

std::vector<WantedTriangle> WantedTriangles(const SurfaceView& surface)
{
  std::vector<WantedTriangle> wanted;
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    std::array<SimplexId, 3> p{ static_cast<SimplexId>(t[0]), static_cast<SimplexId>(t[1]),
      static_cast<SimplexId>(t[2]) };
    std::sort(p.begin(), p.end());
    wanted.emplace_back(p, i);
  }
  std::sort(wanted.begin(), wanted.end());
  return wanted;
}

void MarkSurface(CellFiltration& f, const SurfaceView& surface)
{
  f.EdgeFirst.assign(f.Edges.size(), 0);
  f.TriangleFirst.assign(f.TriangleCount(), 0);
  std::vector<char> onSurface(f.Points.size(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (const std::int64_t p : t)
    {
      onSurface[At(p)] = 1;
    }
  }
  const std::vector<WantedTriangle> wanted = WantedTriangles(surface);
  std::vector<char> found(wanted.size(), 0);
  for (const TriangleId t : f.Triangles())
  {
    const auto p = f.TrianglePoints(t);
    if (onSurface[At(p[0])] == 0 || onSurface[At(p[1])] == 0 || onSurface[At(p[2])] == 0)
    {
      continue;
    }
    for (auto w = std::lower_bound(wanted.begin(), wanted.end(), WantedTriangle{ p, 0 });
         w != wanted.end() && w->first == p; ++w)
    {
      found[static_cast<std::size_t>(w - wanted.begin())] = 1;
      f.TriangleFirst[t] = 1;
      for (const EdgeId e : f.TriangleEdges[t])
      {
        f.EdgeFirst[e] = 1;
      }
    }
  }
  const auto missing = std::find(found.begin(), found.end(), 0);
  if (missing != found.end())
  {
    throw std::invalid_argument("Triangle " +
      std::to_string(wanted[static_cast<std::size_t>(missing - found.begin())].second) +
      " of the surface is no face of the tetrahedral mesh: mesh this surface without moving or "
      "splitting it.");
  }
}

/// The greatest of the values at the points of `simplex(id)`, for each of `count` simplices.
template <typename Id, typename Simplex>
HandleVector<Id, double> LastValues(
  std::size_t count, const Simplex& simplex, const std::vector<double>& square)
{
  HandleVector<Id, double> values(count, 0.0);
  ParallelFor(0, static_cast<std::int64_t>(count), 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const Id id : HandleRange<Id>(begin, end))
      {
        for (const SimplexId p : simplex(id))
        {
          values[id] = std::max(values[id], square[At(p)]);
        }
      }
    });
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
  FindNeighbours(f, Between(progress, 0.0, 0.4));
  Report(progress, 0.4);
  f.Connect(Between(progress, 0.4, 0.6));
  Match(f, surface);
  MarkSurface(f, surface);
  Report(progress, 0.8);
  f.TetrahedronValue = LastValues<TetrahedronId>(
    f.Tetrahedra.size(), [&f](TetrahedronId cell) { return f.Tetrahedra[cell]; }, square);
  f.TriangleValue = LastValues<TriangleId>(
    f.TriangleCount(), [&f](TriangleId t) { return f.TrianglePoints(t); }, square);
  f.EdgeValue = LastValues<EdgeId>(
    f.Edges.size(), [&f](EdgeId e) { return f.Edges[e]; }, square);
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
      const double there = d + Length(step);
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
