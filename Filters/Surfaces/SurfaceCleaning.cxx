#include "Surfaces/SurfaceCleaning.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Surfaces/MeshEdges.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

constexpr int MostLayers = 16;

void RemoveDuplicates(std::vector<Triangle>& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

/// One layer of flat triangles, each flipped at most once.
class FlatLayer
{
public:
  explicit FlatLayer(TriangleMesh& surface)
    : Surface(surface)
    , Edges(SortedHalfEdges(surface, {}))
    , Touched(surface.Triangles.size(), false)
    , Gone(surface.Triangles.size(), false)
  {
  }

  /// Whether any edge was flipped.
  bool FlipEdges(const std::vector<std::int64_t>& flat)
  {
    bool any = false;
    for (const std::int64_t triangle : flat)
    {
      any = this->FlipEdge(triangle) || any;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Gone.size(); ++i)
    {
      if (!this->Gone[i])
      {
        this->Surface.Triangles[kept++] = this->Surface.Triangles[i];
      }
    }
    this->Surface.Triangles.resize(kept);
    return any;
  }

private:
  using Run =
    std::pair<std::vector<HalfEdge>::const_iterator, std::vector<HalfEdge>::const_iterator>;

  Run TrianglesAt(std::int64_t a, std::int64_t b) const
  {
    const auto key = std::minmax(a, b);
    return std::equal_range(this->Edges.begin(), this->Edges.end(),
      HalfEdge{ key.first, key.second, 0, true },
      [](const HalfEdge& p, const HalfEdge& q)
      { return std::pair(p.Low, p.High) < std::pair(q.Low, q.High); });
  }

  /// Turned so that the first and the last corner are the ends of the longest side.
  Triangle LongestLast(Triangle t) const
  {
    const auto length = [&](std::size_t c)
    {
      const Point3 side = this->Surface.Points[At(t[(c + 1) % 3])] - this->Surface.Points[At(t[c])];
      return Dot(side, side);
    };
    std::size_t longest = 0;
    for (std::size_t c = 1; c < 3; ++c)
    {
      longest = length(c) > length(longest) ? c : longest;
    }
    return { t[(longest + 1) % 3], t[(longest + 2) % 3], t[longest] };
  }

  bool FlipEdge(std::int64_t flat)
  {
    const auto [a, b, c] = this->LongestLast(this->Surface.Triangles[At(flat)]);
    const auto [first, last] = this->TrianglesAt(a, c);
    if (this->Touched[At(flat)] || last - first > 2)
    {
      return false;
    }
    if (last - first == 1)
    {
      this->Touched[At(flat)] = this->Gone[At(flat)] = true;
      return true;
    }
    const std::int64_t other = first->Triangle == flat ? (first + 1)->Triangle : first->Triangle;
    const Triangle neighbour = this->Surface.Triangles[At(other)];
    const auto apex = std::find_if(neighbour.begin(), neighbour.end(),
      [a = a, c = c](std::int64_t p) { return p != a && p != c; });
    const auto [found, end] = this->TrianglesAt(b, *apex);
    if (this->Touched[At(other)] || *apex == b || found != end)
    {
      return false;
    }
    Triangle& withA = this->Surface.Triangles[At(flat)];
    Triangle& withC = this->Surface.Triangles[At(other)];
    withA = withC = neighbour;
    std::replace(withA.begin(), withA.end(), c, b);
    std::replace(withC.begin(), withC.end(), a, b);
    this->Touched[At(flat)] = this->Touched[At(other)] = true;
    return true;
  }

  TriangleMesh& Surface;
  std::vector<HalfEdge> Edges;
  std::vector<bool> Touched, Gone;
};

}

TriangleMesh RemoveFlatTriangles(TriangleMesh surface)
{
  RemoveDuplicates(surface.Triangles);
  for (int layer = 0; layer < MostLayers; ++layer)
  {
    const std::vector<std::int64_t> flat = FindDefects(surface).DegenerateTriangles;
    if (flat.empty() || !FlatLayer(surface).FlipEdges(flat))
    {
      break;
    }
  }
  return surface;
}

namespace
{

/// A hash of a point's position (G. L. Steele, D. Lea,
/// C. H. Flood, 2014: the finalizer of SplitMix).
std::uint64_t HashPoint(const Point3& p)
{
  std::uint64_t hash = 0;
  for (const double x : p)
  {
    const double coordinate = x + 0.0; // -0.0 is where 0.0 is
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    hash = (hash ^ bits) + 0x9E3779B97F4A7C15ULL;
    hash = (hash ^ hash >> 30) * 0xBF58476D1CE4E5B9ULL;
    hash = (hash ^ hash >> 27) * 0x94D049BB133111EBULL;
    hash ^= hash >> 31;
  }
  return hash;
}

template <typename Point>
std::vector<std::uint64_t> HashPoints(std::int64_t count, const Point& point)
{
  std::vector<std::uint64_t> hashes(At(count));
  ParallelFor(0, count, 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (std::int64_t i = begin; i < end; ++i)
      {
        hashes[At(i)] = HashPoint(point(i));
      }
    });
  return hashes;
}

/// For each of `count` points the first of those at the same place; `point(i)` gives coordinates.
/// Uses a hash table at most half full. A point with NaN coincides with no other.
template <typename Point>
std::vector<std::int64_t> FirstAtPlace(std::int64_t count, const Point& point)
{
  const std::vector<std::uint64_t> hashes = HashPoints(count, point);
  std::size_t size = 1;
  while (size < 2 * At(count))
  {
    size *= 2;
  }
  std::vector<std::int64_t> table(size, -1);
  std::vector<std::int64_t> first(At(count));
  for (std::int64_t i = 0; i < count; ++i)
  {
    const Point3 place = point(i);
    first[At(i)] = i;
    if (place != place)
    {
      continue;
    }
    std::size_t slot = hashes[At(i)] & (size - 1);
    while (
      table[slot] >= 0 && (hashes[At(table[slot])] != hashes[At(i)] || point(table[slot]) != place))
    {
      slot = (slot + 1) & (size - 1);
    }
    if (table[slot] < 0)
    {
      table[slot] = i;
    }
    first[At(i)] = table[slot];
  }
  return first;
}

/// The points that triangles use; others need not be finite.
std::vector<std::int64_t> CollectIds(const std::vector<char>& used)
{
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      ids.push_back(static_cast<std::int64_t>(i));
    }
  }
  return ids;
}

/// Which of the six faces of `box` a point lies on, one bit each.
unsigned int FindTouchedFaces(const Point3& p, const Bounds3& box, double tolerance)
{
  unsigned int faces = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    faces |= p[a] - box.Min[a] <= tolerance ? 1U << 2 * a : 0U;
    faces |= box.Max[a] - p[a] <= tolerance ? 2U << 2 * a : 0U;
  }
  return faces;
}

/// Whether all corners are points, and finite ones.
bool IsUsable(const SurfaceView& surface)
{
  const auto count = static_cast<std::int64_t>(surface.Points.size());
  const auto usable = [&](std::int64_t id)
  {
    return id >= 0 && id < count &&
      std::all_of(surface.Points[At(id)].begin(), surface.Points[At(id)].end(),
        [](double x) { return std::isfinite(x); });
  };
  return std::all_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& t) { return std::all_of(t.begin(), t.end(), usable); });
}

}

TriangleMesh MergePoints(const SurfaceView& surface, std::vector<std::int64_t>* original)
{
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (const std::int64_t p : t)
    {
      if (p < 0 || At(p) >= surface.Points.size())
      {
        throw std::invalid_argument(
          "The surface has a triangle with point " + std::to_string(p) + ", which does not exist.");
      }
      used[At(p)] = 1;
    }
  }
  const std::vector<std::int64_t> ids = CollectIds(used);
  const auto first = FirstAtPlace(static_cast<std::int64_t>(ids.size()),
    [&](std::int64_t i) { return surface.Points[At(ids[At(i)])]; });
  TriangleMesh merged;
  std::vector<std::int64_t> idOf(surface.Points.size(), -1);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (first[i] == static_cast<std::int64_t>(i))
    {
      idOf[At(ids[i])] = static_cast<std::int64_t>(merged.Points.size());
      merged.Points.push_back(surface.Points[At(ids[i])]);
      if (original)
      {
        original->push_back(ids[i]);
      }
    }
    else
    {
      idOf[At(ids[i])] = idOf[At(ids[At(first[i])])];
    }
  }
  merged.Triangles.reserve(surface.Triangles.size());
  for (const Triangle& t : surface.Triangles)
  {
    const Triangle corners{ idOf[At(t[0])], idOf[At(t[1])], idOf[At(t[2])] };
    if (HasRepeated(t) || !HasRepeated(corners)) // defects of the input are reported, not hidden
    {
      merged.Triangles.push_back(corners);
    }
  }
  return merged;
}

CleanedSurface CleanSurface(TriangleMesh surface)
{
  CleanedSurface taken;
  if (!IsUsable(surface) || FindDefects(surface).None())
  {
    taken.OriginalPoints.resize(surface.Points.size());
    std::iota(taken.OriginalPoints.begin(), taken.OriginalPoints.end(), std::int64_t{ 0 });
    taken.Mesh = std::move(surface);
    return taken;
  }
  taken.Mesh = MergePoints(surface, &taken.OriginalPoints);
  SurfaceCorrection correction;
  std::vector<Triangle> joined = JoinCracks(taken.Mesh, correction);
  if (correction.Joined > 0)
  {
    std::vector<std::int64_t> used;
    taken.Mesh = MergePoints(SurfaceView(taken.Mesh.Points, joined), &used);
    std::transform(used.begin(), used.end(), used.begin(),
      [&taken](std::int64_t id) { return taken.OriginalPoints[At(id)]; });
    taken.OriginalPoints = std::move(used);
    taken.Message = correction.Message();
  }
  taken.Mesh = RemoveFlatTriangles(std::move(taken.Mesh));
  return taken;
}

std::vector<Triangle> MergedCorners(const SurfaceView& surface, std::vector<vtkIdType>* places)
{
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (const vtkIdType corner : t)
    {
      used[At(corner)] = 1;
    }
  }
  const std::vector<std::int64_t> ids = CollectIds(used);
  const auto first = FirstAtPlace(static_cast<std::int64_t>(ids.size()),
    [&](std::int64_t i) { return surface.Point(ids[At(i)]); });
  std::vector<vtkIdType> place(used.size());
  std::iota(place.begin(), place.end(), vtkIdType{ 0 });
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    place[At(ids[i])] = ids[At(first[i])];
  }
  std::vector<Triangle> merged;
  merged.reserve(surface.Triangles.size());
  for (const Triangle& before : surface.Triangles)
  {
    const Triangle after{ place[At(before[0])], place[At(before[1])], place[At(before[2])] };
    if (HasRepeated(before) || !HasRepeated(after))
    {
      merged.push_back(after);
    }
  }
  if (places)
  {
    places->swap(place);
  }
  return merged;
}

std::string DescribeOpenBoundary(const SurfaceView& surface, const SurfaceDefects& defects)
{
  if (defects.BoundaryTriangles.empty() || !defects.InvalidPoints.empty() ||
    !defects.InvalidTriangles.empty())
  {
    return {};
  }
  Bounds3 box{ surface.Points.front(), surface.Points.front() };
  for (const Point3& p : surface.Points)
  {
    box.Add(p);
  }
  const double tolerance = 1e-5 * box.Diagonal(); // coordinates may be rounded to float
  for (const std::int64_t triangle : defects.BoundaryTriangles)
  {
    const Triangle& t = surface.Triangles[At(triangle)];
    unsigned int faces[3];
    for (std::size_t c = 0; c < 3; ++c)
    {
      faces[c] = FindTouchedFaces(surface.Points[At(t[c])], box, tolerance);
    }
    if ((faces[0] & faces[1]) == 0 && (faces[1] & faces[2]) == 0 && (faces[2] & faces[0]) == 0)
    {
      return {};
    }
  }
  return " It is open only at the faces of its bounding box, like a contour whose level leaves the "
         "map: Map Surface closes it there.";
}

}
