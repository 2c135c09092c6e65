#include "Surfaces/StarDefects.h"

#include "Core/Handles.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"

#include <algorithm>
#include <mutex>
#include <numeric>

namespace isthmus
{
namespace
{

using StarTriangle = Handle<struct StarTriangleKind, std::int64_t>;

/// The triangles round each point, in ascending order.
class Stars
{
public:
  Stars(const SurfaceView& mesh, const std::vector<char>& skip)
    : First(mesh.Points.size() + 2, 0)
  {
    const auto forCorners = [&mesh, &skip](auto&& visit)
    {
      for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
      {
        if (!skip[t])
        {
          for (const std::int64_t p : mesh.Triangles[t])
          {
            visit(At(p), StarTriangle::At(t));
          }
        }
      }
    };
    // Counted two places on: filling moves each start to where the next one begins.
    forCorners([this](std::size_t p, StarTriangle) { ++this->First[p + 2]; });
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Around.resize(this->First.back());
    forCorners(
      [this](std::size_t p, StarTriangle t) { this->Around[this->First[p + 1]++] = t.Value; });
  }

  const std::int64_t* Begin(std::size_t p) const { return this->Around.data() + this->First[p]; }
  std::size_t Size(std::size_t p) const { return this->First[p + 1] - this->First[p]; }

private:
  std::vector<std::size_t> First;
  std::vector<std::int64_t> Around;
};

/// A side, of one triangle, that begins or ends at the point.
struct Spoke
{
  std::int64_t Other;
  std::int64_t Apex;   ///< the triangle's third corner
  std::uint32_t Place; ///< of the triangle in the star
  bool Leaves;         ///< the triangle runs from the point to Other

  bool operator<(const Spoke& o) const
  {
    return this->Other != o.Other ? this->Other < o.Other
      : this->Apex != o.Apex      ? this->Apex < o.Apex
                                  : this->Place < o.Place;
  }
};

/// Looks at one star after the other; memory is kept between them.
class StarCheck
{
public:
  StarCheck(const SurfaceView& mesh, const Stars& stars)
    : Mesh(mesh)
    , TheStars(stars)
  {
  }

  void Look(std::int64_t point)
  {
    const std::size_t size = this->TheStars.Size(At(point));
    if (size == 0)
    {
      return;
    }
    this->Triangles = this->TheStars.Begin(At(point));
    this->TakeSpokes(point, size);
    this->Fan.resize(size);
    std::iota(this->Fan.begin(), this->Fan.end(), 0U);
    std::size_t fans = size;
    for (std::size_t i = 0; i < this->Spokes.size();)
    {
      std::size_t end = i + 1;
      for (; end < this->Spokes.size() && this->Spokes[end].Other == this->Spokes[i].Other; ++end)
      {
        fans -= this->Join(this->Spokes[i].Place, this->Spokes[end].Place) ? 1 : 0;
      }
      if (this->Spokes[i].Other > point) // each edge once
      {
        this->LookAtEdge(this->Spokes.data() + i, this->Spokes.data() + end);
      }
      i = end;
    }
    if (fans > 1)
    {
      this->Found.NonManifoldPoints.push_back(point);
    }
  }

  SurfaceDefects Found;

private:
  void TakeSpokes(std::int64_t point, std::size_t size)
  {
    this->Spokes.clear();
    for (std::uint32_t place = 0; place < size; ++place)
    {
      const Triangle& t = this->Mesh.Triangles[At(this->Triangles[place])];
      const std::size_t corner = t[0] == point ? 0 : t[1] == point ? 1 : 2;
      const std::int64_t next = t[(corner + 1) % 3];
      const std::int64_t last = t[(corner + 2) % 3];
      this->Spokes.push_back({ next, last, place, true });
      this->Spokes.push_back({ last, next, place, false });
    }
    std::sort(this->Spokes.begin(), this->Spokes.end());
  }

  std::uint32_t Root(std::uint32_t place)
  {
    while (this->Fan[place] != place)
    {
      this->Fan[place] = this->Fan[this->Fan[place]];
      place = this->Fan[place];
    }
    return place;
  }

  /// True if they were apart.
  bool Join(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t rootA = this->Root(a);
    const std::uint32_t rootB = this->Root(b);
    this->Fan[std::max(rootA, rootB)] = std::min(rootA, rootB);
    return rootA != rootB;
  }

  void LookAtEdge(const Spoke* first, const Spoke* end)
  {
    const auto triangle = [this](const Spoke& spoke) { return this->Triangles[spoke.Place]; };
    const auto count = end - first;
    if (count == 1)
    {
      this->Found.BoundaryTriangles.push_back(triangle(*first));
    }
    else if (count > 2)
    {
      for (const Spoke* spoke = first; spoke != end; ++spoke)
      {
        this->Found.NonManifoldTriangles.push_back(triangle(*spoke));
      }
    }
    else if (first[0].Leaves == first[1].Leaves)
    {
      this->Found.FlippedTriangles.insert(
        this->Found.FlippedTriangles.end(), { triangle(first[0]), triangle(first[1]) });
    }
    for (const Spoke* spoke = first + 1; spoke < end; ++spoke)
    {
      // Of the same triangle's three edges the one between its two lowest points tells.
      if (spoke->Apex == spoke[-1].Apex && spoke->Apex > spoke->Other)
      {
        this->Found.DuplicateTriangles.push_back(triangle(*spoke));
      }
    }
  }

  SurfaceView Mesh;
  const Stars& TheStars;
  const std::int64_t* Triangles = nullptr; ///< of the star
  std::vector<Spoke> Spokes;
  std::vector<std::uint32_t> Fan; ///< union-find over the star's triangles
};

constexpr std::vector<std::int64_t> SurfaceDefects::*ListsOfStars[] = {
  &SurfaceDefects::DuplicateTriangles, &SurfaceDefects::BoundaryTriangles,
  &SurfaceDefects::NonManifoldTriangles, &SurfaceDefects::FlippedTriangles,
  &SurfaceDefects::NonManifoldPoints
};

}

void FindStarDefects(const SurfaceView& mesh, const std::vector<char>& skip, SurfaceDefects& found)
{
  const Stars stars(mesh, skip);
  std::mutex mutex;
  ParallelFor(0, static_cast<std::int64_t>(mesh.Points.size()), 1 << 14,
    [&](std::int64_t begin, std::int64_t end)
    {
      StarCheck check(mesh, stars);
      for (std::int64_t point = begin; point < end; ++point)
      {
        check.Look(point);
      }
      const std::lock_guard<std::mutex> lock(mutex);
      for (const auto kind : ListsOfStars)
      {
        const std::vector<std::int64_t>& mine = check.Found.*kind;
        (found.*kind).insert((found.*kind).end(), mine.begin(), mine.end());
      }
    });
  for (const auto kind : ListsOfStars)
  {
    std::vector<std::int64_t>& ids = found.*kind;
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }
}

}
