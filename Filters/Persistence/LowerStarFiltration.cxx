#include "Persistence/LowerStarFiltration.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RadixSort.h"
#include "Core/TriangleMesh.h"
#include "Persistence/CellFiltration.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// A face of a tetrahedron, but for its smallest point, which is that of its bucket.
struct Face
{
  std::uint32_t Middle, Last; ///< the other points
  std::uint32_t Place;        ///< 4 * cell + the corner opposite to the face

  std::uint64_t OtherPoints() const { return std::uint64_t{ this->Middle } << 32 | this->Last; }

  bool operator<(const Face& o) const
  {
    return this->OtherPoints() != o.OtherPoints() ? this->OtherPoints() < o.OtherPoints()
                                                  : this->Place < o.Place;
  }
};

/// Calls visit(smallest point, face) for the four faces of each cell.
template <typename Visit>
void ForEachFace(const CellFiltration& f, const Visit& visit)
{
  for (const TetrahedronId cell : f.Tetrahedra.Keys())
  {
    const auto& t = f.Tetrahedra[cell];
    for (std::size_t k = 0; k < 4; ++k)
    {
      const SimplexId a = t[(k + 1) % 4], b = t[(k + 2) % 4], c = t[(k + 3) % 4];
      const SimplexId low = std::min(a, b), high = std::max(a, b);
      const SimplexId middle = std::max(low, std::min(high, c));
      visit(At(std::min(low, c)),
        Face{ static_cast<std::uint32_t>(middle), static_cast<std::uint32_t>(std::max(high, c)),
          static_cast<std::uint32_t>(4 * cell.Index() + k) });
    }
  }
}

/// The faces of all tetrahedra in buckets of their smallest points: [first[p], first[p + 1]).
std::vector<Face> FacesByPoint(const CellFiltration& f, std::vector<std::size_t>& first)
{
  // Counted two positions ahead: filling moves each start to the beginning of the next.
  first.assign(f.Points.size() + 2, 0);
  ForEachFace(f, [&first](std::size_t p, const Face&) { ++first[p + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Face> faces(first.back());
  ForEachFace(f, [&](std::size_t p, const Face& face) { faces[first[p + 1]++] = face; });
  return faces;
}

/// The position, from `begin`, where three cells share one face; -1 if there is none.
std::ptrdiff_t LinkTwins(CellFiltration& f, Face* begin, Face* end)
{
  std::sort(begin, end);
  for (Face* face = begin; face != end; ++face)
  {
    if (face + 1 == end || face[0].OtherPoints() != face[1].OtherPoints())
    {
      continue;
    }
    if (face + 2 != end && face[0].OtherPoints() == face[2].OtherPoints())
    {
      return face - begin;
    }
    const std::uint32_t one = face[0].Place, other = face[1].Place;
    const auto cell = TetrahedronId::At(one / 4), beyond = TetrahedronId::At(other / 4);
    f.Neighbours[cell][one % 4] = beyond;
    f.Neighbours[beyond][other % 4] = cell;
    ++face;
  }
  return -1;
}

void FindNeighbours(CellFiltration& f, const ProgressCallback& progress)
{
  f.RequireNumbers();
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

/// The first of the mesh's points at each point of `surface`; -1 where there is none.
std::vector<vtkIdType> IdsInMesh(const CellFiltration& f, const TriangleMesh& surface)
{
  using Place = std::pair<Point3, std::size_t>;
  std::vector<Place> places;
  places.reserve(surface.Points.size());
  for (std::size_t p = 0; p < surface.Points.size(); ++p)
  {
    places.emplace_back(surface.Points[p], p);
  }
  std::sort(places.begin(), places.end());
  std::vector<vtkIdType> ids(surface.Points.size(), -1);
  for (std::size_t i = 0; i < f.Points.size(); ++i)
  {
    for (auto at = std::lower_bound(places.begin(), places.end(), Place{ f.Points[i], 0 });
         at != places.end() && at->first == f.Points[i] && ids[at->second] < 0; ++at)
    {
      ids[at->second] = static_cast<vtkIdType>(i);
    }
  }
  return ids;
}

/// Gives `surface` the ids of the mesh's points at the same places: the first of several.
void Match(const CellFiltration& f, TriangleMesh& surface)
{
  const std::vector<vtkIdType> ids = IdsInMesh(f, surface);
  for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
  {
    for (vtkIdType& p : surface.Triangles[i])
    {
      const vtkIdType id = ids[At(p)];
      if (id < 0)
      {
        throw std::invalid_argument("A corner of triangle " + std::to_string(i) +
          " of the surface is not a point of the tetrahedral mesh: mesh this surface without "
          "moving "
          "or splitting it.");
      }
      p = id;
    }
  }
  surface.Points = f.Points;
}

/// Triangles of a surface in buckets of their smallest points.
class TrianglesByPoint
{
public:
  /// @pre All points are below `points`.
  TrianglesByPoint(const SurfaceView& surface, std::size_t points)
    : First(points + 2, 0)
    , Entries(surface.Triangles.size())
  {
    // Counted two positions ahead: filling moves each start to the beginning of the next.
    for (const Triangle& t : surface.Triangles)
    {
      ++this->First[At(std::min({ t[0], t[1], t[2] })) + 2];
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    for (std::size_t i = 0; i < surface.Triangles.size(); ++i)
    {
      const Triangle& t = surface.Triangles[i];
      std::array<SimplexId, 3> p{ static_cast<SimplexId>(t[0]), static_cast<SimplexId>(t[1]),
        static_cast<SimplexId>(t[2]) };
      std::sort(p.begin(), p.end());
      this->Entries[At(this->First[At(p[0]) + 1]++)] = { p[1], p[2], static_cast<SimplexId>(i) };
    }
  }

  /// Calls visit(triangle) for each one with these points, ascending.
  template <typename Visit>
  void ForEachTriangle(const std::array<SimplexId, 3>& p, Visit&& visit) const
  {
    for (SimplexId i = this->First[At(p[0])]; i < this->First[At(p[0]) + 1]; ++i)
    {
      const auto& [middle, last, triangle] = this->Entries[At(i)];
      if (middle == p[1] && last == p[2])
      {
        visit(At(triangle));
      }
    }
  }

private:
  std::vector<SimplexId> First;
  std::vector<std::array<SimplexId, 3>> Entries; ///< the other points, and the triangle
};

void MarkSurface(CellFiltration& f, const SurfaceView& surface)
{
  f.EdgeFirst.assign(f.Edges.size(), 0);
  f.TriangleFirst.assign(f.TriangleCount(), 0);
  const TrianglesByPoint wanted(surface, f.Points.size());
  std::vector<char> found(surface.Triangles.size(), 0);
  ParallelFor(0, static_cast<std::int64_t>(f.TriangleCount()), 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TriangleId t : HandleRange<TriangleId>(begin, end))
      {
        wanted.ForEachTriangle(f.TrianglePoints(t),
          [&](std::size_t triangle)
          {
            found[triangle] = 1;
            f.TriangleFirst[t] = 1;
          });
      }
    });
  for (const TriangleId t : f.Triangles())
  {
    if (f.TriangleFirst[t] != 0)
    {
      for (const EdgeId e : f.TriangleEdges(t))
      {
        f.EdgeFirst[e] = 1;
      }
    }
  }
  const auto missing = std::find(found.begin(), found.end(), 0);
  if (missing != found.end())
  {
    throw std::invalid_argument("Triangle " + std::to_string(missing - found.begin()) +
      " of the surface is not a face of the tetrahedral mesh: mesh this surface without moving or "
      "splitting it.");
  }
}

/// The values of a function on points, each once and in ascending order from level 1 on, and the
/// level of each point; level 0 is kept for the surface.
struct Levels
{
  std::vector<double> Values{ 0.0 };
  std::vector<std::uint32_t> OfPoint;

  /// @pre no value is negative: its bits then stand in the order of values.
  explicit Levels(const std::vector<double>& values)
    : OfPoint(values.size())
  {
    std::vector<std::pair<std::uint64_t, std::size_t>> order(values.size());
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      std::memcpy(&order[p].first, &values[p], sizeof(double));
      order[p].second = p;
    }
    RadixSort(order, 0, 64, [](const auto& entry) { return entry.first; });
    for (const auto& entry : order)
    {
      const double value = values[entry.second];
      if (this->Values.size() == 1 || value != this->Values.back())
      {
        this->Values.push_back(value);
      }
      this->OfPoint[entry.second] = static_cast<std::uint32_t>(this->Values.size() - 1);
    }
  }
};

/// For each of `count` simplices the greatest level of the points of `simplex(id)`, and its value.
template <typename Id, typename Simplex>
HandleVector<Id, std::uint32_t> LastLevels(
  const Levels& levels, std::size_t count, const Simplex& simplex, HandleVector<Id, double>& values)
{
  HandleVector<Id, std::uint32_t> last(count, 0);
  values.resize(count);
  ParallelFor(0, static_cast<std::int64_t>(count), 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const Id id : HandleRange<Id>(begin, end))
      {
        for (const SimplexId p : simplex(id))
        {
          last[id] = std::max(last[id], levels.OfPoint[At(p)]);
        }
        values[id] = levels.Values[last[id]];
      }
    });
  return last;
}

/// The order of simplices by level, those of the surface, which are `first`, before all others.
template <typename Id, typename Rank>
HandleVector<Rank, Id> SortByLevel(HandleVector<Id, std::uint32_t> level,
  const HandleVector<Id, char>& first, HandleVector<Id, Rank>& rank)
{
  for (const Id id : level.Keys())
  {
    level[id] = first[id] != 0 ? 0 : level[id];
  }
  return SimplexOrder(level, rank);
}

/// Values and orders of all simplices: those of their latest points.
void EnterByPoints(
  CellFiltration& f, const std::vector<double>& square, const ProgressCallback& progress)
{
  const Levels levels(square);
  LastLevels(
    levels, f.Tetrahedra.size(), [&f](TetrahedronId cell) { return f.Tetrahedra[cell]; },
    f.TetrahedronValue);
  Report(progress, 0.3);
  auto ofTriangles = LastLevels(
    levels, f.TriangleCount(), [&f](TriangleId t) { return f.TrianglePoints(t); }, f.TriangleValue);
  f.TrianglesInOrder = SortByLevel(std::move(ofTriangles), f.TriangleFirst, f.RankOfTriangle);
  Report(progress, 0.7);
  auto ofEdges = LastLevels(
    levels, f.Edges.size(), [&f](EdgeId e) { return f.Edges[e]; }, f.EdgeValue);
  f.EdgesInOrder = SortByLevel(std::move(ofEdges), f.EdgeFirst, f.RankOfEdge);
  Report(progress, 1.0);
}

HandleVector<TetrahedronId, std::array<SimplexId, 4>> NarrowIds(
  const std::vector<Tetrahedron>& tetrahedra)
{
  HandleVector<TetrahedronId, std::array<SimplexId, 4>> ids;
  ids.reserve(tetrahedra.size());
  for (const Tetrahedron& t : tetrahedra)
  {
    ids.push_back({ static_cast<SimplexId>(t[0]), static_cast<SimplexId>(t[1]),
      static_cast<SimplexId>(t[2]), static_cast<SimplexId>(t[3]) });
  }
  return ids;
}

/// Derives everything else from points and tetrahedra; `surface` gets their point ids.
void Derive(CellFiltration& f, TriangleMesh& surface, const ProgressCallback& progress)
{
  FindNeighbours(f, Between(progress, 0.0, 0.5));
  Report(progress, 0.5);
  f.Connect(Between(progress, 0.5, 0.75));
  Match(f, surface);
  MarkSurface(f, surface);
  Report(progress, 1.0);
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
  f.Tetrahedra = NarrowIds(mesh.Tetrahedra);
  Derive(f, surface, Between(progress, 0.0, 0.8));
  EnterByPoints(f, square, Between(progress, 0.8, 1.0));
  return f;
}

CellFiltration ComplexAround(
  TetrahedralMesh&& mesh, TriangleMesh& surface, const ProgressCallback& progress)
{
  CellFiltration f;
  f.Points = std::move(mesh.Points);
  f.Tetrahedra = NarrowIds(mesh.Tetrahedra);
  mesh = {};
  ReleaseFreeMemory(); // of TetGen's files, too
  Derive(f, surface, progress);
  return f;
}

}
