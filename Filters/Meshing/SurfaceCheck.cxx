#include "SurfaceCheck.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

/// One side of one triangle, with its ends in ascending order so that neighbours sort together.
struct HalfEdge
{
  std::int64_t Low;
  std::int64_t High;
  std::int64_t Triangle;
  bool Ascending; ///< the triangle runs from Low to High

  bool SameEdge(const HalfEdge& o) const { return this->Low == o.Low && this->High == o.High; }
};

std::vector<HalfEdge> SortedHalfEdges(const TriangleMesh& mesh, const std::vector<bool>& skip)
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
      const std::int64_t a = ids[c];
      const std::int64_t b = ids[(c + 1) % 3];
      edges.push_back({ std::min(a, b), std::max(a, b), static_cast<std::int64_t>(t), a < b });
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

/// Union-find with path halving.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t n)
    : Parent(n)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t{ 0 });
  }

  std::size_t Find(std::size_t i)
  {
    while (this->Parent[i] != i)
    {
      i = this->Parent[i] = this->Parent[this->Parent[i]];
    }
    return i;
  }

  void Join(std::size_t a, std::size_t b)
  {
    a = this->Find(a);
    b = this->Find(b);
    this->Parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::size_t> Parent;
};

void Sort(std::vector<std::int64_t>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Invalid, degenerate and duplicate triangles; returns which ones have no usable point ids.
std::vector<bool> CheckTriangles(const TriangleMesh& mesh, SurfaceDefects& found)
{
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  std::vector<bool> skip(mesh.Triangles.size());
  std::vector<std::pair<Triangle, std::int64_t>> sorted;
  sorted.reserve(mesh.Triangles.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Triangle& ids = mesh.Triangles[t];
    const auto id = static_cast<std::int64_t>(t);
    const bool inRange = std::all_of(
      ids.begin(), ids.end(), [points](std::int64_t p) { return p >= 0 && p < points; });
    if (!inRange || ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0])
    {
      found.InvalidTriangles.push_back(id);
      skip[t] = true;
      continue;
    }
    const Point3& p = mesh.Points[static_cast<std::size_t>(ids[0])];
    const Point3 normal = Cross(mesh.Points[static_cast<std::size_t>(ids[1])] - p,
      mesh.Points[static_cast<std::size_t>(ids[2])] - p);
    if (Dot(normal, normal) == 0.0)
    {
      found.DegenerateTriangles.push_back(id);
    }
    Triangle key = ids;
    std::sort(key.begin(), key.end());
    sorted.emplace_back(key, id);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].first == sorted[i - 1].first)
    {
      found.DuplicateTriangles.push_back(sorted[i].second);
    }
  }
  Sort(found.DuplicateTriangles);
  return skip;
}

void CheckEdges(const std::vector<HalfEdge>& edges, SurfaceDefects& found)
{
  ForEachEdge(edges,
    [&found](auto first, auto last)
    {
      const auto count = last - first;
      if (count == 1)
      {
        found.BoundaryTriangles.push_back(first->Triangle);
      }
      else if (count > 2)
      {
        std::for_each(first, last,
          [&found](const HalfEdge& e) { found.NonManifoldTriangles.push_back(e.Triangle); });
      }
      else if (first->Ascending == (first + 1)->Ascending)
      {
        found.FlippedTriangles.push_back(first->Triangle);
        found.FlippedTriangles.push_back((first + 1)->Triangle);
      }
    });
  Sort(found.BoundaryTriangles);
  Sort(found.NonManifoldTriangles);
  Sort(found.FlippedTriangles);
}

/// Points whose triangles hang together at the point only.
void CheckFans(const TriangleMesh& mesh, const std::vector<HalfEdge>& edges,
  const std::vector<bool>& skip, SurfaceDefects& found)
{
  const auto cornerAt = [&mesh](std::int64_t triangle, std::int64_t point)
  {
    const Triangle& ids = mesh.Triangles[static_cast<std::size_t>(triangle)];
    const auto corner = std::find(ids.begin(), ids.end(), point) - ids.begin();
    return static_cast<std::size_t>(3 * triangle + corner);
  };
  DisjointSets corners(3 * mesh.Triangles.size());
  ForEachEdge(edges,
    [&](auto first, auto last)
    {
      for (auto e = first + 1; e != last; ++e)
      {
        corners.Join(cornerAt(first->Triangle, e->Low), cornerAt(e->Triangle, e->Low));
        corners.Join(cornerAt(first->Triangle, e->High), cornerAt(e->Triangle, e->High));
      }
    });
  std::vector<std::int64_t> fan(mesh.Points.size(), -1);
  for (std::size_t c = 0; c < 3 * mesh.Triangles.size(); ++c)
  {
    if (skip[c / 3])
    {
      continue;
    }
    const std::int64_t point = mesh.Triangles[c / 3][c % 3];
    std::int64_t& root = fan[static_cast<std::size_t>(point)];
    const auto mine = static_cast<std::int64_t>(corners.Find(c));
    if (root < 0)
    {
      root = mine;
    }
    else if (root != mine)
    {
      found.NonManifoldPoints.push_back(point);
    }
  }
  Sort(found.NonManifoldPoints);
}

}

bool SurfaceDefects::None() const
{
  return this->InvalidPoints.empty() && this->InvalidTriangles.empty() &&
    this->DegenerateTriangles.empty() && this->DuplicateTriangles.empty() &&
    this->BoundaryTriangles.empty() && this->NonManifoldTriangles.empty() &&
    this->FlippedTriangles.empty() && this->NonManifoldPoints.empty();
}

std::string FirstIds(const std::vector<std::int64_t>& ids)
{
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, ids.size()); ++i)
  {
    text += (i ? ", " : "") + std::to_string(ids[i]);
  }
  return ids.size() > shown ? text + " and " + std::to_string(ids.size() - shown) + " more" : text;
}

std::string SurfaceDefects::Sentence() const
{
  std::string text;
  const auto add = [&text](const std::vector<std::int64_t>& ids, const char* what)
  {
    if (!ids.empty())
    {
      text += (text.empty() ? "" : "; ") + std::string(what) + " (" + FirstIds(ids) + ")";
    }
  };
  add(this->InvalidPoints, "points that are not finite");
  add(this->InvalidTriangles, "triangles with a repeated or missing point");
  add(this->DegenerateTriangles, "triangles without area");
  add(this->DuplicateTriangles, "duplicate triangles");
  add(this->BoundaryTriangles, "triangles at a hole");
  add(this->NonManifoldTriangles, "triangles at an edge of more than two");
  add(this->FlippedTriangles, "neighbouring triangles of opposite orientation");
  add(this->NonManifoldPoints, "points where sheets touch");
  return text.empty() ? text : "The surface has " + text + ".";
}

SurfaceDefects FindDefects(const TriangleMesh& mesh)
{
  SurfaceDefects found;
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const Point3& p = mesh.Points[i];
    if (!std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }))
    {
      found.InvalidPoints.push_back(static_cast<std::int64_t>(i));
    }
  }
  const std::vector<bool> skip = CheckTriangles(mesh, found);
  const std::vector<HalfEdge> edges = SortedHalfEdges(mesh, skip);
  CheckEdges(edges, found);
  CheckFans(mesh, edges, skip, found);
  return found;
}

std::vector<int> Components(const TriangleMesh& mesh)
{
  const std::size_t n = mesh.Triangles.size();
  DisjointSets sets(n);
  ForEachEdge(SortedHalfEdges(mesh, {}),
    [&sets](auto first, auto last)
    {
      for (auto e = first + 1; e != last; ++e)
      {
        sets.Join(static_cast<std::size_t>(first->Triangle), static_cast<std::size_t>(e->Triangle));
      }
    });
  std::vector<int> label(n, -1);
  int count = 0;
  for (std::size_t t = 0; t < n; ++t)
  {
    const std::size_t root = sets.Find(t); // the smallest triangle id, so met first
    label[t] = root == t ? count++ : label[root];
  }
  return label;
}

double SignedVolume(const TriangleMesh& mesh)
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

std::int64_t EulerCharacteristic(const TriangleMesh& mesh)
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
