#include "Surfaces/FlatTriangles.h"

#include "Core/Index.h"
#include "Surfaces/MeshEdges.h"
#include "Surfaces/SurfaceCheck.h"

#include <algorithm>
#include <utility>

namespace isthmus
{
namespace
{

constexpr int MostLayers = 16;

void RemoveRepeated(std::vector<Triangle>& triangles)
{
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                    [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
    triangles.end());
}

/// One layer of flat triangles, each exchanged at most once.
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

  /// Whether anything was exchanged.
  bool Exchange(const std::vector<std::int64_t>& flat)
  {
    bool any = false;
    for (const std::int64_t triangle : flat)
    {
      any = this->ExchangeOne(triangle) || any;
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

  bool ExchangeOne(std::int64_t flat)
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

TriangleMesh WithoutFlatTriangles(TriangleMesh surface)
{
  RemoveRepeated(surface.Triangles);
  for (int layer = 0; layer < MostLayers; ++layer)
  {
    const std::vector<std::int64_t> flat = FindDefects(surface).DegenerateTriangles;
    if (flat.empty() || !FlatLayer(surface).Exchange(flat))
    {
      break;
    }
  }
  return surface;
}

}
